// SPDX-License-Identifier: MIT
#include "statistics/equivalence.hpp"

#include "scaling/errors.hpp"

#include <boost/math/distributions/normal.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace statistics;

namespace {

std::vector<double> draw(std::mt19937_64& random, std::size_t n, double mean, double deviation) {
    std::normal_distribution<double> normal(mean, deviation);
    std::vector<double> x(n);
    for (double& v : x) v = normal(random);
    return x;
}

// Share of `trials` experiments in which equivalence is found.
struct Found {
    double welch;   // by the test itself
    double pooled;  // by the same interval with n1 + n2 - 2 degrees of freedom
};

Found found(std::uint64_t seed, int trials, std::size_t n1, double s1, std::size_t n2, double s2,
            double difference, double margin) {
    std::mt19937_64 random(seed);
    const double t = student_quantile(0.95, static_cast<double>(n1 + n2 - 2));
    int welch = 0, pooled = 0;
    for (int k = 0; k < trials; ++k) {
        const Summary a = summary(draw(random, n1, 0.0, s1));
        const Summary b = summary(draw(random, n2, difference, s2));
        const Equivalence e = two_one_sided_tests(a, b, margin);
        welch += e.equivalent;
        pooled += std::abs(e.difference) + t * e.standard_error < margin;
    }
    return {static_cast<double>(welch) / trials, static_cast<double>(pooled) / trials};
}

}  // namespace

// The two yields of the NCSS manual, chapter 198 (two-sample t-tests for equivalence), margin 110:
// Welch's lines read standard error 53.618547, 19.169 degrees of freedom, difference -8.1153846, 95
// % interval -120.27336 to 104.04259, one-sided p 0.03628 and 0.02002. Tolerances: half of the last
// printed digit.
TEST_CASE("equivalence: the worked example of two yields comes out as printed",
          "[statistics][exact]") {
    const std::vector<double> a{452, 874, 554, 447, 356, 754, 558, 574, 664, 682, 547, 435, 245};
    const std::vector<double> b{546, 547, 774, 465, 459, 665, 467, 365,
                                589, 534, 456, 651, 654, 665, 546, 537};
    const Equivalence e = two_one_sided_tests(summary(b), summary(a), 110.0, 0.025);
    CHECK(e.difference == Approx(-8.1153846).margin(5e-8));
    CHECK(e.standard_error == Approx(53.618547).margin(5e-7));
    CHECK(e.degrees_of_freedom == Approx(19.169).margin(5e-4));
    CHECK(e.interval.low == Approx(-120.27336).margin(5e-6));
    CHECK(e.interval.high == Approx(104.04259).margin(5e-6));
    CHECK(e.p == Approx(0.03628).margin(5e-6));
    CHECK_FALSE(e.equivalent);
    CHECK(two_one_sided_tests(summary(b), summary(a), 110.0, 0.05).equivalent);
    // The other one-sided p stands when the sides change places and the margin is met from the
    // other end.
    CHECK(two_one_sided_tests(summary(a), summary(b), 110.0, 0.025).p ==
          Approx(0.03628).margin(5e-6));
}

TEST_CASE("equivalence: found exactly when the interval lies inside the margins",
          "[statistics][identity]") {
    std::mt19937_64 random(7);
    int yes = 0;
    for (int k = 0; k < 500; ++k) {
        const Summary a = summary(draw(random, 6, 0.0, 1.0)),
                      b = summary(draw(random, 9, 0.3, 0.7));
        const Equivalence e = two_one_sided_tests(a, b, 1.2);
        REQUIRE(e.equivalent == (-1.2 < e.interval.low && e.interval.high < 1.2));
        yes += e.equivalent;
    }
    REQUIRE(yes > 50);
    REQUIRE(yes < 450);  // both answers occur, so the identity is tested on both
}

TEST_CASE("equivalence: two runs of the same bits differ by nothing, for certain",
          "[statistics][limit]") {
    const Summary a{30.0, 0.0, 3}, b{31.0, 0.0, 4};
    const Equivalence same = two_one_sided_tests(a, a, 2.5), apart = two_one_sided_tests(a, b, 1.0);
    REQUIRE(same.equivalent);
    REQUIRE(same.p == 0.0);
    REQUIRE(same.degrees_of_freedom == 4.0);
    REQUIRE_FALSE(apart.equivalent);
    REQUIRE(apart.p == 1.0);
}

TEST_CASE("equivalence: the answer does not depend on the unit", "[statistics][similarity]") {
    const double unit = GENERATE(1e-120, 3.14e-2, 1e90);
    const Equivalence e = two_one_sided_tests({30.0, 1.5, 8}, {30.9, 2.5, 11}, 2.5);
    const Equivalence u = two_one_sided_tests({30.0 * unit, 1.5 * unit, 8},
                                              {30.9 * unit, 2.5 * unit, 11}, 2.5 * unit);
    REQUIRE(u.p == Approx(e.p).epsilon(1e-10));
    REQUIRE(u.degrees_of_freedom == Approx(e.degrees_of_freedom).epsilon(1e-10));
}

// A true difference on the margin must be called equivalent in 5 % of all cases at the most, and in
// close to 5 % when the margin is many standard errors wide. 40000 trials: standard error 0.0011;
// three are allowed. Welch's degrees of freedom are an approximation where the spreads differ, for which another 0.003 is allowed.
TEST_CASE("equivalence: a difference as large as the margin passes once in twenty",
          "[statistics][simulation]") {
    CHECK(found(11, 40000, 8, 1.0, 8, 1.0, 4.0, 4.0).welch == Approx(0.05).margin(0.0035));
    CHECK(found(12, 40000, 6, 1.0, 14, 3.0, -6.0, 6.0).welch == Approx(0.05).margin(0.0065));
    CHECK(found(13, 40000, 3, 1.0, 3, 1.0, 0.5, 0.5).welch < 0.05);  // few seeds: hardly ever
}

// PowerTOST's manual, sampleN.TOST(logscale = FALSE, theta1 = -0.2, theta0 = -0.05, CV = 0.2,
// design = "parallel"): 48 in total for power 0.8, with 0.815435 by Owen's Q.
TEST_CASE("power: the published parallel-group example needs 24 a side and has 0.815435",
          "[statistics][exact]") {
    REQUIRE(equivalence_power(0.2, 24, 0.2, 0.05, -0.05) == Approx(0.815435).margin(1e-6));
    REQUIRE(equivalence_power(0.2, 24, 0.2, 0.05, 0.05) == Approx(0.815435).margin(1e-6));
    REQUIRE(seeds_per_side(0.2, 0.2, 0.8, 0.05, -0.05) == 24);
}

// With n -> infinity at a fixed margin/s the t becomes normal: power -> 2 Phi(margin/s - z) - 1. At
// nu = 2e5 the two differ by O(1/nu).
TEST_CASE("power: many seeds give the normal limit", "[statistics][limit]") {
    const std::size_t n = 100000;
    const double s = std::sqrt(2.0 / static_cast<double>(n)), margin = 3.0 * s;
    const boost::math::normal phi;
    const double expected = 2.0 * cdf(phi, 3.0 - quantile(phi, 0.95)) - 1.0;
    REQUIRE(equivalence_power(1.0, n, margin) == Approx(expected).margin(1e-5));
}

// 40000 trials: standard error at most 0.0025, three allowed. At n = 6 Welch's degrees of freedom
// are about 9 instead of 10, t 1.833 instead of 1.812; with a density of the difference of at most
// 2 * 0.4 per standard error that costs 0.017.
TEST_CASE("power: as many experiments succeed as the formula says", "[statistics][simulation]") {
    const std::size_t n = GENERATE(as<std::size_t>{}, 6, 12, 20);
    const double difference = GENERATE(0.0, 0.4);
    const double formula = equivalence_power(1.0, n, 1.5, 0.05, difference);
    const Found simulated = found(100 + n, 40000, n, 1.0, n, 1.0, difference, 1.5);
    CHECK(simulated.pooled == Approx(formula).margin(0.0075));
    CHECK(simulated.welch < formula + 0.0075);
    CHECK(simulated.welch > formula - 0.017 - 0.0075);
    CHECK(formula > 0.05);
}

TEST_CASE("power: the number of seeds is the first that gives it", "[statistics][identity]") {
    const double spread = GENERATE(0.2, 1.0, 1.6, 4.0);
    const std::size_t n = seeds_per_side(spread, 2.5, 0.95);
    REQUIRE(equivalence_power(spread, n, 2.5) >= 0.95);
    if (n > 2) REQUIRE(equivalence_power(spread, n - 1, 2.5) < 0.95);
}

TEST_CASE("power: more seeds, wider margins and laxer levels help; spread and difference hurt",
          "[statistics][liveness]") {
    const double base = equivalence_power(1.0, 10, 1.2, 0.05, 0.1);
    CHECK(equivalence_power(1.0, 12, 1.2, 0.05, 0.1) > base + 1e-3);
    CHECK(equivalence_power(1.0, 10, 1.4, 0.05, 0.1) > base + 1e-3);
    CHECK(equivalence_power(1.0, 10, 1.2, 0.10, 0.1) > base + 1e-3);
    CHECK(equivalence_power(1.2, 10, 1.2, 0.05, 0.1) < base - 1e-3);
    CHECK(equivalence_power(1.0, 10, 1.2, 0.05, 0.4) < base - 1e-3);
}

TEST_CASE("equivalence: bad input is refused and named", "[statistics][domain]") {
    const Summary good{1.0, 1.0, 5};
    REQUIRE_THROWS_WITH(two_one_sided_tests(good, good, 0.0), Catch::Contains("margin"));
    REQUIRE_THROWS_WITH(two_one_sided_tests(good, good, 1.0, 0.5), Catch::Contains("alpha"));
    REQUIRE_THROWS_WITH(two_one_sided_tests({1.0, 1.0, 1}, good, 1.0),
                        Catch::Contains("reference"));
    REQUIRE_THROWS_WITH(two_one_sided_tests(good, {1.0, -1.0, 5}, 1.0), Catch::Contains("scaled"));
    REQUIRE_THROWS_WITH(equivalence_power(0.0, 5, 1.0), Catch::Contains("standard_deviation"));
    REQUIRE_THROWS_WITH(equivalence_power(1.0, 1, 1.0), Catch::Contains("per_side"));
    REQUIRE_THROWS_WITH(seeds_per_side(1.0, 1.0, 1.0), Catch::Contains("power"));
    REQUIRE_THROWS_AS(seeds_per_side(1.0, 1.0, 0.9, 0.05, 1.0), scaling::InvalidParameter);
}
