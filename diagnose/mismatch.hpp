// SPDX-License-Identifier: MIT
// Is there a mismatch? Four families of statistics of the whitened residual r of a fit:
//   shapes      what each effect of the catalogue would do at first order, d (projected off the fitted unknowns): d.r/|d|
//   windows     sum r/sqrt(L) and (sum r^2 - L)/sqrt(2 L) over windows of each channel of each recording, all dyadic lengths
//   regimes     the same over rows sorted by a variable of the state (speed, impact speed, ...), all recordings together
//   slow        sums of squares of the 1, 2, 4 and 8 slowest cosines of each recording, over all recordings of a channel and over all channels
// The largest of each family is held against draws under the null: noise as estimated, the refit repeated in each draw (to
// first order: the projection M = 1 - J (J'J + P)^-1 J'). The least of the four p-values is calibrated by the same draws.
#pragma once

#include "diagnose/locate.hpp"

#include <cstdint>
#include <vector>

namespace diagnose {

// `innovations`: standardised residuals to draw from; empty: normal ones.
double p_of_mismatch(const Problem&, const Whitener&, const Hypothesised& h, const Fit&,
                     const std::vector<Shape>&, const std::vector<double>& innovations,
                     std::uint64_t seed, int draws);

}  // namespace diagnose
