// SPDX-License-Identifier: MIT
// What a pile says of itself while it runs.
#pragma once

#include "rigs/pile.hpp"

#include <string>

namespace app {

// Grains times steps that the first `steps` steps are expected to take, `glued` grains of the base
// included; grains that will be lost are counted as if they stayed.
double expected_work(const rigs::PileSetup&, std::size_t glued, double steps);

// One line; `speed` in grain-steps per second, sleeping grains counted as well, and the share of these that were not
// asleep, 1: told where grains may sleep.
std::string pile_status(const std::string& id, const rigs::PileRun&, const rigs::PileSetup&,
                        double speed, double awake);

}  // namespace app
