// SPDX-License-Identifier: MIT
// A heap that some program left behind, read by the same estimators as the heaps of the rig `pile`; and what can be told of grains
// without knowing where they stand: sizes, contacts (docs/measure.md).
#pragma once

#include "rigs/angle_of_repose.hpp"
#include "rigs/formed.hpp"
#include "rigs/frame.hpp"
#include "rigs/height_map.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace rigs {

struct MeasureSettings {
    std::optional<double> base_diameter;  // m; without it there are no heap and no angles
    contact::Vec3 base = {};              // m: the centre of the base's top; z is up
    double contact_gap = 0.0;             // m: surfaces no farther apart than this touch
    double gravity = 9.81;                // m/s^2: what at rest means
    bool moving_known = true;             // the frame has velocities
};

struct GrainContacts {
    double
        coordination;  // ends of contacts at loose grains / loose grains; those with the base count
    double largest_overlap;  // over R* = R1 R2/(R1 + R2), or R at the base; 0 without contacts
    std::size_t pairs, at_base;
};

struct MeasuredHeap {
    Formed formed;  // without `at_rest` where velocities are not known
    std::vector<std::pair<Estimator, std::optional<Angle>>> angles;
    RadialProfile profile;
    std::optional<PackingFraction> packing;
};

struct Measured {
    std::size_t fixed = 0;       // grains that never move
    std::size_t below_base = 0;  // loose, their tops under the base's: fallen off
    std::size_t beyond_rim =
        0;                  // loose, their centres farther out than the base's rim and a radius
    std::size_t loose = 0;  // all others: the heap
    double smallest = 0.0, mean = 0.0, largest = 0.0;  // m, diameters of the heap's grains
    GrainContacts contacts{};
    std::optional<MeasuredHeap> heap;
};

// Throws scaling::InvalidParameter as rigs::scan.
Measured measure(const Frame&, const MeasureSettings&);

// Contacts by geometry: two grains touch where their surfaces are at most `gap` apart, and a grain touches the base's top, z = 0,
// where it is told that there is one. Pairs of fixed grains do not count. A neck that adhesion holds over a wider gap is not seen.
GrainContacts contacts_of(const Frame&, bool flat_base, double gap);

}  // namespace rigs
