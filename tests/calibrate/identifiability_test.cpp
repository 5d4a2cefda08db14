// SPDX-License-Identifier: MIT
#include "calibrate/identifiability.hpp"

#include "calibrate/designs.hpp"
#include "calibrate/trials.hpp"

#include <catch2/catch.hpp>

using namespace calibrate;

namespace {

Eigen::MatrixXd linear(const Eigen::MatrixXd& design) {
    return model_matrix(design, Terms::linear);
}

}  // namespace

TEST_CASE("identifiability: a full factorial has full rank and D-efficiency 1",
          "[calibrate][exact]") {
    const Eigen::MatrixXd x = linear(full_factorial(3));
    CHECK(rank(x) == 4);
    CHECK(null_vectors(x, linear_terms(3)).empty());
    CHECK(d_efficiency(x) == Approx(1.0).epsilon(1e-12));
    CHECK(orthogonal_and_balanced(full_factorial(3)));
}

// Two columns alike and a third their negative: A - B = 0 and A + C = 0 by hand.
TEST_CASE("identifiability: columns that are alike are named", "[calibrate][exact]") {
    Eigen::MatrixXd d(4, 4);
    d << -1, -1, 1, -1, 1, 1, -1, -1, -1, -1, 1, 1, 1, 1, -1, 1;
    const std::vector<NullVector> n = null_vectors(linear(d), linear_terms(4));
    REQUIRE(n.size() == 2);
    CHECK(n[0].text == "A - B = 0");
    CHECK(n[1].text == "A + C = 0");
    CHECK(estimable(n, 5) == std::vector<bool>{true, false, false, false, true});
    CHECK(estimable_pairs(n, linear_terms(4)).empty());  // A + B - C is, and takes three
    CHECK(estimable_pairs({n[0]}, linear_terms(4)) == std::vector<std::string>{"A + B"});
    CHECK(estimable_pairs({n[1]}, linear_terms(4)) == std::vector<std::string>{"A - C"});
    CHECK(d_efficiency(linear(d)) == 0.0);
}

TEST_CASE("identifiability: multiples are whole numbers where that is possible",
          "[calibrate][exact]") {
    Eigen::MatrixXd d(3, 2);  // B = 2 A + 1
    d << -1, -1, 0, 1, 1, 3;
    CHECK(null_vectors(linear(d), linear_terms(2)).front().text == "1 + 2 A - B = 0");
}

// Every null vector vanishes on every run, and b + c n predicts the same for every c.
TEST_CASE("identifiability: null vectors vanish on every run", "[calibrate]") {
    const Eigen::MatrixXd d = plackett_burman(12).topRows(9);
    const Eigen::MatrixXd x = linear(d);
    const std::vector<NullVector> basis = null_vectors(x, linear_terms(11));
    REQUIRE(static_cast<int>(basis.size()) == 12 - rank(x));
    for (const NullVector& n : basis) CHECK((x * n.coefficients).isZero(1e-9));
}

// Lin & Draper (1992), Technometrics 34, 423: in twelve runs each main effect carries a third of
// each pair without it, 45 for eleven factors.
TEST_CASE("identifiability: aliases of twelve runs are thirds", "[calibrate][exact]") {
    const std::vector<Alias> list = aliases(plackett_burman(12));
    CHECK(list.size() == 11 * 45);
    for (const Alias& a : list) {
        CHECK(std::abs(a.coefficient) == Approx(1.0 / 3.0).epsilon(1e-12));
        CHECK(a.factor != a.first);
        CHECK(a.factor != a.second);
    }
    CHECK(aliases(fold_over(plackett_burman(12))).empty());
}

// 2^(3-1) with C = AB: A carries BC, B carries AC, C carries AB, all of it.
TEST_CASE("identifiability: aliases of a half fraction have their names", "[calibrate][exact]") {
    const std::vector<Alias> list = aliases(fractional_factorial(3, {"C=-AB"}));
    REQUIRE(list.size() == 3);
    CHECK(list[0].text == "A carries -BC");
    CHECK(list[1].text == "B carries -AC");
    CHECK(list[2].text == "C carries -AB");
}
