// SPDX-License-Identifier: MIT
#include "calibrate/paper_road.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

using namespace calibrate;
using Eigen::VectorXd;

namespace {

// Runs the road to its end with `angle` (deg; nothing: no heap) for every point, in batches that come
// back last first.
PaperResult walked(const Problem& p, const PaperOptions& o,
                   const std::function<std::optional<double>(const VectorXd&)>& angle,
                   std::vector<Run>* kept = nullptr) {
    std::vector<Run> history;
    for (;;) {
        PaperStep step = next(p, o, history);
        if (step.result) {
            if (kept) *kept = history;
            return *step.result;
        }
        REQUIRE_FALSE(step.requests.empty());
        std::reverse(step.requests.begin(), step.requests.end());
        for (const Request& r : step.requests) {
            history.push_back({r, std::nullopt});
            if (const auto a = angle(r.point)) history.back().values = {*a};
        }
    }
}

Problem plane_problem(double target) {
    Problem p;
    for (const char* name : {"a", "b", "c", "d"}) p.factors.push_back({name, "1", 0.1, 1.0});
    p.targets = {{"angle_of_repose", "deg", target, 0.5}};
    return p;
}

// Slopes 20, -8, 3 and 0 deg per unit.
double plane(const VectorXd& x) { return 20.0 + 20.0 * x[0] - 8.0 * x[1] + 3.0 * x[2]; }

}  // namespace

TEST_CASE("paper's road: on a plane without scatter the answer is exact", "[calibrate][exact]") {
    const double target = GENERATE(28.0, 33.0, 36.5);
    const PaperResult r = walked(plane_problem(target), {}, plane);
    REQUIRE(r.passed);
    REQUIRE(plane(*r.answer) == Approx(target).epsilon(1e-12));
    REQUIRE(r.confirmed.at(0) == Approx(target).epsilon(1e-12));
    // Levels 0.1 and 0.2: effects are slopes times 0.1.
    REQUIRE(r.ranking[0].factor == "a");
    REQUIRE(r.ranking[0].value == Approx(2.0).epsilon(1e-12));
    REQUIRE(r.ranking[1].factor == "b");
    REQUIRE(r.ranking[1].value == Approx(-0.8).epsilon(1e-12));
    REQUIRE(r.ranking[3].value == Approx(0.0).margin(1e-12));
}

// Niu et al. (2026): the ascent of Table 9 and the orthogonal test of Table 10, by their friction and
// energy. The screening is a stand-in with the paper's three strongest factors (its own has no unique
// effects). No heap forms where wall friction is below 0.25 (section 4.5.2). Tolerances: half of
// the last printed digit.
TEST_CASE("paper's road: from the paper's tables it finds the paper's line and answer",
          "[calibrate][exact]") {
    Problem p;
    p.factors = {{"restitution", "1", 0.15, 0.3},        {"sliding_friction", "1", 0.2, 0.9},
                 {"rolling_friction", "1", 0.15, 0.3},   {"wall_restitution", "1", 0.1, 0.2},
                 {"wall_friction", "1", 0.05, 0.6},      {"wall_rolling_friction", "1", 0.05, 0.1},
                 {"surface_energy", "J/m^2", 0.01, 0.27}};
    p.targets = {{"angle_of_repose", "deg", 53.67, 1.86}};
    PaperOptions o;
    o.screening_levels = {{0.15, 0.3}, {0.2, 0.4},  {0.15, 0.3}, {0.1, 0.2},
                          {0.3, 0.6},  {0.05, 0.1}, {0.01, 0.02}};
    const std::map<std::pair<long, long>, double> tables{
        // {10 friction, 100 energy}, deg; the last one is the confirming run
        {{4, 2}, 26.99},  {{5, 7}, 32.25},  {{6, 12}, 40.95}, {{7, 17}, 50.20}, {{8, 22}, 56.60},
        {{9, 27}, 60.11}, {{7, 22}, 57.03}, {{7, 27}, 58.20}, {{8, 17}, 51.73}, {{8, 27}, 58.95},
        {{9, 17}, 50.37}, {{9, 22}, 56.51}, {{8, 19}, 53.87}};
    std::vector<Run> history;
    const PaperResult r = walked(
        p, o,
        [&](const VectorXd& x) -> std::optional<double> {
            if (x[4] < 0.249) return std::nullopt;
            const std::pair place{std::lround(10.0 * x[1]), std::lround(100.0 * x[6])};
            if (std::abs(x[4] - 0.45) < 1e-9 && tables.count(place)) return tables.at(place);
            return 19.0 + 24.7 * (x[1] - 0.2) + 241.0 * (x[6] - 0.01) - 6.0 * (x[4] - 0.3);
        },
        &history);
    CHECK(r.ranking[0].factor == "sliding_friction");
    CHECK(r.ranking[1].factor == "surface_energy");
    CHECK(r.ranking[2].factor == "wall_friction");
    REQUIRE(r.line);
    CHECK(r.line->factor == "surface_energy");
    CHECK(r.line->slope == Approx(97.4).margin(0.05));
    CHECK(r.line->intercept == Approx(35.172).margin(0.0005));
    CHECK((*r.answer)[6] == Approx(0.19).margin(0.005));
    CHECK((*r.answer)[1] == Approx(0.8).epsilon(1e-12));
    CHECK((*r.answer)[4] == Approx(0.45).epsilon(1e-12));
    CHECK(r.confirmed.at(0) == Approx(53.87).epsilon(1e-12));
    // Screening 12; first ascent 4, two of them without a heap; second ascent 6; of the 3 x 3 six
    // are new; confirming run. The paper ran its first ascent to the end and counts 9 of the 3 x 3.
    CHECK(r.runs == 29);
    CHECK(static_cast<int>(history.size()) == r.runs);
}

// With the screening of four factors below, heaps form only where b is low: that is half of the runs,
// and the effect of b cannot be told. It goes last, and the road says what it dropped.
TEST_CASE("paper's road: runs without a heap are dropped, and it says so", "[calibrate]") {
    const PaperResult r =
        walked(plane_problem(33.0), {}, [](const VectorXd& x) -> std::optional<double> {
            if (x[1] > 0.19) return std::nullopt;
            return plane(x);
        });
    CHECK(r.ranking[0].factor == "a");
    CHECK(r.ranking[3].value == Approx(0.0).margin(1e-12));
    REQUIRE_FALSE(r.notes.empty());
    CHECK_THAT(r.notes[0], Catch::Contains("6 of 12"));
    CHECK(plane(*r.answer) == Approx(33.0).epsilon(1e-12));
}

TEST_CASE("paper's road: no heap at all gives no answer; a target out of reach the nearest run",
          "[calibrate][limit]") {
    const PaperResult none =
        walked(plane_problem(33.0), {}, [](const VectorXd&) { return std::nullopt; });
    REQUIRE_FALSE(none.answer);
    REQUIRE(none.confirmed.empty());
    std::vector<Run> history;
    PaperOptions o;
    o.confirmations = 3;
    const PaperResult far = walked(plane_problem(80.0), o, plane, &history);
    REQUIRE_FALSE(far.passed);
    REQUIRE(far.confirmed.size() == 3);
    REQUIRE(far.runs <= most_runs(plane_problem(80.0), o));
    double highest = 0.0;
    for (const Run& r : history) highest = std::max(highest, r.values->front());
    REQUIRE(plane(*far.answer) == Approx(highest).epsilon(1e-12));
}

TEST_CASE("paper's road: bad options are refused", "[calibrate][domain]") {
    PaperOptions o;
    o.screening_levels = {{0.1, 0.2}};
    REQUIRE_THROWS_WITH(next(plane_problem(30.0), o, {}), Catch::Contains("screening_levels"));
}
