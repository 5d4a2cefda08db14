// SPDX-License-Identifier: MIT
// A heap as the pile rig leaves it: the loose grains alone, glued ones and those that fell off left out.
#pragma once

#include "contact/vec3.hpp"

#include <vector>

namespace rigs {

// The axis of the base is x = y = 0, its top is z = 0, z is up.
struct Heap {
    std::vector<contact::Vec3> centre;  // m, [grains]
    std::vector<double> radius;         // m, [grains], > 0
    double base_radius;                 // m, > 0
};

}  // namespace rigs
