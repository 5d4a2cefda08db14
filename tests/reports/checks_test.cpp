// SPDX-License-Identifier: MIT
#include "reports/checks.hpp"

#include "samples.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace reports;

TEST_CASE("verdict: with too few seeds nothing is claimed and nothing held against it",
          "[reports][verdict]") {
    const Verdict v = verdict_of(cone_verification());
    CHECK(v.answer == Answer::yes);
    CHECK_THAT(v.why, Catch::Contains("equivalence is not claimed"));
}

TEST_CASE("verdict: one failing check is a no that names it", "[reports][verdict]") {
    Verification v = cone_verification();
    v.checks[1] = verify::check_absolute(
        {"a stone falls for a second", "flight", "s", "one step", ""}, 1.0, 1.1, 1e-3);
    CHECK(verdict_of(v).answer == Answer::no);
    CHECK_THAT(verdict_of(v).why, Catch::Contains("a stone falls for a second"));
}

TEST_CASE("verdict: one differing bit is a no", "[reports][verdict]") {
    Verification v = cone_verification();
    v.similarity->bits[1].equal = false;
    CHECK(verdict_of(v).answer == Answer::no);
    CHECK_THAT(verdict_of(v).why, Catch::Contains("kept_gravity"));
}

TEST_CASE(
    "verdict: heaps that differ are a no, heaps not decided with enough seeds an open question",
    "[reports][verdict]") {
    Verification v = cone_verification();
    v.similarity->comparisons[0].answer = verify::Answer::different;
    CHECK(verdict_of(v).answer == Answer::no);
    v.similarity->comparisons[0].answer = verify::Answer::not_decided;
    v.similarity->comparisons[0].claims = true;
    CHECK(verdict_of(v).answer == Answer::cannot_tell);
    v.similarity->comparisons[0].answer = verify::Answer::equivalent;
    CHECK(verdict_of(v).answer == Answer::yes);
}

TEST_CASE("verdict: a control made wrong on purpose must not pass as equivalent",
          "[reports][verdict]") {
    Verification v = cone_verification();
    v.similarity->comparisons.push_back(v.similarity->comparisons[0]);
    v.similarity->comparisons[1].must_differ = true;
    v.similarity->comparisons[1].answer = verify::Answer::different;
    CHECK(verdict_of(v).answer == Answer::yes);
    CHECK(comparison_section(v.similarity->comparisons[1]).verdict.answer == Answer::yes);
    v.similarity->comparisons[1].answer = verify::Answer::equivalent;
    CHECK(verdict_of(v).answer == Answer::no);
    CHECK(comparison_section(v.similarity->comparisons[1]).verdict.answer == Answer::no);
}

TEST_CASE(
    "verification as json: every check has expected, got, tolerance and its reason, the bits among "
    "them",
    "[reports][json]") {
    const Json j = to_json(cone_verification());
    REQUIRE(j.at("checks").size() == 4);
    for (const Json& check : j.at("checks")) {
        for (const char* key :
             {"name", "group", "expected", "got", "unit", "tolerance", "reason", "passed"}) {
            INFO(key);
            CHECK(check.contains(key));
        }
        CHECK_FALSE(check.at("reason").get<std::string>().empty());
    }
    CHECK(j.at("checks").back().at("group") == "bitwise similarity");
    CHECK(j.at("comparisons").at(0).at("reference").at("samples").size() == 3);
}

TEST_CASE("comparison: means, intervals and the seeds behind them are told for both sides",
          "[reports]") {
    const RunSection s = comparison_section(cone_verification().similarity->comparisons[0]);
    REQUIRE(s.quantities.size() == 4);
    // Three values 29, 30, 31: standard error 1/sqrt(3), t_{0.975, 2} = 4.3027 (tables), so 30 +-
    // 2.484.
    CHECK(s.quantities[1][1] == "30 [27.52, 32.48]");
    CHECK(s.intervals.size() == 3);
    CHECK(times_in(s.figure.svg, "scaled, d = 240 \u00b5m") == 1);
}

TEST_CASE("profiles: the band runs from the lowest to the highest seed", "[reports][svg]") {
    const HeapGroup group{"two seeds", {{{0, 1, 2}, {4, 2, 0}}, {{0, 1, 2}, {6, 4, 0}}}};
    const std::string text = profile_figure({group}, "p").svg;
    CHECK(fault_in_markup(text) == "");
    CHECK(times_in(text, "fill-opacity=\"0.18\"") == 1);
    CHECK(profile_figure({{"none", {}}}, "q").svg.empty());
}
