// SPDX-License-Identifier: MIT
// Laws by pair of materials.
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

using dem_min::Simulation;
using dem_min::step;

// Glass on glass bounces, clay on either does not: laws by pair of materials, at the wall too.
TEST_CASE("each pair of materials has its own restitution", "[dem_min][materials]") {
    const samples::Powder p = samples::dry();
    samples::Powder dead = p;
    dead.restitution = 0.01;
    const auto rebound = [&](int first, int second) {
        samples::System system = samples::two_grains(p, 0.1, 1e-6, false);
        system.grains[0].material = first, system.grains[1].material = second;
        Simulation s = samples::simulation(system);
        s.particular = {{1, 0, false, samples::laws(dead)}, {1, 1, false, samples::laws(dead)}};
        for (int k = 0; k < 2000; ++k) step(s);
        REQUIRE(pair_count(s) == 0);
        return (s.grains.vx[1] - s.grains.vx[0]) / 0.1;
    };
    // Tsuji's dashpot is exact for a Hertz contact that ends at zero overlap; steps cost some 1e-2.
    REQUIRE(rebound(0, 0) == Approx(p.restitution).margin(0.02));
    REQUIRE(rebound(0, 1) == Approx(0.01).margin(0.02));
    REQUIRE(rebound(1, 0) == Approx(0.01).margin(0.02));
    REQUIRE(rebound(1, 1) == Approx(0.01).margin(0.02));
    const auto rebound_at_wall = [&](int grain, int wall) {
        samples::System system = samples::two_grains(p, 0.0, 1.0, false);
        system.grains = {{{0.0, 0.0, 0.51 * p.diameter},
                          {0.0, 0.0, -0.1},
                          {},
                          0.5 * p.diameter,
                          p.density,
                          false,
                          grain}};
        system.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
        system.time_step = samples::recommended_step(p, 0.1);
        Simulation s = samples::simulation(system);
        s.wall_material = {wall};
        s.particular = {{1, 2, true, samples::laws(dead)}};
        for (int k = 0; k < 2000; ++k) step(s);
        return s.grains.vz[0] / 0.1;
    };
    REQUIRE(rebound_at_wall(0, 2) == Approx(p.restitution).margin(0.02));
    REQUIRE(rebound_at_wall(1, 0) == Approx(p.restitution).margin(0.02));
    REQUIRE(rebound_at_wall(1, 2) == Approx(0.01).margin(0.02));
}
