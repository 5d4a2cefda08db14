// SPDX-License-Identifier: MIT
// Did a heap form at all? An angle of something that is no heap is no angle of repose: a layer, a heap that did not reach
// the rim, one still moving. The verdict is a class with its criteria, never a number in place of an angle.
#pragma once

#include "rigs/height_map.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rigs {

// What the run knows and the map does not show.
struct HeapHistory {
    std::size_t spilled;    // grains that fell off the base
    double kinetic_energy;  // per grain, over m g d; dimensionless
};

struct Criterion {
    std::string name;  // snake_case, stable
    double value;      // dimensionless; lengths in grain diameters
    std::string rule;  // "<= 1"
    bool pass;
};

struct Formed {
    bool formed;  // all criteria pass
    std::vector<Criterion> criteria;
};

// Criteria, in this order:
//   base_covered        share of the base's area under grains                                     >= 0.8
//   falls_outwards      largest rise of the mean profile going outwards, in d                     <= 1
//   stands_above_rim    mean height inside R/4 less that outside 3R/4, in d                       >= 1
//   reaches_rim         gap between foot and rim, in d                                            <= 1, or grains spilled
//   at_rest             kinetic energy per grain over m g d                                       < 1e-6
//   apex_near_axis      distance of the apex from the axis, in d                                  <= 0.1 R/d, at least 1
// 0.8: on a base of 20 d the outermost ring of grains alone is 19 % of the area, and it is full of gaps.
// Without grains nothing passes but at_rest, and every value is finite.
Formed formed(const HeightMap&, const HeapHistory&);

}  // namespace rigs
