// SPDX-License-Identifier: MIT
// The map: which scaling rule keeps which pile. Every cell compares heaps (or single impacts) of one reference grain with
// those of a scaled or softened grain, or of another apparatus, by equivalence tests over seeds (docs/scaling-map.md).
// Results alone stand here; reports/scaling_map_json.hpp writes and reads them.
#pragma once

#include "statistics/intervals.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace verify {

// holds: the 90 % interval of the difference lies inside the margin; breaks: wholly outside, or one side forms heaps and the
// other does not; not_decided: neither; not_poured: of a cell, one side of which has no heap yet.
enum class MapVerdict { holds, breaks, not_decided, not_poured };

const char* to_string(MapVerdict);
std::optional<MapVerdict> map_verdict_named(const std::string&);

struct MapQuantity {
    std::string name, unit;  // a name of map_margins()
    statistics::Summary reference,
        scaled;         // standard_deviation is 0 where fewer than two values are there
    double difference;  // scaled minus reference
    statistics::Interval
        interval;  // of the difference, 90 %; no width in single impacts, infinite where a side has too few values
    double margin;  // in the quantity's unit
    MapVerdict verdict;
    // Not decided: seeds a side with which this difference at this spread would be decided with 95 % power; decided: those that
    // would have done. Nothing where the difference sits on the margin (over 100 000), or a side has fewer than two values.
    std::optional<std::size_t> seeds_needed;
};

// The heaps of one side, whether or not a heap came of them.
struct MapSide {
    double size_ratio;  // Sn = base diameter / grain diameter, 1
    double elasticity;  // E/(rho g d), 1
    double bond;        // F_po/(m g), 1
    int grains;         // fed to each heap
    std::size_t heaps, at_rest,
        formed;  // poured; came to rest; formed (scaling_map_judge.hpp)
};

struct MapCell {
    std::string study;  // a name of map_studies
    std::string
        rule;  // weight_bond, stress_bond, cohesion_number, none; softening: pull_off, sticking_speed,
               // contact_radius; size effects: none
    double bond;  // F_po/(m g) of the reference grain
    double
        factor;  // what the study varies: scaled over reference (h, E over E', Sn, drop height, feed rate, step)
    MapSide reference, scaled;
    std::vector<MapQuantity> quantities;
    MapVerdict
        verdict;      // holds: all do; breaks: one does, or one side forms and the other does not
    std::string why;  // in words: the quantities that break, or what is missing
};

// One finished heap.
struct MapHeap {
    std::string name;  // unique: "bond10-e100000-base48-h2-stress_bond-seed123001"
    std::uint64_t seed;
    std::string setup, git;  // fingerprint of what was poured; the program that poured it
    bool at_rest, formed;
    std::vector<std::string> missed;            // criteria that it does not meet
    std::vector<std::optional<double>> values;  // in the order of map_margins(), in their units
    double grains_on_base, grain_steps,
        seconds;  // cost: grains times steps really made, and s of one thread
};

// The study's names, in the order of the map.
inline constexpr const char* map_studies[] = {
    "coarse_graining",   "softening",   "single_impact", "base_over_grain",
    "outlet_over_grain", "drop_height", "feed_rate",     "time_step"};

// Stated before the map was poured. `relative`: a share of the reference's value, for single impacts, which are exact.
struct MapMargin {
    const char *name, *unit;
    double margin;
    bool relative;
    const char* reason;
};
const std::vector<MapMargin>& map_margins();  // of heaps
const std::vector<MapMargin>& impact_margins();

struct ScalingMap {
    std::string extent;       // tiny, small, full
    double reference_grains;  // fed to the reference heap of coarse-graining
    std::uint64_t first_seed;
    std::vector<MapCell> cells;
    std::vector<MapHeap> heaps;     // finished
    std::size_t heaps_planned = 0;  // by the extent
    std::size_t heaps_stale =
        0;  // in the file under a planned name, but of another setup: not used
    double grain_steps_planned = 0.0;  // expected, of all
};

}  // namespace verify
