// SPDX-License-Identifier: MIT
#include "statistics/probit_process.hpp"

#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace statistics;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

MatrixXd uniform(std::mt19937_64& random, Index rows, Index columns) {
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    MatrixXd x(rows, columns);
    for (double& v : x.reshaped()) v = u(random);
    return x;
}

}  // namespace

TEST_CASE("probit process: yes and no change places by symmetry", "[statistics][identity]") {
    std::mt19937_64 random(1);
    const MatrixXd x = uniform(random, 14, 2), p = uniform(random, 20, 2);
    std::vector<bool> yes, no;
    for (Index k = 0; k < 14; ++k) yes.push_back(x(k, 0) > -0.2), no.push_back(!yes.back());
    const VectorXd a = ProbitProcess(x, yes).probability(p),
                   b = ProbitProcess(x, no).probability(p);
    REQUIRE((a + b - VectorXd::Ones(20)).cwiseAbs().maxCoeff() < 1e-9);
    REQUIRE(a.minCoeff() > 0.0);
    REQUIRE(a.maxCoeff() < 1.0);
}

// One yes and one no at the same place cancel: P = 1/2 there.
TEST_CASE("probit process: a point with one yes and one no is even", "[statistics][exact]") {
    const MatrixXd x{{0.4}, {0.4}};
    REQUIRE(ProbitProcess(x, {true, false}).probability(MatrixXd{{0.4}})[0] ==
            Approx(0.5).margin(1e-9));
}

// A boundary x0 + x1/2 > -0.3 in four factors: after 40 runs nine in ten of the points that are
// 0.3 or more from it are told. Chance would tell as many as the larger class, about two thirds.
TEST_CASE("probit process: it finds where heaps stop forming", "[statistics][simulation]") {
    std::mt19937_64 random(2);
    const auto forms = [](const auto& r) { return r[0] + 0.5 * r[1] + 0.3; };
    const MatrixXd x = uniform(random, 40, 4), p = uniform(random, 400, 4);
    std::vector<bool> yes;
    for (Index k = 0; k < 40; ++k) yes.push_back(forms(x.row(k)) > 0.0);
    const VectorXd probability = ProbitProcess(x, yes).probability(p);
    int told = 0, asked = 0;
    for (Index k = 0; k < 400; ++k) {
        const double margin = forms(p.row(k));
        if (std::abs(margin) < 0.3) continue;
        ++asked;
        told += (margin > 0.0) == (probability[k] > 0.5);
    }
    REQUIRE(told > 0.9 * asked);
}

TEST_CASE("probit process: with nothing but heaps, heaps are expected, most where there were some",
          "[statistics][limit]") {
    std::mt19937_64 random(3);
    const MatrixXd x = 0.2 * uniform(random, 10, 1);
    const VectorXd p =
        ProbitProcess(x, std::vector<bool>(10, true)).probability(MatrixXd{{0.0}, {1.0}});
    REQUIRE(p[0] > 0.9);
    REQUIRE(p[1] > 0.5);
    REQUIRE(p[1] < p[0]);
}

TEST_CASE("probit process: bad input is refused", "[statistics][domain]") {
    REQUIRE_THROWS_AS(ProbitProcess(MatrixXd(0, 1), {}), scaling::InvalidParameter);
    REQUIRE_THROWS_AS(ProbitProcess(MatrixXd{{0.0}}, {true, false}), scaling::InvalidParameter);
}
