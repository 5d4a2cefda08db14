// SPDX-License-Identifier: MIT
// The cube root whose bits follow a change of scale: cube_root(8^k x) = 2^k cube_root(x), exactly.
//
// The binary exponent is split in threes, x = m 8^q with 1 <= m < 8, and m gets Halley's step
//   y <- y (y^3 + 2 m)/(2 y^3 + m)
// from the parabola through (1, 1), (27/8, 3/2), (8, 2), which is off by 2.5 % at worst. The error
// e falls to 2/3 e^3 in each step: 1e-5, 1e-15, round-off. A library's cube root is as accurate,
// but its last bit differs between machines; a power with a fractional exponent keeps no bits.
#pragma once

#include <cmath>

namespace contact {

// x^(1/3) for a finite, normal x > 0; within a few units in the last place.
inline double cube_root(double x) {
    int exponent = 0;
    const double half_to_one = std::frexp(x, &exponent);
    const int doublings =
        (exponent + 2999) % 3;  // 0, 1, 2: what (exponent - 1) leaves beyond threes
    const int q = (exponent - 1 - doublings) / 3;
    const double m = std::ldexp(half_to_one, doublings + 1);
    double y = 0.74009 + m * (0.274538 - 0.0146312 * m);
    for (int step = 0; step < 3; ++step) {
        const double y3 = y * y * y;
        y = y * (y3 + 2.0 * m) / (2.0 * y3 + m);
    }
    return std::ldexp(y, q);
}

}  // namespace contact
