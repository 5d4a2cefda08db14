// SPDX-License-Identifier: MIT
// What the map is made of: piles, each poured with several seeds, and cells that compare two of them.
#pragma once

#include "verify/pile_runs.hpp"
#include "verify/scaling_map.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace verify {

// The sizes of the map's grains over d, as many of each. Grains of one size pile up as a crystal on the square lattice of the
// glued ones (0.74 of space filled without adhesion).
inline constexpr double map_sizes[] = {0.8, 0.9, 1.0, 1.1, 1.2};
inline constexpr double map_mean_cube = 1.06;

// A pile in groups. The apparatus is base_ratio reference grains wide and stays what it is while grains grow by h.
struct MapPile {
    std::string name;          // unique, fit for a file name
    double bond;               // F_po/(m g) of the reference grain
    double elasticity;         // E/(rho g d) of the reference grain
    double base_ratio;         // base diameter over reference grain
    double h = 1.0;            // grain over reference grain
    double softening = 1.0;    // E over the reference's
    double w = 1.0;            // work of adhesion over the reference's
    double drop_height = 0.5;  // in base diameters
    double outlet = 0.0;       // of a funnel, in reference grains; 0: rain from a disc
    double feed_rate = 1.0, time_step = 1.0;  // over the usual ones
    int seeds;
    int block = 0;  // poured after the heaps of all blocks before
};

// One heap of it, in SI: d = 0.1 mm for the reference grain; lengths, forces and times enter as groups alone.
PileJob map_job(const MapPile&, std::uint64_t seed);

struct MapPair {
    std::string study, rule;
    double bond, factor;
    std::size_t reference, scaled;  // numbers of piles
};

// How w follows a softened modulus, (E'/E)^exponent. Pull-off does not hold E; the sticking speed goes as w^(5/6) E^(-1/3), contact
// radius and tear-off gap over R as (w/E)^(1/3) and (w/E)^(2/3) (scaling/jkr_estimates.hpp).
struct MapSoftening {
    const char* name;
    double exponent;
};
inline constexpr MapSoftening map_softenings[] = {
    {"pull_off", 0.0}, {"sticking_speed", 0.4}, {"contact_radius", 1.0}};

struct MapPlan {
    std::string extent;
    double reference_grains;
    std::vector<MapPile> piles;
    std::vector<MapPair> pairs;             // of piles; single impacts need none
    double impact_bond, impact_elasticity;  // of single impacts
    std::vector<double> impact_factors;     // how many times softer
};

enum class MapExtent { tiny, small, full };

// tiny: 150 grains and one rule, for tests; small: minutes; full: hours (docs/scaling-map.md has the numbers).
MapPlan map_plan(MapExtent);

// One heap of the plan, and the order in which heaps are poured: block by block, so that a part of the map is whole cells. In a
// block the first three seeds of every pile, in the order of the plan, then the next three.
struct MapTurn {
    std::size_t pile;
    std::uint64_t seed;
};
std::vector<MapTurn> map_turns(const MapPlan&, std::uint64_t first_seed);

// Grain-steps that the heap is likely to need, from counts and steps (measured: docs/scaling-map.md).
double expected_cost(const MapPile&);

}  // namespace verify
