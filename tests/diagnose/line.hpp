// SPDX-License-Identifier: MIT
// A rig that is no rig: z = a + b t + c t^2, so that every answer of a fit can be worked out by hand.
#pragma once

#include "diagnose/problem.hpp"

#include <cmath>
#include <random>

namespace line {

class Model : public rigs::ForwardModel {
  public:
    rigs::Curves predict(const rigs::World& w, const rigs::Ordinates& o) const override {
        const auto value = [&](const char* name) {
            const auto found = w.parameters.find(name);
            return found == w.parameters.end() ? 0.0 : found->second;
        };
        std::vector<double> z;
        for (const double t : o.at)
            z.push_back(value("a") + value("b") * t +
                        (w.physics.contains("bend") ? value("c") * t * t : 0.0));
        return {{"z", z}};
    }
    rigs::Curves variables(const rigs::World&, const rigs::Ordinates& o) const override {
        return {{"t", o.at}};
    }
    std::set<std::string> effects() const override { return {"bend"}; }
};

inline const cases::Experiment& experiment() {
    static const cases::Experiment e = [] {
        cases::Experiment x;
        x.id = "line-1", x.rig = "drop";
        return x;
    }();
    return e;
}

inline diagnose::Unknown unknown(const char* name, double low, double high) {
    return {.name = name,
            .unit = "1",
            .key = name,
            .prior = diagnose::Prior::uniform,
            .low = low,
            .high = high,
            .start = 0.5 * (low + high)};
}

// n rows on [0, 1], z = a + b t + c t^2 + noise; stated deviation `sigma`; AR(1) noise of correlation rho.
inline diagnose::Problem problem(std::size_t n, double a, double b, double c, double sigma,
                                 double rho, unsigned seed) {
    diagnose::Problem p;
    diagnose::Record r{.experiment = &experiment(),
                       .model = std::make_unique<Model>(),
                       .ordinates = {},
                       .ordinate = "t",
                       .channels = {}};
    diagnose::Channel z{.name = "z", .recorded = {}, .stated_noise = sigma};
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    double e = sigma * normal(random);
    for (std::size_t k = 0; k < n; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(n - 1);
        r.ordinates.at.push_back(t);
        z.recorded.push_back(a + b * t + c * t * t + e);
        e = rho * e + sigma * std::sqrt(1.0 - rho * rho) * normal(random);
    }
    r.channels.push_back(z);
    p.records.push_back(std::move(r));
    p.size = n;
    p.base = {unknown("a", -10.0, 10.0), unknown("b", -10.0, 10.0)};
    p.recorded = Eigen::Map<const Eigen::VectorXd>(p.records[0].channels[0].recorded.data(),
                                                   static_cast<Eigen::Index>(n));
    return p;
}

inline diagnose::Term bend() {
    return {.effect = "bend", .unknowns = {unknown("c", -5.0, 5.0)}, .two_sided = true};
}

}  // namespace line
