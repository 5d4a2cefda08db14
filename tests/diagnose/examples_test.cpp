// SPDX-License-Identifier: MIT
// The five single-grain examples that came with the project's design (data/SOURCE): their truth stands beside them.
#include "cases/read_case.hpp"
#include "diagnose/diagnose.hpp"
#include "verdicts.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace {

diagnose::Verdict verdict_on(const std::string& name, int threads, int* opened = nullptr) {
    const std::string path = "tests/diagnose/data/" + name + "/case.json";
    const cases::Case c = cases::read_case(path, cases::HeldOut::sealed);
    return diagnose::diagnose(c, {.seed = 1, .threads = threads}, [&](cases::Case& sealed) {
        if (opened) ++*opened;
        cases::open_held_out(sealed);
    });
}

}  // namespace

TEST_CASE("diagnose: drag left out of a falling bead is named, held-out error falls",
          "[diagnose]") {
    int opened = 0;
    const diagnose::Verdict v = verdict_on("drop-air-drag", 1, &opened);
    CHECK(opened == 1);
    CHECK(v.answer == diagnose::Answer::explained);
    CHECK(named(v) == std::vector<std::string>{"air_drag"});
    REQUIRE(v.held_out);
    CHECK(v.held_out->nrmse_extended < v.held_out->nrmse_base / 3.0);
}

TEST_CASE("diagnose: rolling resistance is named, its friction within three errors", "[diagnose]") {
    const diagnose::Verdict v = verdict_on("incline-rolling-resistance", 1);
    CHECK(v.answer == diagnose::Answer::explained);
    REQUIRE(named(v) == std::vector<std::string>{"rolling_resistance"});
    // The truth of the example is 0.012; a 90 % interval is 1.645 errors either side.
    const diagnose::Estimate& e = v.effects.front().parameters.front();
    CHECK(std::abs(e.value - 0.012) < 3.0 * (e.high - e.low) / 3.29);
}

TEST_CASE("diagnose: adhesion of a force curve is named, w within three errors", "[diagnose]") {
    const diagnose::Verdict v = verdict_on("pull-off-adhesion", 1);
    CHECK(v.answer == diagnose::Answer::explained);
    REQUIRE(named(v) == std::vector<std::string>{"adhesion"});
    const diagnose::Estimate& e = v.effects.front().parameters.front();  // truth 0.09 J/m^2
    CHECK(std::abs(e.value - 0.09) < 3.0 * (e.high - e.low) / 3.29);
}

TEST_CASE("diagnose: where nothing was left out nothing is named", "[diagnose]") {
    const diagnose::Verdict v = verdict_on("drop-nothing-left-out", 1);
    CHECK(v.answer == diagnose::Answer::consistent);
    CHECK(v.located.empty());
}

TEST_CASE("diagnose: a magnet is in no catalogue, but its pull towards the plate is seen",
          "[diagnose]") {
    const diagnose::Verdict v = verdict_on("drop-magnet", 1);
    CHECK(v.answer == diagnose::Answer::unexplained);
    REQUIRE(v.effects.front().missing);
    CHECK(v.effects.front().missing->words.find("attraction to the plate") != std::string::npos);
}

TEST_CASE("diagnose: the number of threads changes nothing", "[diagnose]") {
    const diagnose::Verdict one = verdict_on("incline-rolling-resistance", 1),
                            three = verdict_on("incline-rolling-resistance", 3);
    CHECK(one.p_value == three.p_value);
    REQUIRE(one.hypotheses.size() == three.hypotheses.size());
    for (std::size_t k = 0; k < one.hypotheses.size(); ++k)
        CHECK(one.hypotheses[k].probability == three.hypotheses[k].probability);
}

TEST_CASE("diagnose: experiments that are all held out decide nothing", "[diagnose]") {
    cases::Case c = cases::read_case("tests/diagnose/data/drop-air-drag/case.json");
    for (cases::Experiment& e : c.experiments) e.held_out = true;
    CHECK(diagnose::diagnose(c, {}, [](cases::Case&) {}).answer == diagnose::Answer::undecided);
}

TEST_CASE("diagnose: an unknown force is looked for across recordings of two rigs", "[diagnose]") {
    cases::Case c = cases::read_case("tests/diagnose/data/drop-magnet/case.json");
    const cases::Case other =
        cases::read_case("tests/diagnose/data/incline-rolling-resistance/case.json");
    // The magnet is beneath the drops alone: nothing that acts on both explains it.
    for (const cases::Experiment& e : other.experiments)
        if (!e.held_out) c.experiments.push_back(e);
    const diagnose::Verdict v = diagnose::diagnose(
        c, {.seed = 1, .threads = 2}, [](cases::Case& sealed) { cases::open_held_out(sealed); });
    CHECK(v.answer == diagnose::Answer::unexplained);
    REQUIRE(v.effects.front().missing);
}

TEST_CASE("diagnose: where nothing is held out the last of three recordings is held back",
          "[diagnose]") {
    cases::Case c = cases::read_case("tests/diagnose/data/drop-nothing-left-out/case.json");
    for (cases::Experiment& e : c.experiments) e.held_out = false;
    const diagnose::Verdict v = diagnose::diagnose(c, {.seed = 1, .threads = 1}, [](auto&) {});
    CHECK(v.answer == diagnose::Answer::consistent);
    REQUIRE(v.held_out);
    CHECK(v.held_out->experiments == std::vector<std::string>{"drop-3"});
    CHECK(v.warnings.front().find("drop-3 was held back") != std::string::npos);
    c.experiments.pop_back();  // two are too few
    CHECK(!diagnose::diagnose(c, {.seed = 1, .threads = 1}, [](auto&) {}).held_out);
}
