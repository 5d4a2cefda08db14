// SPDX-License-Identifier: MIT
// Materials by name and the laws of their pairs: read, and refused in one line.
#include "cases/read_case.hpp"
#include "scaling/errors.hpp"
#include "temporary_case.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace {

// Two kinds of beads through a steel funnel onto a plate; a rubber mat on a mesh.
const std::string mixture = R"({
  "format": "similitude-case/1",
  "grain": {"diameter": "2 mm", "density": "2500 kg/m^3", "youngs_modulus": "60 GPa", "poisson_ratio": 0.2,
            "sizes": [["2 mm", 0.75], ["1 mm", 0.25, "rubber"]]},
  "plate": {"youngs_modulus": "3 GPa", "poisson_ratio": 0.4},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "materials": {
    "steel": {"youngs_modulus": "200 GPa", "poisson_ratio": 0.28},
    "rubber": {"shear_modulus": "2 MPa", "poisson_ratio": 0.49, "density": "1100 kg/m^3"}
  },
  "model": {
    "physics": ["gravity", "hertz_mindlin", "rolling_resistance", "adhesion"],
    "parameters": {"restitution": {"value": 0.8}, "sliding_friction": {"value": 0.4},
                   "rolling_friction": {"value": 0.01}, "work_of_adhesion": {"value": "0 J/m^2"}},
    "pairs": [
      {"between": ["grain", "steel"], "sliding_friction": 0.15},
      {"between": ["steel", "rubber"], "sliding_friction": 0.9, "restitution": 0.3},
      {"between": ["rubber", "rubber"], "rolling_friction": 0.2, "work_of_adhesion": "10 mJ/m^2"}
    ]
  },
  "experiments": [
    {"id": "heap", "rig": "pile",
     "conditions": {"base": "flat", "base_diameter": "40 mm", "grains": 200, "funnel":
       {"outlet_diameter": "10 mm", "top_diameter": "30 mm", "height": "20 mm", "outlet_height": "30 mm", "material": "steel"}}}
  ]
})";

std::string mistake_in(const std::string& json) {
    const TemporaryFolder folder;
    const std::string path = folder.write("case.json", json);
    const std::string message = message_of<scaling::InvalidInput>([&] { cases::read_case(path); });
    CHECK(message.find('\n') == std::string::npos);
    const std::size_t at = message.find("case.json: ");
    REQUIRE(at != std::string::npos);
    return message.substr(at + 11);
}

std::string after(const std::string& old, const std::string& by) {
    return mistake_in(replaced(mixture, old, by));
}

cases::Case read(const std::string& json) {
    const TemporaryFolder folder;
    return cases::read_case(folder.write("case.json", json));
}

}  // namespace

TEST_CASE("materials, sizes, walls and pairs are read by name", "[cases][materials]") {
    const cases::Case c = read(mixture);
    REQUIRE(c.materials.size() == 2);
    CHECK(c.materials[0].name == "steel");
    CHECK(c.materials[0].youngs_modulus.value() == 200e9);
    CHECK_FALSE(c.materials[0].density);
    CHECK(c.materials[1].youngs_modulus.value() == Approx(2.0 * 1.49 * 2e6).epsilon(1e-14));
    CHECK(c.materials[1].density->value() == 1100.0);
    const int steel = 2, rubber = 3;
    const cases::Experiment& heap = c.experiments.at(0);
    CHECK(heap.grain.size_material == std::vector<int>{cases::material_of_grain, rubber});
    CHECK(heap.wall_material.base == cases::material_of_plate);
    CHECK(heap.wall_material.funnel == steel);
    REQUIRE(c.model.pairs.size() == 3);
    const auto& pairs = c.model.pairs;
    CHECK(pairs[0].between == std::array{cases::material_of_grain, steel});
    CHECK(pairs[0].sliding_friction == 0.15);
    CHECK_FALSE(pairs[0].restitution);
    CHECK(pairs[1].between == std::array{steel, rubber});
    CHECK(pairs[1].restitution == 0.3);
    CHECK(pairs[2].between == std::array{rubber, rubber});
    CHECK(pairs[2].rolling_friction == 0.2);
    CHECK(pairs[2].work_of_adhesion == 0.01);
}

TEST_CASE("where every wall has its own material no plate is asked for", "[cases][materials]") {
    const std::string plate = "\"plate\": {\"youngs_modulus\": \"3 GPa\", \"poisson_ratio\": 0.4},";
    CHECK(after(plate, "") ==
          "experiments[0].plate: got nothing, must be given for the rig pile (add \"plate\" to the "
          "case or to this experiment)");
    const cases::Case c = read(replaced(replaced(mixture, plate, ""), "\"base\": \"flat\"",
                                        "\"base\": \"flat\", \"base_material\": \"rubber\""));
    CHECK(c.experiments.at(0).wall_material.base == 3);
}

TEST_CASE("a material that is not there is named beside the nearest", "[cases][materials][bad]") {
    const std::string rule = ", must be one of grain, plate, steel, rubber (did you mean ";
    CHECK(after("\"material\": \"steel\"", "\"material\": \"stel\"") ==
          "experiments[0].conditions.funnel.material: got \"stel\"" + rule + "\"steel\"?)");
    CHECK(after("0.25, \"rubber\"]", "0.25, \"ruber\"]") ==
          "grain.sizes[1][2]: got \"ruber\"" + rule + "\"rubber\"?)");
    CHECK(after("[\"grain\", \"steel\"]", "[\"grains\", \"steel\"]") ==
          "model.pairs[0].between[0]: got \"grains\"" + rule + "\"grain\"?)");
}

TEST_CASE("a pair that contradicts, repeats or says nothing is refused",
          "[cases][materials][bad]") {
    CHECK(
        after("[\"grain\", \"steel\"]", "[\"grain\", \"grain\"]")
            .starts_with("model.pairs[0].between: got a list of 2, must not be grain with grain"));
    CHECK(
        after("[\"grain\", \"steel\"]", "[\"plate\", \"grain\"]")
            .starts_with("model.pairs[0].between: got a list of 2, must not be grain with plate"));
    CHECK(after("[\"grain\", \"steel\"]", "[\"rubber\", \"steel\"]") ==
          "model.pairs[1].between: got a list of 2, must stand once (join the two)");
    CHECK(after("\"steel\"], \"sliding_friction\": 0.15", "\"steel\"]")
              .starts_with("model.pairs[0]: got an object of 1 keys, must say something"));
    CHECK(after("\"sliding_friction\": 0.15", "\"friction\": 0.15")
              .starts_with("model.pairs[0].friction: got an unknown key"));
    CHECK(after("\"sliding_friction\": 0.15", "\"sliding_friction\": -0.15")
              .starts_with("model.pairs[0].sliding_friction: got -0.15, must be >= 0"));
    CHECK(after("\"rolling_resistance\", ", "") ==
          "model.pairs[2].rolling_friction: got 0.2, must belong to rolling_resistance in physics "
          "(add \"rolling_resistance\" to model.physics, or remove it)");
    CHECK(after(", \"adhesion\"]", "]").starts_with("model.pairs[2].work_of_adhesion"));
    CHECK(after("\"10 mJ/m^2\"", "0.01").starts_with("model.pairs[2].work_of_adhesion: got 0.01"));
}

TEST_CASE("a material must be whole for what it is used for", "[cases][materials][bad]") {
    CHECK(after(", \"density\": \"1100 kg/m^3\"", "") ==
          "materials.rubber.density: got nothing, must be given for a material of grains (add the "
          "key \"density\")");
    CHECK(after("\"youngs_modulus\": \"200 GPa\", ", "")
              .starts_with("materials.steel.youngs_modulus: got nothing, must be given"));
    CHECK(after("0.25, \"rubber\"]", "0.25, \"plate\"]")
              .starts_with("grain.sizes[1][2]: got \"plate\", must be of a material of grains"));
    CHECK(
        after("\"steel\": {", "\"grain\": {")
            .starts_with("materials.grain: got an object of 2 keys, must have a name of its own"));
    CHECK(after("\"base\": \"flat\"", "\"base\": \"glued_grains\", \"base_material\": \"steel\"")
              .starts_with("experiments[0].conditions.base_material: got \"steel\", must belong to "
                           "a flat base"));
}
