// SPDX-License-Identifier: MIT
#include "calibrate/failed_runs.hpp"

#include "calibrate/designs.hpp"
#include "calibrate/effects.hpp"
#include "calibrate/identifiability.hpp"
#include "scaling/errors.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace calibrate {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double slope_prior = 1.25, constant_prior = 10.0;  // log odds

std::vector<double> effects_with(const Trials& trials, double value) {
    Trials filled = trials;
    for (std::optional<double>& y : filled.responses) y = y.value_or(value);
    std::vector<double> effects;
    for (const LevelMeans& m : level_means(filled)) effects.push_back(m.effect);
    return effects;
}

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

}  // namespace

std::vector<Imputed> imputed(const Trials& trials, const std::vector<double>& values) {
    check(trials);
    std::vector<Imputed> all;
    for (const double value : values) all.push_back({value, effects_with(trials, value)});
    return all;
}

std::vector<std::optional<double>> sign_changes(const Trials& trials) {
    check(trials);
    const std::vector<double> at_zero = effects_with(trials, 0.0),
                              at_one = effects_with(trials, 1.0);
    std::vector<std::optional<double>> changes;
    for (std::size_t k = 0; k < at_zero.size(); ++k) {
        const double slope = at_one[k] - at_zero[k];
        const bool moves = std::abs(slope) > 1e-9;
        changes.push_back(moves ? std::optional<double>(-at_zero[k] / slope) : std::nullopt);
    }
    return changes;
}

std::vector<ImpliedRange> implied_ranges(const Trials& trials, double bound) {
    check(trials);
    const Trials formed = usable(trials);
    const Eigen::MatrixXd x = model_matrix(formed.design, Terms::linear);
    const std::vector<std::string> names = linear_terms(static_cast<int>(trials.design.cols()));
    const std::vector<NullVector> free = null_vectors(x, names);
    if (free.size() != 1) return {};
    const Eigen::VectorXd n = free.front().coefficients;
    const Eigen::VectorXd b = x.completeOrthogonalDecomposition().solve(responses_of(formed));
    const Eigen::MatrixXd failed = model_matrix(failed_design(trials), Terms::linear);
    double low = -infinity, high = infinity;  // of c
    for (Eigen::Index run = 0; run < failed.rows(); ++run) {
        const double along = failed.row(run).dot(n), rest = bound - failed.row(run).dot(b);
        if (along > 1e-9) high = std::min(high, rest / along);
        if (along < -1e-9) low = std::max(low, rest / along);
        if (std::abs(along) <= 1e-9 && rest < 0.0) low = infinity;
    }
    if (low > high)
        throw scaling::InvalidParameter(scaling::mistake(
            "bound", fmt::format("{}", bound), "must be met by all failed runs of some fit",
            "a linear model does not explain which runs failed"));
    std::vector<ImpliedRange> ranges;
    for (std::size_t k = 1; k < names.size(); ++k) {
        const Eigen::Index j = static_cast<Eigen::Index>(k);
        if (n(j) == 0.0) {
            ranges.push_back({names[k], {2.0 * b(j), 2.0 * b(j)}});
            continue;
        }
        const double one = 2.0 * (b(j) + low * n(j)), other = 2.0 * (b(j) + high * n(j));
        ranges.push_back({names[k], {std::min(one, other), std::max(one, other)}});
    }
    return ranges;
}

Feasibility feasibility(const Trials& trials) {
    check(trials);
    const Eigen::Index failed = failed_design(trials).rows(), runs = trials.design.rows();
    if (failed == 0 || failed == runs)
        throw scaling::InvalidParameter(scaling::mistake(
            "trials", fmt::format("{} failed of {}", failed, runs),
            "must be some that failed and some that formed", "there is nothing to tell apart"));
    const Eigen::MatrixXd x = model_matrix(trials.design, Terms::linear);
    Eigen::VectorXd formed(runs);
    for (Eigen::Index run = 0; run < runs; ++run)
        formed(run) = trials.responses[static_cast<std::size_t>(run)] ? 1.0 : 0.0;
    Eigen::VectorXd precision = Eigen::VectorXd::Constant(x.cols(), std::pow(slope_prior, -2));
    precision(0) = std::pow(constant_prior, -2);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(x.cols());
    Eigen::MatrixXd curvature;
    for (int step = 0; step < 100; ++step) {  // Newton; concave, a few steps are enough
        const Eigen::VectorXd p = (x * b).unaryExpr(&logistic);
        const Eigen::VectorXd weight = p.array() * (1.0 - p.array());
        curvature = x.transpose() * weight.asDiagonal() * x;
        curvature.diagonal() += precision;
        const Eigen::VectorXd gradient = x.transpose() * (formed - p) - precision.cwiseProduct(b);
        const Eigen::VectorXd change = curvature.ldlt().solve(gradient);
        b += change;
        if (change.cwiseAbs().maxCoeff() < 1e-12) break;
    }
    const Eigen::MatrixXd covariance =
        curvature.ldlt().solve(Eigen::MatrixXd::Identity(x.cols(), x.cols()));
    Feasibility f{b(0), {}, {}};
    for (int k = 1; k < x.cols(); ++k)
        f.slopes.push_back(
            {std::string(1, factor_letter(k - 1)), 2.0 * b(k), 2.0 * std::sqrt(covariance(k, k))});
    for (Eigen::Index run = 0; run < runs; ++run)
        f.probability.push_back(logistic(x.row(run).dot(b)));
    return f;
}

double probability_of_forming(const Feasibility& f, const Eigen::VectorXd& coded) {
    double log_odds = f.constant;
    for (std::size_t k = 0; k < f.slopes.size(); ++k)
        log_odds += 0.5 * f.slopes[k].estimate * coded(static_cast<Eigen::Index>(k));
    return logistic(log_odds);
}

}  // namespace calibrate
