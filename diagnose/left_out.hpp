// SPDX-License-Identifier: MIT
// Blocked cross-validation within the fitted recordings: each predicted by what the others say.
#pragma once

#include "diagnose/fit.hpp"

namespace diagnose {

// Chi squared of each recording under parameters fitted to all others, summed. Stated uncertainties of the recording itself (its
// release time, its base line) are refitted to it, priors counted, at first order: nobody else knows them. `at` is where the fits
// begin, a fit to all. NaN with fewer than two recordings.
double left_out_misfit(const Problem&, const Whitener&, const Hypothesised&, const Fit& at);

}  // namespace diagnose
