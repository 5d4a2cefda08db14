// SPDX-License-Identifier: MIT
// The feed of a pile for engines that read grains in batches: the very grains, places and instants of a setup, each where it would
// by then have fallen to, with the speed that it would have.
#pragma once

#include "engines/deck.hpp"
#include "engines/lammps_files.hpp"
#include "rigs/pile.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace engines {

constexpr int rest_check_interval = 100;                               // steps, as in rigs/pile.cpp
constexpr double at_rest_below = 1e-6;                                 // of m g d, likewise
constexpr const char* ours = "leave the option out: dem_min runs it";  // a remedy

// Grains that are read together: `first` to `last`, `last` included, at the step at which `last` is due.
struct FeedBatch {
    std::size_t first, last;
    std::int64_t step;
};

// A batch is closed before its first grain has fallen d/2.
std::vector<FeedBatch> feed_batches(const rigs::PileSetup&);

// Heights at which grains appear over a heap that is below its feed, m: the lowest at which a grain is clear of those still in
// flight, both when it appears and when its batch is read.
std::vector<double> feed_heights(const rigs::PileSetup&, const std::vector<FeedBatch>&);

// The grains of a batch at the step at which it is read, over such a heap, `lift` higher in the room (m), as seen from the base.
std::vector<dem_min::Grain> batch_grains(const rigs::PileSetup&, const FeedBatch&,
                                         const std::vector<double>& heights, double lift = 0.0);

// The base's; none of a flat one.
std::vector<dem_min::Grain> glued_grains(const rigs::PileSetup&);

// 10 d beside base and feed, down to where grains are lost.
Box pile_box(const rigs::PileSetup&);

double loose_density(const rigs::PileSetup&);  // kg/m^3
double energy_unit(const rigs::PileSetup&);    // J, m g d of a nominal grain
// Steps, rounded up to the looks at rest.
std::int64_t whole_checks(double time_step, double duration);
std::int64_t whole_checks(const rigs::PileSetup&, double duration);

// What LAMMPS alone is told of: a fluid, tilt, vibration.
void refuse_surroundings(const rigs::PileSetup&, const DeckOptions&, const std::string& engine);

// What none of the peers is told of: rigid friction, another friction cap, bridges, ageing.
void refuse_contacts_of_our_own(const rigs::ContactParameters&, const DeckOptions&,
                                const std::string& engine);

// These, several materials, funnel and mesh, clumps, sleep.
void refuse_rig_of_our_own(const rigs::PileSetup&, const DeckOptions&, const std::string& engine);

}  // namespace engines
