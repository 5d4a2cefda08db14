// SPDX-License-Identifier: MIT
#include "reports/compression.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;

namespace {

verify::CompressionSide side(double h, double strength) {
    verify::CompressionSide s{.h = h, .work_of_adhesion = 0.25, .d = h * 1e-4, .samples = {}};
    for (const double share : {0.9, 1.1}) {
        verify::CompressionSample sample;
        sample.grains = 1000.0;
        sample.strength = share * strength;
        sample.confined = {{0.0, 0.2, 0.4}, {0.0, 100.0, 1e4 * share}};
        sample.crushed = {{0.0, 0.1}, {0.0, share * strength}};
        s.samples.push_back(sample);
    }
    return s;
}

verify::CompressionCellResult cell(double h, verify::Answer answer) {
    const statistics::Equivalence test{.difference = -1000.0,
                                       .standard_error = 100.0,
                                       .degrees_of_freedom = 2.0,
                                       .interval = {-1200.0, -800.0},
                                       .p = 1.0,
                                       .margin = 250.0,
                                       .alpha = 0.05,
                                       .equivalent = answer == verify::Answer::equivalent};
    const verify::Quantity q{.name = "strength",
                             .unit = "Pa",
                             .reference = {2000.0, 100.0, 2},
                             .scaled = {1000.0, 100.0, 2},
                             .test = test,
                             .seeds_for_power = 7};
    return {.side = side(h, 1000.0), .quantities = {q}, .answer = answer, .claims = true};
}

// Force as d^2 holds, as d and d^3 breaks.
verify::CompressionStudy collapse() {
    using verify::Answer;
    verify::CompressionStudy s{};
    s.plan.seeds = 2;
    const Answer answers[] = {Answer::equivalent, Answer::different, Answer::different,
                              Answer::equivalent};
    for (std::size_t k = 0; k < 4; ++k)
        s.rules.push_back({.rule = verify::adhesion_rules()[k],
                           .reference = side(1.0, 2000.0),
                           .cells = {cell(2.0, answers[k])},
                           .strength_exponent = -1.0,
                           .strength_exponent_interval = {-1.25, -0.75}});
    s.half_speed = cell(2.0, Answer::equivalent);
    s.bits = {.scheme = "exact", .h = 2.0, .grains = 5, .reference = 1, .scaled = 1, .equal = true};
    s.powder = verify::compression_powder();
    return s;
}

}  // namespace

TEST_CASE("compression: a collapse needs d^2 to hold, the others to break, bits and half speed",
          "[reports][compression]") {
    using reports::Answer;
    CHECK(reports::verdict_of(collapse()).answer == Answer::yes);
    verify::CompressionStudy s = collapse();
    s.rules[0].cells[0].answer = verify::Answer::different;
    CHECK(reports::verdict_of(s).answer == Answer::no);
    s = collapse();
    s.rules[2].cells[0].answer = verify::Answer::equivalent;
    CHECK(reports::verdict_of(s).answer == Answer::no);
    s = collapse();
    s.bits.equal = false;
    CHECK(reports::verdict_of(s).answer == Answer::no);
    s = collapse();
    s.rules[0].cells[0].claims = false;  // inside the margins, with too few seeds to say so
    CHECK(reports::verdict_of(s).answer == Answer::cannot_tell);
    s = collapse();
    s.rules[1].cells[0].answer = verify::Answer::not_decided;
    CHECK(reports::verdict_of(s).answer == Answer::cannot_tell);
    s = collapse();
    s.half_speed.answer = verify::Answer::not_decided;
    CHECK(reports::verdict_of(s).answer == Answer::cannot_tell);
}

TEST_CASE("compression: text and JSON give each cell of the map, strengths in kPa and Pa",
          "[reports][compression]") {
    CHECK_THAT(
        reports::text_of(collapse()),
        Contains(
            "w kept: force as d: h = 2 breaks; strength as h to the power -1.00 [-1.25, -0.75]") &&
            Contains("-1 [-1.2, -0.8]") && Contains("the same bits"));
    const reports::Json json = reports::to_json(collapse());
    CHECK(json.at("verdict") == "yes");
    CHECK(json.at("rules").size() == 4);
    const auto& kept = json.at("rules").at(1);
    CHECK(kept.at("cells").at(0).at("answer") == "breaks");
    CHECK(kept.at("cells").at(0).at("quantities").at(0).at("difference") == -1000.0);
    CHECK(kept.at("sides").at(0).at("samples").at(1).at("strength").get<double>() ==
          Approx(2200.0));
    CHECK_FALSE(json.at("rules").at(3).contains("strength_exponent"));
}

TEST_CASE("compression: the page says what the source states and what was not seen of it",
          "[reports][compression]") {
    const std::string page = reports::html(reports::page_of(collapse(), {}));
    CHECK_THAT(page, Contains("the adhesive force scales very well") && Contains("(not stated)") &&
                         Contains("only the abstract was read") && Contains("<svg"));
}
