// SPDX-License-Identifier: MIT
// Grains are worked on in tiles: `tile_size` neighbours in memory, which are neighbours in space too after `reorder`. A tile
// owns the contacts whose grain i is its own, and finds, evaluates and ends them without asking another tile.
//
// The sum of the loads on a grain has one order, whatever the number of threads and whichever list found the contacts:
// contacts of its own tile (group by group, slot by slot), those that other tiles own (by tile and slot), gravity.
#pragma once

#include "dem_min/contacts.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace dem_min {

struct Simulation;

constexpr int tile_size =
    1024;  // grains; the state of a tile fits the second-level cache, with its contacts

inline int tile_of(int grain) { return grain / tile_size; }

// Pairs that do not touch but may soon. `due` is a sum of ways: as long as the two tiles together have come less far since
// the list was made, the pair cannot touch, and nobody looks.
struct Candidates {
    std::vector<int> i, j;  // i < j; at a wall j is the wall
    Array due;              // m
    std::size_t count() const { return i.size(); }
    void add(int grain_i, int partner_j, double when);
    void remove(std::size_t index);  // the last one takes the place
    void clear();
};

// Four numbers side by side, which a processor adds at once.
using Four [[gnu::vector_size(4 * sizeof(double))]] = double;

// What loads a grain: x, y, z and a fourth place that stays 0. One cache line, where six arrays would be six. Aligned by itself:
// what the compiler takes for the alignment of Four moves with the set of instructions.
struct alignas(64) Load {
    Four force, torque;  // N, N m
};

// Loads of contacts on grains of other tiles. Shape of both: [such contacts].
struct Outbox {
    std::vector<Load> loads;
    std::vector<int> to;  // grain
};

// Where a tile finds such a load, and the place in this tile of the grain that it is for.
struct Incoming {
    int tile, index, place;
};

// Memory of one thread for what lives within a step only: a tile takes it when it is loaded and gives it back when it is
// finished, some tiles later, so that a few pieces that stay in the cache serve all tiles.
struct Spare {
    std::vector<std::vector<Load>> loads;
    std::vector<std::vector<Load>> outboxes;
};

struct Tile {
    std::vector<Contacts> groups;  // [groups of laws], see Simulation
    Dissipation ended;             // J, by contacts of this tile that have ended (ledger on)
    double wall_work = 0.0;        // J, of moving walls on grains of this tile (ledger on)

    // The list, made anew by find_neighbours.
    Candidates near_grains, near_walls;
    std::vector<int> due;  // those of near_grains that are looked at in this step
    double margin = 0.0,
           margin_to_walls = 0.0;  // m: the list holds while no grain of the tile has come farther
    // No grain of the tile has come farther since the list was made, m: as seen from Simulation::frame, and from the walls.
    double way = 0.0, way_from_walls = 0.0;
    double rounding =
        0.0;  // m: by which the sum of a position and its way may be rounded, in one step
    std::vector<int>
        partners;  // other tiles that this one has candidates or contacts with, on either side

    std::vector<std::pair<int, int>>
        handed_over;  // candidates of another tile: a contact turned round by `reorder` ended
    bool lost = false, bad = false;            // of the last drift: see Drift
    bool finished = false;                     // its grains have had the second half of this step
    Vec3 sum_of_velocities;                    // m/s, likewise
    double fastest = 0.0, fastest_spin = 0.0;  // m/s, rad/s, likewise
    int quiet_steps = 0;                       // in a row, see Settings::sleep_speed
    bool asleep = false;                       // its grains are held
    bool left_out = false;  // and so are those of all its partners: nothing is done for it

    std::vector<Load>
        loads;  // of each grain, from load_tile to the second half of the step; else none
    Outbox outbox;
    bool slots_have_moved = false;  // a contact has ended: the next outbox has another order
    std::vector<Incoming> inbox;
    std::vector<std::uint64_t> inbox_of;  // outbox_changes of `partners` when the inbox was made
    std::uint64_t outbox_changes = 1;     // raised when a contact of the tile begins or ends

    std::size_t contacts() const;
};

// As many tiles as the grains need.
void fit_tiles(Simulation&);

// Moves grain k to new_index[k] (a permutation, or -1: taken out, contacts and all), and each contact to the tile of its
// grain i. Shape: [grains]. The order of slots follows that of the old tiles or, `by_grain`, that of the grains, so that what a
// loop needs next lies next to what it has just had.
void renumber(Simulation&, const std::vector<int>& new_index, bool by_grain = false);

// Grains that are near in space become near in memory, see `places` in tiles.cpp, and contacts are sorted by their grains. Does
// nothing where all grains fit one tile.
void reorder(Simulation&);

constexpr int steps_to_sleep = 64;  // a grain that turns back is slow for a few steps only

constexpr std::int64_t reorder_interval = 1024;  // steps

}  // namespace dem_min
