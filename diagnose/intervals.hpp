// SPDX-License-Identifier: MIT
// What a fitted hypothesis says of its parameters.
#pragma once

#include "diagnose/candidates.hpp"
#include "diagnose/verdict.hpp"

#include <vector>

namespace diagnose {

// Of one of its terms: 90 % intervals by profile, all other unknowns refitted at each value, to a rise of 2.71 in chi squared or
// the end of the physical range. Curved valleys (a liquid's surface tension and volume) and ends are in them.
std::vector<Estimate> estimates(const Problem&, const Whitener&, const Candidate&, const Term&);

// Of the user's own unknowns: 90 % intervals at first order.
std::vector<Estimate> refitted(const Problem&, const Candidate&);

// What is missing, of its last term.
MissingEstimate missing_of(const Candidate&);

}  // namespace diagnose
