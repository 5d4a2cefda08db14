// SPDX-License-Identifier: MIT
// What a pile will cost in LAMMPS, on paper (docs/export.md).
#pragma once

#include "rigs/pile.hpp"

namespace app {

struct LammpsCost {
    double grains, steps, grain_steps;  // glued grains included in the last alone
    double seconds;                     // wall time, an estimate
};

// grain_steps/(speed x ranks x efficiency): the speed of one rank as it was measured, and half of it a rank where there are several.
LammpsCost lammps_cost(const rigs::PileSetup&, int ranks);

// The limit that a batch system is told, whole hours: three times the estimate, an hour at least.
int hours_to_ask_for(const LammpsCost&);

}  // namespace app
