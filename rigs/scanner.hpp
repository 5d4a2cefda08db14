// SPDX-License-Identifier: MIT
// A heap as a line scanner has it: heights at spots of somebody else's choice.
#pragma once

#include "rigs/heap.hpp"

#include <vector>

namespace rigs {

// The highest point of any grain above each spot, m; 0 where there is none. `azimuth` (rad) and `r` (m, either sign) about the axis of
// the base, of one length.
std::vector<double> heights_at(const Heap&, const std::vector<double>& azimuth,
                               const std::vector<double>& r);

}  // namespace rigs
