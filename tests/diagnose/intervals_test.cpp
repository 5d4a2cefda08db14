// SPDX-License-Identifier: MIT
#include "diagnose/intervals.hpp"

#include "line.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

using namespace diagnose;

namespace {

Candidate fitted(const Problem& p, const Whitener& w, const Term& term) {
    Candidate c{.h = p.hypothesis({&term}), .fit = {}};
    c.fit = fit(p, w, c.h, start_of(c.h.unknowns), false);
    return c;
}

}  // namespace

TEST_CASE("intervals: of a linear model the profile is the normal interval", "[diagnose]") {
    const Problem p = line::problem(200, 1.0, 2.0, 0.7, 0.05, 0.0, 5);
    const Whitener w(p, first_guess(p));
    const Term bend = line::bend();
    const Candidate c = fitted(p, w, bend);
    const std::vector<Estimate> list = estimates(p, w, c, bend);
    REQUIRE(list.size() == 1);
    // Least squares: the deviation of c is sigma/|q|, q what t^2 has beside 1 and t.
    const double n = 200.0;
    Eigen::MatrixXd a(200, 2);
    Eigen::VectorXd q(200);
    for (int k = 0; k < 200; ++k) {
        const double t = k / (n - 1.0);
        a(k, 0) = 1.0, a(k, 1) = t, q[k] = t * t;
    }
    q -= a * (a.transpose() * a).inverse() * (a.transpose() * q);
    const double reach = 1.645 * 0.05 / q.norm();
    // The search for the ends stops within a tenth of their distance, between points by straight lines.
    CHECK(list[0].low == Approx(list[0].value - reach).margin(0.02 * reach));
    CHECK(list[0].high == Approx(list[0].value + reach).margin(0.02 * reach));
}

TEST_CASE("intervals: nine of ten hold the truth", "[diagnose]") {
    const Term bend = line::bend();
    int held = 0;
    constexpr int draws = 300;
    for (int n = 0; n < draws; ++n) {
        const Problem p =
            line::problem(60, 1.0, 2.0, 0.7, 0.05, 0.0, 1000 + static_cast<unsigned>(n));
        const Whitener w(p, first_guess(p));
        const Estimate e = estimates(p, w, fitted(p, w, bend), bend).front();
        held += e.low <= 0.7 && 0.7 <= e.high ? 1 : 0;
    }
    // 270 expected, deviation sqrt(300 x 0.9 x 0.1) = 5.2; four of them.
    CHECK(held > 249);
    CHECK(held < 291);
}

TEST_CASE("intervals: they end where the physical range ends", "[diagnose]") {
    const Problem p = line::problem(60, 1.0, 2.0, 4.9, 0.5, 0.0, 3);
    const Whitener w(p, first_guess(p));
    const Term bend = line::bend();  // c from -5 to 5
    const Estimate e = estimates(p, w, fitted(p, w, bend), bend).front();
    CHECK(e.high == Approx(5.0));
    CHECK(e.low < e.value);
}
