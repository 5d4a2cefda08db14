// SPDX-License-Identifier: MIT
// Profiles of made-up cones, z = apex - slope r, on the 50 mm base of the zirconia case.
#include "calibrate/profile_target.hpp"

#include "calibrate/pile_problem.hpp"
#include "calibrate/surrogate_road.hpp"
#include "cases/read_case.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using Catch::Contains;
using namespace calibrate;

namespace {

constexpr double base_radius = 0.025, apex = 0.03, slope = 0.8;  // m, m, 1
constexpr int azimuths = 12, radii = 50;                         // of a scan

double cone(double r) { return apex - slope * r; }

cases::Recording scan_of(double wave, double start_t = 0.0) {
    cases::Column t{"t", "s"}, azimuth{"azimuth", "rad"}, r{"r", "m"}, z{"z", "m"};
    for (int k = 0; k < azimuths; ++k)
        for (int i = 0; i < radii; ++i) {
            t.values.push_back(start_t);
            azimuth.values.push_back(2.0 * std::numbers::pi * (k + 0.5) / azimuths);
            r.values.push_back(base_radius * (i + 0.5) / radii);
            z.values.push_back(cone(r.values.back()) + (k % 2 == 0 ? wave : -wave));
        }
    cases::Recording recording;
    recording.columns = {t, azimuth, r, z};
    return recording;
}

cases::Case recorded(const cases::Recording& recording) {
    cases::Case c = cases::read_case("data/zirconia/calibrate.json");
    c.experiments.front().recording = recording;
    return c;
}

}  // namespace

// The mean of a straight line over readings even about R/4, R/2 and 3R/4 is its value there. Twelve sectors, +-w by turns, have the
// sample standard deviation w sqrt(12/11).
TEST_CASE("profile: heights in three rings, known by what sectors differ", "[calibrate][profile]") {
    const cases::Case c = recorded(scan_of(1e-4));
    const std::vector<RingHeight> rings = ring_heights(c, c.experiments.front());
    REQUIRE(rings.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
        const double middle = base_radius * static_cast<double>(k + 1) / 4.0;
        const double one_step = slope * base_radius / radii;  // readings need not lie evenly
        CHECK(rings[k].target.value.value() == Approx(1e3 * cone(middle)).margin(1e3 * one_step));
        CHECK(rings[k].target.standard_deviation == Approx(0.1 / std::sqrt(11.0)).epsilon(1e-9));
    }
}

TEST_CASE("profile: a simulated heap is read where the recording was", "[calibrate][profile]") {
    const cases::Case c = recorded(scan_of(1e-4));
    const std::vector<RingHeight> rings = ring_heights(c, c.experiments.front());
    std::vector<double> r, z;  // of the same cone at other radii, not even ones
    for (int i = 0; i <= 9; ++i) {
        r.push_back(base_radius * i * i / 81.0);
        z.push_back(cone(r.back()));
    }
    for (const RingHeight& ring : rings)
        CHECK(height_in(ring, r, z).value() == Approx(*ring.target.value).epsilon(1e-12));
    CHECK_FALSE(height_in(rings.front(), {}, {}).has_value());
}

TEST_CASE("profile: of several scans the last counts", "[calibrate][profile]") {
    cases::Recording both = scan_of(1e-4, 2.0);
    const cases::Recording before = scan_of(5e-3, 1.0);
    for (std::size_t k = 0; k < both.columns.size(); ++k)
        both.columns[k].values.insert(both.columns[k].values.end(),
                                      before.columns[k].values.begin(),
                                      before.columns[k].values.end());
    const cases::Case c = recorded(both);
    CHECK(ring_heights(c, c.experiments.front()).front().target.standard_deviation ==
          Approx(0.1 / std::sqrt(11.0)).epsilon(1e-9));
}

TEST_CASE("profile: one azimuth needs the noise of z", "[calibrate][profile][domain]") {
    cases::Recording line = scan_of(0.0);
    for (cases::Column& column : line.columns) column.values.resize(radii);
    cases::Case c = recorded(line);
    CHECK_THROWS_WITH(ring_heights(c, c.experiments.front()),
                      Contains("noise") && Contains("azimuths"));
    c.experiments.front().noise["z"] = 2e-4;
    CHECK(ring_heights(c, c.experiments.front()).front().target.standard_deviation == Approx(0.2));
}

TEST_CASE("pile problem: a profile is the target in place of the angle, or beside it",
          "[calibrate][pile][profile]") {
    const cases::Case alone = recorded(scan_of(1e-4));
    const PileProblem p = pile_problem(alone, alone.experiments.front(), {}, 1);
    REQUIRE(p.problem.targets.size() == 4);  // and the bulk density, which nobody asked for
    CHECK(p.problem.targets[0].name == "height_near_axis");
    CHECK_FALSE(p.estimator.has_value());
    HeapSeen heap{true, true, {}, 0.4};
    CHECK_FALSE(values_of(p, heap, 5600.0).has_value());
    heap.profile_r = {0.0, base_radius}, heap.profile_z = {cone(0.0), cone(base_radius)};
    const std::vector<double> values = values_of(p, heap, 5600.0).value();
    REQUIRE(values.size() == 4);
    for (std::size_t k = 0; k < 3; ++k)
        CHECK(values[k] == Approx(p.problem.targets[k].value.value()).epsilon(1e-12));
    CHECK(values[3] == Approx(2240.0));

    cases::Recording both = scan_of(1e-4);
    cases::Column angle{"angle_of_repose", "rad"}, by{"estimator", ""};
    angle.values.assign(both.rows(), std::nan(""));
    by.words.assign(both.rows(), "cone");
    angle.values[0] = 0.60, angle.values[1] = 0.64;
    both.columns.push_back(angle), both.columns.push_back(by);
    const cases::Case beside = recorded(both);
    const PileProblem q = pile_problem(beside, beside.experiments.front(), {}, 1);
    REQUIRE(q.problem.targets.size() == 5);
    CHECK(q.problem.targets[0].name == "angle_of_repose");
    CHECK(q.problem.targets[1].name == "height_near_axis");
}

namespace {

// A powder whose heaps are cones: x sets their slope, y their apex. Heights scatter by 0.1 mm from seed to seed.
std::vector<double> heights(const std::vector<RingHeight>& rings, const Eigen::VectorXd& at,
                            std::uint64_t seed) {
    std::mt19937_64 dice(seed);
    std::normal_distribution<double> scatter(0.0, 0.1);
    const double top = 0.025 + 0.01 * at[1], steep = 0.5 + 0.6 * at[0];
    std::vector<double> values;
    for (const RingHeight& ring : rings)
        values.push_back(
            height_in(ring, {0.0, base_radius}, {top, top - steep * base_radius}).value() +
            scatter(dice));
    return values;
}

}  // namespace

// The recorded cone is the powder's at x = y = 1/2. Its angle alone would leave y free.
TEST_CASE("profile: its heights fix the slope's parameter and the apex' parameter",
          "[calibrate][profile][road]") {
    const cases::Case c = recorded(scan_of(5e-4));
    const std::vector<RingHeight> rings = ring_heights(c, c.experiments.front());
    Problem p{{{"x", "1", 0.0, 1.0}, {"y", "1", 0.0, 1.0}}, {}, 1};
    for (const RingHeight& ring : rings) p.targets.push_back(ring.target);
    std::vector<Run> history;
    SurrogateStep step = next(p, {.budget = 12, .batch = 2}, history);
    for (; !step.requests.empty(); step = next(p, {.budget = 12, .batch = 2}, history))
        for (const Request& r : step.requests)
            history.push_back({r, heights(rings, r.point, r.seed)});
    REQUIRE(step.result.has_value());
    const SurrogateResult& found = *step.result;
    for (const Eigen::Index k : {0, 1}) {
        const auto& i = found.free[static_cast<std::size_t>(k)];
        CHECK((i.low < 0.5 && 0.5 < i.high));
        CHECK(i.high - i.low < 0.5);
    }
}
