// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>

using namespace calibrate;

namespace {

// Slices of [-1, 1] that a column visits, of `runs` equal ones.
std::set<int> visited(const Eigen::VectorXd& column, int runs) {
    std::set<int> slices;
    for (const double x : column) slices.insert(static_cast<int>(std::floor((x + 1.0) / 2 * runs)));
    return slices;
}

}  // namespace

TEST_CASE("latin hypercube: one run in each slice of each factor", "[calibrate][exact]") {
    const Eigen::MatrixXd design = latin_hypercube(17, 5, 3);
    std::set<int> all;
    for (int k = 0; k < 17; ++k) all.insert(k);
    for (int factor = 0; factor < 5; ++factor) CHECK(visited(design.col(factor), 17) == all);
    CHECK(design == latin_hypercube(17, 5, 3));
    CHECK(design != latin_hypercube(17, 5, 4));
}

// Sobol (1967), as in Bratley & Fox (1988), ACM Trans. Math. Softw. 14, 88, without the origin:
// 1/2 1/2, 3/4 1/4, 1/4 3/4, 3/8 3/8, 7/8 7/8, 5/8 1/8, 1/8 5/8.
TEST_CASE("sobol: the first seven points are those of the published sequence",
          "[calibrate][exact]") {
    Eigen::MatrixXd published(7, 2);
    published << 4, 4, 6, 2, 2, 6, 3, 3, 7, 7, 5, 1, 1, 5;
    CHECK(sobol(7, 2) == (published / 4.0).array().matrix() - Eigen::MatrixXd::Ones(7, 2));
}

// A (t, s)-sequence in base 2: with the origin, any 2^m points visit each of 2^m slices once.
TEST_CASE("sobol: 63 points and the origin visit each 64th of every factor once",
          "[calibrate][exact]") {
    const Eigen::MatrixXd design = sobol(63, 8);
    for (int factor = 0; factor < 8; ++factor) {
        const std::set<int> slices = visited(design.col(factor), 64);
        CHECK(slices.size() == 63);
        CHECK(slices.count(0) == 0);
    }
}

TEST_CASE("space filling: sizes without a design are refused", "[calibrate][domain]") {
    CHECK_THROWS_AS(latin_hypercube(0, 3, 1), scaling::InvalidParameter);
    CHECK_THROWS_AS(sobol(8, 41), scaling::InvalidParameter);
    CHECK_THROWS_AS(sobol(8, 0), scaling::InvalidParameter);
}
