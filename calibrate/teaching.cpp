// SPDX-License-Identifier: MIT
#include "calibrate/teaching.hpp"

#include "calibrate/designs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace calibrate {
namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int ask_count = 256, candidate_count = 192;

// N(t; m, v)
ArrayXd density(double t, const ArrayXd& m, const ArrayXd& v) {
    return (-0.5 * (t - m).square() / v).exp() / (2.0 * std::numbers::pi * v).sqrt();
}

MatrixXd rows_of(const MatrixXd& points, const std::vector<Index>& rows) {
    MatrixXd taken(static_cast<Index>(rows.size()), points.cols());
    for (std::size_t k = 0; k < rows.size(); ++k)
        taken.row(static_cast<Index>(k)) = points.row(rows[k]);
    return taken;
}

// Where the posterior may be dense, and how much of the ranges each stands for.
struct Questions {
    MatrixXd points;  // [questions][factors]
    ArrayXd shares;   // [questions]
};

// As many where the squared mean likelihood is expected as anywhere, at random.
Questions questions(const Surrogate& s, const Posterior& p, std::uint64_t seed) {
    const auto factors = static_cast<int>(p.points.cols());
    MatrixXd pool(4 * ask_count, factors);
    pool << rows_of(p.points, resampled(p.weights, 2 * ask_count, 0.5)),
        latin_hypercube(2 * ask_count, factors, seed);
    ArrayXd size = (s.log_likelihood(pool).array());
    size = (size - size.maxCoeff()).exp();
    // Half of the pool follows L (normalised here by the other half, which is even), half is even.
    // Two sharp targets may leave nothing of the even half.
    const double level = std::max(size.tail(2 * ask_count).mean(), 1e-200);
    const ArrayXd proposal = 0.5 * size / level + 0.5;
    const ArrayXd weight = size.square() / proposal;
    const auto rows = resampled(weight.matrix(), ask_count, 0.5);
    Questions q{rows_of(pool, rows), ArrayXd(ask_count)};
    for (Index k = 0; k < ask_count; ++k)
        q.shares[k] = 1.0 / (proposal[rows[static_cast<std::size_t>(k)]] *
                             weight[rows[static_cast<std::size_t>(k)]]);
    return q;
}

// Products over the targets of E p^2 [questions], (E p)^2 now [questions] and later
// [questions][candidates], for draw k of each target.
struct Moments {
    ArrayXd square, now;
    ArrayXXd later;
};

Moments moments(const Surrogate& s, const MatrixXd& ask, const MatrixXd& candidates,
                std::size_t k) {
    const double pi = std::numbers::pi;
    Moments m{ArrayXd::Ones(ask.rows()), ArrayXd::Ones(ask.rows()),
              ArrayXXd::Ones(ask.rows(), candidates.rows())};
    for (std::size_t j = 0; j < s.problem().targets.size(); ++j) {
        const Target& target = s.problem().targets[j];
        if (!target.value) continue;
        const auto& process = s.draws(j)[k];
        const double t = *target.value, s2 = target.standard_deviation * target.standard_deviation;
        const double noise = process.hyperparameters().noise;
        const auto at = process.at(ask);
        const ArrayXd v = at.variance.array(), mean = at.mean.array();
        const ArrayXd seen = process.at(candidates).variance.array() + noise * noise;
        const MatrixXd c = process.covariance(ask, candidates);
        m.square *= density(t, mean, 0.5 * s2 + v) / (2.0 * std::sqrt(s2 * pi));
        m.now *= density(t, mean, s2 + v).square();
        for (Index i = 0; i < candidates.rows(); ++i) {
            const ArrayXd tau2 = (c.col(i).array().square() / seen[i]).min(v);
            m.later.col(i) *=
                density(t, mean, 0.5 * (s2 + v + tau2)) / (2.0 * (pi * (s2 + v - tau2)).sqrt());
        }
    }
    return m;
}

}  // namespace

Lesson best_lesson(const Surrogate& s, const Posterior& p, std::uint64_t seed) {
    const Questions q = questions(s, p, seed);
    MatrixXd candidates(2 * candidate_count, p.points.cols());
    candidates << rows_of(p.points, resampled(p.weights, candidate_count, 0.25)),
        latin_hypercube(candidate_count, static_cast<int>(p.points.cols()), seed + 1);
    const ArrayXd weight = q.shares * s.forms(q.points).array().square();
    ArrayXd gain = ArrayXd::Zero(candidates.rows());
    double open = 0.0;
    for (std::size_t k = 0; k < s.draws(0).size(); ++k) {
        const Moments m = moments(s, q.points, candidates, k);
        open += (weight * (m.square - m.now)).sum();
        gain += ((m.later.colwise() - m.now).colwise() * weight).colwise().sum().transpose();
    }
    gain *= s.forms(candidates).array();
    Index best = 0;
    gain.maxCoeff(&best);
    return {candidates.row(best), open > 0.0 ? gain[best] / open : 0.0};
}

}  // namespace calibrate
