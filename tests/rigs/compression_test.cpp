// SPDX-License-Identifier: MIT
// The rig `compression` against statics, Hertz by hand, and the core's promises about bits.
#include "rigs/compression.hpp"

#include "scaling/errors.hpp"
#include "scaling/schemes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using rigs::CompressionSetup;
using rigs::Stage;

namespace {

constexpr double pi = std::numbers::pi;

// About 200 grains of 0.1 mm and E = 10 MPa under 10 kPa, in a cell 6 d wide; pull-off w: 3/2 pi w d/4.
CompressionSetup small_setup(double work_of_adhesion, double friction = 0.5) {
    const double d = 1e-4;
    CompressionSetup s{};
    s.cell = {.width = 6.0 * d,
              .height = 12.0 * d,
              .solid_volume = 0.28 * 36.0 * 12.0 * d * d * d,
              .stress = 1e4,
              .speed = 0.1,
              .crush_strain = 0.1,
              .pause = 5e-4};
    s.d = d;
    s.density = 2500.0;
    s.gravity = 9.81;
    s.grains = {.e_star = 5.5e6,
                .g_star = 1.1e6,
                .work_of_adhesion = work_of_adhesion,
                .sliding_friction = friction,
                .rolling_friction = friction > 0.0 ? 0.1 : 0.0,
                .restitution = 0.3};
    s.plates = s.grains;
    s.plates.work_of_adhesion = 0.0;
    rigs::fill_cell(s, 3);
    return s;
}

rigs::CompressionRun run_of(const CompressionSetup& setup, int threads = 1) {
    rigs::CompressionRun run = rigs::begin_compression(setup, threads);
    run.simulation.settings.grains_per_thread = 1;
    while (!run.finished()) rigs::advance(run, setup, 1000);
    return run;
}

// Equal grains of radius R on top of one another in a cell 4 d wide, `count` of them, touching nothing yet.
CompressionSetup column(int count) {
    CompressionSetup s = small_setup(0.0);
    const double r = 0.5 * s.d;
    s.gravity = 0.0;
    s.cell.width = 4.0 * s.d;
    s.cell.height = 2.0 * r * count;
    s.cell.speed = 1e-3;
    s.radius.assign(static_cast<std::size_t>(count), r);
    s.place.clear();
    for (int k = 0; k < count; ++k) s.place.push_back({2.0 * s.d, 2.0 * s.d, (2 * k + 1) * r});
    return s;
}

}  // namespace

TEST_CASE("filled at random: the solid volume is the cell's, nobody touches, all are inside",
          "[rigs][compression]") {
    const CompressionSetup s = small_setup(0.0);
    double volume = 0.0;
    for (const double r : s.radius) volume += 4.0 / 3.0 * pi * r * r * r;
    CHECK(volume == Approx(s.cell.solid_volume).epsilon(1e-12));
    for (std::size_t i = 0; i < s.place.size(); ++i) {
        CHECK(s.place[i].z >= s.radius[i]);
        CHECK(s.place[i].z <= s.cell.height - s.radius[i]);
        for (std::size_t j = 0; j < i; ++j) {
            double square = std::pow(s.place[i].z - s.place[j].z, 2.0);
            for (const double way : {s.place[i].x - s.place[j].x, s.place[i].y - s.place[j].y})
                square += std::pow(std::min(std::abs(way), s.cell.width - std::abs(way)), 2.0);
            REQUIRE(std::sqrt(square) > s.radius[i] + s.radius[j]);
        }
    }
}

TEST_CASE("a cell too full to be filled at random is refused by name", "[rigs][compression]") {
    CompressionSetup s = small_setup(0.0);
    s.cell.height *= 0.8;
    REQUIRE_THROWS_WITH(rigs::fill_cell(s, 1), Catch::Contains("solid_volume"));
}

// A sphere of radius 1 in a slab from -1/2 to its top: pi (R^2 t - t^3/3) between them, 27/32 of the whole.
TEST_CASE("solid between two heights: a sphere cut at half a radius keeps 27/32",
          "[rigs][compression][exact]") {
    dem_min::Simulation s;
    dem_min::insert(s, {{0.0, 0.0, 0.0}, {}, {}, 1.0, 1.0});
    CHECK(rigs::packing_between(s, 2.0, -0.5, 1.5) * 8.0 ==
          Approx(27.0 / 32.0 * 4.0 / 3.0 * pi).epsilon(1e-12));
    CHECK(rigs::packing_between(s, 2.0, -3.0, 3.0) * 24.0 == Approx(4.0 / 3.0 * pi).epsilon(1e-12));
}

// Three grains in a row, the outer two beside the slab: the middle one has both contacts.
TEST_CASE("coordination between two heights counts the contacts of who is there",
          "[rigs][compression][exact]") {
    CompressionSetup s = column(3);
    rigs::CompressionRun run = rigs::begin_compression(s, 1);
    while (run.stage == Stage::compressing) rigs::advance(run, s, 20);
    CHECK(rigs::coordination_between(run.simulation, s.d, 2.0 * s.d) == 2.0);
    CHECK(rigs::coordination_between(run.simulation, 0.0, s.d) == 1.0);
    CHECK(rigs::coordination_between(run.simulation, 4.0 * s.d, 5.0 * s.d) == 0.0);
}

// Newton: nobody moves, so the floor carries all the weight. 1e-4: what is left of the motion after 0.1 s.
TEST_CASE("a bed at rest: the floor carries its weight, the piston nothing",
          "[rigs][compression][exact]") {
    CompressionSetup s = small_setup(GENERATE(0.0, 1e-3));
    s.gravity = 100.0 * 9.81;  // falls and settles sooner
    s.cell.speed = 1e-12;
    rigs::CompressionRun run = rigs::begin_compression(s, 1);
    rigs::advance(run, s, static_cast<std::int64_t>(0.1 / s.time_step));
    REQUIRE(run.stage == Stage::compressing);
    double weight = 0.0;
    for (const double mass : run.simulation.grains.mass) weight += mass * s.gravity;
    CHECK(rigs::elastic_force_on_grains(run.simulation, 0) == Approx(weight).epsilon(1e-4));
    CHECK(rigs::elastic_force_on_grains(run.simulation, 1) == 0.0);
}

// The sides repeat themselves and carry nothing upright: what the piston presses with arrives at the floor, with the weight. The
// piston has stood still for 500 times 10 d/sqrt(E/rho), the way of a wave through the bed and back. 1e-3: what is left of it.
TEST_CASE("confined and held: the floor carries what the piston presses with, and the weight",
          "[rigs][compression][exact]") {
    const double friction = GENERATE(0.0, 0.5);
    CompressionSetup s = small_setup(0.05, friction);
    s.cell.pause = 500.0 * 10.0 * s.d / std::sqrt(1e7 / s.density);
    rigs::CompressionRun run = rigs::begin_compression(s, 1);
    while (run.stage != Stage::unloading) rigs::advance(run, s, 20);
    const rigs::CompressionRow& held = run.rows.back();
    REQUIRE(held.stage == Stage::holding);
    double weight = 0.0;
    for (const double mass : run.simulation.grains.mass) weight += mass * s.gravity;
    const double area = s.cell.width * s.cell.width;
    CHECK(held.floor_stress == Approx(held.piston_stress + weight / area).epsilon(1e-3));
    CHECK(held.piston_stress > 0.5 * s.cell.stress);
}

// All gaps give way by Hertz: between grains F = 4/3 E* sqrt(R/2) a^1.5 with their E*, at both plates F = 4/3 E* sqrt(R) b^1.5 with
// that of a plate; the shortening is (n - 1) a + 2 b. Solved for F by halving. 1e-3: the piston at 1 mm/s still moves the grains, and
// its look comes every 20 steps.
TEST_CASE("a column of grains under the piston: force over shortening is Hertz's by hand",
          "[rigs][compression][exact]") {
    const int count = GENERATE(1, 5);
    const CompressionSetup s = column(count);
    rigs::CompressionRun run = rigs::begin_compression(s, 1);
    while (run.stage == Stage::compressing) rigs::advance(run, s, 20);
    const rigs::CompressionRow& row = run.rows.back();
    const double r = 0.5 * s.d, shortening = row.strain * s.cell.height;
    const auto gives = [&](double force) {
        const double a = std::pow(0.75 * force / (s.grains.e_star * std::sqrt(0.5 * r)), 2.0 / 3.0);
        const double b = std::pow(0.75 * force / (s.plates.e_star * std::sqrt(r)), 2.0 / 3.0);
        return (count - 1) * a + 2.0 * b;
    };
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 200; ++k)
        (gives(0.5 * (low + high)) < shortening ? low : high) = 0.5 * (low + high);
    CHECK(row.piston_stress * s.cell.width * s.cell.width == Approx(low).epsilon(1e-3));
    CHECK(row.piston_stress == Approx(s.cell.stress).epsilon(5e-3));
}

TEST_CASE("sticky grains stand unconfined and fail under a stress; dry ones carry next to nothing",
          "[rigs][compression][limit]") {
    const CompressionSetup sticky = small_setup(0.25), dry = small_setup(0.0);
    const rigs::CompressionRun a = run_of(sticky), b = run_of(dry);
    const rigs::CompressionRecord wet = record(a, sticky), loose = record(b, dry);
    CAPTURE(wet.strength.stress, loose.strength.stress, wet.inertial_number);
    CHECK(wet.strength.stress > 0.05 * sticky.cell.stress);
    CHECK(loose.strength.stress < 0.2 * wet.strength.stress);
    CHECK(wet.consolidated.piston_stress == Approx(sticky.cell.stress).epsilon(0.02));
    CHECK(loose.consolidated.packing_fraction > wet.consolidated.packing_fraction);
    CHECK(wet.consolidated.packing_fraction > 0.3);
    CHECK(loose.consolidated.packing_fraction < 0.7);
}

TEST_CASE("compressed and crushed: the bits depend neither on threads nor on steps at a time",
          "[rigs][compression][golden]") {
    const CompressionSetup s = small_setup(0.25);
    const rigs::CompressionRun one = run_of(s), three = run_of(s, 3);
    rigs::CompressionRun piecewise = rigs::begin_compression(s, 1);
    while (!piecewise.finished()) rigs::advance(piecewise, s, 37);
    CHECK(record(three, s).hash == record(one, s).hash);
    CHECK(record(piecewise, s).hash == record(one, s).hash);
    CHECK(piecewise.rows.size() == one.rows.size());
    CHECK(record(one, s).strength.stress == record(piecewise, s).strength.stress);
}

TEST_CASE("under exact scaling by a power of two compression and crushing keep every bit",
          "[rigs][compression][similarity]") {
    const double h = GENERATE(2.0, 4.0);
    const CompressionSetup s = small_setup(0.25);
    const auto map = scaling::ScaleMap::solve(scaling::named_scheme("exact"), h);
    const CompressionSetup larger = rigs::scaled(s, map);
    const rigs::CompressionRun original = run_of(s), image = run_of(larger);
    CHECK(dem_min::state_hash(image.simulation, map.factor("length"), map.factor("time")) ==
          record(original, s).hash);
    CHECK(record(image, larger).strength.stress == record(original, s).strength.stress);
    CHECK(record(original, s).strength.stress > 0.0);
}
