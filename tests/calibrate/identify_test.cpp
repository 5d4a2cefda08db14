// SPDX-License-Identifier: MIT
#include "calibrate/identify.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <random>

using namespace calibrate;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Runs at random points of a function without scatter to speak of.
std::vector<Run> runs_of(const Problem& p, int count,
                         const std::function<std::vector<double>(const VectorXd&)>& f) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    std::vector<Run> history;
    for (int k = 0; k < count; ++k) {
        VectorXd c(static_cast<Index>(p.factors.size()));
        for (double& v : c) v = u(random);
        const VectorXd x = point_of(p, c);
        history.push_back({{x, p.seed + static_cast<unsigned>(k), "start"}, f(x)});
    }
    return history;
}

// a acts with 30, b with 15 deg over their ranges, c not at all; the density by a alone.
Problem ridge() {
    return {{{"a", "1", 0.0, 1.0}, {"b", "J/m^2", 0.0, 0.5}, {"c", "1", 0.0, 1.0}},
            {{"angle_of_repose", "deg", 42.5, 0.5}, {"bulk_density", "g/cm^3", {}, 0.02}}};
}
std::vector<double> on_ridge(const VectorXd& x) {
    return {20.0 + 30.0 * x[0] + 30.0 * x[1], 2.0 - 1.0 * x[0]};
}

}  // namespace

// One angle, two factors: b +0.05 is made up by a -0.05 (equal slopes of 30 deg per unit); c trades with nothing.
// Along the ridge a = 0.75 - b + noise, b from 0 to 0.5: both keep the spread of an even distribution over
// 0.5, for a half of its prior spread, for b all of it; the noise, 0.5/30, adds one part in 300.
TEST_CASE("identify: one angle leaves a ridge, and says what trades for what",
          "[calibrate][exact]") {
    const Problem p = ridge();
    const Surrogate s(p, runs_of(p, 30, on_ridge), 3);
    const Posterior post = posterior(s, 4);
    const Identification id = identify(s, post, coded(p, VectorXd{{0.5, 0.25, 0.5}}));
    // About 400 effective samples: a deviation is known to 1/sqrt(800) = 4 %; three of those.
    CHECK(id.factors[0].shrinkage == Approx(0.5).epsilon(0.12));
    CHECK(id.factors[1].shrinkage == Approx(1.0).epsilon(0.12));
    CHECK(id.factors[2].shrinkage == Approx(1.0).epsilon(0.12));
    REQUIRE(id.trades.size() == 1);
    CHECK(id.trades[0].factor == "b");
    CHECK(id.trades[0].step == Approx(0.05).epsilon(1e-12));
    REQUIRE(id.trades[0].with == std::vector<std::string>{"a"});
    CHECK(id.trades[0].by[0] == Approx(-0.05).epsilon(0.03));  // 30 runs of a plane
    CHECK_THAT(id.trades[0].words, Catch::Contains("b +0.05 J/m^2 is made up by a -0.05"));
}

// With a density that depends on a alone, known to 0.02: a to 0.02 of its range of 1, hence b = 0.75 - a to
// sqrt(0.02^2 + (0.5/30)^2) = 0.026 of 0.5. In deviations of the prior, 1/sqrt(12) of the range: 0.07 and 0.18.
TEST_CASE("identify: it knows beforehand what a second measurement would fix",
          "[calibrate][exact]") {
    Problem p = ridge();
    const auto history = runs_of(p, 30, on_ridge);
    const Surrogate before(p, history, 3);
    const VectorXd answer = coded(p, VectorXd{{0.5, 0.25, 0.5}});
    const Identification id = identify(before, posterior(before, 4), answer);
    REQUIRE(id.offers.size() == 1);
    CHECK(id.offers[0].target == "bulk_density");
    CHECK(id.offers[0].shrinkage[0] == Approx(0.07).epsilon(0.3));
    CHECK(id.offers[0].shrinkage[1] == Approx(0.18).epsilon(0.3));
    CHECK(id.offers[0].shrinkage[2] == Approx(1.0).epsilon(0.15));
    // Of a: even over 0.5, afterwards normal with 0.02 (entropy log2(0.02 sqrt(2 pi e))). b follows.
    CHECK(id.offers[0].bits == Approx(std::log2(0.5 / (0.02 * std::sqrt(17.08)))).margin(0.5));

    p.targets[1].value = 1.5;
    const Surrogate after(p, history, 3);
    const Identification both = identify(after, posterior(after, 4), answer);
    CHECK(both.offers.empty());
    CHECK(both.trades.empty());
    CHECK(both.factors[0].shrinkage == Approx(0.07).epsilon(0.3));
    CHECK(both.factors[1].shrinkage == Approx(0.18).epsilon(0.3));
}

TEST_CASE("identify: a measurement that depends on nothing new gives no bits",
          "[calibrate][limit]") {
    Problem p = ridge();
    const auto history = runs_of(p, 30, [](const VectorXd& x) {
        return std::vector<double>{on_ridge(x)[0], 0.01 * on_ridge(x)[0]};
    });
    const Surrogate s(p, history, 3);
    const Identification id = identify(s, posterior(s, 4), VectorXd::Zero(3));
    // The angle is known to 0.5 deg, 0.005 of this; a measurement to 0.02 adds log2(1 + 1/16)/2 = 0.04.
    CHECK(id.offers[0].bits < 0.2);
}
