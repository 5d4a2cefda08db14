// SPDX-License-Identifier: MIT
#include "reports/against.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

using Catch::Matchers::Contains;

namespace {

verify::AgainstLammps sample() {
    verify::AgainstLammps a;
    a.release = "29 Sep 2021";
    a.checks = {verify::check_absolute({"gap", "g", "m", "one step", "LAMMPS"}, 1e-6, 1.2e-6, 1e-6),
                verify::check_relative({"force", "g", "N", "digits", "LAMMPS"}, 2.0, 2.1, 1e-6)};
    a.differences = {{.rule = "lever",
                      .ours = "R - d/2",
                      .theirs = "R",
                      .conditions = "40 deg",
                      .measure = "force",
                      .size = 0.002},
                     {.rule = "wall",
                      .ours = "ends",
                      .theirs = "goes on",
                      .conditions = "head-on",
                      .measure = "force",
                      .size = HUGE_VAL}};
    return a;
}

}  // namespace

TEST_CASE("against: one figure outside its bar is a no, and is named", "[reports][lammps]") {
    verify::AgainstLammps a = sample();
    CHECK(reports::verdict_of(a).answer == reports::Answer::no);
    CHECK_THAT(reports::text_of(a),
               Contains("1 of 2 figures") && Contains("NOT MET") && Contains("not a number"));
    a.checks.pop_back();
    CHECK(reports::verdict_of(a).answer == reports::Answer::yes);
    CHECK_THAT(reports::text_of(a), !Contains("NOT MET"));
}

TEST_CASE("against: an angle is written in degrees, without a prefix", "[reports][lammps]") {
    verify::AgainstLammps a = sample();
    a.checks = {
        verify::check_absolute({"angle", "g", "deg", "margin", "LAMMPS"}, 33.75, 33.7, 2.5)};
    CHECK_THAT(reports::text_of(a), Contains("33.75 deg") && Contains("2.5 deg"));
}

TEST_CASE("against: JSON holds every figure, and null where a size is not finite",
          "[reports][lammps]") {
    const reports::Json json = reports::to_json(sample());
    CHECK(json.at("verdict") == "no");
    CHECK(json.at("checks").size() == 2);
    CHECK(json.at("against").at("release") == "29 Sep 2021");
    CHECK(json.at("against").at("differences").at(0).at("size") == 0.002);
    CHECK(json.at("against").at("differences").at(1).at("size").is_null());
    CHECK(json.at("against").at("heaps").is_null());
}

TEST_CASE("against: the page has the figures, the differences and the heaps", "[reports][lammps]") {
    verify::AgainstLammps a = sample();
    a.heaps = verify::HeapRound{};
    a.heaps->heaps = {{7, 33.96, {}, 25.0, 1e-9, 1e-9, 990.0, 995.0, 9.0, 30.0}};
    const std::string page = reports::html(reports::page_of(a, {}));
    CHECK_THAT(page, Contains("Figures and their bars") && Contains("Where the rules differ") &&
                         Contains("Heaps of a slumped column") && Contains("34.0") &&
                         !Contains("Exact answers"));
}
