// SPDX-License-Identifier: MIT
// Effects that act on pairs, through the door: what a pile makes of the names in model.physics.
#include "cases/read_case.hpp"
#include "rigs/pile.hpp"
#include "scaling/errors.hpp"
#include "scaling/scale_map.hpp"
#include "scaling/schemes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <variant>

namespace {

// Soft beads of 1 mm on a flat plate. `physics` and `parameters` are added, each with a comma before it.
cases::Case beads(const std::string& physics, const std::string& parameters) {
    const std::string text = R"({
  "format": "similitude-case/1",
  "grain": {"diameter": "1 mm", "density": "2500 kg/m^3", "youngs_modulus": "1 MPa", "poisson_ratio": 0.25},
  "plate": {"youngs_modulus": "1 MPa", "poisson_ratio": 0.25},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin")" +
                             physics + R"(],
    "parameters": {"restitution": {"value": 0.5}, "sliding_friction": {"value": 0.5})" +
                             parameters + R"(}},
  "experiments": [{"id": "heap", "rig": "pile", "conditions": {"base": "flat", "base_diameter": "12 mm", "grains": 40}}]
})";
    std::string name =
        (std::filesystem::temp_directory_path() / "similitude-pairs-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    std::ofstream(name + "/case.json") << text;
    const cases::Case c = cases::read_case(name);
    std::filesystem::remove_all(name);
    return c;
}

rigs::PileSetup setup_of(const std::string& physics, const std::string& parameters) {
    const cases::Case c = beads(physics, parameters);
    return rigs::pile_setup(c, c.experiments.at(0), 1);
}

const std::string wet = R"(, "capillary_bridge")";
const std::string water =
    R"(, "surface_tension": {"value": "0.072 N/m"}, "liquid_volume": {"value": "0.5 nL"})";

}  // namespace

// By hand: 4 pi gamma R* cos(theta), R* = R/2 between grains and R at the plate; (1 + theta/2) V^(1/3). 1e-12: algebra.
TEST_CASE("a wet pile has bridges between its grains and at its walls",
          "[rigs][pile][effects][exact]") {
    const rigs::PileSetup s = setup_of(wet, water + R"(, "contact_angle": {"value": "30 deg"})");
    const dem_min::Simulation run = rigs::begin_pile(s, 1).simulation;
    const double theta = std::numbers::pi / 6.0, r = 0.5e-3;
    const double at_plate = 4.0 * std::numbers::pi * 0.072 * r * std::cos(theta);
    CHECK(run.between_grains.bridge.closed(0.5 * r) == Approx(0.5 * at_plate).epsilon(1e-12));
    CHECK(run.at_walls.bridge.closed(r) == Approx(at_plate).epsilon(1e-12));
    CHECK(run.at_walls.bridge.rupture_gap ==
          Approx((1.0 + 0.5 * theta) * std::cbrt(0.5e-12)).epsilon(1e-12));
    CHECK(run.between_grains.twisting.g_star > 0.0);  // as sticky grains have it
    CHECK(!setup_of("", "").grains.bridge.acts());
}

TEST_CASE("wall adhesion acts at walls alone, and is nil where its value is not given",
          "[rigs][pile][effects]") {
    const rigs::PileSetup s =
        setup_of(R"(, "wall_adhesion")", R"(, "wall_work_of_adhesion": {"value": "0.05 J/m^2"})");
    const dem_min::Simulation run = rigs::begin_pile(s, 1).simulation;
    CHECK(std::holds_alternative<contact::Hertz>(run.between_grains.normal));
    CHECK(std::get<contact::Jkr>(run.at_walls.normal).w == 0.05);
    const rigs::PileSetup other =
        setup_of(R"(, "adhesion")", R"(, "work_of_adhesion": {"value": "0.05 J/m^2"})");
    CHECK(other.walls.work_of_adhesion == 0.0);
}

// A grain of 1.3e-5 N under a plate that holds 3/2 pi w R = 2e-5 N, and one that holds 1e-5 N: the first hangs, the second falls.
TEST_CASE("a grain hangs from a wall whose adhesion carries it", "[rigs][pile][effects][exact]") {
    const double weight = 2500.0 * std::numbers::pi / 6.0 * 1e-9 * 9.81;
    for (const double in_weights : {0.8, 1.25}) {
        const double w = in_weights * weight / (1.5 * std::numbers::pi * 0.5e-3);
        const rigs::PileSetup setup =
            setup_of(R"(, "wall_adhesion")", R"(, "wall_work_of_adhesion": {"value": ")" +
                                                 std::to_string(1e6 * w) + R"( uJ/m^2"})");
        dem_min::Simulation s = rigs::begin_pile(setup, 1).simulation;
        s.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}}};
        s.settings.lost_below = -1.0;
        // 1e-7 m beyond touch, where 8/9 of the pull-off force pulls: all but at rest from the start.
        dem_min::insert(s, {{0.0, 0.0, 1e-7 - 0.5e-3}, {}, {}, 0.5e-3, 2500.0});
        dem_min::advance(s, static_cast<std::int64_t>(0.05 / setup.time_step));
        CAPTURE(in_weights, s.grains.z[0]);
        CHECK((wall_contact_count(s) == 1) == (in_weights > 1.0));
    }
}

TEST_CASE("ageing is given to what adheres, and asks for adhesion", "[rigs][pile][effects]") {
    const std::string rate = R"(, "ageing_rate": {"value": 0.2})";
    const std::string adheres = R"(, "work_of_adhesion": {"value": "0.01 J/m^2"})";
    const rigs::PileSetup s = setup_of(R"(, "adhesion", "ageing")", rate + adheres);
    const dem_min::Simulation run = rigs::begin_pile(s, 1).simulation;
    CHECK(run.between_grains.ageing.growth(9.0) == Approx(1.2).epsilon(1e-12));  // onset 1 s
    CHECK(!run.at_walls.ageing.acts());
    const rigs::PileSetup late = setup_of(
        R"(, "adhesion", "ageing")", rate + adheres + R"(, "ageing_onset": {"value": "1 min"})");
    CHECK(late.grains.ageing.growth(540.0) == Approx(1.2).epsilon(1e-12));
    CHECK_THROWS_WITH(setup_of(R"(, "ageing")", rate), Catch::Contains("adhesion"));
    CHECK_THROWS_AS(
        setup_of(R"(, "adhesion", "ageing")", adheres + R"(, "ageing_rate": {"value": -0.2})"),
        scaling::InvalidInput);
}

TEST_CASE("a liquid that does not wet is refused in a pile, by its angle",
          "[rigs][pile][effects]") {
    CHECK_THROWS_WITH(setup_of(wet, water + R"(, "contact_angle": {"value": "100 deg"})"),
                      Catch::Contains("model.parameters") && Catch::Contains("contact_angle"));
}

TEST_CASE("a wet and ageing pile is the same bits when it is scaled",
          "[rigs][pile][effects][similarity]") {
    const rigs::PileSetup original = setup_of(
        wet + R"(, "adhesion", "ageing")",
        water + R"(, "work_of_adhesion": {"value": "0.01 J/m^2"}, "ageing_rate": {"value": 0.5},
                   "ageing_onset": {"value": "1 ms"})");
    const scaling::ScaleMap exact = scaling::ScaleMap::solve(scaling::named_scheme("exact"), 256.0);
    const rigs::PileSetup larger = rigs::scaled(original, exact);
    CHECK(larger.grains.bridge.pull_per_radius == 256.0 * original.grains.bridge.pull_per_radius);
    CHECK(larger.grains.bridge.volume == std::pow(256.0, 3) * original.grains.bridge.volume);
    rigs::PileRun a = rigs::begin_pile(original, 1), b = rigs::begin_pile(larger, 1);
    rigs::advance(a, original, 4000), rigs::advance(b, larger, 4000);
    REQUIRE(dem_min::mean_coordination(a.simulation) > 0.5);  // or nothing is shown
    CHECK(dem_min::state_hash(a.simulation) ==
          dem_min::state_hash(b.simulation, 256.0, exact.factor("time")));
}

// All that the effects do to one heap, on the same seed: adhesion of a few weights holds more grains on the plate.
TEST_CASE("a wet heap comes to rest and keeps more grains on its base than a dry one",
          "[rigs][pile][effects]") {
    const auto left = [](const rigs::PileSetup& setup) {
        rigs::PileRun run = rigs::begin_pile(setup, 1);
        while (!run.finished) rigs::advance(run, setup, 10000);
        CHECK(run.at_rest);
        return run.simulation.grains.count();
    };
    CHECK(left(setup_of(wet, water)) > left(setup_of("", "")));
}
