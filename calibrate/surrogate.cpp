// SPDX-License-Identifier: MIT
#include "calibrate/surrogate.hpp"

#include "scaling/errors.hpp"
#include "statistics/hyperparameters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int draw_count = 12;
constexpr auto kernel = statistics::Kernel::matern52;

MatrixXd places(const Problem& p, const std::vector<Run>& history, bool formed_only) {
    MatrixXd x(static_cast<Index>(history.size()), static_cast<Index>(p.factors.size()));
    Index rows = 0;
    for (const Run& run : history)
        if (run.values || !formed_only) x.row(rows++) = coded(p, run.request.point);
    return x.topRows(rows);
}

std::vector<bool> formed(const std::vector<Run>& history) {
    std::vector<bool> yes;
    for (const Run& run : history) yes.push_back(run.values.has_value());
    return yes;
}

}  // namespace

Surrogate::Surrogate(const Problem& p, const std::vector<Run>& history, std::uint64_t seed)
    : problem_(p), forms_(places(p, history, false), formed(history)) {
    const MatrixXd x = places(p, history, true);
    for (std::size_t j = 0; j < p.targets.size(); ++j) {
        VectorXd y(x.rows());
        Index rows = 0;
        for (const Run& run : history)
            if (run.values) y[rows++] = (*run.values)[j];
        data_.push_back({x, y});
        draws_.emplace_back();
        for (const auto& t :
             statistics::drawn(data_[j], kernel, {}, draw_count, seed + 1000003 * j))
            draws_[j].emplace_back(data_[j], kernel, t);
    }
}

VectorXd Surrogate::forms(const MatrixXd& points) const { return forms_.probability(points); }

statistics::Prediction Surrogate::at(std::size_t target, const MatrixXd& points) const {
    VectorXd mean = VectorXd::Zero(points.rows()), square = mean;
    for (const auto& process : draws_[target]) {
        const auto p = process.at(points);
        mean += p.mean / draw_count;
        square += (p.variance + p.mean.cwiseAbs2()) / draw_count;
    }
    return {mean, (square - mean.cwiseAbs2()).cwiseMax(0.0)};
}

VectorXd Surrogate::log_likelihood(const MatrixXd& points) const {
    // A heap is never impossible: P(forms) has an error of its own.
    VectorXd sum = forms(points).cwiseMax(1e-6).array().log();
    for (std::size_t j = 0; j < draws_.size(); ++j) {
        const Target& target = problem_.targets[j];
        if (!target.value) continue;
        MatrixXd logs(points.rows(), draw_count);
        for (std::size_t k = 0; k < draws_[j].size(); ++k) {
            const auto p = draws_[j][k].at(points);
            const auto v =
                p.variance.array() + target.standard_deviation * target.standard_deviation;
            logs.col(static_cast<Index>(k)) = -0.5 * (*target.value - p.mean.array()).square() / v -
                                              0.5 * (2.0 * std::numbers::pi * v).log();
        }
        const VectorXd most = logs.rowwise().maxCoeff();
        sum.array() += most.array() + (logs.colwise() - most).array().exp().rowwise().mean().log();
    }
    return sum;
}

Surrogate Surrogate::believing(const VectorXd& point) const {
    Surrogate after = *this;
    for (std::size_t j = 0; j < draws_.size(); ++j) {
        statistics::Data& d = after.data_[j];
        const Index n = d.y.size();
        d.x.conservativeResize(n + 1, Eigen::NoChange);
        d.x.row(n) = point;
        d.y.conservativeResize(n + 1);
        after.draws_[j].clear();
        for (const auto& process : draws_[j]) {
            d.y[n] = process.at(point.transpose()).mean[0];
            after.draws_[j].emplace_back(d, kernel, process.hyperparameters());
        }
    }
    return after;
}

}  // namespace calibrate
