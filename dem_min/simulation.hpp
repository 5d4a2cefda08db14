// SPDX-License-Identifier: MIT
// A simulation is plain data and a few free functions. Between two calls of `step` positions and velocities belong to the
// same instant. All numbers SI.
#pragma once

#include "dem_min/contacts.hpp"
#include "dem_min/interaction.hpp"
#include "dem_min/neighbours.hpp"
#include "dem_min/particles.hpp"
#include "dem_min/walls.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dem_min {

struct Settings {
    double time_step = 0.0;  // s
    double skin =
        0.0;  // m, margin of the neighbour list: it is made anew once a grain has moved half of it
    Vec3 gravity;  // m/s^2
    double lost_below =
        0.0;          // m: a grain whose centre sinks below this z has left and is taken out
    int threads = 1;  // at most
    int grains_per_thread = 1000;  // with fewer, threads wait for one another longer than they work
    bool ledger = false;           // keep the energy ledger (costs some 10 % of a step)
};

// Sums over everything that no longer exists: ended contacts and grains that have left.
struct Past {
    Dissipation heat;  // J, of contacts that have ended, springs that were still loaded included
    double kinetic_in = 0.0;     // J, of grains at their birth
    double potential_in = 0.0;   // J, likewise, in gravity, zero at the origin
    double carried_away = 0.0;   // J, kinetic and elastic, by grains that have left
    double potential_out = 0.0;  // J, in gravity, of grains when they left
    std::int64_t grains_lost = 0;
};

struct Simulation {
    Settings settings;
    Laws between_grains, at_walls;
    std::vector<Wall> walls;
    Particles grains;
    Contacts pairs, wall_contacts;
    Neighbours neighbours;
    Past past;
    std::int64_t steps = 0;
    std::int64_t births = 0;  // the next grain's id

    // Threads that this many grains are worth. The bits do not depend on it.
    int team() const {
        return std::clamp(static_cast<int>(grains.count()) / settings.grains_per_thread, 1,
                          settings.threads);
    }
    double time() const { return static_cast<double>(steps) * settings.time_step; }
};

// Adds a grain; gravity acts on it from this instant. Cheap for one, linear in the grains at the next step.
void insert(Simulation&, const Grain&);

// One velocity Verlet step. The bits do not depend on the number of threads.
void step(Simulation&);

// The same step, slow and obvious: all pairs, in order, no list, one thread. Gives the same bits as `step`.
void reference_step(Simulation&);

// Throws std::runtime_error naming the grain, its place and the step if any position, velocity or force is not finite.
void check_finite(const Simulation&);

// Where the energy is, J. What came in (work of gravity, kinetic energy at birth) less what is there or has left or has
// become heat is the imbalance: zero but for the error of the step.
struct Ledger {
    double kinetic = 0.0, elastic_normal = 0.0, elastic_tangential = 0.0, elastic_rolling = 0.0;
    Dissipation heat;
    double gravity_work = 0.0, brought_in = 0.0, carried_away = 0.0;
    double imbalance() const;
};
Ledger ledger(const Simulation&);  // settings.ledger must have been on from the start

double kinetic_energy(const Simulation&);  // J, of all grains that are not fixed, spin included
double translational_energy(const Simulation&);  // J, likewise, without spin
double mean_coordination(
    const Simulation&);  // contacts per loose grain, with grains, base and walls

// Hash of positions, velocities, spins, springs and contact radii, contacts in canonical order, all in multiples of the units
// given: two runs that are one another's image under a scaling by powers of two have the same hash in their own units.
std::uint64_t state_hash(const Simulation&, double unit_of_length = 1.0, double unit_of_time = 1.0);

}  // namespace dem_min
