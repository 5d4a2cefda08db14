// SPDX-License-Identifier: MIT
// Rigid walls. Three shapes serve every rig: a plane; a thin shell of revolution about the z axis whose generating
// line is a segment in the (r, z) half-plane: a disc (0, 0)-(R, 0), a tube (R, z0)-(R, z1), a cone or a funnel
// (r0, z0)-(r1, z1); and a smooth patch of a mesh of triangles (dem_min/mesh.hpp). Shells and patches are felt from both sides
// and at their rims. A plane may move; a shell may rise along its axis and spin about it.
#pragma once

#include "contact/vec3.hpp"

#include <memory>
#include <variant>
#include <vector>

namespace dem_min {

using contact::Vec3;

struct Plane {
    Vec3 point;   // m
    Vec3 normal;  // unit, into the room where grains are
    // m/s, kept until the caller gives another; a step carries `point` along. Infinite mass: no force slows it.
    Vec3 velocity = {};
};

struct Shell {
    double r0, z0, r1, z1;  // m, ends of the generating segment, r >= 0
    // Kept until the caller gives others, by whatever force: m/s along the axis, which a step carries z0 and z1 along by; rad/s about
    // it, right-handed, which drags at grains and changes no shape.
    double rise = 0.0, spin = 0.0;
};

struct Mesh;  // dem_min/mesh.hpp

struct MeshPatch {
    std::shared_ptr<const Mesh> mesh;
    int patch;  // in the mesh
};

using Wall = std::variant<Plane, Shell, MeshPatch>;

Wall disc(double radius, double z);
Wall tube(double radius, double z_bottom, double z_top);
Wall cone(double radius_bottom, double z_bottom, double radius_top, double z_top);

// The way from a point to the nearest point of the wall.
struct WallDistance {
    double
        distance;  // m; for a plane negative behind it, for a patch infinite where another patch answers
    Vec3 n;        // unit, from the point to the wall
};
WallDistance distance(const Wall&, Vec3 point);

// The same distance in m, but of the shape alone, whichever patch answers: at most `distance`. Who may soon touch is asked by
// this, because a grain that rolls over a sharp edge is handed from one patch to the next at full overlap.
double clearance(const Wall&, Vec3 point);

Vec3 velocity(const Wall&, Vec3 point);  // m/s, of the wall's matter at that point
Vec3 spin(const Wall&);                  // rad/s
bool moves(const Wall&);                 // or spins

// The wall after `time` of its motion. Returns the way of its shape, m.
double carry_on(Wall&, double time);

// Along the axes; infinite for a plane.
struct Box {
    Vec3 low, high;  // m
};
Box bounds(const Wall&);

}  // namespace dem_min
