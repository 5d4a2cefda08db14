// SPDX-License-Identifier: MIT
// What a slider lets through: the share of a spring, force or torque that a limit leaves standing.
//
// To shorten a vector x to a ball is a projection P, and (P(x) - y).(x - y) >= |P(x) - y|^2 for any
// y in the ball. With y the force of a spring that has itself been shortened to the limit and
// x - y = c v that of its dashpot, (P - y).v >= 0: what the dashpot adds takes energy, never gives
// it. The spring's own shortening takes k spring.(trial - spring) >= 0, both being parallel.
#pragma once

#include "contact/vec3.hpp"

#include <cmath>

namespace contact {

// As it is: min(1, limit/length), given the square of the length, for limit >= 0 of the same unit; 1 where both are 0.
struct Slider {
    double share(double square, double limit) const {
        return square > limit * limit ? limit / std::sqrt(square) : 1.0;
    }
};

// A slider that does not slide, for contacts that stick, which spares them a root and a quotient. Where `slid` is not 0 in the
// end one would have, and what came out is worth nothing.
struct StuckSlider {
    double slid = 0.0;
    double share(double square, double limit) {
        slid = square > limit * limit ? 1.0 : slid;
        return 1.0;
    }
};

// `a`, shortened to the length `limit` where it is longer.
template <class AnySlider>
inline Vec3 clipped(Vec3 a, double limit, AnySlider&& slider) {
    return slider.share(dot(a, a), limit) * a;
}

}  // namespace contact
