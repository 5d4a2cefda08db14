// SPDX-License-Identifier: MIT
#include "statistics/intervals.hpp"

#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace statistics;

TEST_CASE("summary: three and five lie one from their mean, so their sample deviation is sqrt 2",
          "[statistics][exact]") {
    const Summary s = summary(std::vector<double>{3.0, 5.0});
    REQUIRE(s.mean == Approx(4.0).epsilon(1e-15));
    REQUIRE(s.standard_deviation == Approx(std::sqrt(2.0)).epsilon(1e-15));
    REQUIRE(s.count == 2);
}

// Niu et al. (2026), Coatings 16, 1016: measured angles 50, 55 and 56 deg. By hand: mean 161/3, s =
// sqrt(62/6).
TEST_CASE("summary: the three measured heaps of zirconia give 53.67 deg with a spread of 3.21 deg",
          "[statistics][exact]") {
    const Summary s = summary(std::vector<double>{50.0, 55.0, 56.0});
    REQUIRE(s.mean == Approx(161.0 / 3.0).epsilon(1e-14));
    REQUIRE(s.standard_deviation == Approx(std::sqrt(62.0 / 6.0)).epsilon(1e-14));
}

// Student's t in closed form: nu = 1 is Cauchy, t_p = tan(pi (p - 1/2)); nu = 2 is t_p = (2p - 1)
// sqrt(2 / (4p(1-p))).
TEST_CASE("student quantile: one and two degrees of freedom follow their closed forms",
          "[statistics][exact]") {
    const double p = GENERATE(0.05, 0.6, 0.95, 0.975);
    const double pi = std::acos(-1.0);
    REQUIRE(student_quantile(p, 1.0) == Approx(std::tan(pi * (p - 0.5))).epsilon(1e-12));
    REQUIRE(student_quantile(p, 2.0) ==
            Approx((2.0 * p - 1.0) * std::sqrt(2.0 / (4.0 * p * (1.0 - p)))).epsilon(1e-12));
}

// t_{0.975, 9} = 2.262 and t_{0.95, 20} = 1.725, as every printed t table has them (3 decimals,
// hence the tolerance).
TEST_CASE("student quantile: agrees with the printed table", "[statistics][exact]") {
    REQUIRE(student_quantile(0.975, 9.0) == Approx(2.262).margin(5e-4));
    REQUIRE(student_quantile(0.95, 20.0) == Approx(1.725).margin(5e-4));
}

// By hand from t_{0.975, 2} = 4.302653 (closed form above): half width 4.302653 * sqrt(62/6) / sqrt
// 3 = 7.985.
TEST_CASE("student interval: three heaps pin the angle of zirconia down to 8 deg only",
          "[statistics][exact]") {
    const Interval i = student_interval(summary(std::vector<double>{50.0, 55.0, 56.0}), 0.95);
    REQUIRE(0.5 * (i.high - i.low) == Approx(7.985).margin(1e-3));
    REQUIRE(0.5 * (i.high + i.low) == Approx(161.0 / 3.0).epsilon(1e-12));
}

// 20000 samples: the observed share has a standard error of sqrt(0.9 * 0.1 / 20000) = 0.0021; four
// of them are allowed.
TEST_CASE("student interval: nine in ten 90 % intervals hold the truth",
          "[statistics][simulation]") {
    std::mt19937_64 random(20260101);
    std::normal_distribution<double> normal(30.0, 2.0);
    int held = 0;
    for (int k = 0; k < 20000; ++k) {
        std::vector<double> x(5);
        for (double& v : x) v = normal(random);
        const Interval i = student_interval(summary(x), 0.90);
        held += i.low < 30.0 && 30.0 < i.high;
    }
    REQUIRE(held / 20000.0 == Approx(0.90).margin(0.0085));
}

TEST_CASE("intervals: bad input is refused and named", "[statistics][domain]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    REQUIRE_THROWS_AS(summary(std::vector<double>{1.0}), scaling::InvalidParameter);
    REQUIRE_THROWS_AS(summary(std::vector<double>{1.0, nan}), scaling::InvalidParameter);
    REQUIRE_THROWS_WITH(student_interval({1.0, 1.0, 5}, 1.0), Catch::Contains("confidence"));
    REQUIRE_THROWS_WITH(student_interval({1.0, 1.0, 1}, 0.9), Catch::Contains("at least 2"));
    REQUIRE_THROWS_WITH(student_quantile(0.0, 3.0), Catch::Contains("p: got"));
    REQUIRE_THROWS_WITH(student_quantile(0.5, 0.0), Catch::Contains("degrees_of_freedom"));
}
