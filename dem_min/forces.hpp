// SPDX-License-Identifier: MIT
// Inside of a step: from positions to the loads of all contacts. Shared by step.cpp and reference_step.cpp.
#pragma once

#include "dem_min/simulation.hpp"

#include <limits>
#include <numbers>

namespace dem_min {

// The way from grain i to grain j, m; the shortest one where the box repeats itself.
inline double nearest_image(double way, double period, double inverse_period) {
    const double half = way < 0.0 ? -0.5 : 0.5;
    return way - period * static_cast<double>(static_cast<int>(way * inverse_period + half));
}
inline Vec3 apart(const Simulation& s, std::size_t i, std::size_t j) {
    const Particles& p = s.grains;
    Vec3 way{p.x[j] - p.x[i], p.y[j] - p.y[i], p.z[j] - p.z[i]};
    const double lx = s.settings.period_x, ly = s.settings.period_y;
    if (lx > 0.0) way.x = nearest_image(way.x, lx, 1.0 / lx);
    if (ly > 0.0) way.y = nearest_image(way.y, ly, 1.0 / ly);
    return way;
}

std::size_t group_of_pair(const Simulation&, std::size_t i, std::size_t j);
std::size_t group_of_wall(const Simulation&, std::size_t i, std::size_t wall);
ContactConstants pair_constants(const Simulation&, const Laws&, std::size_t i, std::size_t j);
ContactConstants wall_constants(const Simulation&, const Laws&, std::size_t i);

// dem_min/surroundings.cpp: N on a grain at this instant, weight, inertia, buoyancy and drag; m^3; and half a step's share of what the
// ledger keeps of them, before a step and after it.
Vec3 from_afar(const Simulation&, std::size_t grain);
inline double volume_of(double radius) {
    return (4.0 / 3.0 * std::numbers::pi) * (radius * radius * radius);
}
bool has_books_from_afar(const Simulation&);
void keep_books_from_afar(Simulation&);

double potential_of_gravity(const Simulation&,
                            std::size_t grain);  // J, buoyancy included, zero at the origin
double kinetic_energy(const Particles&, std::size_t grain);  // J, 0 for a fixed grain
double stored_energy(const Laws&, const Contacts&,
                     std::size_t slot);  // J, elastic, of all springs (ledger on)
Dissipation heat_so_far(const Contacts&, std::size_t slot);  // J, since the birth of the contact
Dissipation heat_of_end(const Laws&, const Contacts&,
                        std::size_t slot);  // J, all that it leaves behind

// Contacts are worked on in blocks: what they need of their grains is gathered first, then their laws are evaluated in loops
// without branches that the compiler turns into vectors. 64 contacts fit the first-level cache with all that they need.
constexpr int block_size = 64;

// What a block needs of the memory is asked for while the block before it is worked on: partners j while that one is gathered (their
// grains i have been partners before), histories while it is added up, a line of each array for this many contacts at a time. All
// asked for at once would fill the processor's list of misses, and the loop behind would wait for it.
constexpr int asked_at_a_time = 8;

// The overlap of a contact that a mesh has handed from one patch to another (mesh.hpp): it ends, but nothing tears.
constexpr double handed_over = -std::numeric_limits<double>::infinity();

struct Block {  // shape of each: [block_size]
    double nx[block_size], ny[block_size],
        nz[block_size];           // m, from i to j; `aim` makes it a unit vector
    double distance[block_size];  // m
    double ux[block_size], uy[block_size], uz[block_size];  // m/s, v_j - v_i
    double ix[block_size], iy[block_size], iz[block_size];  // rad/s, spin of i
    double jx[block_size], jy[block_size], jz[block_size];  // rad/s, spin of j
    double r_i[block_size], r_j[block_size];                // m; not filled where all are alike
    double inverse_inertia_i[block_size], inverse_inertia_j[block_size];  // 1/(kg m^2); likewise
    // In between: what one stage leaves for the next.
    double elastic_force[block_size], contact_radius[block_size], cap_force[block_size];  // N, m, N
    double qx[block_size], qy[block_size], qz[block_size];  // N, friction on j
    // Histories, as they will be.
    double sx[block_size], sy[block_size], sz[block_size], rx[block_size], ry[block_size],
        rz[block_size], twist[block_size];
    double slid[block_size];  // see contact::StuckSlider
    // What comes out.
    double fx[block_size], fy[block_size], fz[block_size];     // N, on j
    double tix[block_size], tiy[block_size], tiz[block_size];  // N m
    double tjx[block_size], tjy[block_size], tjz[block_size];
    double hold[block_size];  // m, overlap less that of tear-off: below 0 the contact has ended
};

// Fills the block with the motion of contacts [first, first + size) of a group; size <= block_size. Velocities are half a step
// old. Extrapolated to the time of the force they would make dashpots second order, but halve the damping that a step can bear,
// and at e = 0.2 a loose heap of soft grains blew up.
void gather_pairs(const Simulation&, const Contacts&, std::size_t first, int size, Block&);
void gather_walls(const Simulation&, const Contacts&, std::size_t first, int size, Block&);

// Loads and histories of those contacts.
void load_block(const Laws&, Contacts&, std::size_t first, int size, Block&, const Settings&);

// What one tile does before it loads its contacts, and after.
void begin_pair(Simulation&, std::size_t i, std::size_t j);
void begin_wall_contact(Simulation&, std::size_t i, std::size_t wall);

std::size_t first_of(std::size_t tile);  // grain
int grains_of(const Simulation&, std::size_t tile);

// First half of a step for the grains of a tile: half a kick and the drift.
struct Drift {
    double fastest, fastest_in_frame;  // m/s, the latter against Simulation::frame
    double fastest_spin;               // rad/s
    bool lost, bad;  // some grain is below `lost_below`; some velocity is infinite or no number
    Vec3 sum_of_velocities;  // m/s
};
Drift begin_step(Simulation&, std::size_t tile);
// Second half: Tile::loads, those that other tiles hold for it, weight, half a kick.
void end_step(Simulation&, std::size_t tile);
// Both, of one step and of the next, in one walk over the grains.
Drift end_and_begin_step(Simulation&, std::size_t tile);

// Walls that move, and what a step does to them: each comes on by its way, and the tiles' ways from walls grow by the longest.
std::vector<Wall*> moving_walls(Simulation&);
void move_walls(Simulation&, const std::vector<Wall*>& moving);

// J, half a step's work of moving walls on the grains of these contacts, with the forces that stand in their books.
double half_step_work_of_walls(const Simulation&, const Contacts&);

// Takes out the grains below `lost_below`, with their contacts.
void remove_lost(Simulation&);
// What both steps do now and then: see reorder_interval.
bool time_to_reorder(const Simulation&);

}  // namespace dem_min
