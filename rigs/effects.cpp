// SPDX-License-Identifier: MIT
#include "rigs/effects.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigs {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double edge = 1000.0;  // Re
constexpr double newton_coefficient = 0.44;
constexpr double contact_gap = 0.165e-9;  // m, Israelachvili (2011), section 13.1

}  // namespace

double drag_coefficient_at(double reynolds) {
    if (reynolds >= edge) return newton_coefficient;
    return 24.0 / reynolds * (1.0 + 0.15 * std::pow(reynolds, 0.687));
}

double Drag::reynolds(double speed) const {
    if (viscosity > 0.0) return density * speed * diameter / viscosity;
    return std::numeric_limits<double>::infinity();
}

double Drag::resistance(double speed, bool newton) const {
    if (newton)
        return factor * newton_coefficient * 0.125 * pi * density * diameter * diameter * speed;
    const double re = reynolds(speed);
    const double inertial = re > 0.0 ? 0.15 * std::pow(re, 0.687) : 0.0;
    return factor * 3.0 * pi * viscosity * diameter * (1.0 + inertial);
}

double Attraction::across(double gap, bool bridged) const {
    double force = 0.0;
    if (hamaker_r > 0.0) {
        const double h = std::max(gap, contact_gap);
        force += hamaker_r / (6.0 * h * h);
    }
    if (charge_term != 0.0) {
        const double distance = charge_distance + gap;
        force += charge_term / (distance * distance);
    }
    if (bridged && bridge > 0.0 && gap < rupture)
        force += bridge * (1.0 - gap / std::sqrt(gap * gap + bridge_area));
    return force;
}

double Attraction::steepness(double gap, bool bridged) const {
    double slope = 0.0;
    if (hamaker_r > 0.0 && gap >= contact_gap) slope += hamaker_r / (3.0 * gap * gap * gap);
    if (charge_term != 0.0) slope += 2.0 * charge_term / std::pow(charge_distance + gap, 3);
    if (bridged && bridge > 0.0 && gap < rupture)
        slope += bridge * bridge_area / std::pow(gap * gap + bridge_area, 1.5);
    return slope;
}

double Attraction::in_contact() const {
    return bridge + charge_term / (charge_distance * charge_distance);
}

double Friction::at(double slip) const {
    return velocity > 0.0 ? dynamic + (at_rest - dynamic) * std::exp(-slip / velocity) : at_rest;
}

double Restitution::at(double speed) const {
    double e = loss >= 0.0 ? std::max(0.0, 1.0 - loss * std::pow(speed, 0.2)) : slow;
    if (yield_velocity > 0.0 && speed > yield_velocity)
        e *= std::sqrt(std::sqrt(yield_velocity / speed));
    return e;
}

Vibration::Motion Vibration::at(double t) const {
    if (amplitude == 0.0) return {0.0, 0.0};
    const double angle = omega * t + phase;
    return {amplitude * std::sin(angle), amplitude * omega * std::cos(angle)};
}
double Vibration::acceleration(double t) const {
    return -amplitude * omega * omega * std::sin(omega * t + phase);
}

double straight_between(const std::vector<double>& x, const std::vector<double>& f, double at) {
    if (x.empty()) return 0.0;
    if (!(at > x.front())) return f.front();
    if (at >= x.back()) return f.back();
    const std::size_t k =
        static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
    return f[k - 1] + (f[k] - f[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1]);
}

}  // namespace rigs
