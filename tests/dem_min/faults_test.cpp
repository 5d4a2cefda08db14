// SPDX-License-Identifier: MIT
// Grains that leave and numbers that break are caught where they are born.
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

using dem_min::Simulation;
using dem_min::step;

TEST_CASE("a lost grain is taken out with its contacts and counted", "[dem_min][lost]") {
    const bool reference = GENERATE(false, true);
    const samples::Powder p = samples::sticky();
    samples::System system = samples::two_grains(p, 0.0, 0.0, false);
    // A third grain holds on to the second; only the second and third are near the drain.
    system.time_step = samples::recommended_step(p, 0.01);
    system.grains[1].position.x = system.grains[0].position.x + 0.999 * p.diameter;
    system.grains.push_back(system.grains[1]);
    system.grains[2].position.x += 0.999 * p.diameter;
    Simulation s = samples::simulation(system);
    step(s);
    REQUIRE(pair_count(s) == 2);
    s.grains.z[1] = s.settings.lost_below - p.diameter;
    reference ? reference_step(s) : step(s);
    REQUIRE(s.past.grains_lost == 1);
    REQUIRE(s.grains.count() == 2);
    REQUIRE(s.grains.id == std::vector<std::int64_t>{0, 2});
    REQUIRE(pair_count(s) == 0);
    step(s);
    REQUIRE(s.grains.count() == 2);
}

TEST_CASE("a glued grain is never lost", "[dem_min][lost]") {
    samples::System system = samples::two_grains(samples::dry(), 0.0, 1e-6, false);
    system.time_step = 1e-6;
    system.grains[0].fixed = true;
    system.grains[0].position.z = -1.0;
    Simulation s = samples::simulation(system);
    step(s);
    REQUIRE(s.grains.count() == 2);
}

// Grain 1 of id 1: after the first was lost it stands in place 0, and must still be called 1.
TEST_CASE("a number that is not finite stops the run and names its grain", "[dem_min][faults]") {
    samples::System system = samples::rain(samples::dry(), 3, true, false);
    system.grains[0].position.z = system.lost_below - 1e-4;
    Simulation s = samples::simulation(system);
    step(s);
    REQUIRE(s.grains.count() == 2);
    check_finite(s);
    s.grains.vy[0] = std::numeric_limits<double>::quiet_NaN();
    REQUIRE_THROWS_WITH(check_finite(s), Catch::Contains("grain 1 ") && Catch::Contains("step 1 "));
    SECTION("in a step, too") { REQUIRE_THROWS_WITH(step(s), Catch::Contains("grain 1 ")); }
    SECTION("and in the reference step") {
        REQUIRE_THROWS_WITH(reference_step(s), Catch::Contains("grain 1 "));
    }
}

// 3000 sticky grains in layers that have come to rest, and one that falls on them.
TEST_CASE("quiet tiles sleep, keep their places, and wake when something comes",
          "[dem_min][sleep]") {
    samples::Powder p = samples::sticky();
    p.restitution = 0.05;
    const double d = p.diameter;
    samples::System system = samples::rain(p, 1, true, false);
    system.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    system.grains.clear();
    for (int k = 0; k < 3000; ++k)
        system.grains.push_back({{(k % 15) * d, (k / 15 % 15) * d, (k / 225 + 0.5) * d},
                                 {},
                                 {},
                                 0.5 * d * (1.0 + 1e-4),
                                 p.density,
                                 false});
    Simulation awake = samples::simulation(system);
    advance(awake, 12000);
    Simulation asleep = awake;
    asleep.settings.sleep_speed = 0.02 * std::sqrt(p.gravity * d);
    asleep.settings.sleep_spin = asleep.settings.sleep_speed / (0.5 * d);
    advance(awake, 500), advance(asleep, 500);
    const std::int64_t before = asleep.past.grain_steps_slept;
    const dem_min::Grain guest{
        {7.0 * d, 7.0 * d, 15.5 * d}, {0.0, 0.0, -0.3}, {}, 0.5 * d, p.density, false, 0};
    insert(awake, guest), insert(asleep, guest);
    advance(awake, 3000), advance(asleep, 3000);
    const auto after = static_cast<double>(asleep.past.grain_steps_slept - before);
    REQUIRE(awake.past.grain_steps_slept == 0);
    REQUIRE(before > 300 * 3000);  // steps_to_sleep is 64 of 500
    REQUIRE(after > 0.05 * 3000.0 * 3001.0);
    REQUIRE(after < 0.9 * 3000.0 * 3001.0);  // the hit woke somebody
    double farthest = 0.0;
    std::vector<dem_min::Vec3> places(awake.grains.count());
    for (std::size_t k = 0; k < places.size(); ++k)
        places[static_cast<std::size_t>(awake.grains.id[k])] = awake.grains.position(k);
    for (std::size_t k = 0; k < places.size(); ++k)
        farthest = std::max(farthest,
                            contact::norm(asleep.grains.position(k) -
                                          places[static_cast<std::size_t>(asleep.grains.id[k])]));
    CAPTURE(farthest / d);
    REQUIRE(farthest < 0.01 * d);  // of a heap at rest nobody sees a hundredth of a grain
}

TEST_CASE("free flight: position and spin are exact in every step", "[dem_min][exact]") {
    samples::System system = samples::rain(samples::dry(), 1, true, false);
    system.walls = {};
    system.lost_below = -1.0;
    system.grains[0] = {{0.0, 0.0, 0.0}, {0.3, 0.0, 0.2}, {5.0, 0.0, -7.0}, 5e-5, 2500.0, false};
    Simulation s = samples::simulation(system);
    for (int k = 0; k < 1000; ++k) step(s);
    const double t = s.time();
    // Verlet is exact in a constant field; 1e-12: a thousand roundings.
    REQUIRE(s.grains.z[0] == Approx(0.2 * t - 0.5 * 9.81 * t * t).epsilon(1e-12));
    REQUIRE(s.grains.x[0] == Approx(0.3 * t).epsilon(1e-12));
    REQUIRE(s.grains.spin(0) == dem_min::Vec3{5.0, 0.0, -7.0});
}
