// SPDX-License-Identifier: MIT
#include "rigs/formed.hpp"

#include "synthetic_heap.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

namespace {

constexpr rigs::HeapHistory at_rest{0, 1e-9};

rigs::Formed verdict_on(const synthetic::Shape& shape, rigs::HeapHistory history = at_rest) {
    return rigs::formed(rigs::scan(synthetic::heap(shape, 4)), history);
}

bool passes(const rigs::Formed& verdict, const std::string& name) {
    for (const rigs::Criterion& c : verdict.criteria) {
        if (c.name == name) return c.pass;
    }
    throw std::logic_error("no criterion " + name);
}

// Names of the criteria that fail, in order, each followed by a blank.
std::string failing(const rigs::Formed& verdict) {
    std::string names;
    for (const rigs::Criterion& c : verdict.criteria) {
        if (!c.pass) names += c.name + " ";
    }
    return names;
}

}  // namespace

TEST_CASE("formed: a cone that covers its base is a heap", "[rigs][formed]") {
    const double tangent = GENERATE(0.4, 0.8, 1.4);
    const rigs::Formed verdict = verdict_on(synthetic::cone(10.0, tangent));
    CHECK(failing(verdict).empty());
    CHECK(verdict.formed);
}

TEST_CASE("formed: a flat layer is not a heap", "[rigs][formed]") {
    const double thick = GENERATE(0.3, 3.0);
    const rigs::Formed verdict = verdict_on({10.0, [=](double, double) { return thick; }});
    CHECK_FALSE(verdict.formed);
    CHECK(failing(verdict).find("stands_above_rim") != std::string::npos);
}

TEST_CASE("formed: a heap that leaves most of its base bare is not the base's heap",
          "[rigs][formed]") {
    const synthetic::Shape small{10.0, [](double x, double y) { return 6.0 - std::hypot(x, y); }};
    const rigs::Formed alone = verdict_on(small), spilled = verdict_on(small, {7, 1e-9});
    CHECK(failing(alone) == "base_covered reaches_rim ");
    CHECK(failing(spilled) == "base_covered ");  // bounced off: what fell shows no full base
}

TEST_CASE("formed: a crater rises outwards", "[rigs][formed]") {
    const rigs::Formed verdict = verdict_on(
        {10.0, [](double x, double y) { return 5.0 - std::abs(std::hypot(x, y) - 5.0); }});
    CHECK_FALSE(passes(verdict, "falls_outwards"));
    CHECK_FALSE(verdict.formed);
}

TEST_CASE("formed: grains still moving are no heap at rest", "[rigs][formed]") {
    const rigs::Formed verdict = verdict_on(synthetic::cone(10.0, 0.6), {0, 1e-5});
    CHECK(failing(verdict) == "at_rest ");
}

TEST_CASE("formed: a heap beside its axis was not fed on it", "[rigs][formed]") {
    const rigs::Formed verdict =
        verdict_on({10.0, [](double x, double y) { return 8.0 - 0.6 * std::hypot(x - 3.0, y); }});
    CHECK(failing(verdict) == "apex_near_axis ");
}

TEST_CASE("formed: an empty base bears no heap, and every value is a number", "[rigs][formed]") {
    const rigs::Formed verdict = rigs::formed(rigs::scan({{}, {}, 0.025}), at_rest);
    CHECK_FALSE(verdict.formed);
    CHECK(failing(verdict) ==
          "base_covered falls_outwards stands_above_rim reaches_rim apex_near_axis ");
    for (const rigs::Criterion& c : verdict.criteria) {
        CAPTURE(c.name);
        CHECK(std::isfinite(c.value));
        CHECK_FALSE(c.rule.empty());
    }
}
