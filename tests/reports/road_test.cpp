// SPDX-License-Identifier: MIT
// A calibration of a made-up powder, angle = 20 + 20 x + 5 y deg, no heap below x = 0.1: what is told of it.
#include "reports/road.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Contains;

namespace {

calibrate::PileProblem problem() {
    calibrate::PileProblem p{};
    p.problem.factors = {{"sliding_friction", "1", 0.0, 1.0, false},
                         {"work_of_adhesion", "J/m^2", 0.01, 1.0, true}};
    p.problem.targets = {{"angle_of_repose", "deg", 32.0, 0.5},
                         {"bulk_density", "kg/m^3", std::nullopt, 50.0}};
    p.experiment = "heap";
    p.estimator = rigs::Estimator::cone;
    p.angles = {31.5, 32.5};
    p.notes = {"a note of the problem"};
    return p;
}

calibrate::Run heap_of(const calibrate::Problem& p, const calibrate::Request& r, double off) {
    const Eigen::VectorXd at = calibrate::coded(p, r.point);
    const double x = 0.5 * (at[0] + 1.0), y = 0.5 * (at[1] + 1.0);
    if (x < 0.1) return {r, std::nullopt};
    return {r, std::vector{20.0 + 20.0 * x + 5.0 * y + off, 1000.0 + 10.0 * y}};
}

// `off`: of the confirming heaps alone, deg.
calibrate::Calibration calibrated(double off) {
    calibrate::Calibration c{};
    c.pile = problem();
    const calibrate::SurrogateOptions options{.budget = 14, .batch = 2, .confirmations = 3};
    for (;;) {
        calibrate::SurrogateStep step = calibrate::next(c.pile.problem, options, c.history);
        c.surrogate = step.result;
        if (step.requests.empty()) return c;
        for (const calibrate::Request& r : step.requests)
            c.history.push_back(heap_of(c.pile.problem, r, r.stage == "confirming" ? off : 0.0));
    }
}

}  // namespace

TEST_CASE("road: fresh heaps at the answer decide, not the surrogate", "[reports][calibrate]") {
    CHECK(reports::verdict_of(calibrated(0.0)).answer == reports::Answer::yes);
    const reports::Verdict missed = reports::verdict_of(calibrated(3.0));
    CHECK(missed.answer == reports::Answer::no);
    CHECK_THAT(missed.why, Contains("32") && Contains("3 of 3 fresh heaps"));
    calibrate::Calibration none{};
    none.pile = problem();
    CHECK(reports::verdict_of(none).answer == reports::Answer::cannot_tell);
}

TEST_CASE("road: JSON has every run, and what nobody measured is null", "[reports][calibrate]") {
    const calibrate::Calibration c = calibrated(0.0);
    const reports::Json j = reports::to_json(c, {});
    CHECK(j["format"] == "similitude-calibration/1");
    CHECK(j["estimator"] == "cone");
    CHECK(j["runs"].size() == c.history.size());
    CHECK(j["targets"][0]["measured"] == 32.0);
    CHECK(j["targets"][0]["confirmed"]["heaps"] == 3);
    CHECK(j["targets"][1]["measured"].is_null());
    CHECK(j["holds"] == true);
    int formed = 0;
    for (const auto& run : j["runs"]) {
        formed += run["values"].is_null() ? 0 : 1;
        CHECK(run["values"].is_null() == (run["point"][0].get<double>() < 0.1));
    }
    CHECK(formed == c.surrogate->formed);
}

TEST_CASE("road: text and page name parameters with units, intervals, trades and notes",
          "[reports][calibrate]") {
    const calibrate::Calibration c = calibrated(0.0);
    const std::string text = reports::text_of(c);
    CHECK_THAT(text, Contains("work of adhesion") && Contains("J/m^2") &&
                         Contains("a note of the problem") && Contains("a trade") &&
                         Contains("a further measurement"));
    cases::Case given{};
    given.title = "made up";
    const std::string page = reports::html(reports::page_of(given, c, {}));
    for (const char* part : {"made up", "The calibration", "response-0-0", "measured",
                             "while the others are free", "What this does not show"})
        CHECK_THAT(page, Contains(part));
}

// Half-way along two decades: sqrt(0.01 * 1) = 0.1.
TEST_CASE("road: a logarithmic factor's share of its range is that of its logarithm",
          "[reports][calibrate]") {
    const calibrate::Problem p = problem().problem;
    CHECK(calibrate::share_of_range(p.factors[1], 0.1) == Approx(0.5));
    CHECK(calibrate::share_of_range(p.factors[0], 0.25) == Approx(0.25));
}
