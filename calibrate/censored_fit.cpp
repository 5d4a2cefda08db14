// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "calibrate/failed_runs.hpp"
#include "calibrate/identifiability.hpp"
#include "scaling/errors.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <fmt/format.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_sf_erf.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace calibrate {

namespace {

// log Phi(z), where Phi(z) itself would be 0 or 1 in doubles.
double log_normal_below(double z) {
    if (z > 0.0) return std::log1p(-0.5 * std::erfc(z / std::numbers::sqrt2));
    return gsl_sf_log_erfc(-z / std::numbers::sqrt2) - std::numbers::ln2;
}

// Unknowns: b of the columns of X, then log s.
struct Likelihood {
    Eigen::MatrixXd formed, failed;  // model matrices
    Eigen::VectorXd y;
    double bound, count;
    double slope_precision;  // 1 / prior^2

    double minus_log(const Eigen::VectorXd& u, Eigen::VectorXd* gradient) const {
        const Eigen::Index p = formed.cols();
        const Eigen::VectorXd b = u.head(p);
        const double s = std::exp(u(p));
        const Eigen::VectorXd r = (y - formed * b) / s;
        const Eigen::ArrayXd z = (bound - (failed * b).array()) / s;
        Eigen::VectorXd slopes = b;
        slopes(0) = 0.0;
        double value =
            count * u(p) + 0.5 * r.squaredNorm() + 0.5 * slope_precision * slopes.squaredNorm();
        Eigen::VectorXd mills(z.size());  // phi(z) / Phi(z)
        for (Eigen::Index k = 0; k < z.size(); ++k) {
            const double log_phi = log_normal_below(z(k));
            value -= log_phi;
            mills(k) =
                std::exp(-0.5 * z(k) * z(k) - 0.5 * std::log(2.0 * std::numbers::pi) - log_phi);
        }
        if (gradient != nullptr) {
            gradient->resize(p + 1);
            gradient->head(p) = (-formed.transpose() * r + failed.transpose() * mills) / s +
                                slope_precision * slopes;
            (*gradient)(p) = count - r.squaredNorm() + (mills.array() * z).sum();
        }
        return value;
    }
};

Eigen::Map<const Eigen::VectorXd> view(const gsl_vector* v) {
    return {v->data, static_cast<Eigen::Index>(v->size)};
}

double value_at(const gsl_vector* u, void* l) {
    return static_cast<const Likelihood*>(l)->minus_log(view(u), nullptr);
}

void both_at(const gsl_vector* u, void* l, double* value, gsl_vector* gradient) {
    Eigen::VectorXd g;
    *value = static_cast<const Likelihood*>(l)->minus_log(view(u), &g);
    Eigen::Map<Eigen::VectorXd>(gradient->data, g.size()) = g;
}

void gradient_at(const gsl_vector* u, void* l, gsl_vector* gradient) {
    double unused = 0.0;
    both_at(u, l, &unused, gradient);
}

Eigen::VectorXd minimised(Likelihood& l, Eigen::VectorXd start) {
    const std::size_t n = static_cast<std::size_t>(start.size());
    gsl_multimin_function_fdf function{&value_at, &gradient_at, &both_at, n, &l};
    const std::unique_ptr<gsl_multimin_fdfminimizer, decltype(&gsl_multimin_fdfminimizer_free)>
        search(gsl_multimin_fdfminimizer_alloc(gsl_multimin_fdfminimizer_vector_bfgs2, n),
               &gsl_multimin_fdfminimizer_free);
    // BFGS stops where it cannot go lower; a new start from there forgets its curvature.
    for (int restart = 0; restart < 5; ++restart) {
        const gsl_vector_view from = gsl_vector_view_array(start.data(), n);
        gsl_multimin_fdfminimizer_set(search.get(), &function, &from.vector, 0.1, 0.1);
        for (int step = 0; step < 500; ++step) {
            if (gsl_multimin_fdfminimizer_iterate(search.get()) != 0) break;
            if (gsl_multimin_test_gradient(search->gradient, 1e-9) == 0) break;
        }
        start = Eigen::VectorXd(view(search->x));
    }
    return start;
}

// Curvature by central differences of the gradient.
Eigen::MatrixXd covariance_at(const Likelihood& l, const Eigen::VectorXd& u) {
    constexpr double step = 1e-5;
    Eigen::MatrixXd curvature(u.size(), u.size());
    for (Eigen::Index k = 0; k < u.size(); ++k) {
        Eigen::VectorXd up = u, down = u, above, below;
        up(k) += step;
        down(k) -= step;
        l.minus_log(up, &above);
        l.minus_log(down, &below);
        curvature.col(k) = (above - below) / (2.0 * step);
    }
    return (0.5 * (curvature + curvature.transpose())).inverse();
}

}  // namespace

CensoredFit censored_fit(const Trials& trials, double bound, std::optional<double> prior,
                         Spread spread) {
    check(trials);
    const Trials kept = usable(trials);
    Likelihood l{model_matrix(kept.design, Terms::linear),
                 model_matrix(failed_design(trials), Terms::linear),
                 responses_of(kept),
                 bound,
                 0.0,
                 prior ? 1.0 / (*prior * *prior) : 0.0};
    const int known = rank(l.formed), terms = static_cast<int>(l.formed.cols());
    l.count = static_cast<double>(l.formed.rows() - (spread == Spread::least_squares ? known : 0));
    const std::string have = fmt::format("{} formed runs of rank {}", l.formed.rows(), known);
    if (l.count < 1.0)
        throw scaling::InvalidParameter(
            scaling::mistake("trials", have, "must leave a degree of freedom for the spread",
                             "repeat runs, or fit fewer factors"));
    if (!prior && known < terms)
        throw scaling::InvalidParameter(
            scaling::mistake("trials", have, fmt::format("must have rank {}", terms),
                             "the censored likelihood has no maximum then: give a prior"));
    Eigen::MatrixXd ridge = l.formed.transpose() * l.formed;
    ridge.diagonal().array() += 1e-3;
    Eigen::VectorXd start(terms + 1);
    start.head(terms) = ridge.ldlt().solve(l.formed.transpose() * l.y);
    const double square = (l.y - l.formed * start.head(terms)).squaredNorm();
    start(terms) = 0.5 * std::log(std::max(square / l.count, 1e-12));
    const Eigen::VectorXd u = minimised(l, start);
    const Eigen::MatrixXd covariance = covariance_at(l, u);
    CensoredFit fit{bound, prior, {}, u(0), std::exp(u(terms)), {}};
    for (int k = 1; k < terms; ++k)
        fit.effects.push_back(
            {std::string(1, factor_letter(k - 1)), 2.0 * u(k), 2.0 * std::sqrt(covariance(k, k))});
    for (Eigen::Index run = 0; run < l.failed.rows(); ++run)
        fit.failed_predictions.push_back(l.failed.row(run).dot(u.head(terms)));
    return fit;
}

}  // namespace calibrate
