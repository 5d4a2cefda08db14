// SPDX-License-Identifier: MIT
// A pile in a fluid, on a base that is tilted or shakes: through the door, to the heap.
#include "cases/read_case.hpp"
#include "rigs/forward.hpp"
#include "rigs/pile.hpp"
#include "scaling/errors.hpp"
#include "scaling/scale_map.hpp"
#include "scaling/schemes.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

using Catch::Matchers::Contains;

namespace {

constexpr double d = 1e-3, g = 9.81, pi = std::numbers::pi;
const char* const water = R"(, "fluid_density": "998 kg/m^3", "fluid_viscosity": "1e-3 Pa*s")";

// Soft grains of 1 mm, 2500 kg/m^3 in `surroundings` beside gravity.
rigs::PileSetup setup(const std::string& physics, const std::string& parameters,
                      const std::string& surroundings = "", int grains = 120,
                      const std::string& conditions = "") {
    const std::string text = fmt::format(
        R"({{"format": "similitude-case/1", "title": "t",
  "grain": {{"diameter": "1 mm", "density": "2500 kg/m^3", "youngs_modulus": "2.5 MPa", "poisson_ratio": 0.25}},
  "plate": {{"youngs_modulus": "2.5 MPa", "poisson_ratio": 0.25}},
  "surroundings": {{"gravity": "9.81 m/s^2"{}}},
  "model": {{"physics": ["gravity", "hertz_mindlin", "rolling_resistance"{}],
    "parameters": {{"restitution": {{"value": 0.3}}, "sliding_friction": {{"value": 0.5}}, "rolling_friction": {{"value": 0.1}}{}}}}},
  "experiments": [{{"id": "heap", "rig": "pile",
    "conditions": {{"grains": {}, {}}}}}]}})",
        surroundings, physics, parameters, grains,
        conditions.empty()
            ? R"("base": "glued_grains", "base_diameter": "8 mm", "feed_diameter": "3 mm")"
            : conditions);
    std::string name =
        (std::filesystem::temp_directory_path() / "similitude-surroundings-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    std::ofstream(name + "/case.json") << text;
    const cases::Case c = cases::read_case(name);
    std::filesystem::remove_all(name);
    return rigs::pile_setup(c, c.experiments.at(0), 1);
}

rigs::PileRun at_its_end(const rigs::PileSetup& s) {
    rigs::PileRun run = rigs::begin_pile(s, 1);
    while (!run.finished) rigs::advance(run, s, 10000);
    return run;
}

// Mean place of the heap's grains.
contact::Vec3 middle(const rigs::PileRecord& r) {
    contact::Vec3 sum;
    for (const contact::Vec3& p : r.heap.centre) sum = sum + p;
    return (1.0 / static_cast<double>(r.heap.centre.size())) * sum;
}

}  // namespace

// drag_coefficient is told for a grain of the nominal size that has fallen drop_height freely.
TEST_CASE("the fluid of a pile is the case's, drag_coefficient that at the speed of a free fall",
          "[rigs][pile][surroundings]") {
    const double re = 998.0 * std::sqrt(2.0 * g * 5.0 * d) * d / 1e-3;  // drop_height 5 d
    REQUIRE(re < 1000.0);
    const double curve = 24.0 / re * (1.0 + 0.15 * std::pow(re, 0.687));
    rigs::PileSetup s = setup(R"(, "air_drag", "buoyancy")", "", water);
    CHECK(s.fluid.drag.factor == 1.0);
    CHECK(s.fluid.drag.density == 998.0);
    CHECK(s.fluid.drag.viscosity == 1e-3);
    CHECK(s.fluid.lifting_density == 998.0);
    s = setup(R"(, "air_drag")", R"(, "drag_coefficient": {"value": 0.9})", water);
    CHECK(s.fluid.drag.factor == Approx(0.9 / curve).epsilon(1e-12));
    CHECK(s.fluid.lifting_density == 0.0);
    CHECK_FALSE(setup("", "", water).fluid.acts());
}

TEST_CASE("a fluid that floats the grains and a funnel over a shaking base are refused by name",
          "[rigs][pile][surroundings]") {
    CHECK_THROWS_WITH(setup(R"(, "buoyancy")", "", R"(, "fluid_density": "2500 kg/m^3")"),
                      Contains("2500 kg/m^3") && Contains("float"));
    CHECK_THROWS_WITH(
        setup(
            R"(, "vibration")",
            R"(, "amplitude": {"value": "0.1 mm"}, "frequency": {"value": "50 Hz"})", "", 10,
            R"("base": "flat", "base_diameter": "8 mm", "funnel": {"outlet_diameter": "5 mm", "top_diameter": "9 mm", "height": "9 mm", "outlet_height": "9 mm"})"),
        Contains("vibration") && Contains("mesh"));
}

// By hand: 30 deg towards 90 deg. Gravity is g sin 30 along +y, and plumb up leans towards -y.
TEST_CASE("on a tilted base gravity points downhill, and the feed hangs plumb over its centre",
          "[rigs][pile][tilt]") {
    const rigs::PileSetup s =
        setup(R"(, "tilt")",
              R"(, "tilt_angle": {"value": "30 deg"}, "tilt_azimuth": {"value": "90 deg"})");
    const contact::Vec3 down = rigs::down(s.stand);
    CHECK(std::abs(down.x) < 1e-15);
    CHECK(down.y == Approx(0.5).epsilon(1e-12));
    CHECK(down.z == Approx(-std::sqrt(0.75)).epsilon(1e-12));
    const contact::Vec3 p{0.3, -1.1, 2.7}, there = rigs::on_base(s.stand, p, 0.0);
    CHECK(contact::norm(rigs::in_room(s.stand, there, 0.0) - p) < 1e-15);
    CHECK(contact::norm(there) == Approx(contact::norm(p)).epsilon(1e-14));
    CHECK(contact::dot(down, there) == Approx(-p.z).epsilon(1e-12));  // height is along plumb
    // The first grain, on its way down: 5 d and its radius above the middle of the base, less its fall, along plumb.
    rigs::PileRun run = rigs::begin_pile(s, 1);
    rigs::advance(run, s, 400);
    const dem_min::Particles& grains = run.simulation.grains;
    std::size_t first = 0;
    while (grains.fixed(first)) ++first;
    const contact::Vec3 now = rigs::in_room(s.stand, grains.position(first), 0.0);
    const double t = run.simulation.time();
    CHECK(now.x == Approx(s.feed_x[0]).epsilon(1e-10));
    CHECK(now.y == Approx(s.feed_y[0]).epsilon(1e-10));
    CHECK(now.z == Approx(5.5 * d - 0.5 * g * t * t).epsilon(1e-10));
}

// The mirror image bit by bit: nothing but the tilt tells the sides of a round base apart.
TEST_CASE("a flat base that leans the other way gives the mirror image of the heap",
          "[rigs][pile][tilt]") {
    const auto leaning = [](const char* angle) {
        return setup(R"(, "tilt")", fmt::format(R"(, "tilt_angle": {{"value": "{}"}})", angle), "",
                     60, R"("base": "flat", "base_diameter": "8 mm", "feed_diameter": "3 mm")");
    };
    const rigs::PileSetup one = leaning("6 deg");
    rigs::PileSetup other = leaning("-6 deg");
    for (double& x : other.feed_x) x = -x;
    rigs::PileRun a = rigs::begin_pile(one, 1), b = rigs::begin_pile(other, 1);
    rigs::advance(a, one, 12000), rigs::advance(b, other, 12000);
    REQUIRE(wall_contact_count(a.simulation) > 5);
    const dem_min::Particles &p = a.simulation.grains, &q = b.simulation.grains;
    REQUIRE(p.count() == q.count());
    for (std::size_t k = 0; k < p.count(); ++k) {
        REQUIRE(p.x[k] == -q.x[k]);
        REQUIRE(p.y[k] == q.y[k]);
        REQUIRE(p.z[k] == q.z[k]);
    }
}

// A heap that does not reach the rim: of two slopes at one angle to gravity the downhill one is the longer. Grains lie some 1.5 d
// from the axis, so that the middle of 60 scatters by 0.2 d; the limits are three of these.
TEST_CASE("a heap on a wide tilted base lies downhill of the axis", "[rigs][pile][tilt]") {
    const rigs::PileSetup s =
        setup(R"(, "tilt")",
              R"(, "tilt_angle": {"value": "12 deg"}, "tilt_azimuth": {"value": "180 deg"})", "",
              60, R"("base": "glued_grains", "base_diameter": "20 mm", "feed_diameter": "3 mm")");
    const rigs::PileRun run = at_its_end(s);
    REQUIRE(run.at_rest);
    const contact::Vec3 where = middle(rigs::record(run, s));
    CAPTURE(where.x / d, where.y / d, run.simulation.past.grains_lost);
    CHECK(where.x < -0.6 * d);
    CHECK(std::abs(where.y) < 0.6 * d);
}

TEST_CASE("a pile in a fluid on a tilted base that shakes is the same bits when it is scaled",
          "[rigs][pile][surroundings]") {
    const rigs::PileSetup original =
        setup(R"(, "air_drag", "buoyancy", "tilt", "vibration")",
              R"(, "tilt_angle": {"value": "5 deg"}, "tilt_azimuth": {"value": "40 deg"},
                 "amplitude": {"value": "0.05 mm"}, "frequency": {"value": "60 Hz"}, "phase": {"value": "20 deg"})",
              water, 40);
    for (const char* scheme : {"exact", "kept_gravity"}) {
        const scaling::ScaleMap map =
            scaling::ScaleMap::solve(scaling::named_scheme(scheme), 256.0);
        const rigs::PileSetup larger = rigs::scaled(original, map);
        rigs::PileRun a = rigs::begin_pile(original, 1), b = rigs::begin_pile(larger, 1);
        rigs::advance(a, original, 15000), rigs::advance(b, larger, 15000);
        REQUIRE(dem_min::mean_coordination(a.simulation) > 0.5);
        CHECK(dem_min::state_hash(a.simulation) ==
              dem_min::state_hash(b.simulation, 256.0, map.factor("time")));
    }
}

// 0.5 g at 40 Hz: grains stay where the base carries them; 4 g: they never rest, and the record says so.
TEST_CASE("a heap on a shaking base is at rest where it rides along, else recorded in motion",
          "[rigs][pile][vibration]") {
    const double strength = GENERATE(0.5, 4.0);
    const double amplitude = strength * g / std::pow(2.0 * pi * 40.0, 2);
    const rigs::PileSetup s = setup(
        R"(, "vibration")",
        fmt::format(R"(, "amplitude": {{"value": "{:.6f} mm"}}, "frequency": {{"value": "40 Hz"}})",
                    1e3 * amplitude),
        "", 40,
        R"("base": "flat_with_rim", "base_diameter": "6 mm", "rim_height": "30 mm", "feed_diameter": "3 mm")");
    CHECK(rigs::shaking_strength(s) == Approx(strength).epsilon(1e-4));
    const rigs::PileRun run = at_its_end(s);
    const rigs::PileRecord r = rigs::record(run, s);
    CHECK(run.at_rest == (strength < 1.0));
    if (strength < 1.0) {
        CHECK(r.notes.empty());
    } else {
        REQUIRE(r.notes.size() == 1);
        CHECK_THAT(r.notes[0], Contains("while the base still moved the heap") && Contains("4"));
    }
}
