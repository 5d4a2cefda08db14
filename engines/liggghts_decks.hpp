// SPDX-License-Identifier: MIT
// The rigs `pile`, `drop`, `incline` and `impact` in LIGGGHTS-PUBLIC 3.8.0 (docs/export.md). Its language is that of LAMMPS of 2012 in
// large part.
#pragma once

#include "engines/liggghts_contact.hpp"
#include "engines/one_throw.hpp"

#include <string>
#include <vector>

namespace engines {

// Throws scaling::InvalidInput for what LIGGGHTS has not or is not told of: JKR (unless the nearest is asked for), SDS rolling,
// rigid friction, a rim, several materials, a funnel or mesh, sleep, a restitution below 0.05.
Deck liggghts_pile(const rigs::PileSetup&, const DeckOptions& = {});

// deck.in, start.data and, for a drop or an incline, rows.txt. Throws as Throw does, and for a restitution below 0.05.
Deck liggghts_one_grain(const cases::Case&, const cases::Experiment&, const rigs::Ordinates&,
                        const DeckOptions& = {});

// What its decks share: the first lines, and the materials with the pair style.
std::string liggghts_opening(const LiggghtsRules&);
std::string liggghts_model(const LiggghtsRules&, double skin, double time_step);

// A file for read_data: all of one type among three, ids from `first_id` on in the order given.
std::string liggghts_data(const std::vector<dem_min::Grain>&, const Box&, std::size_t first_id,
                          int type);

// A disc of triangles about the origin at z = 0, as STL text; its edge is a polygon that is inscribed to the circle.
std::string disc_stl(double radius);

std::string liggghts_release(const std::string& output);

}  // namespace engines
