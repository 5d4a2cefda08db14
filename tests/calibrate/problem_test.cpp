// SPDX-License-Identifier: MIT
#include "calibrate/problem.hpp"

#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace calibrate;
using Eigen::VectorXd;

namespace {

Problem two_factors() {
    return {{{"sliding_friction", "1", 0.2, 1.0}, {"surface_energy", "J/m^2", 0.01, 1.0, true}},
            {{"angle_of_repose", "deg", 50.0, 1.0}},
            7};
}

Run run(std::uint64_t seed, double friction, double energy, std::optional<double> angle) {
    Run r{{VectorXd{{friction, energy}}, seed, ""}, std::nullopt};
    if (angle) r.values = {*angle};
    return r;
}

}  // namespace

TEST_CASE("problem: the middle of a logarithmic range is its geometric mean",
          "[calibrate][exact]") {
    const Problem p = two_factors();
    const VectorXd middle = point_of(p, VectorXd::Zero(2));
    REQUIRE(middle[0] == Approx(0.6).epsilon(1e-14));
    REQUIRE(middle[1] == Approx(0.1).epsilon(1e-14));
    const VectorXd there{{-0.3, 0.8}};
    REQUIRE((coded(p, point_of(p, there)) - there).norm() < 1e-14);
}

// 30, 32 and 40, 41, 45: deviations squared 1 + 1 and 4 + 1 + 9 about means 31 and 42, with 1 + 2
// degrees of freedom. A run without a heap and one without a repeat say nothing.
TEST_CASE("problem: scatter is pooled over the points that have repeats", "[calibrate][exact]") {
    const Problem p = two_factors();
    const auto s = scatter(p,
                           {run(7, 0.3, 0.1, 30.0), run(8, 0.5, 0.1, 40.0), run(9, 0.3, 0.1, 32.0),
                            run(10, 0.5, 0.1, 41.0), run(11, 0.5, 0.1, 45.0), run(12, 0.5, 0.1, {}),
                            run(13, 0.9, 0.1, 55.0)},
                           0);
    REQUIRE(s);
    REQUIRE(s->degrees_of_freedom == 3);
    REQUIRE(s->standard_deviation == Approx(std::sqrt(16.0 / 3.0)).epsilon(1e-12));
    REQUIRE_FALSE(scatter(p, {run(7, 0.3, 0.1, 30.0), run(8, 0.5, 0.1, 40.0)}, 0));
}

TEST_CASE("problem: what cannot be is refused and named", "[calibrate][domain]") {
    Problem p = two_factors();
    REQUIRE_NOTHROW(check(p));
    p.factors[0].high = 0.2;
    REQUIRE_THROWS_WITH(check(p), Catch::Contains("sliding_friction"));
    p = two_factors(), p.factors[1].low = 0.0;
    REQUIRE_THROWS_WITH(check(p), Catch::Contains("surface_energy"));
    p = two_factors(), p.targets[0].standard_deviation = 0.0;
    REQUIRE_THROWS_WITH(check(p), Catch::Contains("angle_of_repose"));
    p = two_factors(), p.targets[0].value.reset();
    REQUIRE_THROWS_WITH(check(p), Catch::Contains("first must have been measured"));
    p = two_factors();
    REQUIRE_THROWS_WITH(check(p, {run(7, 0.3, 0.1, 30.0), run(7, 0.4, 0.1, 30.0)}),
                        Catch::Contains("seed 7"));
    REQUIRE_THROWS_WITH(check(p, {run(7, 0.3, 0.1, NAN)}), Catch::Contains("finite"));
    REQUIRE_THROWS_WITH(check(p, {run(6, 0.3, 0.1, 30.0)}), Catch::Contains("seed 6"));
    const std::vector<Run> history{run(8, 0.3, 0.1, 30.0)};
    REQUIRE(find_run(p, history, 0, history[0].request.point) == nullptr);
    REQUIRE(find_run(p, history, 1, history[0].request.point) == &history[0]);
    REQUIRE_THROWS_WITH(find_run(p, history, 1, VectorXd{{0.31, 0.1}}), Catch::Contains("another"));
}
