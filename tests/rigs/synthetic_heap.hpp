// SPDX-License-Identifier: MIT
// Heaps of known shape for the tests: grains of diameter 1 m on a cubic lattice (face-centred or simple) turned at random, cut to shape.
#pragma once

#include "rigs/heap.hpp"

#include <cstdint>
#include <functional>

namespace synthetic {

// Centres lie between the hollows of a base of glued grains and 0.7 m + lift above these.
struct Shape {
    double base_radius;  // m
    std::function<double(double x, double y)>
        lift;            // m, of the surface over that of the lowest layer; < 0: no grain there
    double shell = 1e9;  // m, grains deeper than this under the surface are left out
    bool simple_cubic = false;  // instead of face-centred
    double noise = 0.0;         // m, normal scatter of every centre along x, y and z
};

// The same seed gives the same heap.
rigs::Heap heap(const Shape& shape, std::uint64_t seed);

// Cone of slope `tangent` whose bottom layer ends at the rim.
Shape cone(double base_radius, double tangent);

}  // namespace synthetic
