// SPDX-License-Identifier: MIT
// A plane that moves: what a grain feels of it depends on their relative motion alone, its work is in the books, and it keeps
// every promise of the core about bits.
#include "dem_min/checkpoint.hpp"
#include "tests/dem_min/system.hpp"
#include "tests/dem_min/temporary_file.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using dem_min::Plane;
using dem_min::Simulation;
using dem_min::Vec3;
using samples::dry;
using samples::Powder;
using samples::sticky;
using samples::System;

namespace {

constexpr double d = 1e-4;  // m

// One grain of radius d/2 a tenth of d above a plane, no gravity.
System grain_over_plane(const Powder& p, Vec3 grain_velocity, Vec3 plane_velocity) {
    System s = samples::two_grains(p, 0.05, 1e-6, false);
    s.walls = {Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, plane_velocity}};
    s.grains = {{{0.0, 0.0, 0.6 * d}, grain_velocity, {}, 0.5 * d, p.density, false}};
    return s;
}

// A rain that falls between two plates, the upper one on its way down: it starts 13 d above the floor, beyond the first list.
System press() {
    System s = samples::rain(sticky(), 60, true, true);
    for (dem_min::Grain& grain : s.grains) grain.velocity = {};
    s.walls.push_back(Plane{{0.0, 0.0, 13.0 * d}, {0.0, 0.0, -1.0}, {0.01, 0.0, -0.3}});
    return s;
}

// Until the plate has come down by `share` of its height.
std::int64_t steps_of_press(const System& s, double share) {
    return static_cast<std::int64_t>(share * 13.0 * d / 0.3 / s.time_step);
}

}  // namespace

TEST_CASE("a plane with a velocity comes on by v t, one without stays", "[dem_min][walls][exact]") {
    Simulation s =
        samples::simulation(grain_over_plane(dry(), {0.0, 0.0, 1.0}, {0.01, -0.02, 0.03}));
    s.walls.push_back(Plane{{0.0, 0.0, -d}, {0.0, 0.0, 1.0}});
    dem_min::advance(s, 1000);
    const Vec3 way = std::get<Plane>(s.walls[0]).point;
    // 1e-12: a thousand roundings.
    CHECK(way.x == Approx(0.01 * s.time()).epsilon(1e-12));
    CHECK(way.y == Approx(-0.02 * s.time()).epsilon(1e-12));
    CHECK(way.z == Approx(0.03 * s.time()).epsilon(1e-12));
    CHECK(std::get<Plane>(s.walls[1]).point.z == -d);
}

// Galilei: dashpot, friction and spring see the relative motion alone. 1e-9: round-off of positions that differ by the way of
// the frame, 1e-16 d in an overlap of 1e-3 d, over some 100 steps of contact.
TEST_CASE("a grain hit by a moving plane leaves as from a plane at rest that it hits at that speed",
          "[dem_min][walls][exact]") {
    const Vec3 plane{0.02, 0.0, 0.05};
    const Powder p = GENERATE(dry(), sticky());
    Simulation hit = samples::simulation(grain_over_plane(p, {}, plane));
    Simulation hits = samples::simulation(grain_over_plane(p, -plane, {}));
    dem_min::advance(hit, 4000), dem_min::advance(hits, 4000);
    const Vec3 left = hit.grains.velocity(0) - plane, expected = hits.grains.velocity(0);
    REQUIRE(expected.z > 0.1 * plane.z);  // it has rebounded
    CHECK(contact::norm(left - expected) < 1e-9 * plane.z);
    CHECK(contact::norm(hit.grains.spin(0) - hits.grains.spin(0)) <
          1e-9 * contact::norm(hits.grains.spin(0)));
    CHECK(contact::norm(hits.grains.spin(0)) > 0.0);
}

// J = m v and J R = I w from the belt; U = v + w R without slip: v = 2/7 U. 2 %: Mindlin's spring still swings when gross sliding
// has ended.
TEST_CASE("a grain laid on a belt ends at 2/7 of its speed", "[dem_min][walls][exact]") {
    Powder p = dry();
    p.rolling_friction = 0.0;
    System s = grain_over_plane(p, {}, {0.01, 0.0, 0.0});
    s.gravity = p.gravity;
    s.grains.front().position.z = 0.4999 * d;
    Simulation belt = samples::simulation(s);
    dem_min::advance(belt, static_cast<std::int64_t>(0.05 / s.time_step));
    CHECK(belt.grains.vx[0] == Approx(2.0 / 7.0 * 0.01).epsilon(0.02));
}

// The rain's own limit for the ledger (energy_test.cpp): 1e-3 with the step refined once, here of what the plate has done.
TEST_CASE("the ledger closes while a plate presses grains together", "[dem_min][energy][walls]") {
    System system = press();
    system.time_step /= 2.0;
    Simulation s = samples::simulation(system, 1, true);
    dem_min::advance(s, steps_of_press(system, 0.85));
    const dem_min::Ledger books = ledger(s);
    CAPTURE(books.wall_work, books.gravity_work, books.imbalance());
    REQUIRE(books.wall_work > 5.0 * books.gravity_work);
    CHECK(std::abs(books.imbalance()) < 1e-3 * books.wall_work);
}

TEST_CASE("a plate on its way down: list, threads and steps at a time change no bit",
          "[dem_min][golden][walls]") {
    const System system = press();
    Simulation fast = samples::simulation(system), slow = fast, at_once = fast,
               two = samples::simulation(system, 3);
    two.settings.grains_per_thread = 1;
    const std::int64_t steps = steps_of_press(system, 0.8);
    for (std::int64_t k = 0; k < steps; ++k) step(fast), step(two), reference_step(slow);
    dem_min::advance(at_once, steps);
    int at_plate = 0;
    for_each_contact(fast, [&](std::size_t group, const dem_min::Contacts& c, std::size_t slot) {
        at_plate += fast.at_wall(group) && c.j[slot] == 2;
    });
    REQUIRE(at_plate > 3);
    CHECK(state_hash(fast) == state_hash(slow));
    CHECK(state_hash(fast) == state_hash(two));
    CHECK(state_hash(fast) == state_hash(at_once));
}

TEST_CASE("scaled by a power of two, a plate on its way down keeps every bit",
          "[dem_min][similarity][walls]") {
    const double h = GENERATE(2.0, 4.0);
    const System system = press();
    Simulation original = samples::simulation(system),
               scaled = samples::simulation(samples::scaled(system, h, h));
    const std::int64_t steps = steps_of_press(system, 0.8);
    dem_min::advance(original, steps), dem_min::advance(scaled, steps);
    REQUIRE(wall_contact_count(original) > 10);
    CHECK(state_hash(scaled, h, h) == state_hash(original));
    CHECK(std::get<Plane>(scaled.walls[2]).point.z ==
          h * std::get<Plane>(original.walls[2]).point.z);
}

TEST_CASE("a run resumed while a plate moves gives the bits of one never interrupted",
          "[dem_min][checkpoint][walls]") {
    Simulation whole = samples::simulation(press(), 1, true);
    dem_min::advance(whole, steps_of_press(press(), 0.75));
    std::get<Plane>(whole.walls[2]).velocity = {0.0, 0.0, -0.2};  // its speed is part of the state
    dem_min::advance(whole, 300);
    const samples::TemporaryFile file;
    dem_min::write_checkpoint(whole, file.path);
    Simulation resumed = samples::simulation(press(), 1, true);
    dem_min::read_checkpoint(resumed, file.path);
    const std::int64_t steps = steps_of_press(press(), 0.1);
    dem_min::advance(whole, steps), dem_min::advance(resumed, steps);
    REQUIRE(wall_contact_count(whole) > 10);
    CHECK(state_hash(resumed) == state_hash(whole));
    CHECK(std::get<Plane>(resumed.walls[2]).point == std::get<Plane>(whole.walls[2]).point);
    CHECK(ledger(resumed).wall_work == ledger(whole).wall_work);
}

// A grain on a floor that is drawn away falls; asleep, it would hang in the air. 1 %: it leaves with what its overlap gave it.
TEST_CASE("nobody sleeps while a wall moves", "[dem_min][walls]") {
    System system = grain_over_plane(dry(), {}, {});
    system.gravity = 9.81;
    system.grains.front().position.z = 0.4999 * d;
    Simulation s = samples::simulation(system);
    s.settings.sleep_speed = 1e-3 * std::sqrt(9.81 * d);
    s.settings.sleep_spin = s.settings.sleep_speed / d;
    dem_min::advance(s, 20000);
    REQUIRE(s.tiles.front().asleep);
    const double from = s.grains.z[0], duration = 10000 * s.settings.time_step;
    std::get<Plane>(s.walls[0]).velocity = {0.0, 0.0, -1.0};
    dem_min::advance(s, 10000);
    CHECK(from - s.grains.z[0] == Approx(0.5 * 9.81 * duration * duration).epsilon(0.01));
}
