// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;

namespace {

Outcome convert(std::vector<std::string> more) {
    more.insert(more.begin(), "convert");
    return similitude(more);
}

}  // namespace

TEST_CASE("convert: both readings of EDEM's first JKR model, with force and grain weights",
          "[app][convert]") {
    const Outcome o = convert({"adhesion", "--from", "lammps_jkr", "--value", "0.19 J/m^2", "--to",
                               "edem_v1", "--json", "-"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const Json j = o.json();
    REQUIRE(j.at("to").size() == 2);
    CHECK(j.at("to")[0].at("name") == "edem_v1_equations");
    CHECK(j.at("to")[0].at("value").get<double>() == Approx(0.19));
    CHECK(j.at("to")[1].at("name") == "edem_v1_text");
    CHECK(j.at("to")[1].at("value").get<double>() == Approx(0.38));
    // 3 pi gamma R*, R* = 25 um of the assumed 100 um grains; their weight by hand.
    const double force = 3.0 * std::numbers::pi * 0.19 * 25e-6;
    const double weight = 2500.0 * std::numbers::pi / 6.0 * 1e-12 * 9.80665;
    for (const Json& told : {j.at("from"), j.at("to")[0], j.at("to")[1]}) {
        CHECK(told.at("pull_off_force").get<double>() == Approx(force));
        CHECK(told.at("pull_off_in_grain_weights").get<double>() == Approx(force / weight));
    }
    CHECK(j.at("grain").at("assumed") == true);
}

TEST_CASE("convert: all pairs at once, the grain from a case, another invariant",
          "[app][convert]") {
    const Outcome o =
        convert({"adhesion", "--from", "surface_energy", "--value", "20 mJ/m^2", "--case",
                 "data/zirconia", "--keep", "work_of_adhesion", "--json", "-"});
    REQUIRE(o.code == 0);
    const Json j = o.json();
    CHECK(j.at("grain").at("diameter").get<double>() == Approx(1.2e-6));
    for (const Json& to : j.at("to")) {
        INFO(to.at("name"));
        const bool by_area = to.at("unit") == "J/m^3";
        CHECK(to.at("value").is_null() == by_area);  // has no work of adhesion
        if (!by_area) CHECK(to.at("work_of_adhesion").get<double>() == Approx(0.04));
    }
    CHECK(j.at("unpublished").size() == 3);
    CHECK(
        convert({"adhesion", "--from", "surface_energy", "--value", "20 mJ/m^2", "--to", "edem_v2"})
            .code == 5);
}

TEST_CASE("convert: what cannot be converted is said with its reason", "[app][convert][input]") {
    const auto complaint = [](std::vector<std::string> more) {
        const Outcome o = convert(std::move(more));
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        return o.err;
    };
    CHECK_THAT(complaint({"adhesion", "--from", "edem_v1", "--value", "1 J/m^2"}),
               Contains("edem_v1_equations, edem_v1_text"));
    CHECK_THAT(complaint({"adhesion", "--from", "lamps_jkr", "--value", "1 J/m^2"}),
               Contains("did you mean lammps_jkr?"));
    CHECK_THAT(complaint({"adhesion", "--from", "lammps_jkr", "--value", "0.1"}),
               Contains("0.1 J/m^2"));
    CHECK_THAT(complaint({"adhesion", "--from", "lammps_jkr", "--value", "-1 J/m^2"}),
               Contains("must be > 0"));
    CHECK_THAT(complaint({"adhesion", "--from", "liggghts_sjkr", "--value", "1 J/m^3"}),
               Contains("--youngs-modulus"));
    CHECK_THAT(complaint({"rolling", "--from", "edem_standard", "--value", "0"}),
               Contains("must be > 0"));
    CHECK_THAT(complaint({"damping", "--value", "1.5"}), Contains("between 0 and 1"));
}

TEST_CASE("convert: rolling friction keeps the largest torque, grain on grain and at a wall",
          "[app][convert]") {
    const auto lammps = [](std::vector<std::string> more) {
        std::vector<std::string> all = {"rolling", "--from",     "edem_standard", "--value", "0.1",
                                        "--to",    "lammps_sds", "--json",        "-"};
        all.insert(all.end(), more.begin(), more.end());
        return convert(all).json().at("to")[0].at("value").get<double>();
    };
    CHECK(lammps({}) == Approx(0.2));  // R against R/2
    CHECK(lammps({"--wall"}) == Approx(0.1));
}
