// SPDX-License-Identifier: MIT
// None of these: what is missing as a function of one variable of the state, where no effect of the catalogue need be named.
#pragma once

#include "diagnose/candidates.hpp"

#include <vector>

namespace diagnose {

// `start` plus what may be missing, one candidate for each variable of the state, the best first: in flight and on a plane a
// force, in the impacts of drop and impact a share of the rebound. Values at knots, each a Gaussian about nothing whose size is
// that of greatest evidence. `terms` receives the terms, which the candidates point to. Nothing where no rig takes any.
std::vector<Candidate> with_missing(const Problem&, const Whitener&, const Candidate& start,
                                    std::vector<Term>& terms);

}  // namespace diagnose
