// SPDX-License-Identifier: MIT
// The effects that may have been left out of a case: those that can act in its rigs and are not in its model, with prior
// ranges in physical units (docs/diagnose.md), and the measurement effects.
#pragma once

#include "diagnose/problem.hpp"
#include "diagnose/unknowns.hpp"

#include <string>
#include <vector>

namespace diagnose {

// Several terms may carry one name: a scale of the lengths, a scale of the spin.
std::vector<Term> catalogue(const Problem&);

// No physics: scale, offset, time base, numerical artefact.
bool is_measurement(const std::string& effect);

// Widest range of the channel in any one recording, SI; 0 where none varies.
double channel_range(const Problem&, const std::string& channel);

// The drag coefficient that stands for `drag_factor`: at the fastest speed that the fit recordings reach.
double drag_coefficient(const Problem&, const Hypothesised&, const Eigen::VectorXd& theta,
                        double factor);

}  // namespace diagnose
