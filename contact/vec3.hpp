// SPDX-License-Identifier: MIT
// Three doubles and the few operations that a contact law needs; plain enough for a loop of
// contacts to become vectors.
#pragma once

#include <cmath>

namespace contact {

struct Vec3 {
    double x = 0.0, y = 0.0, z = 0.0;
    friend bool operator==(const Vec3&, const Vec3&) = default;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Vec3 a) { return std::sqrt(dot(a, a)); }

// The part of `a` in the plane normal to the unit vector `n`.
inline Vec3 tangential_part(Vec3 a, Vec3 n) { return a - dot(a, n) * n; }

// `a` turned into the plane normal to `n`, its length kept: how a spring follows its contact as the
// pair turns. With x the square of the sine of that turn, |a|^2 x = (a.n)^2, the part of a in the
// plane is too short by sqrt(1 - x), and 1/sqrt(1 - x) = 1 + x/2 + 3 x^2/8 + 5 x^3/16 + ...: within
// 3e-9 for a turn by a tenth of a radian in one step. A spring along n, which has no direction left
// in that plane, becomes zero.
inline Vec3 turned_into_plane(Vec3 a, Vec3 n) {
    const double along = dot(a, n), square = dot(a, a);
    const double x = square > 0.0 ? along * along / square : 0.0;
    const double stretch = 1.0 + x * (0.5 + x * (0.375 + 0.3125 * x));
    return stretch * (a - along * n);
}

}  // namespace contact
