// SPDX-License-Identifier: MIT
// Rigid walls at rest. Two shapes serve every rig: a plane, and a thin shell of revolution about the z axis whose
// generating line is a segment in the (r, z) half-plane: a disc (0, 0)-(R, 0), a tube (R, z0)-(R, z1), a cone or a funnel
// (r0, z0)-(r1, z1). A shell is felt from both sides and at its rim.
#pragma once

#include "contact/vec3.hpp"

#include <variant>
#include <vector>

namespace dem_min {

using contact::Vec3;

struct Plane {
    Vec3 point;   // m
    Vec3 normal;  // unit, into the room where grains are
};

struct Shell {
    double r0, z0, r1, z1;  // m, ends of the generating segment, r >= 0
};

using Wall = std::variant<Plane, Shell>;

Wall disc(double radius, double z);
Wall tube(double radius, double z_bottom, double z_top);
Wall cone(double radius_bottom, double z_bottom, double radius_top, double z_top);

// The way from a point to the nearest point of the wall.
struct WallDistance {
    double distance;  // m; for a plane negative behind it
    Vec3 n;           // unit, from the point to the wall
};
WallDistance distance(const Wall&, Vec3 point);

}  // namespace dem_min
