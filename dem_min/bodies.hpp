// SPDX-License-Identifier: MIT
// Rigid bodies made of spheres of the core: clumps. The spheres, a body's members, are grains like all others to the lists, the
// contacts and their histories, but they neither weigh anything nor move by themselves: the body has the mass, sums their loads, in the
// order of its members, and carries them with it. Members of one body never touch one another.
//
// A body moves by kick, drift, forces, kick as grains do, with its angular momentum L about its centre kept in space:
//   L += dt/2 T;   the body turns freely for dt;   loads at the new places, with the velocities that L gives there;   L += dt/2 T
// The free turn is composed of turns about fixed axes, each exact and keeping L (Dullweber, Leimkuhler & McLachlan 1997,
// J. Chem. Phys. 107, 5840, doi:10.1063/1.474310):
//   L^2/(2 I_k)  splits into  |L|^2/(2 I_1)  +  (1/I_2 - 1/I_1) L_2^2/2  +  (1/I_3 - 1/I_1) L_3^2/2
// the first about L, by |L| dt/I_1; the others about the body's own axes, 2 for half of dt, 3 for dt, 2 for half of dt. A body with
// I_1 = I_2 turns exactly, any other to second order, reversibly. L is kept to round-off.
#pragma once

#include "contact/vec3.hpp"

#include <cstdint>
#include <vector>

namespace dem_min {

using contact::Vec3;

struct Simulation;

// A turn, of unit length: (cos(angle/2), sin(angle/2) axis).
struct Quaternion {
    double w = 1.0, x = 0.0, y = 0.0, z = 0.0;
};

Vec3 turned(const Quaternion&, Vec3);       // from the body's axes to space
Vec3 turned_back(const Quaternion&, Vec3);  // from space to the body's axes
// The shortest turn that takes the z axis to the unit vector `axis`.
Quaternion turn_to(Vec3 axis);
// How a body with angular momentum L turns within dt without torque. 1/(kg m^2), about its axes.
Quaternion free_turn(const Quaternion&, Vec3 angular_momentum, Vec3 inverse_inertia, double dt);

struct Ball {
    Vec3 place;     // m
    double radius;  // m
};

// What a body is made of: its spheres in its principal axes, places from its centre of mass.
struct Clump {
    std::vector<Ball> balls;
    double mass;   // kg
    Vec3 inertia;  // kg m^2, principal moments about the centre of mass
};

// How it comes into the world.
struct Birth {
    Vec3 centre;      // m
    Quaternion turn;  // from its principal axes to space
    Vec3 velocity;    // m/s
    Vec3 spin;        // rad/s, in space
    int material = 0;
};

struct Body {
    Vec3 centre;            // m
    Vec3 velocity;          // m/s
    Vec3 angular_momentum;  // kg m^2/s, about the centre, in space
    Quaternion turn;        // from its principal axes to space
    Vec3 force, torque;     // N, N m, weight included
    double mass;            // kg
    Vec3 inverse_inertia;   // 1/(kg m^2), principal
    std::int64_t first;     // its members: Simulation::members[first .. first + count)
    std::int64_t count;

    Vec3 spin() const;  // rad/s, in space
};

struct Member {
    std::int64_t grain;
    Vec3 place;  // m, as Ball::place
};

// Adds a body and its members; gravity acts on it from this instant. Throws scaling::InvalidParameter for a clump without balls or
// whose mass and moments are not > 0.
void insert(Simulation&, const Clump&, const Birth&);

double kinetic_energy(const Body&);                           // J
double potential_of_gravity(const Simulation&, const Body&);  // J, zero at the origin

// kg: a grain's own, or the part of its body's that falls to a member by its volume.
double mass_of(const Simulation&, std::size_t grain);

// Before the drift of the grains: half a kick and the free turn. Members get the velocity of the chord from where they are to where
// they will be, so that their tile sees how far they come.
void begin_bodies(Simulation&);
// After it: members stand where the body has them, with its velocity there.
void place_members(Simulation&);
// After the second half of the grains' step: loads of members, weight, half a kick.
void end_bodies(Simulation&);

// Which bodies' centres are below `lost_below`. Shape: [bodies].
std::vector<bool> lost_bodies(const Simulation&);
// Follows Particles::renumber: members that went take their bodies with them.
void renumber_bodies(Simulation&, const std::vector<int>& new_index);
// Throws scaling::InvalidParameter where tiles may sleep and there are bodies.
void refuse_sleep_of_bodies(const Simulation&);

}  // namespace dem_min
