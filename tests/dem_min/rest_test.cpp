// SPDX-License-Identifier: MIT
// What slow things do to a history that is summed in doubles for a long time: creep, rest, sleep.
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using contact::Vec3;
using dem_min::Simulation;

namespace {

// So heavy that its motion is what it was given, whatever pushes.
constexpr double unmoved = 1e32;  // kg/m^3

// Two such grains pressed together by `overlap`, one of them moved across the contact.
Simulation led_pair(const samples::Powder& p, double overlap) {
    samples::System system = samples::two_grains(p, 0.0, -overlap, false);
    for (dem_min::Grain& grain : system.grains) grain.density = unmoved;
    system.time_step = samples::recommended_step(p, 0.1);
    return samples::simulation(system);
}

double spring(const Simulation& s) {
    double length = 0.0;
    dem_min::for_each_contact(
        s, [&](std::size_t, const dem_min::Contacts& c, std::size_t slot) { length = c.sy[slot]; });
    return std::abs(length);
}

// Three grains on a plane and one on top of them, let go at touch.
samples::System tripod(const samples::Powder& p) {
    samples::System system = samples::rain(p, 1, true, false);
    system.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    system.grains.clear();
    const double d = p.diameter, out = 1.02 * d / std::sqrt(3.0);  // from the axis
    for (int k = 0; k < 3; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 3.0;
        system.grains.push_back({{out * std::cos(angle), out * std::sin(angle), 0.5 * d},
                                 {},
                                 {},
                                 0.5 * d,
                                 p.density,
                                 false});
    }
    const double up = std::sqrt(d * d - out * out);
    system.grains.push_back({{0.0, 0.0, 0.5 * d + up}, {}, {}, 0.5 * d, p.density, false});
    return system;
}

}  // namespace

// A step of the creep is 1e-9 m/s times some microseconds, seven decades below the spring that is there already: a history in
// single precision (seven digits) would not see it.
TEST_CASE("a loaded spring still grows by v t at a creep of 1e-9 m/s", "[dem_min][rest]") {
    samples::Powder p = samples::dry();
    p.sliding_friction = 10.0;                      // far from sliding
    p.restitution = 1.0, p.rolling_friction = 0.0;  // the spring alone
    const double load = 1e-3 * p.diameter, overlap = 1e-3 * p.diameter;
    Simulation s = led_pair(p, overlap);
    const double dt = s.settings.time_step;
    // Loaded on the way to where the normal stands straight: there the creep neither leans it nor draws the two apart.
    s.grains.y[1] = -load;
    s.list_is_stale = true;
    s.grains.vy[1] = load / (1000.0 * dt);
    dem_min::advance(s, 1000);
    const double before = spring(s);
    REQUIRE(before == Approx(load).epsilon(0.01));  // it has not slid
    const double creep = 1e-9;                      // m/s
    REQUIRE(creep * dt < 1e-7 * load);
    s.grains.vy[1] = creep;
    const int steps = 200000;
    dem_min::advance(s, steps);
    REQUIRE(pair_count(s) == 1);
    // Less what the contact shrinks by while they are drawn apart by way^2/(2 d): a ~ sqrt(overlap), and the spring with it.
    // A step is 3e-8 of the spring, so that its rounding, 1.1e-16 of that, is 4e-9 of the step.
    const double way = creep * dt * steps;
    const double shrunken = load * way * way / (4.0 * p.diameter * overlap);
    CHECK((spring(s) - before) / way == Approx(1.0 - shrunken / way).epsilon(3e-8));
}

TEST_CASE("a tripod at rest stays where it is for a million steps", "[dem_min][rest]") {
    const samples::Powder p = GENERATE(samples::dry(), samples::sticky());
    Simulation s = samples::simulation(tripod(p));
    dem_min::advance(s, 200000);
    const dem_min::Particles then = s.grains;
    const std::size_t contacts = pair_count(s) + wall_contact_count(s);
    REQUIRE(contacts >= 6);  // three on the plane, one on three
    dem_min::advance(s, 1000000);
    CHECK(pair_count(s) + wall_contact_count(s) == contacts);
    double farthest = 0.0, fastest = 0.0;
    for (std::size_t k = 0; k < then.count(); ++k) {
        farthest = std::max(farthest, contact::norm(s.grains.position(k) - then.position(k)));
        fastest = std::max(fastest, contact::norm(s.grains.velocity(k)));
    }
    CAPTURE(farthest / p.diameter, fastest / std::sqrt(p.gravity * p.diameter));
    // A million roundings of a position, all one way: 1e6 x 1.1e-16.
    CHECK(farthest < 1e-10 * p.diameter);
}

TEST_CASE("who sleeps keeps every bit, springs included, and wakes with them", "[dem_min][sleep]") {
    const samples::Powder p = samples::sticky();
    Simulation s = samples::simulation(tripod(p));
    dem_min::advance(s, 200000);
    s.settings.sleep_speed = 1e-3 * std::sqrt(p.gravity * p.diameter);
    s.settings.sleep_spin = s.settings.sleep_speed / (0.5 * p.diameter);
    dem_min::advance(s, 2 * dem_min::steps_to_sleep);
    REQUIRE(s.past.grain_steps_slept > 0);
    const std::uint64_t asleep = dem_min::state_hash(s);
    const std::int64_t slept = s.past.grain_steps_slept;
    dem_min::advance(s, 100000);
    REQUIRE(s.past.grain_steps_slept == slept + 4 * 100000);
    CHECK(dem_min::state_hash(s) == asleep);
    // Woken, it has no reason to move: its springs still carry what they carried.
    const dem_min::Particles then = s.grains;
    s.settings.sleep_speed = 0.0;
    dem_min::advance(s, 10000);
    for (std::size_t k = 0; k < then.count(); ++k)
        CHECK(contact::norm(s.grains.position(k) - then.position(k)) < 1e-6 * p.diameter);
}

// A sleeping grain that kept its velocity would stretch the springs of those that touch it, though it comes nowhere.
TEST_CASE("who falls asleep stops, and what it had of kinetic energy is told", "[dem_min][sleep]") {
    const samples::Powder p = samples::sticky();
    Simulation s = samples::simulation(tripod(p));
    dem_min::advance(s, 200000);
    s.settings.sleep_speed = 0.02 * std::sqrt(p.gravity * p.diameter);
    s.settings.sleep_spin = s.settings.sleep_speed / (0.5 * p.diameter);
    for (double& vx : s.grains.vx) vx += 0.5 * s.settings.sleep_speed;
    dem_min::advance(s, dem_min::steps_to_sleep - 1);
    REQUIRE(s.past.grain_steps_slept == 0);
    const double before = dem_min::kinetic_energy(s);
    REQUIRE(before > 0.0);
    REQUIRE(s.past.carried_away == 0.0);
    dem_min::advance(s, 1);
    REQUIRE(s.past.grain_steps_slept == 4);
    CHECK(dem_min::kinetic_energy(s) == 0.0);
    CHECK(s.past.carried_away > 0.0);
    CHECK(s.past.carried_away == Approx(before).epsilon(0.1));  // half a step of drag lies between
}

// 1024 glued grains fill a tile and sleep; a grain that comes slowly enough to wake nobody must still find them.
TEST_CASE("a sleeping tile pushes an awake grain that touches it", "[dem_min][sleep]") {
    const samples::Powder p = samples::dry();
    const double d = p.diameter, slow = 1e-2 * std::sqrt(p.gravity * d);
    samples::System system = samples::rain(p, 1, true, false);
    system.walls.clear(), system.grains.clear();
    system.gravity = 0.0;
    const double way_of_30_steps = 30 * system.time_step * 0.9 * slow;
    for (int k = 0; k < dem_min::tile_size; ++k)
        system.grains.push_back({{3.0 * d * k, 0.0, 0.0}, {}, {}, 0.5 * d, p.density, true});
    system.grains.push_back({{0.0, 0.0, d + way_of_30_steps},
                             {},
                             {0.0, 0.0, 3.0 * slow / d},
                             0.5 * d,
                             p.density,
                             false});
    Simulation s = samples::simulation(system);
    s.settings.sleep_speed = slow;
    s.settings.sleep_spin = slow / (0.5 * d);
    dem_min::advance(s, dem_min::steps_to_sleep + 10);  // it spins too fast to be quiet
    REQUIRE(s.tiles.size() == 2);
    REQUIRE(!s.tiles[0].asleep);
    s.grains.wz.back() = 0.0;
    s.grains.vz.back() = -0.9 * slow;
    dem_min::advance(s, 10);
    REQUIRE(s.tiles[0].asleep);
    REQUIRE(!s.tiles[1].asleep);
    dem_min::advance(s, 40);
    REQUIRE(s.tiles[0].asleep);
    REQUIRE(!s.tiles[1].asleep);
    CHECK(dem_min::pair_count(s) == 1);
    CHECK(s.grains.vz.back() > -0.9 * slow);  // pushed back
}
