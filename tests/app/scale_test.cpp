// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

const std::string zirconia = "data/zirconia/case.json";

Json scale(std::vector<std::string> more) {
    std::vector<std::string> all = {"scale", zirconia, "--json", "-", "--threads", "1"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome o = similitude(all);
    INFO(o.err);
    REQUIRE(o.code == 0);
    CHECK(o.err.empty());
    return o.json();
}

std::string exponent(const Json& j, const char* quantity) {
    return j.at("factors").at(quantity).at("exponent");
}

}  // namespace

TEST_CASE("scale: the paper's powder under its own scheme has every key that the format promises",
          "[app][scale]") {
    const Json j = scale({});
    for (const char* key :
         {"scheme", "h", "factors", "groups", "adhesion", "scale_number", "cost", "findings"}) {
        INFO(key);
        CHECK(j.contains(key));
    }
    for (const char* quantity :
         {"length",        "density",          "time",           "velocity",
          "acceleration",  "gravity",          "mass",           "force",
          "stress",        "strain",           "youngs_modulus", "shear_modulus",
          "poisson_ratio", "energy",           "surface_energy", "work_of_adhesion",
          "stiffness",     "damping",          "viscosity",      "liquid_volume",
          "mass_rate",     "apparatus_length", "contact_time"}) {
        INFO(quantity);
        CHECK(j.at("factors").contains(quantity));
    }
    CHECK(j.at("scheme") == "paper");
    CHECK(j.at("h") == 200.0);
    CHECK(j.at("scale_number").at("original").get<double>() == Approx(10000.0).epsilon(1e-12));
    CHECK(j.at("scale_number").at("scaled").get<double>() == Approx(50.0).epsilon(1e-12));
}

TEST_CASE("scale: the exponents of Table 2 come out under the exact scheme", "[app][scale]") {
    // Niu et al. (2026), Table 2: length, time h; density, velocity, stress, strain, moduli 1;
    // mass, energy h^3; force h^2.
    const Json j = scale({"--scheme", "exact"});
    const std::vector<std::pair<const char*, const char*>> table = {
        {"length", "1"},         {"density", "0"},       {"time", "1"},
        {"velocity", "0"},       {"acceleration", "-1"}, {"mass", "3"},
        {"force", "2"},          {"stress", "0"},        {"strain", "0"},
        {"youngs_modulus", "0"}, {"shear_modulus", "0"}, {"poisson_ratio", "0"},
        {"energy", "3"}};
    for (const auto& [quantity, expected] : table) {
        INFO(quantity);
        CHECK(exponent(j, quantity) == expected);
    }
    CHECK(exponent(j, "surface_energy") == "1");
    CHECK(exponent(scale({"--scheme", "kept_gravity"}), "surface_energy") == "2");
}

TEST_CASE("scale: the invariant decides the exponent of adhesion", "[app][scale]") {
    // F_po/(m g) ~ w/(rho g d^2): h^2; with the apparatus kept sigma = rho g D stays and
    // F_po/(sigma R^2) ~ w/d: h.
    CHECK(exponent(scale({"--invariant", "weight_bond"}), "work_of_adhesion") == "2");
    CHECK(exponent(scale({"--invariant", "stress_bond"}), "work_of_adhesion") == "1");
    CHECK(exponent(scale({"--invariant", "cohesion_number"}), "work_of_adhesion") == "8/5");
    const Json scaled = scale(
        {"--keep", "density,gravity,youngs_modulus", "--distorted", "--invariant", "stress_bond"});
    CHECK(exponent(scaled, "work_of_adhesion") == "2");
}

TEST_CASE("scale: what belongs to one surface is half of what belongs to a pair", "[app][scale]") {
    const Json gamma = scale({"--surface-energy", "0.19 J/m^2", "--of", "scaled"});
    const Json w = scale({"--work-of-adhesion", "0.38 J/m^2", "--of", "scaled"});
    CHECK(gamma.at("adhesion") == w.at("adhesion"));
    CHECK(w.at("adhesion").at("original").at("surface_energy").get<double>() ==
          Approx(0.19 / 4e4).epsilon(1e-12));
}

TEST_CASE(
    "scale: 30 mJ/m^2 carried to h = 200 by grain weights makes no usable grain, and the program "
    "says so",
    "[app][scale]") {
    // 0.03 * 200^2 = 1200 J/m^2 per surface; zero-load neck a0/R = (9 pi w / (8 E* R))^(1/3) =
    // 0.94.
    const Outcome o = similitude(
        {"scale", zirconia, "--surface-energy", "30 mJ/m^2", "--of", "original", "--json", "-"});
    CHECK(o.code == 5);
    const Json a = o.json().at("adhesion");
    CHECK(a.at("scaled").at("surface_energy").get<double>() == Approx(1200.0).epsilon(1e-12));
    CHECK_FALSE(a.at("physically_usable").get<bool>());
    CHECK(a.at("findings").at(0).at("value").get<double>() ==
          Approx(0.94).epsilon(0.005));  // two digits
}

TEST_CASE("scale: the table for people goes to standard output, files where they were asked for",
          "[app][scale]") {
    const Folder f;
    const Outcome o = similitude(
        {"scale", zirconia, "--json", f / "new/scale.json", "--report", f / "scale.html"});
    CHECK(o.code == 0);
    CHECK(o.out.find("BROKEN") != std::string::npos);
    CHECK(Json::parse(contents(f / "new/scale.json")).at("scheme") == "paper");
    CHECK(contents(f / "scale.html").find("<!DOCTYPE html>") == 0);
    CHECK(similitude({"scale", zirconia, "--quiet"}).out.empty());
}

TEST_CASE("command line: help has two examples per verb and version its number, both fine",
          "[app]") {
    for (const char* verb : {"scale", "simulate", "verify"}) {
        const Outcome o = similitude({verb, "--help"});
        INFO(verb);
        CHECK(o.code == 0);
        const std::size_t first = o.out.find(std::string("  similitude ") + verb);
        REQUIRE(first != std::string::npos);
        CHECK(o.out.find(std::string("  similitude ") + verb, first + 1) != std::string::npos);
    }
    CHECK(similitude({"--version"}).out.find("similitude ") == 0);
    CHECK(similitude({"--version"}).code == 0);
}
