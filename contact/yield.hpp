// SPDX-License-Identifier: MIT
// What a slider lets through: the share of a spring, force or torque that a limit leaves standing.
//
// To shorten a vector x to a ball is a projection P, and (P(x) - y).(x - y) >= |P(x) - y|^2 for any
// y in the ball. With y the force of a spring that has itself been shortened to the limit and
// x - y = c v that of its dashpot, (P - y).v >= 0: what the dashpot adds takes energy, never gives
// it. The spring's own shortening takes k spring.(trial - spring) >= 0, both being parallel.
#pragma once

#include "contact/vec3.hpp"

namespace contact {

// min(1, limit/length) for length, limit >= 0 of the same unit; 1 where both are 0.
inline double yield_share(double length, double limit) {
    return length > limit ? limit / length : 1.0;
}

// `a`, shortened to the length `limit` where it is longer.
inline Vec3 clipped(Vec3 a, double limit) { return yield_share(norm(a), limit) * a; }

}  // namespace contact
