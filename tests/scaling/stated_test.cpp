// SPDX-License-Identifier: MIT
// What Niu et al. (2026) state about their simulation, against each other and against the scale
// map.
#include "scaling/stated.hpp"

#include "scaling/numbers.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace scaling;

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

StatedCounts paper() {
    return {.grains = {1e6, 1e5},
            .original_grains = 1e9,
            .time_step = 7.78e-7 * si::seconds,
            .feed_rate = 1e5 * si::hertz,
            .settling_time = 2.0 * si::seconds,
            .simulated_time = 10.0 * si::seconds,
            .wall_time = 6.0 * 3600.0 * si::seconds,
            .heap = Heap{50e-3 * si::meters, 53.87 * degree, 2.05 / 5.6}};
}

CostInput scaled_zirconia() {
    const Grain grain = {.diameter = 240e-6 * si::meters,
                         .density = 5600.0 * si::kilogrammes_per_cubic_metre,
                         .youngs_modulus = youngs_modulus(60e6 * si::pascals, 0.3),
                         .poisson_ratio = 0.3,
                         .gravity = 9.81 * si::meters_per_second_squared,
                         .drop_height = std::nullopt};
    return {grain, std::nullopt, std::nullopt, 0.2, 1e7};
}

Finding found(const StatedCounts& stated, const std::string& name) {
    const std::vector<Finding> findings = stated_findings(stated, scaled_zirconia(), 8e6);
    const auto it = std::find_if(findings.begin(), findings.end(),
                                 [&](const Finding& f) { return f.name == name; });
    INFO(name);
    REQUIRE(it != findings.end());
    return *it;
}

}  // namespace

TEST_CASE("stated: 7.78e-7 s is not 20 % of the Rayleigh time but 19.77 %", "[stated][paper]") {
    const Finding f = found(paper(), "stated_time_step_over_computed");
    REQUIRE(f.value == Approx(7.78 / 7.870).epsilon(2e-4));  // four digits
    REQUIRE(f.judgement == Judgement::caution);
    REQUIRE_THAT(f.text, Catch::Contains("19.77 %"));
    StatedCounts mended = paper();
    mended.time_step = 7.87e-7 * si::seconds;
    REQUIRE(found(mended, "stated_time_step_over_computed").judgement == Judgement::fine);
}

TEST_CASE("stated: 1e5 and 1e6 grains are said of one simulation", "[stated][paper]") {
    const Finding f = found(paper(), "stated_grain_counts_apart");
    REQUIRE(f.value == Approx(10.0));
    REQUIRE(f.judgement == Judgement::caution);
}

TEST_CASE("stated: a million scaled grains stand for 8e12, not 1e9", "[stated][paper]") {
    const Finding f = found(paper(), "stated_originals_over_represented");
    REQUIRE(f.value == Approx(1e9 / 8e12).epsilon(1e-12));
    REQUIRE(f.judgement == Judgement::caution);
    REQUIRE_THAT(f.text, Catch::Contains("8e+12"));
}

TEST_CASE("stated: 10 s of feeding and 2 s of settling do not fit into 10 s", "[stated][paper]") {
    const Finding f = found(paper(), "stated_time_over_feed_and_settling");
    REQUIRE(f.value == Approx(10.0 / 12.0).epsilon(1e-12));
    REQUIRE(f.judgement == Judgement::caution);
    StatedCounts mended = paper();
    mended.simulated_time = 12.0 * si::seconds;
    REQUIRE(found(mended, "stated_time_over_feed_and_settling").judgement == Judgement::fine);
}

TEST_CASE("stated: six hours for a million grains are 6e8 grain steps per second",
          "[stated][paper]") {
    // 1e6 * 10 / 7.78e-7 / 21600 = 5.95e8, here against 1e7 measured.
    const Finding f = found(paper(), "implied_speed_over_measured");
    REQUIRE(f.value == Approx(59.5).epsilon(1e-3));  // three digits
    REQUIRE(f.judgement == Judgement::caution);
}

TEST_CASE(
    "stated: a million grains cover a 50 mm base at 53.87 deg only if packed as loosely as 0.323",
    "[stated][paper]") {
    // 7.24 cm^3 of solid in a cone of 22.4 cm^3; the powder was measured at 2.05 / 5.6 = 0.366.
    const Finding f = found(paper(), "packing_to_cover_base_over_measured");
    REQUIRE(f.value * 2.05 / 5.6 == Approx(0.323).epsilon(2e-3));  // three digits
    REQUIRE(f.judgement == Judgement::caution);
    StatedCounts enough = paper();
    enough.grains = {1.2e6};
    REQUIRE(found(enough, "packing_to_cover_base_over_measured").judgement == Judgement::fine);
}

TEST_CASE("stated: numbers that were not given are not judged", "[stated]") {
    REQUIRE(stated_findings({}, scaled_zirconia(), 8e6).empty());
    StatedCounts one;
    one.grains = {1e6};
    REQUIRE(stated_findings(one, scaled_zirconia(), 8e6).empty());
}
