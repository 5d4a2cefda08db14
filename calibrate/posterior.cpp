// SPDX-License-Identifier: MIT
#include "calibrate/posterior.hpp"

#include "calibrate/designs.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int sample_count = 4096;

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// Box and Muller (1958), the cosine half.
double normal(std::mt19937_64& random) {
    const double r = std::sqrt(-2.0 * std::log(1.0 - uniform(random)));
    return r * std::cos(2.0 * std::numbers::pi * uniform(random));
}

VectorXd normalised(const VectorXd& logs) {
    const VectorXd w = (logs.array() - logs.maxCoeff()).exp();
    return w / w.sum();
}

// Kernels at resampled points, a fifth of the samples anywhere: no place is left out.
Posterior around(const Surrogate& s, const Posterior& first, std::uint64_t seed) {
    constexpr int kernels = 128;
    constexpr double anywhere = 0.2;
    std::mt19937_64 random(seed);
    const Index d = first.points.cols();
    const double volume = std::pow(2.0, static_cast<double>(d));
    // Scott's rule: Scott (1992), Multivariate Density Estimation, section 6.3.
    const double width = std::pow(first.effective(), -1.0 / (static_cast<double>(d) + 4.0));
    MatrixXd c = covariance(first) * width * width;
    c.diagonal().array() += 1e-6;
    const Eigen::LLT<MatrixXd> llt(c);
    const auto centres = resampled(first.weights, kernels, uniform(random));
    Posterior p{MatrixXd(sample_count, d), {}, VectorXd(sample_count)};
    for (Index n = 0; n < sample_count; ++n) {
        VectorXd x(d);
        const bool free = uniform(random) < anywhere;
        const auto centre = centres[static_cast<std::size_t>(uniform(random) * kernels)];
        for (double& v : x) v = free ? 2.0 * uniform(random) - 1.0 : normal(random);
        p.points.row(n) =
            free ? x : VectorXd(first.points.row(centre).transpose() + llt.matrixL() * x);
    }
    const MatrixXd clamped = p.points.cwiseMax(-1.0).cwiseMin(1.0);
    p.log_density = s.log_likelihood(clamped);
    const double norm = std::pow(2.0 * std::numbers::pi, -0.5 * static_cast<double>(d)) /
                        llt.matrixLLT().diagonal().prod();
    VectorXd logs(sample_count);
    for (Index n = 0; n < sample_count; ++n) {
        double density = anywhere / volume;
        for (const Index k : centres) {
            const VectorXd z =
                llt.matrixL().solve((p.points.row(n) - first.points.row(k)).transpose());
            density += (1.0 - anywhere) / kernels * norm * std::exp(-0.5 * z.squaredNorm());
        }
        const bool inside = p.points.row(n).cwiseAbs().maxCoeff() <= 1.0;
        logs[n] = inside ? p.log_density[n] - std::log(density) : -1e300;
    }
    p.points = clamped;
    p.weights = normalised(logs);
    return p;
}

}  // namespace

Posterior posterior(const Surrogate& s, std::uint64_t seed) {
    constexpr double enough = 400.0;  // effective samples: a quantile to about 2 % of its rank
    const auto factors = static_cast<int>(s.problem().factors.size());
    Posterior p{latin_hypercube(sample_count, factors, seed), {}, {}};
    p.log_density = s.log_likelihood(p.points);
    p.weights = normalised(p.log_density);
    for (std::uint64_t round = 1; round <= 3 && p.effective() < enough; ++round) {
        Posterior better = around(s, p, seed + round);
        if (better.effective() < p.effective()) break;
        p = std::move(better);
    }
    return p;
}

VectorXd mean(const Posterior& p) { return p.points.transpose() * p.weights; }

MatrixXd covariance(const Posterior& p) {
    const MatrixXd off = p.points.rowwise() - mean(p).transpose();
    return off.transpose() * p.weights.asDiagonal() * off;
}

statistics::Interval marginal(const Posterior& p, Index factor, double confidence) {
    std::vector<Index> order(static_cast<std::size_t>(p.points.rows()));
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return p.points(a, factor) < p.points(b, factor); });
    statistics::Interval found{-1.0, 1.0};
    double below = 0.0;
    bool begun = false;
    for (const Index k : order) {
        below += p.weights[k];
        if (!begun && below >= 0.5 * (1.0 - confidence))
            found.low = p.points(k, factor), begun = true;
        if (below >= 0.5 * (1.0 + confidence)) {
            found.high = p.points(k, factor);
            break;
        }
    }
    return found;
}

statistics::Interval conditional(const Surrogate& s, const VectorXd& point, Index factor,
                                 double confidence) {
    constexpr Index cells = 400;
    MatrixXd line = point.transpose().replicate(cells, 1);
    for (Index k = 0; k < cells; ++k)
        line(k, factor) = -1.0 + (2.0 * static_cast<double>(k) + 1.0) / cells;
    const VectorXd weights = normalised(s.log_likelihood(line));
    const auto quantile = [&](double q) {
        double below = 0.0;
        for (Index k = 0; k < cells; ++k) {
            if (below + weights[k] >= q)
                return line(k, factor) + ((q - below) / weights[k] - 0.5) * 2.0 / cells;
            below += weights[k];
        }
        return 1.0;
    };
    return {quantile(0.5 * (1.0 - confidence)), quantile(0.5 * (1.0 + confidence))};
}

double mass_above(const Posterior& p, const Surrogate& s, const VectorXd& point) {
    const double here = s.log_likelihood(point.transpose())[0];
    double sum = 0.0;
    for (Index k = 0; k < p.weights.size(); ++k)
        if (p.log_density[k] > here) sum += p.weights[k];
    return sum;
}

std::vector<Index> resampled(const VectorXd& weights, int count, double shift) {
    std::vector<Index> rows;
    const double all = weights.sum();
    double below = 0.0;
    Index k = -1;
    for (int n = 0; n < count; ++n) {
        const double level = all * (n + shift) / count;
        while (k + 1 < weights.size() && (k < 0 || below <= level)) below += weights[++k];
        rows.push_back(std::max<Index>(k, 0));
    }
    return rows;
}

}  // namespace calibrate
