// SPDX-License-Identifier: MIT
#include "photo/flank.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace photo {
namespace {

constexpr std::size_t fewest_points = 12;

struct Weighted {
    double level, slope, scale;
    std::vector<EdgePoint> points;
    std::vector<double> weights;  // [points]

    double above(double along) const { return level - slope * along; }
    double residual(const EdgePoint& p) const { return p.above - above(p.along); }
};

double robust_scale(std::vector<double> residuals) {
    for (double& e : residuals) e = std::abs(e);
    const auto middle = residuals.begin() + static_cast<long>(residuals.size() / 2);
    std::nth_element(residuals.begin(), middle, residuals.end());
    return 1.4826 * *middle;
}

// Weighted least squares about the weighted mean; false where the points have no extent.
bool solve(Weighted& fit) {
    double w = 0.0, x = 0.0, z = 0.0, xx = 0.0, xz = 0.0;
    for (std::size_t k = 0; k < fit.points.size(); ++k) {
        w += fit.weights[k], x += fit.weights[k] * fit.points[k].along;
        z += fit.weights[k] * fit.points[k].above;
    }
    x /= w, z /= w;
    for (std::size_t k = 0; k < fit.points.size(); ++k) {
        const double u = fit.points[k].along - x;
        xx += fit.weights[k] * u * u, xz += fit.weights[k] * u * (fit.points[k].above - z);
    }
    if (!(w > 0.0) || !(xx > 0.0)) return false;
    fit.slope = -xz / xx;
    fit.level = z + fit.slope * x;
    return true;
}

void weigh(Weighted& fit) {
    std::vector<double> residuals;
    for (const EdgePoint& p : fit.points) residuals.push_back(fit.residual(p));
    // Not below a hundredth of a pixel: on an exact line all weights are then 1.
    fit.scale = std::max(robust_scale(residuals), 0.01);
    for (std::size_t k = 0; k < residuals.size(); ++k) {
        const double u = residuals[k] / (4.685 * fit.scale);
        fit.weights[k] = std::abs(u) < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
    }
}

std::optional<Weighted> line_through(std::span<const EdgePoint> points, double low, double high) {
    Weighted fit{0.0, 0.0, 0.0, {}, {}};
    const auto choose = [&](auto above) {
        fit.points.clear();
        for (const EdgePoint& p : points)
            if (above(p) >= low && above(p) <= high) fit.points.push_back(p);
        fit.weights.assign(fit.points.size(), 1.0);
    };
    choose([](const EdgePoint& p) { return p.above; });
    if (fit.points.size() < fewest_points || !solve(fit)) return std::nullopt;
    for (int round = 0; round < 30; ++round) {
        const Weighted last = fit;
        choose([&](const EdgePoint& p) { return last.above(p.along); });
        if (fit.points.size() < fewest_points) return std::nullopt;
        weigh(fit);
        if (!solve(fit)) return std::nullopt;
        if (fit.slope == last.slope && fit.points.size() == last.points.size()) break;
    }
    if (!(fit.slope > 0.0)) return std::nullopt;
    return fit;
}

// 1 + 2 sum of the autocorrelations up to the first that is not positive, in points; at least 1. A tenth of a pixel of white scatter is taken to be in
// any edge, so that the smooth remainder of an exact line does not look like one long bump.
double correlation_length(const std::vector<double>& e) {
    double variance = 0.01 * static_cast<double>(e.size()), sum = 1.0;
    for (const double x : e) variance += x * x;
    for (std::size_t lag = 1; lag < e.size() / 2; ++lag) {
        double product = 0.0;
        for (std::size_t k = 0; k + lag < e.size(); ++k) product += e[k] * e[k + lag];
        if (product <= 0.0) break;
        sum += 2.0 * product / variance;
    }
    return sum;
}

}  // namespace

std::optional<double> flank_slope(std::span<const EdgePoint> points, double low, double high) {
    const auto fit = line_through(points, low, high);
    return fit ? std::optional(fit->slope) : std::nullopt;
}

std::optional<FlankFit> fit_flank(std::span<const EdgePoint> points, double height,
                                  std::uint64_t seed) {
    const auto fit = line_through(points, 0.2 * height, 0.8 * height);
    if (!fit) return std::nullopt;
    const std::size_t n = fit->points.size();
    // Residuals as the fit sees them, and what each adds to the slope.
    std::vector<double> e(n), lever(n);
    double w = 0.0, x = 0.0, xx = 0.0, answered = 0.0;
    for (std::size_t k = 0; k < n; ++k)
        w += fit->weights[k], x += fit->weights[k] * fit->points[k].along;
    x /= w;
    for (std::size_t k = 0; k < n; ++k) {
        e[k] = std::sqrt(fit->weights[k]) * fit->residual(fit->points[k]);
        lever[k] = std::sqrt(fit->weights[k]) * (fit->points[k].along - x);
        answered += lever[k] * lever[k];
        // The estimate answers to a shift of a point by the derivative of residual times weight, not by the weight.
        const double v2 = std::pow(fit->residual(fit->points[k]) / (4.685 * fit->scale), 2);
        if (v2 < 1.0) xx += (1.0 - v2) * (1.0 - 5.0 * v2) * std::pow(fit->points[k].along - x, 2);
    }
    // Many wild points would make that sum small or negative.
    xx = std::max(xx, 0.5 * answered);
    const double correlated = correlation_length(e), size = static_cast<double>(n);
    const std::size_t block =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(3.0 * correlated)), 1, n / 5);

    constexpr int repeats = 1000;
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<std::size_t> anywhere(0, n - 1);
    double squares = 0.0;
    for (int r = 0; r < repeats; ++r) {
        double change = 0.0;
        for (std::size_t k = 0; k < n;) {
            const std::size_t from = anywhere(random);
            for (std::size_t j = 0; j < block && k < n; ++j, ++k)
                change += lever[k] * e[(from + j) % n];
        }
        squares += change * change / (xx * xx);
    }
    const double pieces = size / correlated;
    // A line has taken two of the pieces' freedoms out of the residuals, and as large a share out of their correlation.
    const double freedom = std::max(1.0, pieces - 2.0);
    return FlankFit{fit->level,
                    fit->slope,
                    fit->scale,
                    pieces,
                    std::sqrt(squares / repeats) * std::max(1.0, pieces / freedom),
                    freedom,
                    fit->points};
}

}  // namespace photo
