// SPDX-License-Identifier: MIT
#include "reports/proof.hpp"

#include <catch2/catch.hpp>

using namespace reports;
using Catch::Contains;

namespace {

prove::ScoreTable table() {
    prove::ScoreTable t;
    t.cases = 60, t.missing = 2;
    t.lines = {{.figure = "right name where D >= 5",
                .bar = ">= 95 %",
                .value = 0.975,
                .bounds = prove::Wilson{0.871, 0.996},
                .count = 40,
                .met = true},
               {.figure = "nobody counts this",
                .bar = "",
                .value = 0.5,
                .count = 10,
                .note = "for interest"}};
    t.confusion = {{"air_drag", {{"air_drag", 18}, {"ambiguous", 2}}},
                   {"none", {{"consistent", 3}}}};
    t.calibration.bins = {{0.05, 0.04, 100}, {0.95, 0.9, 20}};
    return t;
}

}  // namespace

TEST_CASE("proof: a page tells bars, names and reliability", "[reports]") {
    const std::string page = html(page_of(table(), "1 s a verdict", {"not the moon"}, {}));
    for (const char* text :
         {"1 of 1 bars are met", "[0.871,", "met", "for interest", "21 of 23 answers are right",
          "air drag 18, ambiguous 2", "1 s a verdict", "not the moon", "Reliability"})
        REQUIRE_THAT(page, Contains(text));
}

TEST_CASE("proof: one missed bar is a no, none that could be tested cannot tell", "[reports]") {
    prove::ScoreTable t = table();
    t.lines[1].met = false;
    REQUIRE(page_of(t, "", {}, {}).verdict.answer == Answer::no);
    REQUIRE_THAT(html(page_of(t, "", {}, {})), Contains("missed"));
    t.lines[0].met = t.lines[1].met = std::nullopt;
    REQUIRE(page_of(t, "", {}, {}).verdict.answer == Answer::cannot_tell);
}
