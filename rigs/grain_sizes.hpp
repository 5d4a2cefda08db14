// SPDX-License-Identifier: MIT
// Sizes of the grains of a case, drawn one by one.
#pragma once

#include "cases/case.hpp"

namespace rigs {

struct DrawnGrain {
    double diameter;  // m
    int material;     // see cases/materials.hpp
};

// The grain below which a share `u`, 0 to 1, of all grains by number lies: all of one diameter, or by `sizes`, or by
// `size_distribution`.
DrawnGrain draw_grain(const cases::Grain&, double u);

}  // namespace rigs
