// SPDX-License-Identifier: MIT
// Bounces and stick or slip make many minima of the sum of squares, and a fit ends in one of them. Here others are looked for.
#pragma once

#include "diagnose/fit.hpp"

#include <vector>

namespace diagnose {

// A jump one row too early looks like nothing that fits.
bool has_force_curve(const Problem&);

struct Deeper {
    Fit fit;
    std::vector<Place> left;  // shallower minima that fits had ended in
};

// From `from`, short fits with each unknown that has a range put to values all over it, the others where they are, and with all
// moved together along the directions that the fit leaves open. The deepest are fitted out, and again from there as long as
// something is gained.
Deeper deeper_minimum(const Problem&, const Whitener&, const Hypothesised&, const Fit& from);

// From each of `from` (u) by ever more of each recording over time, a tenth at a time, once from the first fifth and once from the
// first half: a fit that is led so keeps in step with the bounces as they come. Those that do worst are given up on the way. Least
// left first.
std::vector<Place> followed_in_time(const Problem&, const Whitener&, const Hypothesised&,
                                    const std::vector<Eigen::VectorXd>& from);

}  // namespace diagnose
