// SPDX-License-Identifier: MIT
// The rig `pull_off` in LAMMPS: two like grains of radius 2 R*, so that their pair has the R* of grain and counterpart, led from row
// to row, one a step, without dashpots or friction. A pair stands for the plate as well: a wall of the release of 2021 has no adhesion
// beyond its fold. LAMMPS ends a contact at the deepest tension 3/2 pi w R*, at a gap of 0.572 L^2/R*; JKR under a rigid drive ends at the
// fold, at 1.19 L^2/R* and 5/9 of that tension, L^3 = pi w R*^2/(2 E*).
#pragma once

#include "cases/case.hpp"
#include "engines/deck.hpp"
#include "engines/lammps_dump.hpp"
#include "rigs/forward.hpp"

#include <string>
#include <vector>

namespace engines {

// deck.in, start.data and the way of the upper grain, way.txt. Throws scaling::InvalidInput for a cantilever, for rigid
// friction, and for what acts in a pull-off beside Hertz and JKR.
Deck lammps_pull_off(const cases::Case&, const cases::Experiment&, const rigs::Ordinates&,
                     const DeckOptions&);

// The channel `force` (N, > 0 repulsive; [ordinates]) from that deck's rows.dump. Throws std::runtime_error where a step is missing.
rigs::Curves pull_off_curves(const cases::Case&, const cases::Experiment&, const rigs::Ordinates&,
                             const std::vector<LammpsFrame>&);

// Where the channel differs from the rig's own: between which gaps. Empty without adhesion.
std::string tear_off_note(const cases::Case&, const cases::Experiment&);

}  // namespace engines
