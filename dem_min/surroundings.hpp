// SPDX-License-Identifier: MIT
// What acts on grains from afar: their weight, a fluid at rest in the room, and the motion of the frame in which all places are
// told. That frame may shake along z with a base: walls and glued grains then stand still, and every grain has the inertial
// force -m a(t) of the frame. SI.
#pragma once

#include "contact/drag_schiller1935.hpp"
#include "contact/vec3.hpp"

#include <cmath>

namespace dem_min {

using contact::Vec3;

struct Fluid {
    contact::DragSchiller1935 drag{0.0, 0.0, 0.0};
    double lifting_density = 0.0;  // kg/m^3, of the fluid where it buoys grains up; 0: it does not
    bool acts() const { return drag.factor > 0.0 || lifting_density > 0.0; }
};

// The frame is at A sin(omega t + phase) above its mean.
struct Shaking {
    double amplitude = 0.0, omega = 0.0, phase = 0.0;  // m, rad/s, rad
    bool acts() const { return amplitude > 0.0 && omega > 0.0; }
    double height(double t) const { return amplitude * std::sin(omega * t + phase); }
    double velocity(double t) const { return amplitude * omega * std::cos(omega * t + phase); }
    double acceleration(double t) const { return -omega * omega * height(t); }
};

// Of one instant, the same for all grains.
struct Field {
    Vec3 per_mass;    // m/s^2, weight and inertia
    Vec3 per_volume;  // N/m^3, buoyancy
    Vec3 wind;        // m/s, of the fluid, as seen from the frame
};

struct Settings;
Field field_at(const Settings&, double t);

}  // namespace dem_min
