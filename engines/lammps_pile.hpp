// SPDX-License-Identifier: MIT
// The rig `pile` in LAMMPS: a setup as a deck with its data files (docs/export.md). The deck feeds the grains in small batches; it looks
// for rest by the rig's own criterion, and leaves the heap in final.dump. Written for the release of 29 September 2021, or in
// the syntax of later ones.
#pragma once

#include "engines/deck.hpp"
#include "rigs/pile.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace engines {

// Throws scaling::InvalidInput for what LAMMPS has not or we have not told it yet: contact rules of our own, rigid friction, a rim,
// walls that adhere, several materials, a funnel or mesh, sleep, a restitution below 0.12.
Deck lammps_pile(const rigs::PileSetup&, const DeckOptions& = {});

// A look at rest where runs follow one another without a set-up: what to do `then`, in quotes, once the variable `restless` has been below
// 1e-6 since the step ${moved} for `still` steps.
std::string lammps_calm(std::int64_t still, const std::string& then);

// `program -in deck.in -log log.PROGRAM`, with mpirun where there is more than one rank; LIGGGHTS takes the same.
std::vector<std::string> lammps_like_deck_command(const std::string& program, int ranks,
                                                  const std::string& log);

// What LAMMPS and LIGGGHTS have in common: what the loops of the feed and of rest ask (`present`: the grains that progress counts), and
// that of the feed, in which `reading` reads feed/${batch}.data, ${up} higher than it says, into the group `fresh`, where those that lie
// within others go up until they are clear.
std::string pile_questions(const rigs::PileSetup&, const std::string& present);
std::string pile_feed_loop(const rigs::PileSetup&, std::size_t batches, const std::string& reading);

}  // namespace engines
