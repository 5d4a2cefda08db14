// SPDX-License-Identifier: MIT
// Who may touch whom: a Verlet list from a cell grid, valid until some grain has moved half the skin.
#pragma once

#include "dem_min/contacts.hpp"
#include "dem_min/particles.hpp"
#include "dem_min/walls.hpp"

#include <functional>
#include <vector>

namespace dem_min {

// Pairs (i < j) in lexicographic order, and grains near walls in order of (wall, grain).
struct CandidateList {
    std::vector<int> i, j;  // j is the wall in the list of walls
    std::vector<double>
        reach;  // m, R_i + R_j, or R_i at a wall: they touch when their distance is this
    std::vector<int> slot;  // of the contact, -1 where there is none
    std::size_t count() const { return i.size(); }
};

// For each grain the contacts that load it, in the canonical order of summation: partners by rising index, then walls.
// That order depends on who touches whom and on nothing else, hence neither does any sum.
struct Incidence {
    std::vector<int> begin;  // [grains + 1]
    std::vector<int> entry;  // contact slot * 2 + (1 if the grain is the j of that contact)
};

struct Neighbours {
    CandidateList pairs, walls;
    Incidence of_pairs, of_walls;
    std::vector<double> x0, y0, z0;  // m, [grains], where the list was made
    bool stale = true;               // grains were added or taken out
};

// The farthest that a pair can be and still feel each other: R_i + R_j + gap(R*). `gap` in m for an R* in m.
using GapOf = std::function<double(double r_star)>;

// Makes both lists anew and links the existing contacts to them. Pairs of fixed grains are left out.
void find_neighbours(Neighbours&, const Particles&, const std::vector<Wall>&, Contacts& pairs,
                     Contacts& wall_contacts, double skin, const GapOf& pair_gap,
                     const GapOf& wall_gap, int threads);

// True when some grain has moved more than half the skin since the list was made, or its place is not a number.
bool outdated(const Neighbours&, const Particles&, double skin, int threads);

Incidence incidence(const CandidateList&, std::size_t grains, bool both_sides);

}  // namespace dem_min
