// SPDX-License-Identifier: MIT
#include "calibrate/effects.hpp"

#include "calibrate/designs.hpp"
#include "calibrate/identifiability.hpp"
#include "scaling/errors.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <boost/math/distributions/non_central_t.hpp>
#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace calibrate {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// 1 and an indicator of each further level of each factor but `without`. Shape [runs][columns].
Eigen::MatrixXd level_indicators(const Eigen::MatrixXd& design, int without) {
    std::vector<Eigen::VectorXd> columns{Eigen::VectorXd::Ones(design.rows())};
    for (int k = 0; k < design.cols(); ++k) {
        if (k == without) continue;
        const Eigen::VectorXd column = design.col(k);
        std::set<double> levels(column.begin(), column.end());
        levels.erase(levels.begin());
        for (const double level : levels)
            columns.push_back((design.col(k).array() == level).cast<double>().matrix());
    }
    Eigen::MatrixXd x(design.rows(), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
        x.col(static_cast<Eigen::Index>(k)) = columns[k];
    return x;
}

double residual_square(const Eigen::MatrixXd& x, const Eigen::VectorXd& y) {
    return (y - x * x.completeOrthogonalDecomposition().solve(y)).squaredNorm();
}

}  // namespace

std::vector<LevelMeans> level_means(const Trials& trials) {
    const Eigen::VectorXd y = responses_of(trials);
    std::vector<LevelMeans> all;
    for (int k = 0; k < trials.design.cols(); ++k) {
        const Eigen::ArrayXd high = (trials.design.col(k).array() > 0.0).cast<double>();
        LevelMeans m{};
        m.factor = std::string(1, factor_letter(k));
        m.sum_high = (y.array() * high).sum();
        m.sum_low = (y.array() * (1.0 - high)).sum();
        m.count_high = static_cast<int>(high.sum());
        m.count_low = static_cast<int>(high.size()) - m.count_high;
        m.mean_high = m.sum_high / m.count_high;
        m.mean_low = m.sum_low / m.count_low;
        m.effect = m.mean_high - m.mean_low;
        all.push_back(m);
    }
    for (LevelMeans& m : all) {
        m.rank = 1;
        for (const LevelMeans& other : all) m.rank += std::abs(other.effect) > std::abs(m.effect);
    }
    return all;
}

EffectFit fit_effects(const Trials& trials, int left_out) {
    check(trials);
    const Eigen::VectorXd y = responses_of(trials);
    const Eigen::MatrixXd whole = model_matrix(trials.design, Terms::linear);
    const std::vector<std::string> names = linear_terms(static_cast<int>(trials.design.cols()));
    std::vector<int> terms;
    for (int k = 0; k < whole.cols(); ++k)
        if (k != left_out) terms.push_back(k);
    const Eigen::MatrixXd x = whole(Eigen::all, terms);
    if (rank(x) < x.cols())
        throw scaling::InvalidParameter(scaling::mistake(
            "design", fmt::format("rank {} of {}", rank(x), x.cols()), "must have full rank",
            "leave a term out, or add runs that tell the terms apart"));
    const Eigen::MatrixXd inverse =
        (x.transpose() * x).ldlt().solve(Eigen::MatrixXd::Identity(x.cols(), x.cols()));
    const Eigen::VectorXd b = inverse * (x.transpose() * y);
    EffectFit fit{};
    if (left_out >= 0) fit.left_out = names[static_cast<std::size_t>(left_out)];
    fit.sum_of_squares = (y - x * b).squaredNorm();
    fit.degrees_of_freedom = static_cast<int>(x.rows() - x.cols());
    const int nu = fit.degrees_of_freedom;
    fit.spread = nu > 0 ? std::sqrt(fit.sum_of_squares / nu) : nan;
    for (std::size_t k = 0; k < terms.size(); ++k) {
        const Eigen::Index j = static_cast<Eigen::Index>(k);
        if (terms[k] == 0) {
            fit.constant = b(j);
            continue;
        }
        Effect e{names[static_cast<std::size_t>(terms[k])], 2.0 * b(j), nan, nan, nan, {nan, nan}};
        if (nu > 0) {
            e.standard_error = 2.0 * fit.spread * std::sqrt(inverse(j, j));
            e.t = e.estimate / e.standard_error;
            e.p = 2.0 * gsl_cdf_tdist_Q(std::abs(e.t), nu);
            const double half = statistics::student_quantile(0.975, nu) * e.standard_error;
            e.interval = {e.estimate - half, e.estimate + half};
        }
        fit.effects.push_back(e);
    }
    return fit;
}

AnalysisOfVariance analysis_of_variance(const Trials& trials) {
    check(trials);
    const Eigen::VectorXd y = responses_of(trials);
    const Eigen::MatrixXd full = level_indicators(trials.design, -1);
    const int runs = static_cast<int>(y.size()), full_rank = rank(full), nu = runs - full_rank;
    const double residual = residual_square(full, y);
    AnalysisOfVariance a{};
    a.residual = {"residual", residual, nu, nu > 0 ? residual / nu : nan, nan, nan};
    a.total = {"total", (y.array() - y.mean()).square().sum(), runs - 1, nan, nan, nan};
    a.spread = std::sqrt(a.residual.mean_square);
    for (int k = 0; k < trials.design.cols(); ++k) {
        const Eigen::MatrixXd x = level_indicators(trials.design, k);
        VarianceRow row{std::string(1, factor_letter(k)),
                        residual_square(x, y) - residual,
                        full_rank - rank(x),
                        nan,
                        nan,
                        nan};
        if (row.degrees_of_freedom > 0) {
            row.mean_square = row.sum_of_squares / row.degrees_of_freedom;
            if (nu > 0) {
                row.f = row.mean_square / a.residual.mean_square;
                row.p = gsl_cdf_fdist_Q(row.f, row.degrees_of_freedom, nu);
            }
        }
        a.factors.push_back(row);
    }
    return a;
}

double power_of(double effect, double standard_error, int degrees_of_freedom, double alpha) {
    if (!(standard_error > 0.0) || degrees_of_freedom < 1 || !(alpha > 0.0 && alpha < 1.0))
        throw scaling::InvalidParameter(
            scaling::mistake("power",
                             fmt::format("standard error {}, {} degrees of freedom, alpha {}",
                                         standard_error, degrees_of_freedom, alpha),
                             "must be > 0, >= 1 and between 0 and 1",
                             "a saturated design has no power to speak of: repeat runs"));
    const double limit = statistics::student_quantile(1.0 - 0.5 * alpha, degrees_of_freedom);
    if (effect == 0.0) return alpha;
    const boost::math::non_central_t t(degrees_of_freedom, std::abs(effect) / standard_error);
    return boost::math::cdf(complement(t, limit)) + boost::math::cdf(t, -limit);
}

double detectable_effect(double standard_error, int degrees_of_freedom, double power,
                         double alpha) {
    double low = 0.0, high = standard_error;
    while (power_of(high, standard_error, degrees_of_freedom, alpha) < power) high *= 2.0;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (power_of(middle, standard_error, degrees_of_freedom, alpha) < power ? low : high) = middle;
    }
    return high;
}

}  // namespace calibrate
