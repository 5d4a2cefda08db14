// SPDX-License-Identifier: MIT
#include "app/lammps_cost.hpp"

#include "app/pile_status.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double speed = 3.6e6;     // grain-steps/s of one rank, docs/export.md
constexpr double efficiency = 0.5;  // of several ranks: assumed, not measured on a cluster
constexpr double margin = 3.0;      // cores differ, and the heap may take long to come to rest

}  // namespace

LammpsCost lammps_cost(const rigs::PileSetup& s, int ranks) {
    const std::size_t glued = rigs::begin_pile(s, 1).simulation.grains.count();
    LammpsCost c{};
    c.grains = static_cast<double>(s.feed_time.size());
    c.steps = static_cast<double>(rigs::expected_steps(s));
    c.grain_steps = expected_work(s, glued, c.steps);
    c.seconds = c.grain_steps / (speed * ranks * (ranks > 1 ? efficiency : 1.0));
    return c;
}

int hours_to_ask_for(const LammpsCost& c) {
    return std::max(1, static_cast<int>(std::ceil(margin * c.seconds / 3600.0)));
}

}  // namespace app
