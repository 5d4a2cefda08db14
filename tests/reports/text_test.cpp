// SPDX-License-Identifier: MIT
#include "reports/text.hpp"

#include "reports/verdict.hpp"
#include "samples.hpp"

#include <catch2/catch.hpp>

using namespace reports;

TEST_CASE("text: columns line up", "[reports][text]") {
    CHECK(columns({{"a", "factor"}, {"length", "h"}}, {false, true}) ==
          "  a       factor\n  length       h\n");
}

TEST_CASE("text: long lines break at spaces and no word is lost", "[reports][text]") {
    CHECK(wrapped("one two three four", 9, 2) == "one two\n  three\n  four");
    CHECK(wrapped("short", 9, 2) == "short");
    CHECK(wrapped("averyveryverylongword and more", 9, 0) == "averyveryverylongword\nand more");
}

TEST_CASE("text: a scheme that keeps all groups is called similar, one that breaks some is not",
          "[reports][verdict]") {
    CHECK(verdict_of(zirconia_study("kept_gravity")).answer == Answer::yes);
    const Verdict broken = verdict_of(zirconia_study("paper"));
    CHECK(broken.answer == Answer::no);
    CHECK_THAT(broken.why, Catch::Contains("200 times"));
}

TEST_CASE("text: the study in words names what is broken, both adhesions and both grain counts",
          "[reports][text]") {
    const std::string text = text_of(zirconia_study("paper"));
    CHECK_THAT(text, Catch::Contains("BROKEN"));
    CHECK_THAT(text, Catch::Contains("4.75 uJ/m^2") && Catch::Contains("0.19 J/m^2"));
    CHECK_THAT(text, Catch::Contains("10000 (macro) -> 50 (micro)"));
    CHECK_THAT(text, !Catch::Contains("nan") && !Catch::Contains("inf "));
}
