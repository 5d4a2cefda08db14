// SPDX-License-Identifier: MIT
// Drag of a fluid on a sphere that moves through it at u: Schiller & Naumann's curve, above Re = 1000 Newton's constant.
//   F = -r u,   r = k 3 pi eta d (1 + 0.15 Re^0.687)   below Re = 1000,   Re = rho |u| d/eta
//               r = k 0.44 pi/8 rho d^2 |u|            above; Cd jumps there by 0.4 %
// k is a factor on the whole curve, 1 for the curve as it is. No added mass, no history force, no lift.
// Schiller & Naumann (1935), Z. Ver. Dtsch. Ing. 77, 318 (curve, Re < 800); 0.44: Newton's range, Re < 2e5.
#pragma once

#include "scaling/quantities.hpp"

#include <bit>
#include <cstdint>
#include <numbers>

namespace contact {

// x^0.687 for 2^-100 <= x <= 2^100, within 1e-14: no branch and no library call, so that a loop over grains becomes vectors and
// has the same bits on every machine. x = m 2^e with m about 1; ln m as a series in (m - 1)/(m + 1); then e^z for |z| < 0.35.
inline double power_0687(double x) {
    constexpr std::uint64_t one = 0x3ff0000000000000, from_half_root = 0x00095f619980c433;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t exponent =
        (bits + from_half_root) >> 52;  // biased; sqrt(1/2) <= m < sqrt(2)
    const double m = std::bit_cast<double>(bits - (exponent << 52) + one);
    // A whole number below 2^52 in the last bits of 2^52.
    const double e = std::bit_cast<double>(exponent | 0x4330000000000000) - (0x1p52 + 1023.0);
    const double t = (m - 1.0) / (m + 1.0), u = t * t;
    double series = 1.0 / 21.0;
    for (int k = 19; k > 0; k -= 2) series = series * u + 1.0 / k;
    const double y = 0.687 * (e + 2.0 / std::numbers::ln2 * (t * series));  // 2^y is the answer
    const double shifted = y + 0x1.8p52;  // rounds y to a whole number, in the last bits
    const double z = std::numbers::ln2 * (y - (shifted - 0x1.8p52));
    double exponential = 1.0;
    for (int k = 14; k > 0; --k) exponential = exponential * (z * (1.0 / k)) + 1.0;
    return exponential * std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) << 52) + one);
}

struct DragSchiller1935 {
    double factor;              // 1; 0: no drag
    double density, viscosity;  // kg/m^3, Pa s, of the fluid

    // Throws InvalidParameter unless factor >= 0 and the fluid has a density or a viscosity, neither below 0.
    static DragSchiller1935 from(double factor, scaling::Density density,
                                 scaling::Viscosity viscosity);

    struct Resistance {
        double value;   // kg/s, r
        double growth;  // kg/s, |u| dr/d|u|
    };
    Resistance at(double diameter, double speed) const {
        constexpr double edge = 1000.0, least = 0x1p-100;
        constexpr double pi = std::numbers::pi;
        // In a fluid without viscosity infinite, or no number at rest.
        const double re = density * speed * diameter / viscosity;
        const double bounded = re > least ? (re < edge ? re : edge) : least;
        const double stokes = factor * (3.0 * pi) * viscosity * diameter;
        const double inertial = 0.15 * power_0687(bounded);
        const double newton = factor * (0.44 * pi / 8.0) * density * diameter * diameter * speed;
        return {re >= edge ? newton : stokes * (1.0 + inertial),
                re >= edge ? newton : stokes * (0.687 * inertial)};
    }
};

}  // namespace contact
