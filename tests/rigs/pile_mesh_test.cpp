// SPDX-License-Identifier: MIT
// A heap fed through a funnel of triangles, as in examples/funnel.
#include "cases/read_case.hpp"
#include "rigs/pile.hpp"
#include "scaling/schemes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

// 120 of the example's beads, sooner.
rigs::PileSetup few_beads() {
    cases::Case c = cases::read_case("examples/funnel");
    rigs::PileSetup s = rigs::pile_setup(c, c.experiments.at(0), 1);
    s.conditions.grains = 120;
    s.conditions.feed_rate = 5000.0;
    rigs::choose_feed(s, c.grain, 1);
    rigs::choose_steps(s);
    return s;
}

// Inner radius of the example's funnel in m at height z, 0 below its outlet (make_funnel.py; the case lifts it by 12 mm).
double funnel_radius(double z) {
    const double mm = 1e-3, up = z / mm - 12.0;
    if (up < 0.0) return 0.0;
    return mm * (up < 6.0 ? 3.0 : 3.0 + (up - 6.0) * 9.0 / 14.0);
}

}  // namespace

TEST_CASE("beads run through a funnel of triangles and keep inside it", "[rigs][pile][mesh]") {
    const bool plugged = GENERATE(false, true);
    rigs::PileSetup setup = few_beads();
    if (plugged) {  // a triangle right across the tube, wide of it
        dem_min::Surface plug;
        plug.vertices = {{-8e-3, -5e-3, 13e-3}, {8e-3, -5e-3, 13e-3}, {0.0, 9e-3, 13e-3}};
        plug.triangles = {{0, 1, 2}};
        setup.conditions.meshes.push_back(plug);
    }
    rigs::PileRun run = rigs::begin_pile(setup, 1);
    const dem_min::Particles& p = run.simulation.grains;
    std::size_t through = 0;
    for (int pause = 0; pause < 60; ++pause) {
        rigs::advance(run, setup, 500);
        through = 0;
        for (std::size_t k = 0; k < p.count(); ++k) {
            if (p.fixed(k)) continue;
            const double r = std::hypot(p.x[k], p.y[k]), wall = funnel_radius(p.z[k]);
            // 32 flats lie up to 0.5 % of the radius inside the round; then the bead's own radius, across the slope of the cone, less
            // an overlap of a tenth.
            if (wall > 0.0 && p.z[k] < 32e-3) REQUIRE(r < wall - 0.4 * setup.d);
            through += p.z[k] < 12e-3;
        }
    }
    REQUIRE(run.fed == 120);
    const std::size_t gone = static_cast<std::size_t>(run.simulation.past.grains_lost);
    if (plugged) CHECK(through + gone == 0);
    if (!plugged) CHECK(through + gone > 60);
}

TEST_CASE("a scaled pile has its mesh scaled with the apparatus, and the same bits",
          "[rigs][pile][mesh][similarity]") {
    const rigs::PileSetup original = few_beads();
    const scaling::ScaleMap exact = scaling::ScaleMap::solve(scaling::named_scheme("exact"), 256.0);
    const rigs::PileSetup larger = rigs::scaled(original, exact);
    REQUIRE(larger.conditions.meshes.at(0).vertices.at(5).z ==
            256.0 * original.conditions.meshes.at(0).vertices.at(5).z);
    rigs::PileRun a = rigs::begin_pile(original, 1), b = rigs::begin_pile(larger, 1);
    rigs::advance(a, original, 14000), rigs::advance(b, larger, 14000);
    REQUIRE(dem_min::mean_coordination(a.simulation) > 0.5);  // or nothing is shown
    REQUIRE(dem_min::state_hash(a.simulation) ==
            dem_min::state_hash(b.simulation, 256.0, exact.factor("time")));
}
