// SPDX-License-Identifier: MIT
// The rig `pile` as a deck of LAMMPS with its data files (docs/export.md); lammps_pile_run.hpp runs it.
// The deck feeds the very grains of the setup. It feeds them in small batches (lammps_feed.hpp), each grain
// with the speed that it would have by then; it looks for rest by the rig's own criterion, and leaves the heap in final.dump.
// Written for the release of 29 September 2021.
#pragma once

#include "rigs/pile.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace engines {

struct LammpsDeck {
    std::string deck;                                        // deck.in
    std::vector<std::pair<std::string, std::string>> files;  // name and text, beside deck.in
};

// What follows `pair_coeff * *`, and `granular` in `fix wall/gran/region`. The moduli are told as E = 2 E* with nu = 0, which
// gives E* between grains and, by LAMMPS' own rule E/2, at a wall; k_t/a = 8 G* as a number.
// `tsuji` is told the restitution that gives the case's (restitution_to_tell). A pair has it; a wall of this release does not: its
// number goes through the polynomial anew whenever a run is set up.
std::string granular_arguments(const rigs::ContactParameters&);

// Throws scaling::InvalidInput, which names `option`, below 0.12: there the polynomial of `tsuji` ends.
void refuse_restitution(double restitution, const std::string& option);

// Throws scaling::InvalidInput, which names `option`, for what LAMMPS has not or we have not told it yet: contact rules of our own,
// rigid friction, a rim, walls that adhere, several materials, a funnel or mesh, sleep, a restitution below 0.12.
LammpsDeck lammps_pile(const rigs::PileSetup&, const std::string& option = "--engine");

// kg/m^3
double loose_density(const rigs::PileSetup&);

void write_lammps_deck(const LammpsDeck&, const std::filesystem::path& folder);

}  // namespace engines
