// SPDX-License-Identifier: MIT
// A case of heaps on glued grains, without recordings yet; and a scan of a heap, noise added.
#pragma once

#include "cases/case.hpp"
#include "rigs/scanner.hpp"

#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace pile_case {

struct Heaps {
    std::string name;
    double d;                   // m
    double youngs_modulus;      // Pa
    std::string base_diameter;  // "14 mm"
    double grains;
    double noise;                           // m
    double restitution;                     // 1
    std::pair<double, double> friction_in;  // the free sliding friction starts at 0.4
};

inline cases::Value text(const std::string& key, const std::string& value) {
    return {.where = key, .kind = cases::Value::Kind::text, .written_text = value};
}

inline cases::Experiment experiment(const Heaps& h) {
    cases::Experiment e;
    e.rig = "pile";
    e.grain.diameter.value = scaling::Length::from_value(h.d);
    e.grain.density.value = scaling::Density::from_value(2500.0);
    e.grain.youngs_modulus.value = scaling::Pressure::from_value(h.youngs_modulus);
    e.grain.poisson_ratio.value = scaling::Dimensionless(0.25);
    e.plate = {scaling::Pressure::from_value(h.youngs_modulus), scaling::Dimensionless(0.25)};
    e.surroundings.gravity = scaling::Acceleration::from_value(9.81);
    e.conditions.members = {{"base", text("base", "glued_grains")},
                            {"base_diameter", text("base_diameter", h.base_diameter)},
                            {"grains", {.where = "grains", .kind = cases::Value::Kind::number}}};
    e.conditions.members.back().second.written_number = h.grains;
    e.noise = {{"z", h.noise}};
    return e;
}

inline cases::Case without_recordings(const Heaps& h) {
    cases::Case c;
    c.title = c.path = h.name;
    c.grain = experiment(h).grain;
    c.model.physics = {"gravity", "hertz_mindlin"};
    c.model.parameters = {{"restitution", {h.restitution, "1", {}}},
                          {"sliding_friction", {0.4, "1", h.friction_in}}};
    return c;
}

// At so many azimuths, r at (n + 1/2) step.
template <class Random>
cases::Recording scan(const rigs::Heap& heap, int azimuths, int radii, double step, double noise,
                      Random& random) {
    std::normal_distribution<double> normal;
    std::vector<double> azimuth, r;
    for (int a = 0; a < azimuths; ++a)
        for (int n = 0; n < radii; ++n) {
            azimuth.push_back(2.0 * std::numbers::pi * a / azimuths);
            r.push_back((n + 0.5) * step);
        }
    std::vector<double> z = rigs::heights_at(heap, azimuth, r);
    for (double& v : z) v += noise * normal(random);
    return {{{"azimuth", "rad", azimuth, {}}, {"r", "m", r, {}}, {"z", "m", z, {}}}};
}

}  // namespace pile_case
