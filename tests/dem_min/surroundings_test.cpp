// SPDX-License-Identifier: MIT
// What acts from afar: a fluid, gravity aslant, the frame of a base that shakes. Against closed forms and against the same motion seen
// from the room; and every promise of the core about bits.
#include "dem_min/checkpoint.hpp"
#include "tests/dem_min/system.hpp"
#include "tests/dem_min/temporary_file.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using dem_min::Plane;
using dem_min::Shaking;
using dem_min::Simulation;
using dem_min::Vec3;
using samples::dry;
using samples::sticky;
using samples::System;

namespace {

constexpr double d = 1e-4, g = 9.81, pi = std::numbers::pi;

struct Surroundings {
    Vec3 gravity{0.0, 0.0, -g};
    dem_min::Fluid fluid = {};
    Shaking shaking = {};
};

Simulation surrounded(System system, const Surroundings& in, int threads = 1, bool ledger = false) {
    const std::vector<dem_min::Grain> grains = std::move(system.grains);
    system.grains.clear();
    Simulation s = samples::simulation(system, threads, ledger);
    s.settings.gravity = in.gravity, s.settings.fluid = in.fluid, s.settings.shaking = in.shaking;
    for (const dem_min::Grain& grain : grains) insert(s, grain);
    return s;
}

// Drag that slows a fall of 12 d by about a third, a fifth of the weight buoyed up, tilted by 20 degrees, shaken at 1.6 g and 500 Hz.
Surroundings all_at_once() {
    return {{1.2, -3.1, -9.2},
            {{1.3, 50.0, 5e-5}, 500.0},
            {1.6 * g / std::pow(2.0 * pi * 500.0, 2), 2.0 * pi * 500.0, 0.4}};
}

// The rain with its base or its disc, in all of that.
System rain(bool walled) { return samples::rain(sticky(), 60, walled, true); }

System one_grain(Vec3 position, Vec3 velocity) {
    System s = samples::two_grains(dry(), 0.05, 1e-6, false);
    s.grains = {{position, velocity, {}, 0.5 * d, dry().density, false}};
    return s;
}

// Speed of a grain thrown along x, after `duration` in so many steps.
double slowed_to(double speed, const dem_min::Fluid& fluid, double duration, int steps) {
    System system = one_grain({}, {speed, 0.0, 0.0});
    system.time_step = duration / steps;
    Simulation s = surrounded(system, {{}, fluid, {}});
    dem_min::advance(s, steps);
    return s.grains.vx[0];
}

}  // namespace

// v = v0 exp(-t/tau), tau = rho d^2/(18 eta); and Newton's v = v0/(1 + v0 t/L), L = m/(0.44 pi/8 rho_f d^2).
TEST_CASE("drag slows a grain to second order in the step, and no step is too long for it",
          "[dem_min][drag][order]") {
    const double eta = 2e-4, tau = 2500.0 * d * d / (18.0 * eta), speed = 2.0;
    const dem_min::Fluid stokes{{1.0, 0.0, eta}, 0.0}, newton{{1.0, 900.0, 0.0}, 0.0};
    const double length = 2500.0 * d / 6.0 * pi / (0.44 * pi / 8.0 * 900.0);
    const auto error = [&](bool viscous, int steps) {
        return viscous ? slowed_to(speed, stokes, tau, steps) - speed * std::exp(-1.0)
                       : slowed_to(speed, newton, length / speed, steps) - 0.5 * speed;
    };
    for (const bool viscous : {true, false}) {
        CAPTURE(viscous, error(viscous, 20), error(viscous, 40));
        CHECK(std::abs(error(viscous, 40)) < 1e-3 * speed);
        // 5 %: the next order.
        CHECK(error(viscous, 20) / error(viscous, 40) == Approx(4.0).epsilon(0.05));
    }
    // Steps of 50 tau: no answer any more, but it does not blow up.
    CHECK(std::abs(slowed_to(speed, stokes, 5000.0 * tau, 100)) < speed);
    CHECK(std::abs(slowed_to(speed, newton, 5000.0 * length / speed, 100)) < speed);
}

// No axis is distinguished: turned about (1, 2, 3) by 1 rad, the motion is turned. 1e-12 of the way: some hundred roundings.
TEST_CASE("a fall through a fluid turned as a whole is the fall turned", "[dem_min][drag][exact]") {
    const auto turn = [](Vec3 v) {
        const Vec3 axis = (1.0 / std::sqrt(14.0)) * Vec3{1.0, 2.0, 3.0};
        const double c = std::cos(1.0), s = std::sin(1.0);
        return c * v + s * contact::cross(axis, v) + ((1.0 - c) * contact::dot(axis, v)) * axis;
    };
    const Surroundings in = all_at_once();
    const Surroundings turned{turn(in.gravity), in.fluid, {}};
    const Vec3 velocity{0.3, 0.1, -0.4};
    Simulation a = surrounded(one_grain({}, velocity), {in.gravity, in.fluid, {}});
    Simulation b = surrounded(one_grain({}, turn(velocity)), turned);
    dem_min::advance(a, 500), dem_min::advance(b, 500);
    const double way = contact::norm(a.grains.position(0));
    REQUIRE(way > d);
    CHECK(contact::norm(turn(a.grains.position(0)) - b.grains.position(0)) < 1e-12 * way);
}

// With a density of its own a grain that is as heavy as the fluid stays where it is, whatever its size.
TEST_CASE("buoyancy takes the weight of the fluid off each grain by its own volume",
          "[dem_min][buoyancy][exact]") {
    System system = one_grain({}, {});
    system.grains.push_back({{10.0 * d, 0.0, 0.0}, {}, {}, 2.0 * d, 500.0, false});
    Simulation s = surrounded(system, {{0.0, 0.0, -g}, {{0.0, 0.0, 0.0}, 500.0}, {}});
    dem_min::advance(s, 200);
    CHECK(s.grains.vz[0] == Approx(-g * (1.0 - 500.0 / 2500.0) * s.time()).epsilon(1e-12));
    CHECK(std::abs(s.grains.vz[1]) < 1e-12 * g * s.time());
}

// The base's frame has walls at rest and an inertial force, the room has a plate that moves: two codes for one motion. In the room
// the plate goes by straight pieces of one step, so that its place is A sin at every step. 5e-4 d: each piece has the mean speed of its
// step, off by (omega dt)^2/24 = 4e-7 of it, and a bounce multiplies what is there; a third one is not waited for.
TEST_CASE("a grain thrown by a shaking plate moves as seen from the room",
          "[dem_min][shaking][exact]") {
    const Shaking base{0.4 * d, std::sqrt(2.2 * g / (0.4 * d)), 0.3};  // 2.2 g
    System system = one_grain({0.0, 0.0, 0.52 * d + base.height(0.0)}, {0.0, 0.0, 0.0});
    system.walls = {Plane{{0.0, 0.0, base.height(0.0)}, {0.0, 0.0, 1.0}}};
    Simulation room = surrounded(system, {});
    system.walls = {Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    system.grains.front().position.z -= base.height(0.0);
    system.grains.front().velocity.z -= base.velocity(0.0);
    Simulation frame = surrounded(system, {{0.0, 0.0, -g}, {}, base});
    const double dt = system.time_step, duration = 1.4 * 2.0 * pi / base.omega;
    double highest = 0.0, farthest = 0.0;
    while (room.time() < duration) {
        const double t = room.time();
        std::get<Plane>(room.walls[0]).velocity.z = (base.height(t + dt) - base.height(t)) / dt;
        dem_min::step(room), dem_min::step(frame);
        highest = std::max(highest, frame.grains.z[0] - 0.5 * d);
        farthest = std::max(
            farthest, std::abs(frame.grains.z[0] + base.height(frame.time()) - room.grains.z[0]));
    }
    CAPTURE(highest / d, farthest / d);
    REQUIRE(highest > 0.2 * d);  // it has been thrown
    CHECK(farthest < 5e-4 * d);
}

// A grain in the hollow of four glued ones: below A omega^2 = g its contacts hold through every turn, above they open.
TEST_CASE("a grain on a glued lattice follows its base below A omega^2 = g and leaves it above",
          "[dem_min][shaking][exact]") {
    const double strength = GENERATE(0.95, 1.05), omega = 2.0 * pi * 60.0;
    System system = one_grain({0.0, 0.0, std::sqrt(0.5) * d - 1e-4 * d}, {});
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
            system.grains.push_back({{x * d, y * d, 0.0}, {}, {}, 0.5 * d, 2500.0, true});
    // Set off at rest: it swings up from nothing over the first turns.
    Simulation s = surrounded(system, {});
    const auto turn = static_cast<std::int64_t>(2.0 * pi / omega / system.time_step);
    dem_min::advance(s, turn);
    REQUIRE(pair_count(s) == 4);
    s.settings.shaking = {strength * g / (omega * omega), omega, 0.0};
    std::size_t fewest = 4;
    for (std::int64_t k = 0; k < 2 * turn; ++k) {
        dem_min::step(s);
        fewest = std::min(fewest, pair_count(s));
    }
    CHECK(fewest == (strength < 1.0 ? 4 : 0));
}

TEST_CASE("in a fluid, aslant and shaken: list, threads and steps at a time change no bit",
          "[dem_min][golden][surroundings]") {
    const System system = rain(GENERATE(true, false));
    Simulation fast = surrounded(system, all_at_once()), slow = fast, at_once = fast,
               two = surrounded(system, all_at_once(), 3),
               books = surrounded(system, all_at_once(), 1, true);
    two.settings.grains_per_thread = 1;
    std::size_t most_contacts = 0;
    for (int k = 0; k < 2500; ++k) {
        step(fast), step(two), reference_step(slow);
        most_contacts = std::max(most_contacts, pair_count(fast) + wall_contact_count(fast));
    }
    dem_min::advance(at_once, 2500), dem_min::advance(books, 2500);
    REQUIRE(most_contacts > 10);
    CHECK(state_hash(fast) == state_hash(slow));
    CHECK(state_hash(fast) == state_hash(two));
    CHECK(state_hash(fast) == state_hash(at_once));
    CHECK(state_hash(fast) == state_hash(books));
}

TEST_CASE("in a fluid, aslant and shaken: every part moves the bits",
          "[dem_min][liveness][surroundings]") {
    const auto hash = [](const Surroundings& in) {
        Simulation s = surrounded(rain(false), in);
        dem_min::advance(s, 300);
        return state_hash(s);
    };
    const Surroundings usual = all_at_once();
    for (int part = 0; part < 8; ++part) {
        CAPTURE(part);
        Surroundings other = usual;
        double* const parts[] = {&other.gravity.x,
                                 &other.fluid.drag.factor,
                                 &other.fluid.drag.density,
                                 &other.fluid.drag.viscosity,
                                 &other.fluid.lifting_density,
                                 &other.shaking.amplitude,
                                 &other.shaking.omega,
                                 &other.shaking.phase};
        *parts[part] *= 1.1;
        CHECK(hash(other) != hash(usual));
    }
}

// Density kept: viscosity rho L^2/T.
TEST_CASE("scaled by a power of two, grains in a fluid on a shaking base keep every bit",
          "[dem_min][similarity][surroundings]") {
    const double h = GENERATE(2.0, 256.0), t = GENERATE(true, false) ? h : std::sqrt(h);
    if (t != h && h == 2.0) return;  // its root is no power of two
    const Surroundings in = all_at_once();
    Surroundings larger = in;
    larger.gravity = (h / (t * t)) * in.gravity;
    larger.fluid.drag.viscosity *= h * h / t;
    larger.shaking.amplitude *= h, larger.shaking.omega /= t;
    Simulation original = surrounded(rain(true), in),
               scaled = surrounded(samples::scaled(rain(true), h, t), larger);
    dem_min::advance(original, 2500), dem_min::advance(scaled, 2500);
    REQUIRE(pair_count(original) + wall_contact_count(original) > 10);
    CHECK(state_hash(scaled, h, t) == state_hash(original));
}

TEST_CASE("a run resumed in a fluid on a shaking base gives the bits of one never interrupted",
          "[dem_min][checkpoint][surroundings]") {
    Simulation whole = surrounded(rain(false), all_at_once(), 1, true);
    dem_min::advance(whole, 1700);
    const samples::TemporaryFile file;
    dem_min::write_checkpoint(whole, file.path);
    Simulation resumed = surrounded(rain(false), all_at_once(), 1, true);
    dem_min::read_checkpoint(resumed, file.path);
    dem_min::advance(whole, 800), dem_min::advance(resumed, 800);
    CHECK(state_hash(resumed) == state_hash(whole));
    CHECK(ledger(resumed).heat.drag == ledger(whole).heat.drag);
    CHECK(ledger(resumed).shaking_work == ledger(whole).shaking_work);
    CHECK(ledger(whole).heat.drag > 0.0);
}

// The rain's own limit for the ledger (energy_test.cpp): 1e-3 with the step refined once, here of what came in and went to and fro.
TEST_CASE("the ledger closes in a fluid on a shaking base", "[dem_min][energy][surroundings]") {
    System system = samples::rain(dry(), 60, GENERATE(true, false), true);
    system.time_step /= 2.0;
    Simulation s = surrounded(system, all_at_once(), 1, true);
    dem_min::advance(s, 5000);
    const dem_min::Ledger books = ledger(s);
    const double turnover = books.brought_in + std::abs(books.gravity_work);
    CAPTURE(books.gravity_work, books.shaking_work, books.heat.drag, books.imbalance());
    REQUIRE(books.heat.drag > 0.05 * turnover);
    REQUIRE(std::abs(books.shaking_work) > 0.01 * turnover);
    CHECK(std::abs(books.imbalance()) < 1e-3 * turnover);
}

// Asleep, it would not be thrown.
TEST_CASE("nobody sleeps on a base that shakes", "[dem_min][shaking]") {
    System system = one_grain({0.0, 0.0, 0.4999 * d}, {});
    system.walls = {Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    Simulation s = surrounded(system, {{0.0, 0.0, -g}, {}, {1e-3 * d, 1.0, 0.0}});
    s.settings.sleep_speed = 1e-3 * std::sqrt(g * d);
    s.settings.sleep_spin = s.settings.sleep_speed / d;
    dem_min::advance(s, 20000);
    CHECK(s.grains.vz[0] < s.settings.sleep_speed);
    CHECK_FALSE(s.tiles.front().asleep);
}
