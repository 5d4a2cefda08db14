// SPDX-License-Identifier: MIT
// Inside of a step: from positions to the loads of all contacts. Shared by step.cpp and reference_step.cpp.
#pragma once

#include "dem_min/simulation.hpp"

namespace dem_min {

ContactConstants pair_constants(const Simulation&, std::size_t i, std::size_t j);
ContactConstants wall_constants(const Simulation&, std::size_t i);

double potential_of_gravity(const Simulation&, std::size_t grain);  // J, zero at the origin
double kinetic_energy(const Particles&, std::size_t grain);         // J, 0 for a fixed grain
double stored_energy(const Laws&, const Contacts&,
                     std::size_t slot);  // J, elastic, of all springs (ledger on)
Dissipation heat_so_far(const Contacts&, std::size_t slot);  // J, since the birth of the contact

// Motion of a pair, or of a grain and a wall, at the grains' present positions. Their velocities are half a step older, as in
// LAMMPS: what dashpots dissipate is then first order in the step. Velocities extrapolated to the same instant make it second
// order, but halve the damping that a step can bear, and at e = 0.2 a loose heap of soft grains blew up.
inline Motion pair_motion(const Particles& p, std::size_t i, std::size_t j) {
    const Vec3 apart{p.x[j] - p.x[i], p.y[j] - p.y[i], p.z[j] - p.z[i]};
    const double d = contact::norm(apart);
    const Vec3 n = (1.0 / d) * apart;
    const double overlap = (p.radius[i] + p.radius[j]) - d;
    const double lever_i = p.radius[i] - 0.5 * overlap, lever_j = p.radius[j] - 0.5 * overlap;
    const Vec3 spin_i{p.wx[i], p.wy[i], p.wz[i]}, spin_j{p.wx[j], p.wy[j], p.wz[j]};
    const Vec3 relative{p.vx[j] - p.vx[i], p.vy[j] - p.vy[i], p.vz[j] - p.vz[i]};
    const Vec3 slip = contact::tangential_part(relative, n) -
                      contact::cross(lever_i * spin_i + lever_j * spin_j, n);
    return {n, overlap, -contact::dot(relative, n), slip, spin_i, spin_j, lever_i, lever_j};
}

inline Motion wall_motion(const Particles& p, std::size_t i, const WallDistance& wall) {
    const double overlap = p.radius[i] - wall.distance;
    const double lever = p.radius[i] - 0.5 * overlap;
    const Vec3 spin{p.wx[i], p.wy[i], p.wz[i]};
    const Vec3 relative{-p.vx[i], -p.vy[i], -p.vz[i]};
    const Vec3 slip =
        contact::tangential_part(relative, wall.n) - contact::cross(lever * spin, wall.n);
    return {wall.n, overlap, -contact::dot(relative, wall.n), slip, spin, {}, lever, 0.0};
}

// Contacts are worked on in blocks: the motion of a block is gathered first, then its laws are evaluated in one loop without
// branches that the compiler turns into vectors. 64 contacts fit the first-level cache with all that they need.
constexpr int block_size = 64;

struct MotionBlock {  // shape of each: [block_size]
    double nx[block_size], ny[block_size], nz[block_size], overlap[block_size],
        approach_speed[block_size];
    double slip_x[block_size], slip_y[block_size], slip_z[block_size];
    double spin_ix[block_size], spin_iy[block_size], spin_iz[block_size];
    double spin_jx[block_size], spin_jy[block_size], spin_jz[block_size];
    double lever_i[block_size], lever_j[block_size];

    void set(int k, const Motion&);
    Motion get(int k) const {
        return {{nx[k], ny[k], nz[k]},
                overlap[k],
                approach_speed[k],
                {slip_x[k], slip_y[k], slip_z[k]},
                {spin_ix[k], spin_iy[k], spin_iz[k]},
                {spin_jx[k], spin_jy[k], spin_jz[k]},
                lever_i[k],
                lever_j[k]};
    }
};

// Loads and histories of the contacts [first, first + size); size <= block_size.
void load_block(const Laws&, Contacts&, std::size_t first, int size, const MotionBlock&,
                const Settings&);

// First half of a step: half a kick and the drift.
void kick_and_drift(Simulation&);
// Second half: sums the loads of each grain in canonical order, adds gravity, half a kick.
void gather_and_kick(Simulation&);

// Takes out the grains below `lost_below`, with their contacts. Only here do indices change.
void remove_lost(Simulation&);

// Ends contact `slot`: its springs and its hold become heat. `list` may be null (reference step).
void end_contact(Past&, const Laws&, Contacts&, std::size_t slot, CandidateList* list,
                 bool with_ledger);

}  // namespace dem_min
