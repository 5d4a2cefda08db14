// SPDX-License-Identifier: MIT
// A shell that rises along its axis and spins about it: what grains feel of it, its books, and the promises about bits.
#include "dem_min/checkpoint.hpp"
#include "tests/dem_min/system.hpp"
#include "tests/dem_min/temporary_file.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using dem_min::Shell;
using dem_min::Simulation;
using dem_min::Vec3;
using samples::dry;
using samples::Powder;
using samples::sticky;
using samples::System;

namespace {

constexpr double d = 1e-4;  // m

// A rain into a cup that turns, one turn in 30 sqrt(d/g), and whose wall is drawn up from its bottom.
System turning_cup() {
    System s = samples::rain(sticky(), 80, true, true);
    for (dem_min::Grain& grain : s.grains) grain.velocity = {};
    const double turns = 2.0 * 3.14159 / 30.0 / std::sqrt(d / 9.81);
    s.walls = {Shell{0.0, 0.0, 3.5 * d, 0.0, 0.0, turns},
               Shell{3.5 * d, 0.0, 3.5 * d, 6.0 * d, 0.01, turns}};
    return s;
}

constexpr std::int64_t steps_of_cup = 6000;  // most of the rain is on the bottom

}  // namespace

// A ball that rolls on a turntable feels m dv/dt = (2/7) m Omega x v, whatever its place: it runs in a circle (Weltner 1979, Am. J.
// Phys. 47, 984; Weckesser 1997, Am. J. Phys. 65, 736). It starts rolling: spin such that its lowest point has the table's speed.
// 1 %: Mindlin's spring lets the contact creep while it follows, of the order of its own stretch over the way.
TEST_CASE("a ball rolls on a turntable in circles at 2/7 of the table's spin",
          "[dem_min][walls][exact]") {
    Powder p = dry();
    p.rolling_friction = 0.0;
    const double omega = 20.0;                                // rad/s
    const Vec3 start{3.0 * d, 0.0, 0.0}, v{0.0, 0.002, 0.0};  // m, m/s
    System s = samples::two_grains(p, 0.05, 1e-6, false);
    s.gravity = p.gravity;
    s.walls = {Shell{0.0, 0.0, 200.0 * d, 0.0, 0.0, omega}};
    // v + w x (-R z) = Omega x r: w = (1/R) z x (v - Omega x r).
    const Vec3 slip = v - Vec3{-omega * start.y, omega * start.x, 0.0};
    const Vec3 spin = (2.0 / d) * Vec3{-slip.y, slip.x, 0.0};
    s.grains = {{start + Vec3{0.0, 0.0, 0.4999 * d}, v, spin, 0.5 * d, p.density, false}};
    Simulation table = samples::simulation(s);
    const double turn = 1.0;  // rad, of the velocity
    dem_min::advance(table, std::lround(turn / (2.0 / 7.0 * omega) / s.time_step));
    const Vec3 now = table.grains.velocity(0);
    CHECK(std::atan2(-now.x, now.y) == Approx(turn).epsilon(0.01));
    CHECK(std::hypot(now.x, now.y) == Approx(contact::norm(v)).epsilon(0.01));
}

// The rain's own limit for the ledger (energy_test.cpp), of what the walls have done.
TEST_CASE("the ledger closes in a cup that turns", "[dem_min][energy][walls]") {
    System system = turning_cup();
    system.time_step /= 2.0;
    Simulation s = samples::simulation(system, 1, true);
    dem_min::advance(s, 2 * steps_of_cup);
    const dem_min::Ledger books = ledger(s);
    CAPTURE(books.wall_work, books.gravity_work, books.heat.total(), books.imbalance());
    REQUIRE(std::abs(books.wall_work) > 0.01 * books.gravity_work);
    CHECK(std::abs(books.imbalance()) < 1e-3 * books.gravity_work);
}

TEST_CASE("a cup that turns: list, threads and steps at a time change no bit",
          "[dem_min][golden][walls]") {
    const System system = turning_cup();
    Simulation fast = samples::simulation(system), slow = fast, at_once = fast,
               two = samples::simulation(system, 3);
    two.settings.grains_per_thread = 1;
    for (std::int64_t k = 0; k < steps_of_cup; ++k) step(fast), step(two), reference_step(slow);
    dem_min::advance(at_once, steps_of_cup);
    REQUIRE(wall_contact_count(fast) > 10);
    CHECK(state_hash(fast) == state_hash(slow));
    CHECK(state_hash(fast) == state_hash(two));
    CHECK(state_hash(fast) == state_hash(at_once));
    // 1e-12: some thousand roundings.
    CHECK(std::get<Shell>(fast.walls[1]).z0 == Approx(0.01 * fast.time()).epsilon(1e-12));
}

TEST_CASE("scaled by a power of two, a cup that turns keeps every bit",
          "[dem_min][similarity][walls]") {
    const System system = turning_cup();
    const double h = 2.0;
    Simulation original = samples::simulation(system),
               scaled = samples::simulation(samples::scaled(system, h, h));
    dem_min::advance(original, steps_of_cup), dem_min::advance(scaled, steps_of_cup);
    REQUIRE(wall_contact_count(original) > 10);
    CHECK(state_hash(scaled, h, h) == state_hash(original));
}

TEST_CASE("a run resumed while a cup turns gives the bits of one never interrupted",
          "[dem_min][checkpoint][walls]") {
    Simulation whole = samples::simulation(turning_cup(), 1, true);
    dem_min::advance(whole, steps_of_cup);
    std::get<Shell>(whole.walls[1]).rise = 0.02;  // its speed is part of the state
    const samples::TemporaryFile file;
    dem_min::write_checkpoint(whole, file.path);
    Simulation resumed = samples::simulation(turning_cup(), 1, true);
    dem_min::read_checkpoint(resumed, file.path);
    dem_min::advance(whole, 500), dem_min::advance(resumed, 500);
    CHECK(state_hash(resumed) == state_hash(whole));
    CHECK(std::get<Shell>(resumed.walls[1]).z0 == std::get<Shell>(whole.walls[1]).z0);
    CHECK(ledger(resumed).wall_work == ledger(whole).wall_work);
}
