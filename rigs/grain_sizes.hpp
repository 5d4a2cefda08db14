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
// `size_distribution`. `size_spread` > 0: in place of these, log-normal by number about `diameter`, standard deviation over mean (cut
// at 2.5 deviations of the logarithm).
DrawnGrain draw_grain(const cases::Grain&, double u, double size_spread = 0.0);

}  // namespace rigs
