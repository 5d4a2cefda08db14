// SPDX-License-Identifier: MIT
#include "rigs/stand.hpp"

#include <cmath>

namespace rigs {
namespace {

using contact::Vec3;

// Turns by `angle` about the level axis across the azimuth; plumb up goes away from it.
Vec3 turned(Vec3 p, double angle, double azimuth) {
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    const double along = p.x * c + p.y * s, across = p.y * c - p.x * s;
    const double there = along * std::cos(angle) - p.z * std::sin(angle);
    return {there * c - across * s, there * s + across * c,
            along * std::sin(angle) + p.z * std::cos(angle)};
}

}  // namespace

Vec3 down(const Stand& stand) {
    if (stand.tilt_angle == 0.0) return {0.0, 0.0, -1.0};
    return turned({0.0, 0.0, -1.0}, stand.tilt_angle, stand.tilt_azimuth);
}

Vec3 in_room(const Stand& stand, Vec3 p, double t) {
    if (stand.shaking.acts()) p.z += stand.shaking.height(t);
    return stand.tilt_angle == 0.0 ? p : turned(p, -stand.tilt_angle, stand.tilt_azimuth);
}

Vec3 on_base(const Stand& stand, Vec3 p, double t) {
    if (stand.tilt_angle != 0.0) p = turned(p, stand.tilt_angle, stand.tilt_azimuth);
    if (stand.shaking.acts()) p.z -= stand.shaking.height(t);
    return p;
}

}  // namespace rigs
