// SPDX-License-Identifier: MIT
#include "diagnose/fit.hpp"

#include "diagnose/candidates.hpp"
#include "diagnose/noise.hpp"
#include "line.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <numbers>

using diagnose::Candidate;

namespace {

Candidate base(const diagnose::Problem& p, const diagnose::Whitener& w) {
    Candidate c{.h = p.hypothesis({}), .fit = {}};
    c.fit = diagnose::fit_base(p, w, c.h);
    c.log_evidence = c.fit.log_evidence;
    return c;
}

}  // namespace

// The normal equations of a straight line, worked out here with Eigen.
TEST_CASE("fit: a straight line comes out as the normal equations say, with their errors",
          "[diagnose][fit][exact]") {
    const diagnose::Problem p = line::problem(60, 1.0, -2.0, 0.0, 0.1, 0.0, 5);
    const diagnose::Whitener w(p, diagnose::first_guess(p));
    const Candidate c = base(p, w);
    Eigen::MatrixXd x(60, 2);
    for (Eigen::Index k = 0; k < 60; ++k) x(k, 0) = 1.0, x(k, 1) = static_cast<double>(k) / 59.0;
    const Eigen::MatrixXd inverse = (x.transpose() * x).inverse();
    const Eigen::VectorXd solution = inverse * (x.transpose() * p.recorded);
    const Eigen::VectorXd errors = diagnose::standard_errors(c.h.unknowns, c.fit);
    for (Eigen::Index k = 0; k < 2; ++k) {
        // The fit stops when a step gains less than 1e-3 of chi squared: 0.03 of an error.
        CHECK(c.fit.theta[k] == Approx(solution[k]).margin(0.03 * errors[k]));
        // The prior counts as 2 pi/(range/error)^2, 1e-4 here.
        CHECK(errors[k] == Approx(0.1 * std::sqrt(inverse(k, k))).epsilon(2e-3));
    }
}

// Gaussian integral in closed form: Z = (2 pi sigma^2)^(-n/2) exp(-chi^2/2) (2 pi)^(p/2) det(X'X/sigma^2)^(-1/2)/20^p.
TEST_CASE("fit: the evidence of a straight line is its Gaussian integral over the prior",
          "[diagnose][fit][exact]") {
    const diagnose::Problem p = line::problem(80, 0.3, 1.0, 0.0, 0.05, 0.0, 6);
    const diagnose::Whitener w(p, diagnose::first_guess(p));
    const Candidate c = base(p, w);
    Eigen::MatrixXd x(80, 2);
    for (Eigen::Index k = 0; k < 80; ++k) x(k, 0) = 1.0, x(k, 1) = static_cast<double>(k) / 79.0;
    const Eigen::VectorXd left =
        p.recorded - x * (x.transpose() * x).ldlt().solve(x.transpose() * p.recorded);
    const double s2 = 0.05 * 0.05;
    const double expected = -40.0 * std::log(2.0 * std::numbers::pi * s2) -
                            0.5 * left.squaredNorm() / s2 + std::log(2.0 * std::numbers::pi) -
                            0.5 * std::log((x.transpose() * x / s2).determinant()) -
                            2.0 * std::log(20.0);
    CHECK(c.log_evidence == Approx(expected).margin(2e-3));  // chi squared is minimal to 1e-3
}

TEST_CASE("fit: a range is a hard end", "[diagnose][fit][limit]") {
    diagnose::Problem p = line::problem(50, 3.0, 0.0, 0.0, 0.1, 0.0, 7);
    p.base[0].high = 2.0;
    const diagnose::Whitener w(p, diagnose::first_guess(p));
    CHECK(base(p, w).fit.theta[0] == Approx(2.0).epsilon(1e-9));
}

TEST_CASE("fit: a bend that was left out is found, its evidence falls where there is none",
          "[diagnose][fit]") {
    const diagnose::Term bend = line::bend();
    for (const double c : {0.0, 1.0}) {
        const diagnose::Problem p = line::problem(100, 0.0, 1.0, c, 0.05, 0.0, 8);
        const diagnose::Whitener w(p, diagnose::first_guess(p));
        const Candidate without = base(p, w), with = diagnose::extended(p, w, without, bend);
        const double error = diagnose::standard_errors(with.h.unknowns, with.fit)[2];
        CHECK(std::abs(with.fit.theta[2] - c) < 4.0 * error);
        CHECK((with.log_evidence > without.log_evidence) == (c > 0.0));
        if (c > 0.0) {
            // A parabola less its best straight line has variance c^2/180 over an even grid on [0, 1].
            CHECK(diagnose::separation(p, w, with, without) ==
                  Approx(with.fit.theta[2] * std::sqrt(100.0 / 180.0) / 0.05)
                      .epsilon(0.03));  // 100 rows, not infinitely many
        }
    }
}

TEST_CASE("noise: whitening turns AR(1) noise white, and back", "[diagnose][noise][exact]") {
    const diagnose::Problem p = line::problem(4000, 0.0, 0.0, 0.0, 0.2, 0.7, 9);
    const diagnose::Whitener w(p, {{{0.2, 0.7}}});
    const Eigen::VectorXd z = w(p.recorded);
    CHECK((w.coloured(z) - p.recorded).norm() < 1e-12 * p.recorded.norm());
    const double lag = z.head(3999).dot(z.tail(3999)) / z.squaredNorm();
    CHECK(std::abs(lag) <
          4.0 / std::sqrt(4000.0));  // four standard errors of a correlation of none
    CHECK(z.squaredNorm() / 4000.0 == Approx(1.0).margin(4.0 * std::sqrt(2.0 / 4000.0)));
}

TEST_CASE("noise: correlation and deviation are found, a smooth mismatch notwithstanding",
          "[diagnose][noise]") {
    const double rho = GENERATE(0.0, 0.4, 0.8);
    diagnose::Problem p = line::problem(400, 0.0, 0.0, 2.0, 0.1, rho, 10);
    SECTION("deviation stated") {}
    SECTION("deviation not stated") { p.records[0].channels[0].stated_noise = 0.0; }
    const diagnose::Noise n = diagnose::estimated(p, p.recorded, 2);  // the parabola is still in it
    CHECK(n[0][0].correlation ==
          Approx(rho).margin(
              0.12));  // 4 sqrt(1 - rho^2)/sqrt(300) at most 0.2; three quarters of the spectrum
    CHECK(n[0][0].deviation == Approx(0.1).epsilon(0.25));
}
