// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace calibrate;
using scaling::InvalidParameter;

namespace {

// Largest entry of C' D: 0 where every column of C is orthogonal to every column of D.
double largest_product(const Eigen::MatrixXd& c, const Eigen::MatrixXd& d) {
    return (c.transpose() * d).cwiseAbs().maxCoeff();
}

Eigen::MatrixXd two_factor_interactions(const Eigen::MatrixXd& design) {
    const Eigen::Index k = design.cols();
    return model_matrix(design, Terms::interactions).rightCols(k * (k - 1) / 2);
}

}  // namespace

TEST_CASE("factorial: 2^3 stands in Yates' order", "[calibrate][exact]") {
    Eigen::MatrixXd yates(8, 3);  // Box, Hunter & Hunter (2005), table 5.1: minus is low
    yates << -1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1;
    CHECK(full_factorial(3) == yates);
}

TEST_CASE("factorial: 3^2 holds each pair of levels once, evenly spaced", "[calibrate][exact]") {
    const Eigen::MatrixXd design = full_factorial(2, 3);
    REQUIRE(design.rows() == 9);
    for (const double a : {-1.0, 0.0, 1.0}) {
        for (const double b : {-1.0, 0.0, 1.0}) {
            const auto same = (design.col(0).array() == a) && (design.col(1).array() == b);
            CHECK(same.count() == 1);
        }
    }
}

// 2^(4-1) with D = ABC: I = ABCD, resolution IV, so AB = CD and main effects are clear of pairs.
// Box, Hunter & Hunter (2005), chapter 6.
TEST_CASE("factorial: a fraction has the aliases of its generator", "[calibrate][exact]") {
    const Eigen::MatrixXd d = fractional_factorial(4, {"D=ABC"});
    REQUIRE(d.rows() == 8);
    const Eigen::VectorXd ab = d.col(0).cwiseProduct(d.col(1));
    CHECK(ab == d.col(2).cwiseProduct(d.col(3)));
    CHECK(largest_product(d, two_factor_interactions(d)) == 0.0);
    CHECK(fractional_factorial(3, {"C=-AB"}).col(2) == -fractional_factorial(3, {"C=AB"}).col(2));
}

// 2^(7-4) with D=AB, E=AC, F=BC, G=ABC is saturated and of resolution III; folding it over gives
// resolution IV in 16 runs (Box, Hunter & Hunter 2005, section 6.7).
TEST_CASE("factorial: folding over frees main effects of two-factor interactions",
          "[calibrate][exact]") {
    const Eigen::MatrixXd d = fractional_factorial(7, {"D=AB", "E=AC", "F=BC", "G=ABC"});
    CHECK(d.transpose() * d == 8.0 * Eigen::MatrixXd::Identity(7, 7));
    CHECK(largest_product(d, two_factor_interactions(d)) == 8.0);
    const Eigen::MatrixXd both = fold_over(d);
    REQUIRE(both.rows() == 16);
    CHECK(both.transpose() * both == 16.0 * Eigen::MatrixXd::Identity(7, 7));
    CHECK(largest_product(both, two_factor_interactions(both)) == 0.0);
}

// The variance of a fitted quadratic is the same in all directions: at alpha = 2^(k/4) only. Here
// seen in X'X: sum x_i^4 = 3 sum x_i^2 x_j^2 (Box & Hunter 1957, Ann. Math. Stat. 28, 195).
TEST_CASE("factorial: a central composite with alpha = 2^(k/4) is rotatable",
          "[calibrate][exact]") {
    const int k = GENERATE(2, 3, 4);
    const Eigen::MatrixXd d = central_composite(k, std::pow(2.0, k / 4.0), 3);
    REQUIRE(d.rows() == (1 << k) + 2 * k + 3);
    const Eigen::ArrayXXd squares = d.array().square();
    const double fourth = squares.col(0).square().sum();
    CHECK(fourth == Approx(3.0 * (squares.col(0) * squares.col(1)).sum()).epsilon(1e-12));
    CHECK(d.bottomRows(3).isZero(0.0));
}

TEST_CASE("factorial: factors are named by letters without I", "[calibrate]") {
    CHECK(factor_letter(0) == 'A');
    CHECK(factor_letter(7) == 'H');
    CHECK(factor_letter(8) == 'J');
}

TEST_CASE("factorial: sizes and generators that make no design are refused",
          "[calibrate][domain]") {
    CHECK_THROWS_AS(full_factorial(0), InvalidParameter);
    CHECK_THROWS_AS(full_factorial(3, 1), InvalidParameter);
    CHECK_THROWS_AS(full_factorial(25), InvalidParameter);
    CHECK_THROWS_AS(fractional_factorial(4, {"D=ABD"}), InvalidParameter);
    CHECK_THROWS_AS(fractional_factorial(4, {"E=ABC"}), InvalidParameter);
    CHECK_THROWS_AS(fractional_factorial(4, {"ABC"}), InvalidParameter);
    CHECK_THROWS_AS(fractional_factorial(1, {"A=A"}), InvalidParameter);
    CHECK_THROWS_AS(central_composite(2, 0.0, 1), InvalidParameter);
}
