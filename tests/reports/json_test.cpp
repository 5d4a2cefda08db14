// SPDX-License-Identifier: MIT
#include "reports/json.hpp"

#include "samples.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <limits>

using reports::Json;

TEST_CASE("json: the study has the keys of its format in their order", "[reports][json]") {
    const Json j = reports::to_json(zirconia_study("paper"));
    std::vector<std::string> keys;
    for (const auto& [key, value] : j.items()) keys.push_back(key);
    CHECK(keys == std::vector<std::string>{"units", "scheme", "kept", "distorted", "h", "softening",
                                           "exact_in_binary", "factors", "groups", "adhesion",
                                           "scale_number", "cost", "findings"});
}

TEST_CASE("json: Feng and Owen's exponents stand as exact fractions", "[reports][json]") {
    // Length and time as h with density kept: force h^2, energy h^3, velocity and stress 1,
    // acceleration 1/h, by dimension alone.
    const Json factors = reports::to_json(zirconia_study("exact")).at("factors");
    const std::vector<std::pair<const char*, const char*>> expected = {
        {"length", "1"},         {"density", "0"},  {"time", "1"},   {"velocity", "0"},
        {"acceleration", "-1"},  {"gravity", "-1"}, {"mass", "3"},   {"force", "2"},
        {"stress", "0"},         {"strain", "0"},   {"energy", "3"}, {"stiffness", "1"},
        {"surface_energy", "1"}, {"mass_rate", "2"}};
    for (const auto& [name, exponent] : expected) {
        INFO(name);
        CHECK(factors.at(name).at("exponent") == exponent);
    }
    const Json kept = reports::to_json(zirconia_study("kept_gravity")).at("factors");
    CHECK(kept.at("time").at("exponent") == "1/2");
    CHECK(kept.at("time").at("factor").get<double>() == Approx(14.142135623730951).epsilon(1e-15));
    CHECK(kept.at("surface_energy").at("exponent") == "2");
}

TEST_CASE("json: groups say kept or broken, adhesion both grains, the scale number both classes",
          "[reports][json]") {
    const Json j = reports::to_json(zirconia_study("paper"));
    CHECK(j.at("groups").at("weight_bond").at("status") == "kept");
    CHECK(j.at("groups").at("size_ratio").at("status") == "broken");
    CHECK(j.at("adhesion").at("invariant") == "weight_bond");
    CHECK(j.at("adhesion").at("scaled").at("surface_energy").get<double>() ==
          Approx(0.19).epsilon(1e-12));
    CHECK(j.at("adhesion").at("original").at("surface_energy").get<double>() ==
          Approx(4.75e-6).epsilon(1e-12));
    CHECK(j.at("adhesion").at("findings").size() > 5);
    CHECK(j.at("scale_number").at("original").get<double>() == Approx(1e4).epsilon(1e-12));
    CHECK(j.at("scale_number").at("scaled").get<double>() == Approx(50.0).epsilon(1e-12));
}

TEST_CASE("json: what is not known is null and says why", "[reports][json]") {
    const Json j = reports::to_json(zirconia_study("exact"));  // no duration is given
    CHECK(j.at("cost").at("scaled").at("steps").is_null());
    CHECK_FALSE(j.at("cost").at("scaled").at("reasons").at("steps").get<std::string>().empty());
    scaling::ScaleStudy study = zirconia_study("exact");
    study.groups.front().ratio = std::numeric_limits<double>::quiet_NaN();
    const std::string text = reports::text_of(reports::to_json(study));
    CHECK(times_in(text, "nan") == 0);
    CHECK(Json::parse(text).at("groups").front().at("ratio").is_null());
}

TEST_CASE("json: a number read back is the same double", "[reports][json]") {
    scaling::ScaleStudy study = zirconia_study("exact");
    study.h = 0.1 + 0.2;
    CHECK(Json::parse(reports::text_of(reports::to_json(study))).at("h").get<double>() ==
          0.1 + 0.2);
}
