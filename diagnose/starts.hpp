// SPDX-License-Identifier: MIT
// Where the fit of one more term begins: its unknowns on a grid, all others following at first order.
#pragma once

#include "diagnose/fit.hpp"

#include <utility>
#include <vector>

namespace diagnose {

// A fitted hypothesis that a term is added to.
struct Footing {
    const Problem& problem;
    const Whitener& whiten;
    const Hypothesised& h;
    const Fit& fit;
};

struct Starts {
    std::vector<std::pair<double, Eigen::VectorXd>>
        best_first;       // chi squared at first order, values of the term's unknowns (SI)
    double unseen = 0.0;  // share of the prior of the term that moves nothing by a sigma
};

Hypothesised plus(const Problem&, const Hypothesised&, const Term&);

// theta of `to`: what it shares with the footing from there, its last unknowns `own`.
Eigen::VectorXd carried(const Footing&, const Hypothesised& to, const Eigen::VectorXd& own);

// Over the whole prior of the term. A vibration is linear in A cos(phase) and A sin(phase) while it is small: both are solved
// for at each of several hundred frequencies; larger ones are tried as they are, two thousand of them, by all rows and by the
// early ones alone; the three lists take turns.
Starts starts_of(const Footing&, const Term&);

// Beside another term: the values u of the term's own fit, other strengths with its further unknowns as there, and its grid. A vibration
// is looked for anew: what it was taken for may have been the other term.
Starts starts_beside(const Footing&, const Term&, const Eigen::VectorXd& u);

// The first `most` that are a tenth of a range, or of a frequency, or more apart in some unknown.
std::vector<Eigen::VectorXd> distinct(const Term&, const Starts&, std::size_t most);

}  // namespace diagnose
