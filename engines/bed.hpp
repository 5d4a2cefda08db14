// SPDX-License-Identifier: MIT
// The bed on which the core is timed against other engines: equal spheres on a cubic lattice,
// nearly touching, that a tilted gravity compacts and shears; periodic in x and y, on a plane at
// z = 0.
#pragma once

#include "contact/vec3.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace engines {

struct Bed {
    int nx = 30, ny = 30, nz = 50;
    double radius = 120e-6;  // m
    double density = 5600;   // kg/m^3
    double spacing = 2.002;  // of the lattice, radii
    double jitter = 1e-7;    // m, each coordinate is moved by up to this, so that no two are alike
    std::uint64_t seed = 4711;
    double gravity = 9.81;                   // m/s^2
    contact::Vec3 downward{0.3, 0.0, -1.0};  // not normalised
    double youngs_modulus = 156e6;           // Pa, of grains and wall
    double poisson_ratio = 0.3;              // likewise
    double surface_energy = 0.19;            // J/m^2; the work of adhesion is twice that
    double restitution = 0.368;              // 1
    double sliding_friction = 0.8;           // 1
    double rolling_stiffness = 500.0;        // N/m, SDS
    double rolling_damping = 1e-5;           // kg/s
    double rolling_friction = 0.225;         // 1
    double wall_restitution = 0.291, wall_friction = 0.45;  // 1; no adhesion, no rolling resistance
    double time_step = 7.78e-7;                             // s
    double margin = 24e-6;                                  // m, of every engine's neighbour list
    int warm_up = 3000, steps = 2000;                       // only the latter are timed

    int grains() const { return nx * ny * nz; }
    double lattice() const { return spacing * radius; }  // m
    double period_x() const { return nx * lattice(); }   // m
    double period_y() const { return ny * lattice(); }   // m
    double height() const {
        return nz * lattice() + 10.0 * radius;
    }                                    // m, of the box for engines that want one
    contact::Vec3 acceleration() const;  // m/s^2
};

// x runs fastest, then y, then z. The same for every engine, to the last bit. m
std::vector<contact::Vec3> positions(const Bed&);

// The positions as LAMMPS and LIGGGHTS read them (read_data, atom_style sphere or granular, units
// si), with the digits that give the same double again. LIGGGHTS wants a type for the wall: two.
std::string positions_data(const Bed&, int types);

// What an engine did on the bed.
struct BedFigures {
    double seconds = 0.0;         // wall time of the timed steps
    std::int64_t grains = 0;      // at the end
    double neighbours = 0.0;      // overlapping grains per grain, at the end
    double kinetic_energy = 0.0;  // J, at the end, spin included
    std::string version;

    double grain_steps_per_second(const Bed& bed) const {
        return bed.grains() * static_cast<double>(bed.steps) / seconds;
    }
};

// Overlapping grains per grain, counted from positions alone, as `compute contact/atom` of LAMMPS
// does: a JKR contact that is stretched past its touching distance is not among them, nor a wall.
double overlapping_neighbours(const Bed&, const std::vector<contact::Vec3>& positions);

}  // namespace engines
