// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace calibrate;

namespace {

// Levels as tables print them: 1, 2, 3 for -1, 0, +1; of a two-level column 1 and 2.
std::string printed(const Eigen::MatrixXd& design, int run) {
    std::string text;
    for (int k = 0; k < design.cols(); ++k) {
        const bool two = (design.col(k).array() == 0.0).count() == 0;
        text += std::to_string(static_cast<int>((design(run, k) + 1.0) / (two ? 2.0 : 1.0)) + 1);
    }
    return text;
}

// Whether any two columns hold each pair of their levels equally often (strength 2).
bool pairs_balanced(const Eigen::MatrixXd& design) {
    for (int i = 0; i < design.cols(); ++i) {
        for (int j = i + 1; j < design.cols(); ++j) {
            std::map<double, int> first, second;
            std::map<std::pair<double, double>, int> both;
            for (int run = 0; run < design.rows(); ++run) {
                ++first[design(run, i)];
                ++second[design(run, j)];
                ++both[{design(run, i), design(run, j)}];
            }
            for (const auto& [a, unused] : first) {
                for (const auto& [b, none] : second) {
                    const auto count = both[{a, b}] * first.size() * second.size();
                    if (count != static_cast<std::size_t>(design.rows())) return false;
                }
            }
        }
    }
    return true;
}

}  // namespace

// Plackett & Burman (1946) as printed in Plasun (1999), thesis, TU Wien, table 3.6.
TEST_CASE("plackett-burman: twelve runs are those of the published table", "[calibrate][exact]") {
    const std::vector<std::string> table{
        "22122211121", "12212221112", "21221222111", "12122122211", "11212212221", "11121221222",
        "21112122122", "22111212212", "22211121221", "12221112122", "21222111212", "11111111111"};
    const Eigen::MatrixXd design = plackett_burman(12);
    REQUIRE(design.rows() == 12);
    for (int run = 0; run < 12; ++run) {
        CHECK(printed(design, run) == table[static_cast<std::size_t>(run)]);
    }
}

// One wrong sign of a first row would break it.
TEST_CASE("plackett-burman: columns are orthogonal and balanced", "[calibrate][exact]") {
    const int runs = GENERATE(8, 12, 16, 20, 24, 36);
    const Eigen::MatrixXd d = plackett_burman(runs);
    REQUIRE(d.cols() == runs - 1);
    CHECK(d.transpose() * d == runs * Eigen::MatrixXd::Identity(runs - 1, runs - 1));
    CHECK(d.colwise().sum().isZero(0.0));
}

// In twelve runs the product of two columns is aliased with each third column by 1/3 or -1/3 (Lin
// & Draper 1992, Technometrics 34, 423); folding over takes the alias away.
TEST_CASE("plackett-burman: each main effect carries a third of each other pair",
          "[calibrate][exact]") {
    const Eigen::MatrixXd d = plackett_burman(12), both = fold_over(d);
    for (int i = 0; i < 11; ++i) {
        for (int j = i + 1; j < 11; ++j) {
            for (int k = 0; k < 11; ++k) {
                if (k == i || k == j) continue;
                CHECK(std::abs(d.col(i).cwiseProduct(d.col(j)).dot(d.col(k))) == 4.0);
                CHECK(both.col(i).cwiseProduct(both.col(j)).dot(both.col(k)) == 0.0);
            }
        }
    }
}

// Taguchi (1987), System of Experimental Design: L9 whole, rows of L18 and L27.
TEST_CASE("orthogonal arrays: rows are those of Taguchi's tables", "[calibrate][exact]") {
    const std::vector<std::string> l9{"1111", "1222", "1333", "2123", "2231",
                                      "2312", "3132", "3213", "3321"};
    for (int run = 0; run < 9; ++run) {
        CHECK(printed(orthogonal_array(9), run) == l9[static_cast<std::size_t>(run)]);
    }
    const Eigen::MatrixXd l18 = orthogonal_array(18), l27 = orthogonal_array(27);
    CHECK(printed(l18, 3) == "12112233");
    CHECK(printed(l18, 9) == "21133221");
    CHECK(printed(l18, 17) == "23321231");
    CHECK(printed(l27, 1) == "1111222222222");
    CHECK(printed(l27, 3) == "1222111222333");
    CHECK(printed(l27, 9) == "2123123123123");
    CHECK(printed(l27, 26) == "3321321213132");
}

TEST_CASE("orthogonal arrays: any two columns hold each pair of levels equally often",
          "[calibrate][exact]") {
    CHECK(pairs_balanced(orthogonal_array(GENERATE(9, 18, 27))));
    Eigen::MatrixXd wrong = orthogonal_array(18);
    wrong(4, 4) = -wrong(4, 4);
    CHECK_FALSE(pairs_balanced(wrong));
}

TEST_CASE("published arrays: a number of runs without a table is refused", "[calibrate][domain]") {
    CHECK_THROWS_AS(plackett_burman(14), scaling::InvalidParameter);
    CHECK_THROWS_AS(plackett_burman(28), scaling::InvalidParameter);
    CHECK_THROWS_AS(orthogonal_array(12), scaling::InvalidParameter);
}
