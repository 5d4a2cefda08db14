// SPDX-License-Identifier: MIT
// The real recordings of data/recordings are cases, and say what their originals say.
#include "cases/read_case.hpp"
#include "scaling/errors.hpp"
#include "temporary_case.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace {

const std::string recordings = "data/recordings/";

const cases::Recording& recorded(const cases::Case& c, const std::string& id) {
    const cases::Experiment* experiment = c.find(id);
    REQUIRE(experiment != nullptr);
    REQUIRE(experiment->recording);
    return *experiment->recording;
}

}  // namespace

// Diameter and density by hand from data/recordings/falling_balls/original/balls.csv.
TEST_CASE("a falling ball: one drop to fit, one kept back, drag left out", "[cases][recordings]") {
    const auto [name, diameter, density, rows] =
        GENERATE(table<std::string, double, double, std::size_t>({
            {"whiffle", 0.0726, 141.6, 54},    // 1 oz, 22.8 cm round
            {"tennis", 0.0660, 375.8, 46},     // 2 oz, 20.75 cm
            {"golf", 0.0439, 1034.8, 43},      // 1.62 oz, 13.8 cm
            {"basketball", 0.2387, 71.6, 45},  // 18 oz, 75 cm
            {"bowling", 0.2180, 1086.4, 43},   // 208 oz, 68.5 cm
        }));
    const cases::Case c = cases::read_case(recordings + "falling_balls/" + name);
    CHECK(c.grain.diameter.value.value() == Approx(diameter).epsilon(1e-3));
    CHECK(c.grain.density.value.value() == Approx(density).epsilon(1e-3));
    CHECK(c.grain.density.uncertainty.value() > 0.0);
    CHECK(c.surroundings.gravity.value() == 9.79);
    CHECK_FALSE(c.model.includes("air_drag"));
    REQUIRE(c.experiments.size() == 2);
    CHECK_FALSE(c.experiments[0].held_out);
    CHECK(c.experiments[1].held_out);
    CHECK(recorded(c, name + "-1").rows() == rows);
    for (const cases::Experiment& drop : c.experiments) {
        const std::vector<double>& z = drop.recording->values("z");
        CHECK(*std::min_element(z.begin(), z.end()) > 10.0);  // m: nothing bounces
        CHECK(drop.recording->values("t").front() == 0.0);
        CHECK(drop.conditions.at("release_time").uncertainty<scaling::Time>().value() > 0.0);
    }
}

TEST_CASE("balls together differ in weight for their face", "[cases][recordings]") {
    const cases::Case c = cases::read_case(recordings + "falling_balls/all");
    REQUIRE(c.experiments.size() == 10);
    double lightest = 1e9, heaviest = 0.0;  // rho d, kg/m^2: weight for a face
    for (const cases::Experiment& drop : c.experiments) {
        CHECK(drop.held_out == drop.id.starts_with("tennis"));
        const double load = drop.grain.density.value.value() * drop.grain.diameter.value.value();
        lightest = std::min(lightest, load);
        heaviest = std::max(heaviest, load);
    }
    CHECK(heaviest / lightest > 20.0);
    CHECK(cases::read_case(recordings + "falling_balls/light").experiments.size() == 4);
}

TEST_CASE("oblique impacts: each quantity has angles of its own", "[cases][recordings]") {
    const cases::Case c = cases::read_case(recordings + "oblique_impact_kharaz2001");
    CHECK(c.model.includes("hertz_coulomb"));
    CHECK(recorded(c, "tangential_restitution").rows() == 8);
    CHECK(recorded(c, "rebound_angle").rows() == 9);
    CHECK(recorded(c, "rebound_spin").rows() == 7);
    CHECK(c.find("rebound_spin")->held_out);
    CHECK(recorded(c, "rebound_spin").values("rebound_spin")[2] == 577.65);
    CHECK(recorded(c, "rebound_angle").values("angle").back() ==
          Approx(60.208 * std::numbers::pi / 180.0).epsilon(1e-12));
}

// Figures read in the original file: 1015 rows each way, drive 15072.4571 to 18452.4571 nm.
TEST_CASE("a force curve: the drive falls on approach and the force rises", "[cases][recordings]") {
    const cases::Case c = cases::read_case(recordings + "afm_force_curves/2020");
    const cases::Recording& curve = recorded(c, "curve-1");
    REQUIRE(curve.rows() == 2 * 203);
    const std::vector<double>& x = curve.values("displacement");
    const std::vector<double>& force = curve.values("force");
    CHECK(curve.column("branch").words.front() == "approach");
    CHECK(curve.column("branch").words.back() == "retract");
    CHECK(x.front() == Approx(3380e-9).epsilon(1e-12));
    CHECK(x[1] < x[0]);
    CHECK(force[202] > force[0]);
    CHECK(force.front() == Approx(1276.4373e-9).epsilon(1e-12));
    CHECK(c.experiments[0]
              .conditions.at("contact_displacement")
              .quantity<scaling::Length>()
              .value() == Approx(1980e-9).epsilon(1e-12));
}

TEST_CASE("volts are no force until sensitivity and stiffness are stated", "[cases][recordings]") {
    const std::string message = message_of<scaling::InvalidInput>(
        [] { cases::read_case(recordings + "afm_force_curves/2018"); });
    CHECK(message ==
          "data/recordings/afm_force_curves/2018/curve-1.csv: column \"force [V]\": got \"V\", "
          "must be a "
          "force: a photodiode's voltage is none by itself (state the conditions "
          "deflection_sensitivity (nm/V) and cantilever_stiffness (N/m), both; force = voltage x "
          "sensitivity x stiffness)");
}

TEST_CASE("force is voltage times sensitivity times stiffness", "[cases][recordings]") {
    const std::string json = R"({"format": "similitude-case/1",
      "grain": {"diameter": "10 um", "density": "1000 kg/m^3", "youngs_modulus": "1 GPa", "poisson_ratio": 0.3},
      "plate": {"youngs_modulus": "70 GPa", "poisson_ratio": 0.25},
      "model": {"physics": ["hertz_mindlin"]},
      "experiments": [{"id": "a", "rig": "pull_off", "recording": "a.csv",
        "conditions": {"counterpart": "plate", "preload": "1 uN", "cantilever_stiffness": "0.5 N/m"SENSITIVITY}}]})";
    const TemporaryFolder folder;
    folder.write("a.csv", "displacement [nm],force [mV],branch\n10,200,approach\n");
    const auto read = [&](const std::string& sensitivity) {
        return cases::read_case(
            folder.write("case.json", replaced(json, "SENSITIVITY", sensitivity)));
    };
    const cases::Case c = read(", \"deflection_sensitivity\": \"60 nm/V\"");
    // 0.2 V x 60 nm/V x 0.5 N/m = 6 nN
    CHECK(recorded(c, "a").values("force")[0] == Approx(6e-9).epsilon(1e-12));
    CHECK_THROWS_AS(read(""), scaling::InvalidInput);
}

TEST_CASE("the single-grain examples are cases", "[cases][recordings]") {
    const std::string name = GENERATE("drop-air-drag", "drop-magnet", "drop-nothing-left-out",
                                      "incline-rolling-resistance", "pull-off-adhesion");
    const cases::Case c = cases::read_case("tests/diagnose/data/" + name);
    CHECK(c.experiments.size() >= 3);
    CHECK(c.experiments.back().held_out);
    for (const cases::Experiment& e : c.experiments) CHECK(e.recording);
}
