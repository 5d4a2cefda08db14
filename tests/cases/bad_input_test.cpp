// SPDX-License-Identifier: MIT
// Every mistake is one line: place in the input, value, rule, remedy.
#include "cases/read_case.hpp"
#include "sample_case.hpp"
#include "scaling/errors.hpp"
#include "temporary_case.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

namespace {

// The message behind "case.json", for the sample with its only `old` replaced.
std::string mistake_in(const std::string& json, const std::string& recording = sample_recording) {
    const TemporaryFolder folder;
    folder.write("drop-1.csv", recording);
    const std::string path = folder.write("case.json", json);
    const std::string message = message_of<scaling::InvalidInput>([&] { cases::read_case(path); });
    CHECK(std::count(message.begin(), message.end(), '\n') == 0);
    const std::size_t at = message.find(folder.path());
    REQUIRE(at != std::string::npos);
    return message.substr(0, at) + message.substr(at + folder.path().size() + 1);
}

std::string after(const std::string& old, const std::string& by) {
    return mistake_in(replaced(sample_case, old, by));
}

}  // namespace

TEST_CASE("a missing unit is named and suggested", "[cases][bad]") {
    CHECK(
        after("\"density\": \"28 kg/m^3\"", "\"density\": 28") ==
        "case.json: grain.density: got 28, must be a density with its unit (write \"28 kg/m^3\")");
    CHECK(
        after("\"density\": \"28 kg/m^3\"", "\"density\": \"28\"") ==
        "case.json: grain.density: got 28, must be a density with its unit (write \"28 kg/m^3\")");
    CHECK(after("[\"10 mJ/m^2\", \"0.1 J/m^2\"]", "[0.01, 0.1]") ==
          "case.json: model.parameters.work_of_adhesion.range[0]: got 0.01, must be an energy per "
          "area with its unit "
          "(write \"0.01 J/m^2\")");
}

TEST_CASE("a friction cap belongs to piles, and is one that contact laws have", "[cases][bad]") {
    CHECK(after("\"model\": {", "\"model\": {\"friction_cap\": \"elastic\",") ==
          "case.json: model.friction_cap: got \"elastic\", must not stand in a case with the rig "
          "drop (only piles know it: give them a case of their own)");
    CHECK(after("\"model\": {", "\"model\": {\"friction_cap\": \"repulsive_par\",")
              .find("did you mean \"repulsive_part\"?") != std::string::npos);
}

TEST_CASE("a wrong dimension is named beside the right one", "[cases][bad]") {
    CHECK(after("\"value\": \"50 mJ/m^2\"", "\"value\": \"50 mJ/m^3\"") ==
          "case.json: model.parameters.work_of_adhesion.value: got \"50 mJ/m^3\" [M L^-1 T^-2], "
          "must be an energy per area "
          "[M T^-2] (did you mean \"50 mJ/m^2\"?)");
    CHECK(after("\"height\": \"600 mm\"", "\"height\": \"600 ms\"") ==
          "case.json: experiments[0].conditions.height: got \"600 ms\" [T], must be a length [L] "
          "(write it in m)");
}

TEST_CASE("an unknown key is named with its full path, at every depth", "[cases][bad]") {
    CHECK(after("\"title\"", "\"titel\"") ==
          "case.json: titel: got an unknown key, must be one of format, title, source, grain, "
          "plate, surroundings, materials, model, "
          "experiments, scaling, stated (did you mean \"title\"?)");
    CHECK(after("\"height\": \"600 mm\"", "\"hieght\": \"600 mm\"") ==
          "case.json: experiments[0].conditions.hieght: got an unknown key, must be one of height, "
          "speed, horizontal_speed, "
          "spin, release_time (did you mean \"height\"?)");
    CHECK(after("\"uncertainty\": \"0.1 mm\"", "\"sigma\": \"0.1 mm\"") ==
          "case.json: grain.diameter.sigma: got an unknown key, must be one of value, uncertainty "
          "(remove it, or correct "
          "its name)");
    CHECK(after("\"range\": [0.2, 0.98]", "\"ranges\": [0.2, 0.98]") ==
          "case.json: model.parameters.restitution.ranges: got an unknown key, must be one of "
          "value, range (did you mean "
          "\"range\"?)");
    CHECK(after("\"noise\": {\"z\"", "\"noise\": {\"y\"") ==
          "case.json: experiments[0].noise.y: got an unknown key, must be one of t, z, x (did you "
          "mean \"t\"?)");
    CHECK(after("\"h\": 200", "\"h\": 200, \"factor\": 2")
              .starts_with("case.json: scaling.factor: got an unknown key"));
    CHECK(after("\"time_step\"", "\"timestep\"")
              .starts_with("case.json: model.numerics.timestep: got an unknown key"));
    CHECK(after("\"gravity\": \"9.81", "\"gravitation\": \"9.81")
              .starts_with("case.json: surroundings.gravitation: got an unknown"));
    CHECK(after("\"restitution\": {", "\"restituton\": {")
              .starts_with("case.json: model.parameters.restituton: got an unknown"));
}

TEST_CASE("a name that is not known is named with the nearest", "[cases][bad]") {
    CHECK(after("\"adhesion\"]", "\"adhesive\"]")
              .starts_with("case.json: model.physics[2]: got \"adhesive\", must be one of "));
    CHECK(after("\"adhesion\"]", "\"adhesive\"]").ends_with("(did you mean \"adhesion\"?)"));
    CHECK(after("\"id\": \"drop-1\", \"rig\": \"drop\"", "\"id\": \"drop-1\", \"rig\": \"dorp\"") ==
          "case.json: experiments[0].rig: got \"dorp\", must be one of drop, incline, impact, "
          "pull_off, pile, discharge, "
          "column, drum (did you mean \"drop\"?)");
    CHECK(after("\"role\": \"fit\"", "\"role\": \"train\"") ==
          "case.json: experiments[0].role: got \"train\", must be one of fit, held_out (correct "
          "the name)");
    CHECK(after("\"paper\"", "\"papers\"").ends_with("(did you mean \"paper\"?)"));
    CHECK(after("\"weight_bond\"", "\"wieght_bond\"").ends_with("(did you mean \"weight_bond\"?)"));
    CHECK(after("similitude-case/1", "similitude-case/2") ==
          "case.json: format: got \"similitude-case/2\", must be one of similitude-case/1 (did you "
          "mean \"similitude-case/1\"?)");
}

TEST_CASE("a value out of its range is refused", "[cases][bad]") {
    const std::string diameter = "{\"value\": \"4 mm\", \"uncertainty\": \"0.1 mm\"}";
    CHECK(after(diameter, "\"-4 mm\"") ==
          "case.json: grain.diameter: got \"-4 mm\", must be > 0 (check the sign, and that the "
          "number is not zero)");
    CHECK(after(diameter, "{\"value\": \"4 mm\", \"uncertainty\": \"-1 mm\"}") ==
          "case.json: grain.diameter.uncertainty: got \"-1 mm\", must be >= 0 (check the sign)");
    const std::string nu = GENERATE("0.5", "-1", "7");
    CHECK(after("\"poisson_ratio\": 0.3", "\"poisson_ratio\": " + nu) ==
          "case.json: grain.poisson_ratio: got " + nu +
              ", must be above -1 and below 0.5 (0.5 is incompressible; solids lie between 0.1 and "
              "0.45)");
    CHECK(after("\"value\": 0.7", "\"value\": 1.7")
              .starts_with(
                  "case.json: model.parameters.restitution.value: got 1.7, must be between"));
    CHECK(after("[0.2, 0.98]", "[0.98, 0.2]") ==
          "case.json: model.parameters.restitution.range[1]: got 0.2, must be above the lower end, "
          "0.98 (write [low, high])");
    CHECK(after("[0.2, 0.98]", "[0.8, 0.98]") ==
          "case.json: model.parameters.restitution.value: got 0.7, must lie in its range, 0.8 to "
          "0.98 (widen the range or "
          "correct the value)");
    CHECK(after("\"h\": 200", "\"h\": 0").starts_with("case.json: scaling.h: got 0, must be > 0"));
}

TEST_CASE("a size distribution that falls is refused", "[cases][bad]") {
    CHECK(after("[0.5, \"4 mm\"]", "[0.5, \"2 mm\"]") ==
          "case.json: grain.size_distribution[1][1]: got \"2 mm\", must be above the 3 mm before "
          "it (a cumulative distribution "
          "rises; sort it)");
    CHECK(after("[0.5, \"4 mm\"]", "[\"5 %\", \"4 mm\"]") ==
          "case.json: grain.size_distribution[1][0]: got \"5 %\", must be above the 10 % before it "
          "(a cumulative distribution "
          "rises; sort it)");
    const std::string all =
        "\"size_distribution\": [[\"10 %\", \"3 mm\"], [0.5, \"4 mm\"], [\"90 %\", \"5 mm\"]]";
    CHECK(after(all, "\"sizes\": [[\"1 mm\", 0.5], [\"2 mm\", 0.7]]") ==
          "case.json: grain.sizes: got a list of 2, must have fractions that sum to 1, not to 1.2 "
          "(correct the number fractions)");
    CHECK(after(all, "\"sizes\": [[\"1 mm\", -0.5]]")
              .starts_with("case.json: grain.sizes[0][1]: got -0.5, must be > 0"));
}

TEST_CASE("JSON that ends too soon or is none is refused with line and column", "[cases][bad]") {
    const std::string cut = sample_case.substr(0, sample_case.find("\"density\"") - 1);
    // `grain` is on the fifth line.
    CHECK(mistake_in(cut).starts_with("case.json:5:"));
    CHECK(mistake_in(cut).ends_with(
        ": got the end of the file, must be complete JSON here (grain is not closed)"));
    CHECK(mistake_in("{\n  \"format\": similitude\n}") ==
          "case.json:2:13: got \"similitude\", must be complete JSON here (look inside the "
          "outermost object for a missing "
          "comma, quote or bracket)");
    CHECK(mistake_in("") ==
          "case.json:1:1: got the end of the file, must be complete JSON here (the file is not "
          "closed)");
    CHECK(mistake_in("[1]") ==
          "case.json: got a list of 1, must be an object (begin the file with {)");
    CHECK(mistake_in(std::string(200, '[')).find("must not be nested this deep") !=
          std::string::npos);
}

TEST_CASE("a key that stands twice in an object is refused", "[cases][bad]") {
    CHECK(after("\"density\": \"28 kg/m^3\"",
                "\"density\": \"28 kg/m^3\", \"density\": \"30 kg/m^3\"") ==
          "case.json: grain.density: got the key a second time, must stand once in its object "
          "(remove one of the two)");
}

TEST_CASE("a missing key is named", "[cases][bad]") {
    CHECK(after("\"density\": \"28 kg/m^3\", ", "") ==
          "case.json: grain.density: got nothing, must be given (add the key \"density\")");
    CHECK(after("{\"height\": \"600 mm\"}", "{}") ==
          "case.json: experiments[0].conditions.height: got nothing, must be given (add the key "
          "\"height\")");
    CHECK(after("  \"plate\": {\"youngs_modulus\": \"200 GPa\", \"poisson_ratio\": 0.28},\n", "") ==
          "case.json: experiments[0].plate: got nothing, must be given for the rig drop (add "
          "\"plate\" to the case or to this "
          "experiment)");
    CHECK(after("\"gravity\": \"9.81 m/s^2\", ", "") ==
          "case.json: experiments[0].surroundings.gravity: got nothing above 0, must be given with "
          "\"gravity\" in physics (add it "
          "to the surroundings of the case)");
    CHECK(after("\"adhesion\"]", "\"adhesion\", \"electrostatic\"]") ==
          "case.json: model.parameters.charge: got nothing, must be given with \"electrostatic\" "
          "in physics (add it, or remove "
          "the effect)");
}

TEST_CASE("statements that contradict each other are refused", "[cases][bad]") {
    CHECK(after("\"hertz_mindlin\"", "\"hertz_mindlin\", \"hertz_coulomb\"") ==
          "case.json: model.physics: got a list of 4, must name one contact law, not 2 (add or "
          "leave one of hertz_mindlin, "
          "hertz_coulomb)");
    CHECK(after("\"youngs_modulus\": \"3 GPa\"",
                "\"youngs_modulus\": \"3 GPa\", \"shear_modulus\": \"3 GPa\"") ==
          "case.json: grain.shear_modulus: got \"3 GPa\", must be 1.15385 GPa beside this "
          "youngs_modulus: E = 2 G (1 + nu) "
          "(give one of the two)");
    CHECK(after("\"softening\": 0.5", "\"scaled_surface_energy\": \"0.19 J/m^2\"")
              .starts_with("case.json: scaling: got an object of 4 keys, must not state the "
                           "adhesion of the scaled grain"));
    CHECK(after("\"id\": \"drop-2\"", "\"id\": \"drop-1\"") ==
          "case.json: experiments[1].id: got \"drop-1\", must not be used twice (rename one)");
}

TEST_CASE("a recording that is missing or empty is refused", "[cases][bad]") {
    CHECK(after("\"recording\": \"drop-1.csv\"", "\"recording\": \"drop-9.csv\"")
              .starts_with("case.json: experiments[0].recording: got \"drop-9.csv\", must be a "
                           "file beside case.json (no file "));
    CHECK(
        mistake_in(sample_case, "") ==
        "drop-1.csv: got an empty file, must have a header and rows (export the recording again)");
    const TemporaryFolder folder;
    CHECK(message_of<scaling::InvalidInput>([&] { cases::read_case(folder.path()); }) ==
          folder.path() +
              "/case.json: got no readable file, must be a case (case.json or its folder) (check "
              "the path)");
}

TEST_CASE("conditions of a rig that exclude or need each other are checked", "[cases][bad]") {
    const auto with_pile = [](const std::string& conditions) {
        const std::string drop =
            "\"rig\": \"drop\", \"conditions\": {\"height\": \"600 mm\"}, \"recording\": "
            "\"drop-1.csv\",\n     \"noise\": {\"z\": \"1.5 mm\"}";
        return mistake_in(
            replaced(sample_case, drop, "\"rig\": \"pile\", \"conditions\": {" + conditions + "}"));
    };
    const std::string pile = "\"base_diameter\": \"50 mm\", \"grains\": 100";
    CHECK(with_pile("\"base\": \"flat\", \"rim_height\": \"1 mm\", " + pile) ==
          "case.json: experiments[0].conditions.rim_height: got \"1 mm\", must belong to the base "
          "flat_with_rim (remove "
          "\"rim_height\")");
    CHECK(with_pile("\"base\": \"flat\", \"base_diameter\": \"50 mm\", \"grains\": 1.5") ==
          "case.json: experiments[0].conditions.grains: got 1.5, must be a whole number >= 1 "
          "(write a bare number such as 1300)");
    CHECK(with_pile("\"base\": \"flat\", \"base_diameter\": \"50 mm\", \"grains\": \"many\"") ==
          "case.json: experiments[0].conditions.grains: got \"many\", must be one of "
          "until_it_spills (correct the name)");
    const std::string funnel =
        ", \"funnel\": {\"outlet_diameter\": \"6 mm\", \"top_diameter\": \"50 mm\", \"height\": "
        "\"40 mm\", \"outlet_height\": \"65 mm\"}";
    CHECK(with_pile("\"base\": \"flat\", \"feed_diameter\": \"6 mm\", " + pile + funnel) ==
          "case.json: experiments[0].conditions.feed_diameter: got \"6 mm\", must not stand beside "
          "a funnel (remove "
          "\"feed_diameter\")");
    CHECK(with_pile("\"base\": \"flat\", " + pile + replaced(funnel, "\"6 mm\"", "\"60 mm\""))
              .ends_with("got \"60 mm\", must not be wider than top_diameter (exchange the two)"));
}
