// SPDX-License-Identifier: MIT
// Ageing of contacts in the core: what a contact pulls with after so many steps, that a new one is young, that the books close.
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using dem_min::Ledger;
using dem_min::Simulation;
using samples::sticky;

namespace {

constexpr double radius = 5e-5, rate = 0.5;  // m; growth per decade

// A grain at a fixed one, or at a wall, which is put back to its place before each step. The onset of ageing is one step.
struct Resting {
    Simulation s;
    double reach, r_star;

    Resting(bool at_wall, bool wet) {
        s.settings.time_step = 1e-12;  // in which nothing moves
        s.settings.skin = 0.1 * radius;
        s.settings.lost_below = -1.0;
        dem_min::Laws laws = samples::laws(sticky());
        laws.damping = contact::DampingTsuji1992{0.0};  // the elastic force alone
        laws.ageing = {.rate = rate, .onset = s.settings.time_step};
        if (wet) laws.bridge = samples::bridge(sticky(), 4.0);
        (at_wall ? s.at_walls : s.between_grains) = laws;
        if (at_wall)
            s.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
        else
            dem_min::insert(s, {{0.0, 0.0, 0.0}, {}, {}, radius, 2500.0, true});
        reach = at_wall ? radius : 2.0 * radius, r_star = at_wall ? radius : 0.5 * radius;
        dem_min::insert(s, {{0.0, 0.0, 2.0 * reach}, {}, {}, radius, 2500.0, false});
    }

    double force_at(double gap, int steps) {  // N, after so many steps at that place
        dem_min::Particles& p = s.grains;
        const std::size_t k = p.count() - 1;
        for (int step = 0; step < steps; ++step) {
            p.z[k] = reach + gap, p.vz[k] = 0.0;
            s.list_is_stale = true;
            dem_min::step(s);
        }
        return p.fz[k];
    }
    // At touch 8/9 of the pull-off force pulls (docs/laws/jkr.md), beside a bridge's pull.
    double pull_at_touch(double growth) const {
        const double w = sticky().work_of_adhesion;
        const double bridge =
            s.between_grains.bridge.closed(r_star) + s.at_walls.bridge.closed(r_star);
        return 4.0 / 3.0 * std::numbers::pi * growth * w * r_star + bridge;
    }
};

}  // namespace

// The contact is born in the first step, at age 0; n steps later its age is n onsets. 1e-9: JKR's root at touch, and places that are
// known to 1e-16 of a radius, over overlaps of a thousandth of it.
TEST_CASE(
    "a contact at rest pulls with a work of adhesion that grows with the logarithm of its age",
    "[dem_min][ageing][exact]") {
    const bool at_wall = GENERATE(false, true), wet = GENERATE(false, true);
    Resting grain(at_wall, wet);
    REQUIRE(grain.force_at(0.0, 1) == Approx(-grain.pull_at_touch(1.0)).epsilon(1e-9));
    REQUIRE(grain.force_at(0.0, 9) == Approx(-grain.pull_at_touch(1.0 + rate)).epsilon(1e-9));
    REQUIRE(grain.force_at(0.0, 90) ==
            Approx(-grain.pull_at_touch(1.0 + 2.0 * rate)).epsilon(1e-9));
}

// Of a wet contact the bridge may outlast the solids' contact, and the next one is young all the same.
TEST_CASE("a contact that parted is young when it touches again", "[dem_min][ageing]") {
    const bool at_wall = GENERATE(false, true), wet = GENERATE(false, true);
    Resting grain(at_wall, wet);
    const double fresh = grain.force_at(0.0, 1), old = grain.force_at(0.0, 99);
    REQUIRE(old < fresh);
    const double held = grain.force_at(0.05 * radius, 1);  // beyond the fold, within the bridge
    REQUIRE((held < 0.0) == wet);
    REQUIRE(grain.force_at(0.0, 1) == Approx(fresh).epsilon(1e-12));
}

// Twenty grains on a base, whose contacts double their adhesion while they settle. As in energy_test.cpp, the project's limit:
// 1e-3 of the work of gravity at half of the step, and less at an eighth.
TEST_CASE("the ledger of wet and of ageing grains dropped on a base closes",
          "[dem_min][ageing][bridge][energy]") {
    const bool ages = GENERATE(false, true), wet = !ages || GENERATE(false, true);
    samples::System system = samples::rain(sticky(), 20, GENERATE(false, true), true);
    for (dem_min::Grain& grain : system.grains) grain.velocity = {};
    const double duration = 8.0 * std::sqrt(sticky().diameter / sticky().gravity);
    for (dem_min::Laws* laws : {&system.between_grains, &system.at_walls}) {
        if (ages) laws->ageing = {.rate = 0.5, .onset = 0.01 * duration};
        if (wet) laws->bridge = samples::bridge(sticky(), 4.0);
    }
    const auto imbalance = [&](int refinement) {
        samples::System finer = system;
        finer.time_step /= refinement;
        Simulation s = samples::simulation(finer, 1, true);
        advance(s, static_cast<std::int64_t>(duration / finer.time_step));
        const Ledger books = ledger(s);
        REQUIRE(pair_count(s) + wall_contact_count(s) > 10);
        REQUIRE(std::abs(books.heat.tear_off) > 1e-3 * books.gravity_work);
        return std::abs(books.imbalance()) / books.gravity_work;
    };
    const double half = imbalance(2), eighth = imbalance(8);
    CAPTURE(ages, wet, half, eighth);
    REQUIRE(half < 1e-3);
    REQUIRE(eighth < 3e-4);
}

namespace {

using dem_min::Vec3;

// An oblique, spinning impact of two wet or ageing grains that stick, as seen from another frame.
Simulation impact(bool wet, const auto& turned, Vec3 wind) {
    samples::System system = samples::two_grains(sticky(), 0.02, 1e-6, true);
    if (wet) system.between_grains.bridge = samples::bridge(sticky(), 4.0);
    system.between_grains.ageing = {.rate = wet ? 0.0 : 0.5, .onset = 20.0 * system.time_step};
    for (dem_min::Grain& grain : system.grains) {
        grain.position = turned(grain.position);
        grain.velocity = turned(grain.velocity) + wind;
        grain.spin = turned(grain.spin);
    }
    Simulation s = samples::simulation(system);
    advance(s, 3000);
    return s;
}

Vec3 as_it_is(Vec3 v) { return v; }
// A turn by 120 degrees about the diagonal keeps bits; this one does not: about z by 0.7 rad, then about x by 1.1 rad.
Vec3 turned(Vec3 v) {
    const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(1.1), t = std::sin(1.1);
    const Vec3 u{c * v.x - s * v.y, s * v.x + c * v.y, v.z};
    return {u.x, d * u.y - t * u.z, t * u.y + d * u.z};
}

}  // namespace

// 1e-9 of a diameter: 3000 steps of rounding of places, each 1e-16 of a metre's thousandth.
TEST_CASE("a wet or ageing impact is the same from a turned frame and from one that moves",
          "[dem_min][ageing][bridge][invariance]") {
    const bool wet = GENERATE(false, true);
    const Simulation s = impact(wet, as_it_is, {}), rotated = impact(wet, turned, {});
    const Vec3 wind{0.03, -0.02, 0.05};
    const Simulation carried = impact(wet, as_it_is, wind);
    REQUIRE(pair_count(s) == 1);
    const double d = sticky().diameter;
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec3 place = s.grains.position(k);
        REQUIRE(contact::norm(rotated.grains.position(k) - turned(place)) < 1e-9 * d);
        REQUIRE(contact::norm(carried.grains.position(k) - s.time() * wind - place) < 1e-9 * d);
        REQUIRE(contact::norm(rotated.grains.spin(k) - turned(s.grains.spin(k))) <
                1e-9 * contact::norm(s.grains.spin(k)));
    }
}
