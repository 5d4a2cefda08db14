// SPDX-License-Identifier: MIT
// How far the nearest adhesion of an engine without JKR is from JKR of the same pull-off force: two nominal grains drawn apart in the
// engine, from a deep overlap on, without friction, damping or motion of their own.
#pragma once

#include "engines/peer.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace engines {

// From an overlap at which the grains press on one another until nothing pulls any more.
struct Separation {
    double pull_off;  // N, the deepest tension
    double at_touch;  // N, the tension where the overlap is 0
    double overlap;   // m, where no force acts
    double gap;       // m, at which the pull ends
    double work;      // J, from that overlap to the end of the pull
};

Separation jkr_separation(double work_of_adhesion, double r_star, double e_star);

// How the grains are drawn apart: rows of equal steps between two overlaps, of which the last is a gap.
struct DrawnApart {
    double first, last;  // m
    int steps;
    double overlap(int step) const { return first + (last - first) * step / steps; }
};
DrawnApart drawn_apart(const rigs::PileSetup&);

// Decks that write the force on the upper grain, rows.dump with `id z fz`, one frame a step.
Deck liggghts_apart(const rigs::PileSetup&);
Deck yade_apart(const rigs::PileSetup&);

// Runs the peer's deck in `folder`. Throws std::runtime_error where that fails.
Separation measured_separation(const Peer&, const std::filesystem::path& program,
                               const rigs::PileSetup&, const std::filesystem::path& folder);

// Sentences for the user: the measured separation beside JKR's, and what else the nearest leaves out. Empty where the case needs no
// nearest.
std::vector<std::string> how_far_off(const Peer&, const std::filesystem::path& program,
                                     const rigs::PileSetup&, const std::filesystem::path& folder);

}  // namespace engines
