// SPDX-License-Identifier: MIT
#include "verify/advice.hpp"

#include <catch2/catch.hpp>

using namespace verify;

namespace {

MapCell cell(const char* study, const char* rule, double bond, double factor, double low,
             double high) {
    MapCell c{};
    c.study = study, c.rule = rule, c.bond = bond, c.factor = factor;
    c.reference = {48.0, 1e5, bond, 8000, 6, 6, 6};
    c.scaled = {48.0 / factor, 1e5 / factor, bond, 8000, 6, 6, 6};
    c.verdict = MapVerdict::not_decided;
    MapQuantity q{};
    q.name = "angle_flank_20_80", q.unit = "deg";
    q.reference = {40.0, 2.0, 6}, q.scaled = {40.0, 1.0, 6};
    q.interval = {low, high}, q.margin = 2.5, q.verdict = MapVerdict::not_decided;
    c.quantities = {q};
    return c;
}

// Bond 1 and 10; stress_bond holds to h = 2 at Bond 1 and to 1.5 at Bond 10, weight_bond breaks.
ScalingMap map() {
    ScalingMap m{};
    m.cells = {cell("coarse_graining", "stress_bond", 1.0, 1.5, -0.5, 0.6),
               cell("coarse_graining", "stress_bond", 1.0, 2.0, -1.0, 1.5),
               cell("coarse_graining", "stress_bond", 10.0, 1.5, -0.5, 1.9),
               cell("coarse_graining", "stress_bond", 10.0, 2.0, 3.0, 6.0),
               cell("coarse_graining", "weight_bond", 1.0, 1.5, 4.0, 6.0),
               cell("coarse_graining", "weight_bond", 10.0, 1.5, 4.0, 6.0)};
    MapCell soft = cell("softening", "pull_off", 10.0, 100.0, -1.0, 1.0);
    soft.reference.elasticity = 1e7, soft.scaled.elasticity = 1e5;
    m.cells.push_back(soft);
    return m;
}

}  // namespace

TEST_CASE("advice: a powder's Bond number is carried to the map's grain by the rule", "[advice]") {
    // 480 grains wide: ten times the map's. stress_bond: w ~ h, F_po/(m g) ~ h^-1, so 50 becomes 5, between 1 and 10: both are read.
    const PowderGroups powder{480.0, 1e5, 50.0};
    const MapReading r = read_coarse(map(), powder, "stress_bond", 15.0, 2.0);
    REQUIRE(r.cells.size() == 2);
    REQUIRE(r.says == AngleSays::within);
    REQUIRE(r.low == -0.5);
    REQUIRE(r.high == 1.9);
    REQUIRE(r.outside.size() == 1);  // from 480 to 48 the map says nothing
    // 10 becomes 1: that cell alone. weight_bond: w ~ h^2 keeps 50, above all of the map.
    REQUIRE(read_coarse(map(), {480.0, 1e5, 10.0}, "stress_bond", 15.0, 2.0).cells.size() == 1);
    REQUIRE(read_coarse(map(), powder, "weight_bond", 15.0, 2.0).outside.size() == 2);
}

TEST_CASE("advice: between two factors the coarser one is read", "[advice]") {
    const PowderGroups powder{48.0, 1e5, 10.0};
    REQUIRE(read_coarse(map(), powder, "stress_bond", 1.4, 2.0).says == AngleSays::within);
    REQUIRE(read_coarse(map(), powder, "stress_bond", 1.6, 2.0).says == AngleSays::beyond);
    REQUIRE(read_coarse(map(), powder, "stress_bond", 1.4, 1.0).says == AngleSays::not_decided);
    REQUIRE(read_coarse(map(), powder, "stress_bond", 1.4, 2.0).outside.empty());
    const MapReading coarser = read_coarse(map(), powder, "stress_bond", 4.0, 2.0);
    REQUIRE(coarser.says == AngleSays::not_decided);
    REQUIRE(coarser.outside.size() == 1);
    const MapReading finer = read_coarse(map(), powder, "stress_bond", 0.5, 2.0);
    REQUIRE(finer.says == AngleSays::within);
    REQUIRE(finer.outside.size() == 1);
}

TEST_CASE("advice: one side without heaps is no angle that stays", "[advice]") {
    ScalingMap m = map();
    for (MapCell& c : m.cells) c.scaled.formed = 0, c.verdict = MapVerdict::breaks;
    REQUIRE(read_coarse(m, {48.0, 1e5, 1.0}, "stress_bond", 1.5, 2.0).says == AngleSays::beyond);
}

TEST_CASE("advice: a softer modulus is read where the map has one as soft", "[advice]") {
    REQUIRE(read_softening(map(), 1e7, 1e5, 10.0, 2.0).says == AngleSays::within);
    REQUIRE(read_softening(map(), 1e7, 1e5, 10.0, 2.0).outside.empty());
    REQUIRE(read_softening(map(), 1e9, 1e5, 10.0, 2.0).outside.size() == 1);
    REQUIRE(read_softening(map(), 1e7, 1e5, 1000.0, 2.0).outside.size() == 1);
    REQUIRE(read_softening(map(), 1e7, 1e4, 10.0, 2.0).cells.empty());
}

TEST_CASE("advice: the finest grain that the budget allows, and the tolerance before the rest",
          "[advice]") {
    AdvisedGrain g{};
    g.affordable = true, g.coarse.says = AngleSays::within;
    std::vector<AdvisedGrain> list(4, g);
    list[0].h = 3.0, list[1].h = 2.0, list[2].h = 1.5, list[3].h = 1.0;
    list[3].affordable = false;
    REQUIRE(choose(list) == 2);
    list[2].unusable = "its neck is as wide as itself";
    REQUIRE(choose(list) == 1);
    list[1].coarse.says = AngleSays::not_decided;
    REQUIRE(choose(list) == 0);
    list[0].coarse.says = AngleSays::beyond;
    REQUIRE(choose(list) == 1);  // left open, for a check to tell
    list[1].coarse.says = AngleSays::beyond;
    REQUIRE_FALSE(choose(list));
}
