// SPDX-License-Identifier: MIT
#include "cases/read_case.hpp"

#include "cases/rig_table.hpp"
#include "sample_case.hpp"
#include "scaling/errors.hpp"
#include "temporary_case.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <string>

namespace {

cases::Case read(const std::string& json) {
    const TemporaryFolder folder;
    folder.write("drop-1.csv", sample_recording);
    return cases::read_case(folder.write("case.json", json));
}

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("a case arrives in SI, as it was written", "[cases][read]") {
    const cases::Case c = read(sample_case);
    CHECK(c.title == "polystyrene bead on a steel plate");
    CHECK(c.source == "written for this test");
    CHECK(c.grain.diameter.value.value() == 4e-3);
    CHECK(c.grain.diameter.uncertainty.value() == Approx(1e-4).epsilon(1e-15));
    CHECK(c.grain.density.value.value() == 28.0);
    CHECK(c.grain.density.uncertainty.value() == 0.0);
    CHECK(c.grain.youngs_modulus.value.value() == 3e9);
    CHECK(c.grain.poisson_ratio.value.value() == 0.3);
    REQUIRE(c.grain.size_distribution.size() == 3);
    CHECK(c.grain.size_distribution[0].first == Approx(0.1).epsilon(1e-15));
    CHECK(c.grain.size_distribution[2].second.value() == 5e-3);
    CHECK(c.plate.youngs_modulus.value() == 2e11);
    CHECK(c.surroundings.gravity.value() == 9.81);
    CHECK(c.surroundings.fluid_viscosity.value() == 1.81e-5);

    CHECK(c.model.physics == std::vector<std::string>{"gravity", "hertz_mindlin", "adhesion"});
    const cases::Parameter& w = *c.model.find("work_of_adhesion");
    CHECK(w.value == Approx(0.05).epsilon(1e-15));
    CHECK(w.unit == "J/m^2");
    CHECK(w.range->first == Approx(0.01).epsilon(1e-15));
    CHECK(w.range->second == 0.1);
    CHECK_FALSE(c.model.find("sliding_friction")->range);
    CHECK(c.model.numerics.time_step->value() == 1e-6);
    CHECK(c.model.numerics.integrator == "verlet");
    CHECK(c.model.numerics.youngs_modulus_factor == 0.01);

    REQUIRE(c.scaling);
    CHECK(c.scaling->h == 200.0);
    CHECK(c.scaling->scheme == "paper");
    CHECK(c.scaling->invariant == "weight_bond");
    CHECK(c.scaling->softening == 0.5);
    CHECK_FALSE(c.scaling->scaled_work_of_adhesion);
}

TEST_CASE("an experiment carries its conditions, its recording and what it overrides",
          "[cases][read]") {
    const cases::Case c = read(sample_case);
    REQUIRE(c.experiments.size() == 2);
    const cases::Experiment& first = c.experiments[0];
    CHECK(first.conditions.at("height").quantity<scaling::Length>().value() ==
          Approx(0.6).epsilon(1e-15));
    CHECK(first.conditions.at("height").uncertainty<scaling::Length>().value() == 0.0);
    CHECK(first.recording->values("z")[1] == Approx(0.551).epsilon(1e-15));
    CHECK(first.noise.at("z") == Approx(1.5e-3).epsilon(1e-15));
    CHECK_FALSE(first.held_out);
    CHECK(first.grain.diameter.value.value() == 4e-3);

    const cases::Experiment& second = *c.find("drop-2");
    CHECK(second.held_out);
    CHECK_FALSE(second.recording);
    CHECK(second.conditions.at("height").quantity<scaling::Length>().value() ==
          Approx(1.2).epsilon(1e-15));
    CHECK(second.conditions.at("height").uncertainty<scaling::Length>().value() ==
          Approx(2e-3).epsilon(1e-15));
    CHECK(second.conditions.at("spin").quantity<scaling::Frequency>().value() ==
          Approx(2.0 * pi).epsilon(1e-15));
    CHECK(second.conditions.quantity_or("speed", scaling::Velocity::from_value(-1.0)).value() ==
          -1.0);
    // Another ball: its diameter, no longer the sizes of the first, and the first one's material.
    CHECK(second.grain.diameter.value.value() == 6e-3);
    CHECK(second.grain.size_distribution.empty());
    CHECK(second.grain.density.value.value() == 28.0);
    CHECK(c.find("drop-3") == nullptr);
}

TEST_CASE("E = 2 G (1 + nu) where the shear modulus is given", "[cases][read]") {
    const std::string g =
        replaced(sample_case, "\"youngs_modulus\": \"3 GPa\"", "\"shear_modulus\": \"60 MPa\"");
    CHECK(read(g).grain.youngs_modulus.value.value() == Approx(156e6).epsilon(1e-15));
    // 3 GPa / 2.6 = 1.1538 GPa
    const std::string both = "\"youngs_modulus\": \"3 GPa\", \"shear_modulus\": \"1.154 GPa\"";
    CHECK(read(replaced(sample_case, "\"youngs_modulus\": \"3 GPa\"", both))
              .grain.youngs_modulus.value.value() == 3e9);
}

TEST_CASE("a surface energy of the grain is half its work of adhesion", "[cases][read]") {
    std::string json = replaced(sample_case, "\"density\": \"28",
                                "\"surface_energy\": \"30 mJ/m^2\", \"density\": \"28");
    json = replaced(json,
                    ",\n      \"work_of_adhesion\": {\"value\": \"50 mJ/m^2\", \"range\": [\"10 "
                    "mJ/m^2\", \"0.1 J/m^2\"]}",
                    "");
    CHECK(read(json).model.value_or("work_of_adhesion", -1.0) == Approx(0.06).epsilon(1e-15));
}

TEST_CASE("walls take the grains' parameters but not their adhesion", "[cases][read]") {
    cases::Model model = read(sample_case).model;
    CHECK(model.wall_value_or("restitution", -1.0) == 0.7);
    CHECK(model.wall_value_or("work_of_adhesion", -1.0) == 0.0);
    CHECK(model.wall_value_or("rolling_friction", 0.0) == 0.0);
    model.parameters["wall_restitution"] = {0.4, "1", std::nullopt};
    model.parameters["wall_work_of_adhesion"] = {0.01, "J/m^2", std::nullopt};
    CHECK(model.wall_value_or("restitution", -1.0) == 0.4);
    CHECK(model.wall_value_or("work_of_adhesion", -1.0) == 0.01);
}

TEST_CASE("number fractions are made to sum to one", "[cases][read]") {
    const std::string distribution =
        "\"size_distribution\": [[\"10 %\", \"3 mm\"], [0.5, \"4 mm\"], [\"90 %\", \"5 mm\"]]";
    const cases::Case c =
        read(replaced(sample_case, distribution,
                      "\"sizes\": [[\"1 mm\", 0.33], [\"2 mm\", 0.33], [\"3 mm\", 0.33]]"));
    REQUIRE(c.grain.sizes.size() == 3);
    CHECK(c.grain.sizes[2].first.value() == 3e-3);
    CHECK(c.grain.sizes[2].second == Approx(1.0 / 3.0).epsilon(1e-15));
}

TEST_CASE("a folder and its case.json are the same case", "[cases][read]") {
    CHECK(cases::read_case("data/zirconia").title ==
          cases::read_case("data/zirconia/case.json").title);
}

TEST_CASE("every case that comes with the project can be read", "[cases][read]") {
    int read = 0;
    for (const char* root : {"data", "tests/cases/data"}) {
        for (const auto& entry : std::filesystem::directory_iterator(root)) {
            if (!std::filesystem::exists(entry.path() / "case.json")) continue;
            CAPTURE(entry.path().string());
            CHECK_NOTHROW(cases::read_case(entry.path().string()));
            ++read;
        }
    }
    CHECK(read >= 3);
}

TEST_CASE("the example pile has four sizes and a recorded height field", "[cases][read]") {
    const cases::Case c = cases::read_case("tests/cases/data/pile-adhesion");
    CHECK(c.grain.sizes.size() == 4);
    const cases::Experiment& pile = c.experiments.at(0);
    CHECK(pile.conditions.at("base").text() == "glued_grains");
    CHECK(pile.conditions.at("grains").count() == 1300);
    CHECK(pile.conditions.at("feed_rate").quantity<scaling::Frequency>().value() == 886.0);
    // Its first row reads 15.0,0.562,9.115 in deg, mm, mm.
    CHECK(pile.recording->values("azimuth")[0] == Approx(pi / 12.0).epsilon(1e-15));
    CHECK(pile.recording->values("z")[0] == Approx(9.115e-3).epsilon(1e-15));
}

// Niu et al. (2026), doi:10.3390/coatings16091016: Tables 1, 4, 11 and sections 2.2, 4.3.
TEST_CASE("the zirconia case holds the numbers of the paper", "[cases][read]") {
    const cases::Case c = cases::read_case("data/zirconia");
    CHECK(c.grain.diameter.value.value() == 1.2e-6);
    CHECK(c.grain.density.value.value() == 5600.0);
    CHECK(c.grain.youngs_modulus.value.value() == Approx(2.6 * 60e6).epsilon(1e-15));
    REQUIRE(c.grain.size_distribution.size() == 5);
    CHECK(c.grain.size_distribution[4].first == Approx(0.9).epsilon(1e-15));
    CHECK(c.grain.size_distribution[4].second.value() == 5.101e-6);
    CHECK(c.plate.youngs_modulus.value() == Approx(2.6 * 70e9).epsilon(1e-15));
    CHECK(c.model.value_or("sliding_friction", 0.0) == 0.8);
    CHECK(c.model.wall_value_or("sliding_friction", 0.0) == 0.45);
    CHECK(c.model.wall_value_or("work_of_adhesion", -1.0) == 0.0);
    CHECK(c.model.find("work_of_adhesion") == nullptr);
    CHECK(c.scaling->scaled_work_of_adhesion->value() == Approx(2.0 * 0.19).epsilon(1e-15));
    const cases::Value& funnel = c.experiments.at(0).conditions.at("funnel");
    CHECK(funnel.at("outlet_height").quantity<scaling::Length>().value() == 0.065);
    const std::vector<double>& angles = c.experiments.at(0).recording->values("angle_of_repose");
    REQUIRE(angles.size() == 3);
    CHECK(angles[0] == Approx(50.0 * pi / 180.0).epsilon(1e-15));
    CHECK(angles[2] == Approx(56.0 * pi / 180.0).epsilon(1e-15));
    CHECK(c.stated.counts.grains == std::vector<double>{1e6, 1e5});
    CHECK(c.stated.counts.time_step->value() == 7.78e-7);
    CHECK(c.stated.counts.wall_time->value() == 21600.0);
    CHECK(c.stated.counts.heap->packing_fraction == Approx(2050.0 / 5600.0).epsilon(1e-15));
}

TEST_CASE("a force curve may say where the drive touches, with an uncertainty", "[cases][read]") {
    const auto text = [](const std::string& written) {
        return cases::Value{.where = "case.json: conditions",
                            .kind = cases::Value::Kind::text,
                            .written_text = written};
    };
    cases::Value conditions{.where = "case.json: conditions"};
    conditions.members = {{"counterpart", text("plate")},
                          {"preload", text("1 nN")},
                          {"contact_displacement", text("-2 um")}};
    const cases::RigRule& rig = cases::rig_rule("pull_off");
    CHECK_NOTHROW(cases::check_conditions(rig, conditions));
    cases::Value pair{.where = "case.json: conditions"};
    pair.members = {{"value", text("-2 um")}, {"uncertainty", text("1 um")}};
    conditions.members.back().second = pair;
    CHECK_NOTHROW(cases::check_conditions(rig, conditions));
    conditions.members.back().second = text("2 N");
    CHECK_THROWS_AS(cases::check_conditions(rig, conditions), scaling::InvalidInput);
}
