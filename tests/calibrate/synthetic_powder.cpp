// SPDX-License-Identifier: MIT
#include "synthetic_powder.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

namespace synthetic {
namespace {

using Eigen::VectorXd;

double rises(double x, double half) { return x / (x + half); }

// The coefficients of one trial: each within `share` of what is usual.
struct Varied {
    std::mt19937_64 random;
    double operator()(double usual, double share = 0.3) {
        return usual * std::uniform_real_distribution<double>(1.0 - share, 1.0 + share)(random);
    }
};

Powder three(Varied& vary) {
    Powder p;
    p.problem.factors = {{"sliding_friction", "1", 0.1, 1.0},
                         {"rolling_friction", "1", 0.02, 0.5},
                         {"surface_energy", "J/m^2", 0.005, 0.3}};
    const double base = vary(14.0), friction = vary(34.0), cohesion = vary(22.0), half = vary(0.12),
                 both = vary(10.0), slides = vary(0.07);
    const auto grip = [](const VectorXd& x) { return std::sqrt(x[0] * (0.1 + x[1])); };
    p.angle_deg = [=](const VectorXd& x) {
        const double c = rises(x[2], half);
        return base + friction * std::tanh(1.4 * grip(x)) + cohesion * c + both * c * grip(x);
    };
    p.density = [=](const VectorXd& x) {
        return 3.4 - 0.5 * std::tanh(2.0 * grip(x)) - 1.6 * rises(x[2], 0.6 * half);
    };
    p.margin = [=](const VectorXd& x) { return x[0] * (0.1 + x[1]) - slides + 0.1 * x[2]; };
    return p;
}

Powder five(Varied& vary) {
    Powder p;
    p.problem.factors = {{"restitution", "1", 0.1, 0.8},
                         {"sliding_friction", "1", 0.1, 1.0},
                         {"rolling_friction", "1", 0.02, 0.5},
                         {"wall_friction", "1", 0.1, 0.8},
                         {"surface_energy", "J/m^2", 0.001, 1.0, true}};
    const double base = vary(16.0), friction = vary(26.0), cohesion = vary(26.0), lumps = vary(9.0),
                 centre = vary(0.06), rolling = vary(9.0), wall = vary(4.0), slides = vary(0.25);
    p.angle_deg = [=](const VectorXd& x) {
        const double l = std::log10(x[4] / centre);
        return base +
               friction * rises(x[1], 0.35) / rises(1.0, 0.35) *
                   (0.6 + 0.4 * std::tanh(4.0 * x[2])) +
               rolling * x[2] + cohesion / (1.0 + std::exp(-3.0 * l)) -
               lumps / (1.0 + std::exp(-8.0 * (l - 0.7))) + wall * std::min(x[3], 0.4) - 2.0 * x[0];
    };
    p.density = [=](const VectorXd& x) {
        return 3.4 - 0.6 * rises(x[1], 0.3) -
               1.5 / (1.0 + std::exp(-2.5 * std::log10(x[4] / centre)));
    };
    p.margin = [=](const VectorXd& x) {
        return x[3] + 0.5 * x[1] * (0.3 + x[2]) - slides - 0.1 * x[0];
    };
    return p;
}

Powder seven(Varied& vary) {
    Powder p;
    p.problem.factors = {
        {"restitution", "1", 0.15, 0.6},       {"sliding_friction", "1", 0.2, 1.0},
        {"rolling_friction", "1", 0.15, 0.6},  {"wall_restitution", "1", 0.1, 0.6},
        {"wall_friction", "1", 0.1, 0.6},      {"wall_rolling_friction", "1", 0.05, 0.3},
        {"surface_energy", "J/m^2", 0.01, 0.5}};
    const double base = vary(9.0), friction = vary(30.0), cohesion = vary(30.0), both = vary(16.0),
                 half = vary(0.2), rolling = vary(6.0), small = vary(1.0), slides = vary(0.17),
                 grip = vary(0.15);
    p.angle_deg = [=](const VectorXd& x) {
        const double b = rises(x[1], 0.4), c = rises(x[6], half);
        return base + friction * b + cohesion * c + both * b * c + rolling * x[2] -
               small * (2.0 * x[0] - x[3] + 4.0 * x[4] - 3.0 * x[5]);
    };
    p.density = [=](const VectorXd& x) {
        return 3.3 - 0.5 * rises(x[1], 0.3) - 1.5 * rises(x[6], 0.6 * half) - 0.2 * x[2];
    };
    p.margin = [=](const VectorXd& x) {
        return x[4] + 0.4 * x[5] + 0.2 * x[1] - slides - grip * rises(x[6], half);
    };
    return p;
}

double normal(std::mt19937_64& random) { return std::normal_distribution<double>()(random); }

}  // namespace

Powder powder(const std::string& kind, std::uint64_t trial, bool density_measured) {
    Varied vary{std::mt19937_64(1000 * trial + kind.size())};
    Powder p = kind == "three"  ? three(vary)
               : kind == "five" ? five(vary)
               : kind == "seven"
                   ? seven(vary)
                   : throw std::invalid_argument("powder: three, five or seven, not " + kind);
    p.scatter_deg = 0.8;  // Niu et al. (2026), Table 10: residual of their nine runs, 0.83 deg
    p.scatter_density = 0.015;
    const auto factors = static_cast<Eigen::Index>(p.problem.factors.size());
    do {
        VectorXd c(factors);
        for (double& v : c) v = std::uniform_real_distribution<double>(-1.0, 1.0)(vary.random);
        p.truth = calibrate::point_of(p.problem, c);
    } while (p.margin(p.truth) <= 0.0);
    constexpr double angle_off = 0.5, density_off = 0.02;  // deg, g/cm^3
    const double angle = p.angle_deg(p.truth) + angle_off * normal(vary.random);
    const double density = p.density(p.truth) + density_off * normal(vary.random);
    p.problem.targets = {{"angle_of_repose", "deg", angle, angle_off},
                         {"bulk_density", "g/cm^3", std::nullopt, density_off}};
    if (density_measured) p.problem.targets[1].value = density;
    p.problem.seed = 100000 * (trial + 1);
    return p;
}

calibrate::Run Powder::run(const calibrate::Request& request) const {
    calibrate::Run r{request, std::nullopt};
    if (margin(request.point) <= 0.0) return r;
    std::mt19937_64 random(request.seed);
    const double angle = angle_deg(request.point) + scatter_deg * normal(random);
    r.values = {angle, density(request.point) + scatter_density * normal(random)};
    return r;
}

}  // namespace synthetic
