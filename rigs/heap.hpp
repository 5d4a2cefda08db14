// SPDX-License-Identifier: MIT
// A heap as the pile rig leaves it: the loose grains alone, glued ones and those that fell off left out.
#pragma once

#include "contact/vec3.hpp"

#include <cstddef>
#include <vector>

namespace rigs {

// The axis of the base is x = y = 0, its top is z = 0, z is up.
struct Heap {
    std::vector<contact::Vec3> centre;  // m, [grains]
    std::vector<double> radius;         // m, [grains], > 0
    double base_radius;                 // m, > 0
    // Where grains are clumps (dem_min/clump.hpp) these are their spheres, grain by grain: how many a grain has, and the radius of one
    // over that of a sphere as large as the grain.
    int spheres = 1;
    double sphere_size = 1.0;

    std::size_t grains() const { return centre.size() / static_cast<std::size_t>(spheres); }
    // Of the volume of its spheres, what a grain fills: less than 1 where they overlap.
    double filled() const { return 1.0 / (spheres * (sphere_size * sphere_size * sphere_size)); }
};

}  // namespace rigs
