// SPDX-License-Identifier: MIT
// A simulation is plain data and a few free functions. Between two calls of `step` or `advance` positions and velocities belong
// to the same instant. All numbers SI.
#pragma once

#include "dem_min/bodies.hpp"
#include "dem_min/contacts.hpp"
#include "dem_min/interaction.hpp"
#include "dem_min/particles.hpp"
#include "dem_min/surroundings.hpp"
#include "dem_min/tiles.hpp"
#include "dem_min/walls.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dem_min {

struct Settings {
    double time_step = 0.0;  // s
    // m, usual margin of the neighbour list, >= 0. Tiles at rest take less and fast ones more; no bit depends on it.
    double skin = 0.0;
    Vec3 gravity;  // m/s^2
    Fluid fluid = {};
    Shaking shaking = {};
    double lost_below =
        0.0;  // m: a grain or a body whose centre sinks below this z has left and is taken out
    int threads = 1;               // at most
    int grains_per_thread = 1000;  // with fewer, threads wait for one another longer than they work
    bool ledger = false;           // keep the energy ledger
    // m, the box repeats itself with these periods in x and y; 0: open. Positions are not folded back.
    double period_x = 0.0, period_y = 0.0;
    // Tiles whose grains have been slower than both for `steps_to_sleep`, and that meet none which is faster, are left out until
    // one is (core.md, Sleep); 0: never. It changes the result a little, and what goes on from a checkpoint may then differ in its last digits.
    double sleep_speed = 0.0, sleep_spin = 0.0;  // m/s, rad/s
};

// Sums over everything that no longer exists: ended contacts and grains that have left.
struct Past {
    Dissipation heat;  // J, of contacts that have ended, springs that were still loaded included
    double wall_work = 0.0;     // J, of moving walls on grains of tiles that are no more
    double shaking_work = 0.0;  // J, of a shaking frame, by its inertial force and the wind in it
    double kinetic_in = 0.0;    // J, of grains at their birth
    double potential_in = 0.0;  // J, likewise, in gravity and buoyancy, zero at the origin
    double carried_away =
        0.0;  // J, kinetic and elastic, by grains that have left; kinetic, of those put to sleep
    double potential_out = 0.0;    // J, in gravity, of grains when they left
    std::int64_t grains_lost = 0;  // a body counts as one
    std::int64_t grain_steps = 0,
                 grain_steps_slept = 0;  // all, and those left out by sleeping tiles
};

// Laws of one pair of materials, where they differ from those of all others.
struct ParticularLaws {
    int material;
    int partner;  // the other material; at a wall the wall's
    bool at_wall;
    Laws laws;
};

struct Simulation {
    Settings settings;
    Laws between_grains, at_walls;
    std::vector<ParticularLaws> particular;
    std::vector<Wall> walls;
    std::vector<int> wall_material;  // [walls], or empty: all 0
    Particles grains;
    std::vector<Body> bodies;     // that some of the grains are members of
    std::vector<Member> members;  // body by body
    std::vector<Tile> tiles;
    std::vector<int>
        shares;  // [team + 1] tiles at which the share of each thread begins; made with the list
    std::vector<Spare> spare;   // [team]
    bool list_is_stale = true;  // grains were added, taken out or moved by hand
    // m/s, of the frame in which the tiles count their ways: grains that move together do not come closer. Any would do.
    Vec3 frame;
    Past past;
    std::int64_t steps = 0;
    std::int64_t births = 0;  // the next grain's id

    // Contacts stand in groups of one set of laws each: 0 between grains, 1 at walls, 2... particular ones.
    std::size_t groups() const { return 2 + particular.size(); }
    bool at_wall(std::size_t group) const {
        return group == 1 || (group > 1 && particular[group - 2].at_wall);
    }
    const Laws& laws(std::size_t group) const {
        return group == 0 ? between_grains : group == 1 ? at_walls : particular[group - 2].laws;
    }

    // Threads that this many grains are worth. The bits do not depend on it.
    int team() const {
        return std::clamp(static_cast<int>(grains.count()) / settings.grains_per_thread, 1,
                          settings.threads);
    }
    double time() const { return static_cast<double>(steps) * settings.time_step; }
};

// Adds a grain; gravity acts on it from this instant. Cheap for one, linear in the grains at the next step.
void insert(Simulation&, const Grain&);

// Velocity Verlet steps. The bits depend neither on the number of threads nor on how many steps are taken at a time.
void advance(Simulation&, std::int64_t steps);
void step(Simulation&);

// The same step, slow and obvious: all pairs, in order, no list, one thread. Gives the same bits as `step`.
void reference_step(Simulation&);

// Throws std::runtime_error naming the grain, its place and the step if any position, velocity or force is not finite.
void check_finite(const Simulation&);

std::size_t pair_count(const Simulation&);
std::size_t wall_contact_count(const Simulation&);

// Calls visit(group, contacts, slot) for each contact, tile by tile.
template <class Visit>
void for_each_contact(const Simulation& s, Visit&& visit) {
    for (const Tile& tile : s.tiles)
        for (std::size_t group = 0; group < tile.groups.size(); ++group)
            for (std::size_t slot = 0; slot < tile.groups[group].count(); ++slot)
                visit(group, tile.groups[group], slot);
}

// Where the energy is, J, as seen from the frame of the places. What came in (work of gravity, buoyancy included, of moving walls and of a
// shaking frame, kinetic energy at birth) less what is there or has left or has become heat is the imbalance: zero but for the error of the step.
struct Ledger {
    double kinetic = 0.0, elastic_normal = 0.0, elastic_tangential = 0.0, elastic_rolling = 0.0;
    Dissipation heat;
    double gravity_work = 0.0, wall_work = 0.0, shaking_work = 0.0, brought_in = 0.0,
           carried_away = 0.0;
    double imbalance() const;
};
Ledger ledger(const Simulation&);  // settings.ledger must have been on from the start

double kinetic_energy(
    const Simulation&);  // J, of all grains that are not fixed and of bodies, spin included
double translational_energy(const Simulation&);  // J, likewise, without spin
// Loose grains that are no members, and bodies.
std::size_t loose_count(const Simulation&);
// Contacts per loose grain or body, with grains, base and walls; two clumps may touch at several points, each of which counts.
double mean_coordination(const Simulation&);
double largest_overlap(const Simulation&);  // 1, overlap over R* of the deepest contact; 0 without
// N, mean over all contacts between grains of the elastic normal force, tension counted as 0; 0 without contacts.
double mean_compression(const Simulation&);

// What the simulation keeps in memory, bytes.
struct MemoryUse {
    std::size_t bytes_grains, bytes_contacts, bytes_lists;
};
MemoryUse memory_use(const Simulation&);

// What a step must read and write at least, each array once, bytes: positions, velocities, spins and histories both ways,
// constants and lists one way. What fits the cache, loads and outboxes, is not in it, nor are arrays that a step leaves alone.
std::size_t bytes_moved(const Simulation&);

// Hash of positions, velocities, spins, springs and contact radii, in the order of memory, all in multiples of the units
// given: two runs that are one another's image under a scaling by powers of two have the same hash in their own units.
std::uint64_t state_hash(const Simulation&, double unit_of_length = 1.0, double unit_of_time = 1.0);

}  // namespace dem_min
