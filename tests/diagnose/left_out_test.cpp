// SPDX-License-Identifier: MIT
#include "diagnose/left_out.hpp"

#include "line.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr std::size_t rows = 40;
constexpr double sigma = 0.1;

// Two straight lines recorded one after the other.
diagnose::Problem two_lines(const cases::Experiment& second) {
    diagnose::Problem p = line::problem(rows, 1.0, -2.0, 0.0, sigma, 0.0, 5);
    diagnose::Problem other = line::problem(rows, 1.1, -2.3, 0.0, sigma, 0.0, 6);
    diagnose::Record& r = other.records[0];
    r.experiment = &second, r.channels[0].first = rows;
    p.records.push_back(std::move(r));
    VectorXd both(static_cast<Index>(2 * rows));
    both << p.recorded, other.recorded;
    p.recorded = both, p.size = 2 * rows;
    return p;
}

}  // namespace

// The normal equations of each line alone, worked out here with Eigen, and what its line leaves of the other.
TEST_CASE("left out: each line is predicted by the fit to the other alone", "[diagnose][exact]") {
    cases::Experiment second = line::experiment();
    second.id = "line-2";
    const diagnose::Problem p = two_lines(second);
    const diagnose::Whitener w(p, diagnose::first_guess(p));
    const diagnose::Hypothesised h = p.hypothesis({});
    const diagnose::Fit all = diagnose::fit_base(p, w, h);
    MatrixXd x(static_cast<Index>(rows), 2);
    for (Index k = 0; k < x.rows(); ++k)
        x(k, 0) = 1.0, x(k, 1) = static_cast<double>(k) / (rows - 1.0);
    const VectorXd one = p.recorded.head(x.rows()), two = p.recorded.tail(x.rows());
    const auto line_of = [&](const VectorXd& y) {
        return VectorXd((x.transpose() * x).ldlt().solve(x.transpose() * y));
    };
    const double expected =
        ((two - x * line_of(one)).squaredNorm() + (one - x * line_of(two)).squaredNorm()) /
        (sigma * sigma);
    // A fit stops when a step gains less than 1e-2 of chi squared: a tenth of an error of a, and that moves the sum by some 3.
    CHECK(diagnose::left_out_misfit(p, w, h, all) == Approx(expected).margin(3.0));
    CHECK(diagnose::left_out_misfit(p, w, h, all) > all.chi_squared + 10.0);
}

TEST_CASE("left out: one recording leaves nothing to predict it by", "[diagnose]") {
    const diagnose::Problem p = line::problem(rows, 1.0, -2.0, 0.0, sigma, 0.0, 5);
    const diagnose::Whitener w(p, diagnose::first_guess(p));
    const diagnose::Hypothesised h = p.hypothesis({});
    CHECK(std::isnan(diagnose::left_out_misfit(p, w, h, diagnose::fit_base(p, w, h))));
}
