// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include <cmath>

using namespace calibrate;

namespace {

double determinant(const Eigen::MatrixXd& design, Terms terms) {
    const Eigen::MatrixXd x = model_matrix(design, terms);
    return (x.transpose() * x).determinant();
}

// The largest det over every choice of `runs` different rows, by trying all of them.
double largest_of_all(const Eigen::MatrixXd& candidates, Terms terms, int runs) {
    const int n = static_cast<int>(candidates.rows());
    double largest = 0.0;
    for (int mask = 0; mask < 1 << n; ++mask) {
        if (__builtin_popcount(static_cast<unsigned>(mask)) != runs) continue;
        Eigen::MatrixXd design(runs, candidates.cols());
        for (int row = 0, run = 0; row < n; ++row) {
            if (mask >> row & 1) design.row(run++) = candidates.row(row);
        }
        largest = std::max(largest, determinant(design, terms));
    }
    return largest;
}

}  // namespace

// Hadamard: det(X'X) <= N^terms, reached by orthogonal two-level designs only.
TEST_CASE("d-optimal: a linear model from three levels picks an orthogonal 2^k design",
          "[calibrate][exact]") {
    const int factors = GENERATE(2, 3);
    const Eigen::MatrixXd d = d_optimal(full_factorial(factors, 3), Terms::linear, 8, 1);
    const Eigen::MatrixXd x = model_matrix(d, Terms::linear);
    CHECK(x.transpose() * x == 8.0 * Eigen::MatrixXd::Identity(factors + 1, factors + 1));
}

TEST_CASE("d-optimal: with interactions the optimum in eight runs is the full 2^3",
          "[calibrate][exact]") {
    const Eigen::MatrixXd d = d_optimal(full_factorial(3, 3), Terms::interactions, 8, 1);
    CHECK(determinant(d, Terms::interactions) == Approx(std::pow(8.0, 7)).epsilon(1e-10));
}

// Twelve runs of eleven factors from all 2048 corners: Hadamard's bound 12^12 is met by
// Plackett-Burman's design, and exchanges that only climb need not find it. At least 90 % of its
// D-efficiency is asked.
TEST_CASE("d-optimal: eleven factors in twelve runs come near Hadamard's bound", "[calibrate]") {
    const Eigen::MatrixXd d = d_optimal(full_factorial(11), Terms::linear, 12, 1);
    CHECK(std::pow(determinant(d, Terms::linear), 1.0 / 12.0) / 12.0 > 0.9);
}

// With repeats allowed det can only be larger; for six terms in six runs a repeat makes it 0.
TEST_CASE("d-optimal: six runs of a quadratic are the best of all choices from 3^2",
          "[calibrate][exact]") {
    const Eigen::MatrixXd candidates = full_factorial(2, 3);
    const double best = largest_of_all(candidates, Terms::quadratic, 6);
    const Eigen::MatrixXd d = d_optimal(candidates, Terms::quadratic, 6, 5);
    CHECK(determinant(d, Terms::quadratic) == Approx(best).epsilon(1e-10));
}

TEST_CASE("d-optimal: too few runs or too few levels are refused", "[calibrate][domain]") {
    CHECK_THROWS_AS(d_optimal(full_factorial(3), Terms::linear, 3, 1), scaling::InvalidParameter);
    CHECK_THROWS_AS(d_optimal(full_factorial(2), Terms::quadratic, 8, 1),
                    scaling::InvalidParameter);
}
