// SPDX-License-Identifier: MIT
// Feng & Owen's exact similarity and similarity under kept gravity, to the last bit: a factor that
// is a power of two changes exponents alone, as long as the core has no length, time or force of
// its own.
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using dem_min::Simulation;
using dem_min::step;
using samples::dry;
using samples::rain;
using samples::sticky;
using samples::System;

namespace {

void run(Simulation& s, int steps) {
    for (int k = 0; k < steps; ++k) step(s);
}

// The scaled run's state in the units of the original.
void require_same_bits(const Simulation& original, const Simulation& scaled, double length,
                       double time) {
    const dem_min::Particles &a = original.grains, &b = scaled.grains;
    REQUIRE(a.count() == b.count());
    for (std::size_t k = 0; k < a.count(); ++k) {
        REQUIRE((1.0 / length) * b.position(k) == a.position(k));
        REQUIRE((time / length) * b.velocity(k) == a.velocity(k));
        REQUIRE(time * b.spin(k) == a.spin(k));
    }
    REQUIRE(pair_count(original) == pair_count(scaled));
}

// Sticky and dry, glued and walled, each rolling law, wet and ageing.
System sample(int kind) {
    const bool dry_ones = kind == 2 || kind == 5;
    System s = rain(dry_ones ? dry() : sticky(), 60, kind == 2 || kind == 3, kind != 0);
    if (kind == 3) s.between_grains.rolling = contact::RollingSds{5e-3, 1e-9, 0.2};
    if (kind == 4) s.between_grains.rolling = contact::RollingEdemStandard{0.2};
    if (kind == 4) s.between_grains.tangential = contact::Coulomb{0.4};
    if (kind >= 5) s.between_grains.bridge = samples::bridge(dry(), 8.0);
    if (kind == 6) s.between_grains.ageing = {.rate = 2.0, .onset = 20.0 * s.time_step};
    return s;
}

}  // namespace

TEST_CASE("exact scaling (times h, g/h, w h, E and density kept) keeps every bit",
          "[dem_min][similarity]") {
    const double h = GENERATE(2.0, 8.0, 256.0);
    const System system = sample(GENERATE(0, 1, 2, 3, 4, 5, 6));
    Simulation original = samples::simulation(system),
               scaled = samples::simulation(samples::scaled(system, h, h));
    run(original, 2500), run(scaled, 2500);
    REQUIRE(pair_count(original) + wall_contact_count(original) > 10);  // or nothing is shown
    require_same_bits(original, scaled, h, h);
}

TEST_CASE("scaling at kept gravity (times sqrt h, E h, w h^2) keeps every bit for h = 4^k",
          "[dem_min][similarity]") {
    const double h = GENERATE(4.0, 256.0);
    const System system = sample(GENERATE(0, 1, 2, 3, 4, 5, 6));
    const System larger = samples::scaled(system, h, std::sqrt(h));
    REQUIRE(larger.gravity == system.gravity);
    Simulation original = samples::simulation(system), scaled = samples::simulation(larger);
    run(original, 2500), run(scaled, 2500);
    require_same_bits(original, scaled, h, std::sqrt(h));
}

// 200 is no power of two, so that every product is rounded anew: about 1e-16 a step, and collisions
// multiply what is there. 1e-12 of the grain's diameter after 400 steps, in which some ten pairs
// collide, is still round-off.
TEST_CASE("scaling by 200 keeps the motion to round-off over a short run",
          "[dem_min][similarity]") {
    const System system = samples::two_grains(sticky(), 0.05, 5e-6, true);
    const double h = 200.0, time = GENERATE(200.0, std::sqrt(200.0));
    Simulation original = samples::simulation(system),
               scaled = samples::simulation(samples::scaled(system, h, time));
    run(original, 400), run(scaled, 400);
    REQUIRE(original.past.heat.total() + static_cast<double>(pair_count(original)) >= 0.0);
    const double d = 2.0 * original.grains.radius[0];
    for (std::size_t k = 0; k < 2; ++k) {
        const dem_min::Vec3 off =
            (1.0 / h) * scaled.grains.position(k) - original.grains.position(k);
        REQUIRE(contact::norm(off) <= 1e-12 * d);
        const dem_min::Vec3 spun = time * scaled.grains.spin(k) - original.grains.spin(k);
        REQUIRE(contact::norm(spun) <= 1e-12 * contact::norm(original.grains.spin(k)));
    }
}

// What the bits must be able to show: 1 % more adhesion moves the heap.
TEST_CASE("scaling with the wrong work of adhesion does not keep the bits",
          "[dem_min][similarity]") {
    const System system = sample(0);
    System wrong = samples::scaled(system, 2.0, 2.0);
    std::get<contact::Jkr>(wrong.between_grains.normal).w *= 1.01;
    Simulation original = samples::simulation(system), scaled = samples::simulation(wrong);
    run(original, 2500), run(scaled, 2500);
    double farthest = 0.0;
    for (std::size_t k = 0; k < original.grains.count(); ++k)
        farthest = std::max(
            farthest, contact::norm(0.5 * scaled.grains.position(k) - original.grains.position(k)));
    REQUIRE(farthest > 1e-3 * samples::sticky().diameter);
}
