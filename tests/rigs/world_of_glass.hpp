// SPDX-License-Identifier: MIT
// Experiments and worlds for the tests of the forward models: glass on glass, 4 mm, in air.
#pragma once

#include "rigs/forward.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

constexpr double glass_radius = 2e-3, glass_density = 2500.0, normal_gravity = 9.81;
constexpr double glass_mass = glass_density * 4.0 / 3.0 * 3.14159265358979323846 * 8e-9;  // kg

using Written = std::vector<std::pair<std::string, std::string>>;

inline cases::Experiment glass_experiment(const std::string& rig, const Written& conditions) {
    cases::Experiment e;
    e.id = rig, e.rig = rig;
    e.conditions.where = "test";
    for (const auto& [key, text] : conditions) {
        cases::Value v{
            .where = "test." + key, .kind = cases::Value::Kind::text, .written_text = text};
        e.conditions.members.emplace_back(key, v);
    }
    e.grain.diameter.value = scaling::in_si<scaling::Length>(2.0 * glass_radius);
    e.grain.density.value = scaling::in_si<scaling::Density>(glass_density);
    e.grain.youngs_modulus.value = scaling::in_si<scaling::Pressure>(6e10);
    e.grain.poisson_ratio.value = 0.22;
    e.plate = {e.grain.youngs_modulus.value, e.grain.poisson_ratio.value};
    e.surroundings = {scaling::in_si<scaling::Acceleration>(normal_gravity),
                      scaling::in_si<scaling::Density>(1.2),
                      scaling::in_si<scaling::Viscosity>(1.8e-5)};
    return e;
}

inline rigs::World a_world(std::set<std::string> physics,
                           std::map<std::string, double> parameters = {}) {
    rigs::World w;
    w.physics = std::move(physics);
    w.parameters = std::move(parameters);
    return w;
}

inline std::vector<double> evenly(double first, double last, int count) {
    std::vector<double> at;
    for (int k = 0; k < count; ++k) at.push_back(first + (last - first) * k / (count - 1));
    return at;
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
}
