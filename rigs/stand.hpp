// SPDX-License-Identifier: MIT
// How a base stands in the room: tilted against gravity, shaking along its own z. Places of a rig are told on the base: z its
// normal, 0 on it, azimuth in its plane. In the room z is plumb; both have the centre of the base's mean place as their origin.
#pragma once

#include "contact/vec3.hpp"
#include "dem_min/surroundings.hpp"

namespace rigs {

struct Stand {
    // rad: gravity points by the angle away from the base's -z, towards the azimuth. Downhill is there.
    double tilt_angle = 0.0, tilt_azimuth = 0.0;
    dem_min::Shaking shaking = {};
};

contact::Vec3 down(const Stand&);  // unit, gravity as seen from the base

// A place on the base at time t as it is in the room, and back.
contact::Vec3 in_room(const Stand&, contact::Vec3 on_base, double t);
contact::Vec3 on_base(const Stand&, contact::Vec3 in_room, double t);

}  // namespace rigs
