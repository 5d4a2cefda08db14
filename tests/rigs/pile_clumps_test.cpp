// SPDX-License-Identifier: MIT
// Elongated grains through the door of a case: `shape` with `aspect_ratio` (docs/clumps.md).
#include "cases/read_case.hpp"
#include "rigs/height_map.hpp"
#include "rigs/pile.hpp"
#include "scaling/errors.hpp"
#include "scaling/schemes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

namespace {

// Soft grains on a glued base of 5 d; `shape` is what physics and parameters say of it.
cases::Case beans(const std::string& physics, const std::string& parameters,
                  const std::string& sizes = "") {
    const std::string text = R"({
  "format": "similitude-case/1",
  "grain": {"diameter": "1 mm", "density": "2500 kg/m^3", "youngs_modulus": "0.245 MPa", "poisson_ratio": 0.3)" +
                             sizes + R"(},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {
    "physics": ["gravity", "hertz_mindlin", "rolling_resistance")" +
                             physics + R"(],
    "parameters": {"restitution": {"value": 0.3}, "sliding_friction": {"value": 0.5}, "rolling_friction": {"value": 0.1})" +
                             parameters + R"(}
  },
  "experiments": [
    {"id": "heap", "rig": "pile",
     "conditions": {"base": "glued_grains", "base_diameter": "5 mm", "grains": 40, "drop_height": "3 mm", "feed_diameter": "4 mm",
       "feed_rate": "1000 1/s"}}
  ]
})";
    std::string name =
        (std::filesystem::temp_directory_path() / "similitude-clumps-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    std::ofstream(name + "/case.json") << text;
    try {
        const cases::Case c = cases::read_case(name);
        std::filesystem::remove_all(name);
        return c;
    } catch (...) {
        std::filesystem::remove_all(name);
        throw;
    }
}

rigs::PileSetup setup_of(const cases::Case& c, std::uint64_t seed = 1) {
    return rigs::pile_setup(c, c.experiments.at(0), seed);
}

cases::Case elongated(const std::string& a, const std::string& sizes = "") {
    return beans(R"(, "shape")", R"(, "aspect_ratio": {"value": )" + a + "}", sizes);
}

rigs::PileRun poured(const rigs::PileSetup& s) {
    rigs::PileRun run = rigs::begin_pile(s, 1);
    while (!run.finished) rigs::advance(run, s, 10000);
    return run;
}

}  // namespace

TEST_CASE("an aspect ratio of 1 is the sphere, to the last bit", "[rigs][pile][shape]") {
    const rigs::PileSetup spheres = setup_of(beans("", "")), round = setup_of(elongated("1"));
    REQUIRE(round.time_step == spheres.time_step);
    REQUIRE(round.feed_x == spheres.feed_x);
    rigs::PileRun a = rigs::begin_pile(spheres, 1), b = rigs::begin_pile(round, 1);
    rigs::advance(a, spheres, 3000), rigs::advance(b, round, 3000);
    REQUIRE(a.fed > 5);
    REQUIRE(b.simulation.bodies.empty());
    REQUIRE(state_hash(a.simulation) == state_hash(b.simulation));
}

TEST_CASE("an aspect ratio below 1, or a shape without one, is refused where it stands",
          "[rigs][pile][shape][domain]") {
    CHECK_THROWS_WITH(elongated("0.5"), Catch::Contains("aspect_ratio") && Catch::Contains(">= 1"));
    CHECK_THROWS_WITH(beans(R"(, "shape")", ""), Catch::Contains("aspect_ratio"));
    rigs::PileSetup s = setup_of(elongated("2"));
    s.sleep_speed = rigs::speed_of_rest(s);
    CHECK_THROWS_AS(rigs::begin_pile(s, 1), scaling::InvalidInput);
}

// 40 000 directions: the mean of each component has a deviation of 1/sqrt(3 n) = 0.003, of its square 2/sqrt(45 n) = 0.0015; four of them.
TEST_CASE("elongated grains are born in all directions alike, wholly inside the feed's disc",
          "[rigs][pile][shape]") {
    rigs::PileSetup s = setup_of(elongated("2"));
    s.conditions.grains = 40000;
    const cases::Case c = elongated("2");
    rigs::choose_feed(s, c.experiments.at(0).grain, 3);
    contact::Vec3 mean, square;
    const double half = dem_min::half_length(rigs::grain_of(s, s.d, s.density));
    REQUIRE(half > 0.7 * s.d);
    for (std::size_t k = 0; k < s.feed_axis.size(); ++k) {
        const contact::Vec3 a = s.feed_axis[k];
        REQUIRE(contact::norm(a) == Approx(1.0).epsilon(1e-14));
        mean = mean + (1.0 / 40000.0) * a;
        square = square + (1.0 / 40000.0) * contact::Vec3{a.x * a.x, a.y * a.y, a.z * a.z};
        REQUIRE(std::hypot(s.feed_x[k], s.feed_y[k]) + half <=
                0.5 * s.conditions.feed_diameter * (1.0 + 1e-12));
    }
    for (const double m : {mean.x, mean.y, mean.z}) CHECK(std::abs(m) < 0.012);
    for (const double m : {square.x, square.y, square.z})
        CHECK(m == Approx(1.0 / 3.0).margin(0.006));
}

TEST_CASE("a heap of elongated grains comes to rest, and its record counts grains, not spheres",
          "[rigs][pile][shape]") {
    const rigs::PileSetup s =
        setup_of(elongated("2", R"(, "sizes": [["1 mm", 0.5], ["0.8 mm", 0.5]])"));
    REQUIRE(rigs::spheres_per_grain(s) == 3);
    const rigs::PileRun run = poured(s);
    const rigs::PileRecord r = rigs::record(run, s);
    REQUIRE(r.at_rest);
    REQUIRE(r.grains_fed == 40);
    REQUIRE(r.grains_lost > 0);
    REQUIRE(r.heap.grains() + static_cast<std::size_t>(r.grains_lost) == 40);
    REQUIRE(r.heap.centre.size() == 3 * r.heap.grains());
    REQUIRE(r.heap.grains() == run.simulation.bodies.size());
    REQUIRE(r.aspect_ratio == 2.0);
    // The masses are those of spheres of the sizes drawn.
    const double pi = std::numbers::pi;
    for (const dem_min::Body& b : run.simulation.bodies) {
        const double d = std::cbrt(6.0 * b.mass / (pi * s.density));
        REQUIRE(std::min(std::abs(d - 1e-3), std::abs(d - 0.8e-3)) < 1e-12);
    }
    // Diameter of the grid: the mean of equal spheres, not that of the parts.
    const double mean = rigs::scan(r.heap).grain_diameter;
    REQUIRE(mean > 0.8e-3);
    REQUIRE(mean < 1e-3);
    // Contacts are counted by grain: a heap of friction stands on 4 to 8 of them.
    REQUIRE(r.coordination > 3.0);
    REQUIRE(r.coordination < 12.0);
}

// What a clump fills is less than its spheres together; heap.filled() makes up for it.
TEST_CASE("the share of their spheres that elongated grains fill is that of volumes",
          "[rigs][pile][shape]") {
    const rigs::PileSetup s = setup_of(elongated("2"));
    const dem_min::Clump one = rigs::grain_of(s, s.d, s.density);
    rigs::Heap heap{{}, {}, 1.0};
    heap.spheres = 3;
    heap.sphere_size = one.balls.front().radius / (0.5 * s.d);
    const double spheres =
        3.0 * 4.0 / 3.0 * std::numbers::pi * std::pow(one.balls.front().radius, 3);
    REQUIRE(heap.filled() * spheres == Approx(one.mass / s.density).epsilon(1e-13));
}

TEST_CASE("a heap of elongated grains scaled by powers of two keeps every bit",
          "[rigs][pile][shape][similarity]") {
    const rigs::PileSetup s = setup_of(elongated("1.5"));
    const auto map = scaling::ScaleMap::solve(scaling::named_scheme("exact"), 8.0);
    const rigs::PileSetup large = rigs::scaled(s, map);
    rigs::PileRun a = rigs::begin_pile(s, 1), b = rigs::begin_pile(large, 1);
    rigs::advance(a, s, 4000), rigs::advance(b, large, 4000);
    REQUIRE(pair_count(a.simulation) > 10);
    REQUIRE(state_hash(b.simulation, 8.0, 8.0) == state_hash(a.simulation));
}
