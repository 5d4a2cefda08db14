// SPDX-License-Identifier: MIT
// What a pile may cost before somebody is asked.
#pragma once

#include "rigs/pile.hpp"

#include <cstdint>

namespace app {

// The setup of a pile that has a count. Throws scaling::InvalidInput where the case feeds without one, and for more
// than 5e6 grains unless `yes`.
rigs::PileSetup counted_setup(const cases::Case&, const cases::Experiment&, std::uint64_t seed,
                              bool yes);

constexpr double longest_unasked = 12.0 * 3600.0;  // s: a night

// What our core is likely to need, s. Measures this machine's speed.
double seconds_of(const rigs::PileSetup&, int threads);

// Throws scaling::InvalidInput where the run would take more than 12 hours.
void refuse_unaffordable(const cases::Experiment&, std::size_t grains, std::int64_t steps,
                         int threads);
void refuse_unaffordable(const cases::Experiment&, const rigs::PileSetup&, int threads);

}  // namespace app
