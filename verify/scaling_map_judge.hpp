// SPDX-License-Identifier: MIT
// From finished heaps to the cells of the map.
#pragma once

#include "verify/scaling_map_plan.hpp"

namespace verify {

// What the map reads of a heap. It is formed when it is at rest and meets the criteria of rigs::formed, but for two that count in grains:
// apex_near_axis is left out (where the apex under a round stream lies is scatter, and grows with the grain), and falls_outwards
// allows a rise of 0.05 of the base, which stays what it is, or of one grain. `setup` and `git` are left empty.
MapHeap map_heap(const PileSample&, const MapPile&);

MapSide map_side(const MapPile&, const std::vector<MapHeap>&);

// One quantity. `values` of both sides; margins as in map_margins().
MapQuantity judged(const MapMargin&, const std::vector<double>& reference,
                   const std::vector<double>& scaled);

// The cell of a pair: base_covered counts only where both bases are 20 d and wider. Flank angles of formed heaps, all else of heaps at rest. Angles are left out where neither side forms.
MapCell map_cell(const MapPair&, const MapPile& reference, const MapPile& scaled,
                 std::vector<MapHeap> reference_heaps, std::vector<MapHeap> scaled_heaps);

// Sticking speed, restitution, pull-off force, contact radius without load and tear-off gap of a pair of reference grains and of
// the same, softened by each rule: closed forms, and restitution from GSL.
std::vector<MapCell> single_impacts(double bond, double elasticity,
                                    const std::vector<double>& factors);

}  // namespace verify
