// SPDX-License-Identifier: MIT
#include "calibrate/identify.hpp"

#include <Eigen/QR>
#include <boost/math/distributions/normal.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace calibrate {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const double prior_deviation = 1.0 / std::sqrt(3.0);  // of a coded factor

// Whitened slopes of the measured targets at the answer, [measured][factors].
MatrixXd slopes(const Surrogate& s, const VectorXd& answer) {
    constexpr double reach = 0.1;  // coded, to both sides: a twentieth of the range
    const Index d = answer.size();
    MatrixXd ends = answer.transpose().replicate(2 * d, 1);
    for (Index k = 0; k < d; ++k) {
        ends(2 * k, k) = std::max(answer[k] - reach, -1.0);
        ends(2 * k + 1, k) = std::min(answer[k] + reach, 1.0);
    }
    std::vector<VectorXd> rows;
    for (std::size_t j = 0; j < s.problem().targets.size(); ++j) {
        const Target& t = s.problem().targets[j];
        if (!t.value) continue;
        const double known = std::sqrt(t.standard_deviation * t.standard_deviation +
                                       s.at(j, answer.transpose()).variance[0]);
        const VectorXd mean = s.at(j, ends).mean;
        rows.emplace_back(d);
        for (Index k = 0; k < d; ++k)
            rows.back()[k] = (mean[2 * k + 1] - mean[2 * k]) /
                             (ends(2 * k + 1, k) - ends(2 * k, k)) * prior_deviation / known;
    }
    MatrixXd j(static_cast<Index>(rows.size()), d);
    for (std::size_t k = 0; k < rows.size(); ++k) j.row(static_cast<Index>(k)) = rows[k];
    return j;
}

std::string signed_value(double x, const std::string& unit) {
    return fmt::format("{:+.3g}{}", x, unit == "1" ? "" : " " + unit);
}

// What a small coded step of a factor is in its unit, at the answer.
double unit_step(const Problem& p, const VectorXd& answer, Index k, double step) {
    VectorXd to = answer;
    to[k] += step;
    return point_of(p, to)[k] - point_of(p, answer)[k];
}

Trade trade(const Problem& p, const VectorXd& answer, Index free, const std::vector<Index>& pinned,
            const VectorXd& by) {
    constexpr double tenth = 0.2;  // coded: a tenth of the range, towards its middle
    const double step = answer[free] > 0.0 ? -tenth : tenth;
    const Factor& f = p.factors[static_cast<std::size_t>(free)];
    Trade t{f.name, unit_step(p, answer, free, step), {}, {}, {}};
    t.words = fmt::format("{} {} is made up by ", f.name, signed_value(t.step, f.unit));
    for (std::size_t n = 0; n < pinned.size(); ++n) {
        const Factor& g = p.factors[static_cast<std::size_t>(pinned[n])];
        t.with.push_back(g.name);
        t.by.push_back(unit_step(p, answer, pinned[n], step * by[static_cast<Index>(n)]));
        t.words +=
            fmt::format("{}{} {}", n > 0 ? " and " : "", g.name, signed_value(t.by.back(), g.unit));
    }
    return t;
}

std::vector<Trade> trades(const Surrogate& s, const VectorXd& answer) {
    const MatrixXd j = slopes(s, answer);
    Eigen::ColPivHouseholderQR<MatrixXd> qr(j);
    const auto& order = qr.colsPermutation().indices();
    std::vector<Index> pinned;
    const MatrixXd r = qr.matrixQR();
    for (Index k = 0; k < std::min(j.rows(), j.cols()) && std::abs(r(k, k)) > 1.0; ++k)
        pinned.push_back(order[k]);
    std::vector<Trade> list;
    if (pinned.empty()) return list;
    MatrixXd held(j.rows(), static_cast<Index>(pinned.size()));
    for (std::size_t n = 0; n < pinned.size(); ++n)
        held.col(static_cast<Index>(n)) = j.col(pinned[n]);
    for (Index k = 0; k < j.cols(); ++k) {
        if (std::count(pinned.begin(), pinned.end(), k) > 0 || j.col(k).norm() < 1.0) continue;
        list.push_back(
            trade(s.problem(), answer, k, pinned, -held.colPivHouseholderQr().solve(j.col(k))));
    }
    return list;
}

std::vector<double> shrinkages(const Posterior& p) {
    const VectorXd v = covariance(p).diagonal();
    std::vector<double> list;
    for (const double x : v) list.push_back(std::sqrt(std::max(x, 0.0)) / prior_deviation);
    return list;
}

Offer offered(const Surrogate& s, const Posterior& p, std::size_t target) {
    constexpr int asked = 64;
    const Target& t = s.problem().targets[target];
    const auto at = s.at(target, p.points);
    const ArrayXd v = at.variance.array() + t.standard_deviation * t.standard_deviation;
    const ArrayXd log_norm = -0.5 * (2.0 * std::numbers::pi * v).log();
    const auto truths = resampled(p.weights, asked, 0.5);
    Offer offer{t.name, 0.0, std::vector<double>(s.problem().factors.size(), 0.0), {}};
    for (int n = 0; n < asked; ++n) {
        const Index k = truths[static_cast<std::size_t>(n)];
        // Every 64th part of the normal distribution once, in an order of its own: 37 and 64 are
        // coprime.
        const double rank = (37 * n % asked + 0.5) / asked;
        const double value =
            at.mean[k] + std::sqrt(v[k]) * boost::math::quantile(boost::math::normal(), rank);
        const ArrayXd logs = log_norm - 0.5 * (value - at.mean.array()).square() / v;
        Posterior after = p;
        after.weights = (logs - logs.maxCoeff()).exp() * p.weights.array();
        const double evidence = after.weights.sum();
        after.weights /= evidence;
        offer.bits += (logs[k] - std::log(evidence) - logs.maxCoeff()) / std::numbers::ln2 / asked;
        const VectorXd spread = covariance(after).diagonal();
        for (std::size_t f = 0; f < offer.shrinkage.size(); ++f)
            offer.shrinkage[f] += spread[static_cast<Index>(f)] / asked;
    }
    offer.bits =
        std::max(offer.bits, 0.0);  // sums of 64 parts may come out below the least there is
    for (double& x : offer.shrinkage) x = std::sqrt(std::max(x, 0.0)) / prior_deviation;
    return offer;
}

}  // namespace

Identification identify(const Surrogate& s, const Posterior& p, const VectorXd& answer) {
    const Problem& problem = s.problem();
    const std::vector<double> now = shrinkages(p);
    Identification id{{}, trades(s, answer), {}};
    for (std::size_t k = 0; k < now.size(); ++k)
        id.factors.push_back({problem.factors[k].name, now[k]});
    for (std::size_t j = 0; j < problem.targets.size(); ++j) {
        if (problem.targets[j].value) continue;
        Offer offer = offered(s, p, j);
        std::size_t most = 0;
        for (std::size_t k = 0; k < now.size(); ++k)
            if (offer.shrinkage[k] / now[k] < offer.shrinkage[most] / now[most]) most = k;
        offer.words = fmt::format(
            "measuring {} to {:.3g} {} is expected to give {:.1f} bits; it would narrow {} most, "
            "to {:.0f} % "
            "of its range's deviation from {:.0f} %",
            offer.target, problem.targets[j].standard_deviation, problem.targets[j].unit,
            offer.bits, problem.factors[most].name, 100.0 * offer.shrinkage[most],
            100.0 * now[most]);
        if (offer.bits < 0.05)
            offer.words = fmt::format(
                "measuring {} to {:.3g} {} is expected to say nothing new of the parameters",
                offer.target, problem.targets[j].standard_deviation, problem.targets[j].unit);
        id.offers.push_back(std::move(offer));
    }
    std::stable_sort(id.offers.begin(), id.offers.end(),
                     [](const Offer& a, const Offer& b) { return a.bits > b.bits; });
    return id;
}

}  // namespace calibrate
