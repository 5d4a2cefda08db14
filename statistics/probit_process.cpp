// SPDX-License-Identifier: MIT
#include "statistics/probit_process.hpp"

#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace statistics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double bias = 1.5;  // P(yes) anywhere between 0.07 and 0.93 at one sigma

double below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

// phi(z) / Phi(z); for z << 0 by -z - 1/z + ..., where both vanish.
double mills(double z) {
    if (z < -25.0) return -z - 1.0 / z;
    return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi) / below(z);
}

double log_below(double z) {
    if (z < -25.0) return -0.5 * z * z - std::log(-z * std::sqrt(2.0 * std::numbers::pi));
    return std::log(below(z));
}

MatrixXd covariance(const MatrixXd& a, const MatrixXd& b, const ProbitProcess::Scales& s) {
    MatrixXd k = s.slope * s.slope * a * b.transpose();
    for (Index i = 0; i < k.rows(); ++i)
        for (Index j = 0; j < k.cols(); ++j)
            k(i, j) += bias * bias + s.bend * s.bend *
                                         std::exp(-0.5 * (a.row(i) - b.row(j)).squaredNorm() /
                                                  (s.length * s.length));
    return k;
}

// log of likelihood times prior, f = K a.
double objective(const VectorXd& sign, const VectorXd& f, const VectorXd& a) {
    double sum = -0.5 * a.dot(f);
    for (Index i = 0; i < f.size(); ++i) sum += log_below(sign[i] * f[i]);
    return sum;
}

}  // namespace

// Newton's steps on a concave function, shortened where a full one overshoots. Leaves the gradient
// and the curvature at its top; returns log of the evidence.
double ProbitProcess::climb(const MatrixXd& k, const VectorXd& sign, Fitted& fit) {
    const Index n = sign.size();
    VectorXd f = VectorXd::Zero(n), a = VectorXd::Zero(n);
    double value = objective(sign, f, a);
    for (int step = 0; step < 50; ++step) {
        VectorXd w(n);
        fit.gradient.resize(n);
        for (Index i = 0; i < n; ++i) {
            const double m = mills(sign[i] * f[i]);
            fit.gradient[i] = sign[i] * m;
            w[i] = std::max(m * (m + sign[i] * f[i]), 1e-12);
        }
        fit.root_w = w.cwiseSqrt();
        fit.b.compute(MatrixXd::Identity(n, n) +
                      fit.root_w.asDiagonal() * k * fit.root_w.asDiagonal());
        const VectorXd c = w.cwiseProduct(f) + fit.gradient;
        const VectorXd full =
            c - fit.root_w.cwiseProduct(fit.b.solve(fit.root_w.cwiseProduct(k * c)));
        VectorXd to = full;
        double better = objective(sign, k * to, to);
        for (double share = 0.5; better < value && share > 1e-3; share *= 0.5) {
            to = a + share * (full - a);
            better = objective(sign, k * to, to);
        }
        const double gained = better - value;
        if (gained < 1e-9) break;
        a = to, f = k * to, value = better;
    }
    return value - fit.b.matrixLLT().diagonal().array().log().sum();
}

ProbitProcess::ProbitProcess(const MatrixXd& x, const std::vector<bool>& yes) : x_(x) {
    const Index n = x.rows();
    if (n < 1 || yes.size() != static_cast<std::size_t>(n))
        throw scaling::InvalidParameter(
            scaling::mistake("probit_process.yes", std::to_string(yes.size()) + " answers",
                             "must be one for each run, and at least one", "give one a run"));
    VectorXd sign(n), evidence(12);
    for (Index i = 0; i < n; ++i) sign[i] = yes[static_cast<std::size_t>(i)] ? 1.0 : -1.0;
    for (const double slope : {0.5, 1.5, 4.0})
        for (const double bend : {0.5, 2.0})
            for (const double length : {1.0, 2.5}) {
                Fitted fit{{slope, bend, length}, 0.0, {}, {}, {}};
                evidence[static_cast<Index>(fitted_.size())] =
                    climb(covariance(x, x, fit.scales), sign, fit);
                fitted_.push_back(std::move(fit));
            }
    const VectorXd share = (evidence.array() - evidence.maxCoeff()).exp();
    for (std::size_t k = 0; k < fitted_.size(); ++k)
        fitted_[k].weight = share[static_cast<Index>(k)] / share.sum();
}

VectorXd ProbitProcess::probability(const MatrixXd& points) const {
    VectorXd p = VectorXd::Zero(points.rows());
    for (const Fitted& f : fitted_) {
        const MatrixXd cross = covariance(x_, points, f.scales);  // [runs][points]
        const VectorXd mean = cross.transpose() * f.gradient;
        const MatrixXd white = f.b.matrixL().solve(f.root_w.asDiagonal() * cross);
        for (Index i = 0; i < points.rows(); ++i) {
            const double own = bias * bias + f.scales.bend * f.scales.bend +
                               f.scales.slope * f.scales.slope * points.row(i).squaredNorm();
            const double variance = std::max(own - white.col(i).squaredNorm(), 0.0);
            p[i] += f.weight * below(mean[i] / std::sqrt(1.0 + variance));
        }
    }
    return p;
}

}  // namespace statistics
