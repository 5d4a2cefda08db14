// SPDX-License-Identifier: MIT
// Who may touch whom soon: candidates found by cell grids, one for each class of sizes, kept until some tile has come farther
// than its margin. The list says who may touch, never who does: no bit depends on it.
#pragma once

#include "dem_min/simulation.hpp"

namespace dem_min {

// Makes the candidates of all tiles anew: each pair of grains, not both fixed and not in contact, whose surfaces are closer
// than the margins of their tiles, in the tile of the grain that stands first in memory; likewise grains and walls.
void find_neighbours(Simulation&);

// True when grains were added or taken out, or some tile has used up its margin.
bool outdated(const Simulation&);

// Candidates of tile `t` that touch now become contacts, in the order of (i, j), then those at walls in the order of (i, wall).
// Of the others it is worked out how far the tiles may come before they are looked at again.
void begin_contacts(Simulation&, std::size_t t);

}  // namespace dem_min
