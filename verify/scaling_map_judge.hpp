// SPDX-License-Identifier: MIT
// From finished heaps to the cells of the map.
#pragma once

#include "verify/scaling_map_plan.hpp"

namespace verify {

// What the map reads of a heap. A heap is formed here when it meets every criterion of rigs::formed but apex_near_axis: where the
// apex of a round stream's heap lies is scatter, in grain diameters, and grows with the grain.
MapHeap map_heap(const PileSample&, const MapPile&);

MapSide map_side(const MapPile&, const std::vector<MapHeap>&);

// One quantity. `values` of both sides; margins as in map_margins().
MapQuantity judged(const MapMargin&, const std::vector<double>& reference,
                   const std::vector<double>& scaled);

// The cell of a pair: flank angles of formed heaps, all else of heaps at rest. Angles are left out where neither side forms.
MapCell map_cell(const MapPair&, const MapPile& reference, const MapPile& scaled,
                 const std::vector<MapHeap>& reference_heaps,
                 const std::vector<MapHeap>& scaled_heaps);

// Sticking speed, restitution, pull-off force, contact radius without load and tear-off gap of a pair of reference grains and of
// the same, softened by each rule: closed forms, and restitution from GSL.
std::vector<MapCell> single_impacts(double bond, double elasticity,
                                    const std::vector<double>& factors);

}  // namespace verify
