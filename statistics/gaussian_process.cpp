// SPDX-License-Identifier: MIT
#include "statistics/gaussian_process.hpp"

#include "scaling/errors.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace statistics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using scaling::InvalidParameter;
using scaling::mistake;

double correlation(Kernel kernel, double r2) {
    if (kernel == Kernel::squared_exponential) return std::exp(-0.5 * r2);
    const double s = std::sqrt(5.0 * r2);
    return (1.0 + s + s * s / 3.0) * std::exp(-s);
}

// c'(r) / r, finite at r = 0.
double slope_over_r(Kernel kernel, double r2) {
    if (kernel == Kernel::squared_exponential) return -std::exp(-0.5 * r2);
    const double s = std::sqrt(5.0 * r2);
    return -5.0 / 3.0 * (1.0 + s) * std::exp(-s);
}

void check(const Data& d, const Hyperparameters& t) {
    const auto refuse = [](const std::string& where, double value, const std::string& rule) {
        throw InvalidParameter(
            mistake("gaussian_process." + where, std::to_string(value), rule, "see its header"));
    };
    if (d.y.size() < 1) refuse("data.y", 0.0, "must hold at least one run");
    if (d.x.rows() != d.y.size())
        refuse("data.x", static_cast<double>(d.x.rows()), "must have one row for each run");
    if (!d.x.allFinite() || !d.y.allFinite()) refuse("data", NAN, "must be finite");
    if (d.noise_factor.size() != 0 && d.noise_factor.size() != d.y.size())
        refuse("data.noise_factor", static_cast<double>(d.noise_factor.size()),
               "must have one entry for each run, or none");
    if (d.noise_factor.size() != 0 &&
        !(d.noise_factor.minCoeff() > 0.0 && d.noise_factor.allFinite()))
        refuse("data.noise_factor", d.noise_factor.minCoeff(), "must be > 0");
    if (t.inverse_length.size() != d.x.cols())
        refuse("inverse_length", static_cast<double>(t.inverse_length.size()),
               "must have one entry for each factor");
    if (!(t.inverse_length.minCoeff() > 0.0) || !t.inverse_length.allFinite())
        refuse("inverse_length", t.inverse_length.minCoeff(), "must be > 0");
    if (!(t.amplitude > 0.0)) refuse("amplitude", t.amplitude, "must be > 0");
    if (!(t.slope >= 0.0)) refuse("slope", t.slope, "must be >= 0");
    if (!(t.noise > 0.0)) refuse("noise", t.noise, "must be > 0");
}

}  // namespace

MatrixXd GaussianProcess::prior(const MatrixXd& a, const MatrixXd& b) const {
    // One column a point: distances read memory in order.
    const MatrixXd za = (a * theta_.inverse_length.asDiagonal()).transpose();
    const MatrixXd zb = (b * theta_.inverse_length.asDiagonal()).transpose();
    MatrixXd k = theta_.slope * theta_.slope * za.transpose() * zb;
    const double v = theta_.amplitude * theta_.amplitude;
    for (Index j = 0; j < k.cols(); ++j)
        for (Index i = 0; i < k.rows(); ++i)
            k(i, j) += v * correlation(kernel_, (za.col(i) - zb.col(j)).squaredNorm());
    return k;
}

GaussianProcess::GaussianProcess(Data data, Kernel kernel, Hyperparameters theta)
    : data_(std::move(data)), kernel_(kernel), theta_(std::move(theta)) {
    check(data_, theta_);
    const Index n = data_.y.size();
    MatrixXd k = prior(data_.x, data_.x);
    // Rounding of a nearly singular K is kept below one part in 1e10 of its largest entry.
    k.diagonal().array() += 1e-12 * k.diagonal().maxCoeff();
    k.diagonal() += noises();
    k_.compute(k);
    if (k_.info() != Eigen::Success)
        throw InvalidParameter(mistake("gaussian_process.noise", std::to_string(theta_.noise),
                                       "leaves the covariance singular", "raise it"));
    k_one_ = k_.solve(VectorXd::Ones(n));
    one_k_one_ = k_one_.sum();
    mean_ = k_one_.dot(data_.y) / one_k_one_;
    p_y_ = k_.solve((data_.y.array() - mean_).matrix());
    const double log_k = 2.0 * k_.matrixLLT().diagonal().array().log().sum();
    log_likelihood_ = -0.5 * data_.y.dot(p_y_) - 0.5 * log_k - 0.5 * std::log(one_k_one_) -
                      0.5 * static_cast<double>(n - 1) * std::log(2.0 * std::numbers::pi);
}

VectorXd GaussianProcess::noises() const {
    const double one = theta_.noise * theta_.noise;
    if (data_.noise_factor.size() == 0) return VectorXd::Constant(data_.y.size(), one);
    return one * data_.noise_factor.cwiseAbs2();
}

Prediction GaussianProcess::at(const MatrixXd& points) const {
    const MatrixXd cross = prior(data_.x, points);  // [runs][points]
    const MatrixXd white = k_.matrixL().solve(cross);
    const VectorXd z2 = (points * theta_.inverse_length.asDiagonal()).rowwise().squaredNorm();
    const VectorXd lack = (1.0 - (cross.transpose() * k_one_).array()).matrix();
    Prediction p;
    p.mean = (cross.transpose() * p_y_).array() + mean_;
    p.variance =
        (theta_.amplitude * theta_.amplitude + theta_.slope * theta_.slope * z2.array() -
         white.colwise().squaredNorm().transpose().array() + lack.array().square() / one_k_one_)
            .max(0.0);
    return p;
}

MatrixXd GaussianProcess::covariance(const MatrixXd& a, const MatrixXd& b) const {
    const MatrixXd ka = prior(data_.x, a), kb = prior(data_.x, b);
    const MatrixXd wa = k_.matrixL().solve(ka), wb = k_.matrixL().solve(kb);
    const VectorXd la = (1.0 - (ka.transpose() * k_one_).array()).matrix();
    const VectorXd lb = (1.0 - (kb.transpose() * k_one_).array()).matrix();
    return prior(a, b) - wa.transpose() * wb + la * lb.transpose() / one_k_one_;
}

Prediction GaussianProcess::left_one_out() const {
    const Index n = data_.y.size();
    if (n < 2)
        throw InvalidParameter(mistake("gaussian_process.left_one_out", std::to_string(n) + " run",
                                       "must be at least 2 runs", "add a run"));
    MatrixXd p = k_.solve(MatrixXd::Identity(n, n));
    p -= k_one_ * k_one_.transpose() / one_k_one_;
    const VectorXd d = p.diagonal();
    return {data_.y - p_y_.cwiseQuotient(d), d.cwiseInverse()};
}

// d log p / d t = [ (P y)' dK (P y) - tr(P dK) ] / 2: P takes the place that K^-1 has without a
// mean (Rasmussen & Williams equation 5.9).
VectorXd GaussianProcess::gradient() const {
    const Index n = data_.y.size(), d = data_.x.cols();
    MatrixXd w = k_.solve(MatrixXd::Identity(n, n));
    w -= k_one_ * k_one_.transpose() / one_k_one_;
    w = p_y_ * p_y_.transpose() - w;
    const MatrixXd z = data_.x * theta_.inverse_length.asDiagonal();
    const double v = theta_.amplitude * theta_.amplitude, s = theta_.slope * theta_.slope;
    VectorXd g = VectorXd::Zero(d + 3);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            const double r2 = (z.row(i) - z.row(j)).squaredNorm(), wij = 0.5 * w(i, j);
            const double by_r = v * slope_over_r(kernel_, r2);
            for (Index k = 0; k < d; ++k) {
                const double dz = z(i, k) - z(j, k);
                g[k] += wij * (by_r * dz * dz + 2.0 * s * z(i, k) * z(j, k));
            }
            g[d] += wij * 2.0 * v * correlation(kernel_, r2);
            g[d + 1] += wij * 2.0 * s * z.row(i).dot(z.row(j));
        }
    g[d + 2] = w.diagonal().dot(noises());
    return g;
}

}  // namespace statistics
