// SPDX-License-Identifier: MIT
// The zirconia case as a calibration, and cases that cannot be one.
#include "calibrate/pile_problem.hpp"

#include "cases/read_case.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using Catch::Contains;
using namespace calibrate;

namespace {

cases::Case zirconia() { return cases::read_case("data/zirconia/calibrate.json"); }

PileProblem problem_of(const cases::Case& c, const PileOptions& o = {}) {
    return pile_problem(c, c.experiments.front(), o, 1);
}

}  // namespace

// 50, 55 and 56 deg by hand: mean 161/3, deviation sqrt(31/3), of the mean sqrt(31)/3.
TEST_CASE("pile problem: the recorded angles give the target and how well it is known",
          "[calibrate][pile]") {
    const PileProblem p = problem_of(zirconia());
    REQUIRE(p.problem.targets.size() == 2);
    const Target& angle = p.problem.targets[0];
    CHECK(angle.value.value() == Approx(161.0 / 3.0).epsilon(1e-12));
    CHECK(angle.standard_deviation == Approx(std::sqrt(31.0) / 3.0).epsilon(1e-12));
    CHECK(p.estimator == rigs::Estimator::silhouette);
    CHECK_FALSE(p.problem.targets[1].value.has_value());
    const PileProblem both = problem_of(zirconia(), {.estimator = "", .bulk_density = true});
    CHECK(both.problem.targets[1].value.value() == Approx(2050.0).epsilon(1e-12));
}

TEST_CASE("pile problem: a recording's noise counts where it is larger than its scatter",
          "[calibrate][pile]") {
    cases::Case c = zirconia();
    c.experiments.front().noise["angle_of_repose"] = 0.1;  // rad, 5.73 deg
    CHECK(problem_of(c).problem.targets[0].standard_deviation ==
          Approx(18.0 / std::acos(-1.0) / std::sqrt(3.0)).epsilon(1e-12));
}

TEST_CASE("pile problem: parameters with a range are factors; a decade and more is logarithmic",
          "[calibrate][pile]") {
    const cases::Case c = zirconia();
    const Problem p = problem_of(c).problem;
    REQUIRE(p.factors.size() == 7);
    for (const Factor& f : p.factors) CHECK(f.logarithmic == (f.name == "work_of_adhesion"));
    Eigen::VectorXd point(7);
    point << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0;
    const cases::Case there = at_point(c, p, point);
    for (std::size_t k = 0; k < 7; ++k) {
        CHECK(there.model.parameters.at(p.factors[k].name).value == static_cast<double>(k + 1));
        CHECK_FALSE(there.model.parameters.at(p.factors[k].name).range.has_value());
    }
}

TEST_CASE("pile problem: no heap, no rest or an angle that cannot be read is a run without values",
          "[calibrate][pile]") {
    const PileProblem p = problem_of(zirconia());
    HeapSeen heap{true, true, {40.0, 41.0, 42.0, 43.0, 44.0}, 0.4};
    CHECK(values_of(p, heap, 5600.0).value() == std::vector{43.0, 2240.0});
    const auto without = [&](auto change) {
        HeapSeen other = heap;
        change(other);
        return values_of(p, other, 5600.0).has_value();
    };
    CHECK_FALSE(without([](HeapSeen& h) { h.formed = false; }));
    CHECK_FALSE(without([](HeapSeen& h) { h.at_rest = false; }));
    CHECK_FALSE(without([](HeapSeen& h) { h.angles[3].reset(); }));
    CHECK_FALSE(without([](HeapSeen& h) { h.packing_fraction.reset(); }));
    CHECK(without([](HeapSeen& h) { h.angles[0].reset(); }));
}

TEST_CASE("pile problem: a given point is the case's values, with others in their place",
          "[calibrate][pile]") {
    const cases::Case c = zirconia();
    const Problem p = problem_of(c).problem;
    const Eigen::VectorXd there =
        stated_point(c, p, {"work_of_adhesion=380 mJ/m^2", "sliding_friction=30 %"});
    for (std::size_t k = 0; k < p.factors.size(); ++k) {
        const std::string& name = p.factors[k].name;
        const double expected = name == "work_of_adhesion"   ? 0.38
                                : name == "sliding_friction" ? 0.3
                                                             : c.model.parameters.at(name).value;
        CHECK(there[static_cast<Eigen::Index>(k)] == Approx(expected).epsilon(1e-12));
    }
    CHECK_THROWS_WITH(stated_point(c, p, {"work_of_adhesion"}), Contains("NAME=VALUE"));
    CHECK_THROWS_WITH(stated_point(c, p, {"sliding_fiction=1"}), Contains("sliding_friction"));
    CHECK_THROWS_WITH(stated_point(c, p, {"work_of_adhesion=0.4"}), Contains("J/m^2"));
    CHECK_THROWS_WITH(stated_point(c, p, {"restitution=1.5"}), Contains("between 0 and 1"));
}

TEST_CASE("pile problem: what a case lacks is named", "[calibrate][pile][domain]") {
    cases::Case fixed = zirconia();
    for (auto& [name, parameter] : fixed.model.parameters) parameter.range.reset();
    CHECK_THROWS_WITH(problem_of(fixed), Contains("model.parameters") && Contains("range"));
    cases::Case silent = zirconia();
    silent.experiments.front().recording.reset();
    CHECK_THROWS_WITH(problem_of(silent), Contains("heap") && Contains("angle_of_repose"));
    cases::Case weightless = zirconia();
    weightless.stated.bulk_density.reset();
    CHECK_THROWS_WITH(problem_of(weightless, {.estimator = "", .bulk_density = true}),
                      Contains("stated.bulk_density"));
    CHECK_THROWS_WITH(problem_of(zirconia(), {.estimator = "cone", .bulk_density = false}),
                      Contains("--estimator") && Contains("protractor"));
    cases::Case single = zirconia();
    for (cases::Column& column : single.experiments.front().recording->columns) {
        if (!column.values.empty()) column.values = {column.values.front()};
        if (!column.words.empty()) column.words = {column.words.front()};
    }
    CHECK_THROWS_WITH(problem_of(single), Contains("noise"));
}
