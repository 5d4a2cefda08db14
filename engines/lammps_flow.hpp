// SPDX-License-Identifier: MIT
// The rigs `discharge`, `column` and `drum` in LAMMPS: a setup as a deck with its data file (docs/export.md). Grains begin to fall
// where the setup says; rest, strike-off, t = 0, looks and endings are the rig's own (rigs/flow.hpp), in one run that is set up once. The
// deck leaves the grains of t = 0, of each look and of the end in looks.dump.
#pragma once

#include "engines/deck.hpp"
#include "rigs/flow.hpp"

namespace engines {

// Throws scaling::InvalidInput for what LAMMPS has not: contact rules of our own, walls that adhere, a restitution below 0.12,
// outlets with ends or narrower than a grain.
Deck lammps_flow(const rigs::FlowSetup&, const DeckOptions& = {});

}  // namespace engines
