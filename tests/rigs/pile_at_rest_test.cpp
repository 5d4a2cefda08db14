// SPDX-License-Identifier: MIT
#include "rigs/pile.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

constexpr double d = 1e-4;  // m

// 120 soft grains on a glued base of 8 d; the pull-off force is `bond` weights of a grain.
rigs::PileSetup small_pile(double bond) {
    rigs::PileSetup s{};
    s.d = d;
    s.density = 2500.0;
    s.gravity = 9.81;
    s.conditions = {.base = rigs::Base::glued_grains,
                    .base_diameter = 8.0 * d,
                    .rim_height = d,
                    .grains = 120,
                    .drop_height = 5.0 * d,
                    .feed_diameter = 4.0 * d,
                    .feed_rate = 0.0,
                    .funnel = {}};
    s.conditions.feed_rate = rigs::default_feed_rate(s.conditions, d, s.gravity);
    const double weight = s.density * std::numbers::pi / 6.0 * d * d * d * s.gravity;
    s.grains = {.e_star = 1.3e5,
                .g_star = 2.3e4,
                .work_of_adhesion = bond * weight / (1.5 * std::numbers::pi * d / 4.0),
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

// Rest as the case format defines it, 1e-6 m g d of kinetic energy a grain for sqrt(1000 d/g), must
// mean rest: over the same time again the heap keeps its shape to a thousandth of a grain. Grains
// that hang below the base by one contact are no part of it: they may turn and sway for long, since
// no law here resists twisting.
TEST_CASE("a pile at rest is at rest", "[rigs][pile]") {
    const rigs::PileSetup setup = small_pile(GENERATE(0.0, 5.0));
    rigs::PileRun run = rigs::begin_pile(setup, 1);
    while (!run.finished) rigs::advance(run, setup, 10000);
    REQUIRE(run.at_rest);
    dem_min::Simulation& s = run.simulation;
    const dem_min::Particles then = s.grains;
    std::size_t loose = 0;
    for (std::size_t k = 0; k < then.count(); ++k) loose += then.z[k] > 0.0;
    REQUIRE(loose > 40);  // a heap, not a few leftovers
    const auto steps = static_cast<std::int64_t>(setup.rest_duration / setup.time_step);
    for (std::int64_t k = 0; k < steps; ++k) dem_min::step(s);
    REQUIRE(s.grains.count() == then.count());
    double farthest = 0.0;
    for (std::size_t k = 0; k < then.count(); ++k)
        if (then.z[k] > 0.0)
            farthest = std::max(farthest, contact::norm(s.grains.position(k) - then.position(k)));
    REQUIRE(farthest < 1e-3 * d);
}
