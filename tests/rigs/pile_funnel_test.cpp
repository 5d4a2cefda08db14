// SPDX-License-Identifier: MIT
// What a funnel still holds is no heap: a jammed outlet must not be read as a steep one.
#include "rigs/height_map.hpp"
#include "rigs/pile.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace {

constexpr double d = 1e-3;  // m

// Sticky grains; base of 10 d; a funnel from 4 d to 12 d wide, its outlet 8 d up, 6 d high.
rigs::PileSetup under_a_funnel(rigs::Base base) {
    rigs::PileSetup s{};
    s.d = d;
    s.density = 2500.0;
    s.gravity = 9.81;
    s.conditions = {.base = base,
                    .base_diameter = 10.0 * d,
                    .rim_height = d,
                    .grains = 1,
                    .drop_height = 5.0 * d,
                    .feed_diameter = 12.0 * d,
                    .feed_rate = 1.0,
                    .funnel = rigs::Funnel{4.0 * d, 12.0 * d, 6.0 * d, 8.0 * d}};
    const double weight = s.density * std::numbers::pi / 6.0 * d * d * d * s.gravity;
    s.grains = {.e_star = 1.3e6,
                .g_star = 2.3e5,
                .work_of_adhesion = 10.0 * weight / (1.5 * std::numbers::pi * d / 4.0),
                .sliding_friction = 0.5,
                .rolling_friction = 0.1,
                .restitution = 0.3};
    s.walls = s.grains;
    rigs::choose_feed(s, {}, 1);
    s.radius.assign(s.radius.size(), 0.5 * d);
    rigs::choose_steps(s);
    return s;
}

}  // namespace

TEST_CASE("the heap under a jammed outlet ends where the base's grains end",
          "[rigs][pile][funnel]") {
    const rigs::Base base =
        GENERATE(rigs::Base::flat, rigs::Base::flat_with_rim, rigs::Base::glued_grains);
    const rigs::PileSetup setup = under_a_funnel(base);
    rigs::PileRun run = rigs::begin_pile(setup, 1);
    dem_min::Simulation& s = run.simulation;
    const double touch = 0.999;  // of a diameter
    const auto put = [&](double x, double z) {
        dem_min::insert(s, {{x * d, 0.0, z * d}, {}, {}, 0.5 * d, setup.density, false});
    };
    // On the base: two, one on the other, right over a glued grain where those are. In flight: one.
    const double bottom = 0.5 * touch;
    for (const double z : {bottom, bottom + touch})
        dem_min::insert(s, {{0.5 * d, 0.5 * d, z * d}, {}, {}, 0.5 * d, setup.density, false});
    put(-3.0, 5.0);
    // In the funnel: two in the outlet, one above its mouth; from the outlet two hang, one under the other. Beside the
    // funnel, higher than its outlet and wide of its cone: one in flight.
    put(-0.5, 8.3), put(-0.5 + touch, 8.3);
    put(0.0, 16.0);
    put(-0.5, 8.3 - touch), put(-0.5, 8.3 - 2.0 * touch);
    put(5.0, 8.5);
    dem_min::advance(s, 1);
    const rigs::PileRecord record = rigs::record(run, setup);
    CHECK(record.grains_in_funnel == 5);
    REQUIRE(record.heap.radius.size() == 4);
    for (const contact::Vec3& place : record.heap.centre)
        CHECK((place.z < 5.1 * d || place.x > 4.9 * d));
}

TEST_CASE("without a funnel every loose grain is of the heap", "[rigs][pile][funnel]") {
    rigs::PileSetup setup = under_a_funnel(rigs::Base::flat);
    setup.conditions.funnel.reset();
    rigs::PileRun run = rigs::begin_pile(setup, 1);
    for (const double z : {0.5, 9.0})
        dem_min::insert(run.simulation, {{0.0, 0.0, z * d}, {}, {}, 0.5 * d, setup.density, false});
    dem_min::advance(run.simulation, 1);
    const rigs::PileRecord record = rigs::record(run, setup);
    CHECK(record.grains_in_funnel == 0);
    CHECK(record.heap.radius.size() == 2);
}
