// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace calibrate {
namespace {

constexpr int starts = 20;
constexpr double gain_floor = 1e-9;  // a swap that betters det by less is rounding

struct Choice {
    std::vector<int> rows;   // of the candidates, shape [runs]
    double log_determinant;  // of X'X; -infinity where singular
};

Eigen::MatrixXd information(const Eigen::MatrixXd& x, const std::vector<int>& rows) {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(x.cols(), x.cols());
    for (const int r : rows) m += x.row(r).transpose() * x.row(r);
    return m;
}

double log_determinant(const Eigen::MatrixXd& m) {
    const Eigen::LDLT<Eigen::MatrixXd> factors(m);
    const Eigen::VectorXd d = factors.vectorD();
    if (d.minCoeff() <= 1e-10 * d.maxCoeff()) return -std::numeric_limits<double>::infinity();
    return d.array().log().sum();
}

// A few random rows, then one by one the candidate of the largest variance x' M^-1 x, which raises
// the determinant most (Dykstra 1971). The ridge only keeps the first steps regular.
std::vector<int> random_start(const Eigen::MatrixXd& x, int runs, std::mt19937_64& random) {
    const int terms = static_cast<int>(x.cols());
    std::vector<int> rows;
    for (int k = 0; k < std::max(1, terms / 2); ++k) {
        rows.push_back(static_cast<int>(random() % static_cast<std::uint64_t>(x.rows())));
    }
    Eigen::MatrixXd m = information(x, rows) + 1e-6 * Eigen::MatrixXd::Identity(terms, terms);
    while (static_cast<int>(rows.size()) < runs) {
        const Eigen::MatrixXd solved = m.ldlt().solve(x.transpose());
        Eigen::Index best = 0;
        x.cwiseProduct(solved.transpose()).rowwise().sum().maxCoeff(&best);
        rows.push_back(static_cast<int>(best));
        m += x.row(best).transpose() * x.row(best);
    }
    return rows;
}

// Swaps each run for the candidate that betters the determinant most, until a whole pass betters
// nothing. Swapping row i for j multiplies det by
//   (1 + d_j)(1 - d_i) + d_ij^2,   d_ij = x_i' M^-1 x_j, d_i = d_ii   (Fedorov 1972)
Choice exchanged(const Eigen::MatrixXd& x, std::vector<int> rows) {
    Eigen::MatrixXd m = information(x, rows);
    if (std::isinf(log_determinant(m))) return {rows, log_determinant(m)};
    for (bool bettered = true; bettered;) {
        bettered = false;
        for (int& run : rows) {
            const Eigen::MatrixXd solved = m.ldlt().solve(x.transpose());
            const Eigen::ArrayXd d = x.cwiseProduct(solved.transpose()).rowwise().sum().array();
            const Eigen::ArrayXd across = (x.row(run) * solved).transpose().array();
            const Eigen::ArrayXd gain = (1.0 + d) * (1.0 - d(run)) + across.square();
            Eigen::Index best = 0;
            if (gain.maxCoeff(&best) <= 1.0 + gain_floor) continue;
            m += x.row(best).transpose() * x.row(best) - x.row(run).transpose() * x.row(run);
            run = static_cast<int>(best);
            bettered = true;
        }
    }
    return {rows, log_determinant(information(x, rows))};
}

}  // namespace

Eigen::MatrixXd model_matrix(const Eigen::MatrixXd& design, Terms terms) {
    const Eigen::Index k = design.cols();
    const Eigen::Index pairs = terms == Terms::linear ? 0 : k * (k - 1) / 2;
    const Eigen::Index squares = terms == Terms::quadratic ? k : 0;
    Eigen::MatrixXd x(design.rows(), 1 + k + pairs + squares);
    x.col(0).setOnes();
    x.middleCols(1, k) = design;
    Eigen::Index column = 1 + k;
    if (pairs > 0) {
        for (Eigen::Index i = 0; i < k; ++i) {
            for (Eigen::Index j = i + 1; j < k; ++j) {
                x.col(column++) = design.col(i).cwiseProduct(design.col(j));
            }
        }
    }
    if (squares > 0) x.rightCols(k) = design.cwiseAbs2();
    return x;
}

Eigen::MatrixXd d_optimal(const Eigen::MatrixXd& candidates, Terms terms, int runs,
                          std::uint64_t seed) {
    const Eigen::MatrixXd x = model_matrix(candidates, terms);
    if (runs < x.cols()) {
        throw scaling::InvalidParameter(scaling::mistake(
            "d_optimal.runs", std::to_string(runs),
            fmt::format("must be at least the {} terms", x.cols()), "fit fewer terms or run more"));
    }
    std::mt19937_64 random(seed);
    Choice best{{}, -std::numeric_limits<double>::infinity()};
    for (int start = 0; start < starts; ++start) {
        Choice found = exchanged(x, random_start(x, runs, random));
        if (found.log_determinant > best.log_determinant) best = std::move(found);
    }
    if (best.rows.empty()) {
        throw scaling::InvalidParameter(
            scaling::mistake("d_optimal.candidates", fmt::format("{} runs", candidates.rows()),
                             fmt::format("must tell the {} terms apart", x.cols()),
                             "add candidates, such as a third level for squares"));
    }
    Eigen::MatrixXd design(runs, candidates.cols());
    for (int run = 0; run < runs; ++run) {
        design.row(run) = candidates.row(best.rows[static_cast<std::size_t>(run)]);
    }
    return design;
}

}  // namespace calibrate
