// SPDX-License-Identifier: MIT
#include "rigs/forward.hpp"

#include "rigs/effects.hpp"
#include "rigs/single_grain.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>

namespace rigs {
namespace {

using scaling::InvalidInput;
using scaling::mistake;

double reynolds(const cases::Experiment& e, double speed) {
    const Drag law{1.0, e.surroundings.fluid_density.value(),
                   e.surroundings.fluid_viscosity.value(), e.grain.diameter.value.value()};
    return law.reynolds(speed);
}

// Where nothing was recorded: long enough for a few bounces, or a metre of plane.
Ordinates ordinates_of(const cases::Experiment& e) {
    if (e.recording || e.simulated) {
        cases::Experiment known = e;
        if (e.simulated) known.recording = e.simulated;
        return recorded_ordinates(known);
    }
    Ordinates o;
    for (int k = 0; k < 400; ++k) o.at.push_back(5e-3 * k);
    return o;
}

double fastest(const cases::Experiment& e, const World& world) {
    const Ordinates o = ordinates_of(e);
    const Curves v = forward_model(e)->variables(world, o);
    double most = 0.0;
    for (const double speed : v.at("speed"))
        if (std::isfinite(speed)) most = std::max(most, std::abs(speed));
    return most;
}

}  // namespace

std::unique_ptr<ForwardModel> forward_model(const cases::Experiment& e) {
    if (e.rig == "drop") return drop_model(e);
    if (e.rig == "incline") return incline_model(e);
    if (e.rig == "impact") return impact_model(e);
    if (e.rig == "pull_off") return pull_off_model(e);
    throw InvalidInput(mistake("experiment \"" + e.id + "\"", "rig \"" + e.rig + "\"",
                               "must be drop, incline, impact or pull_off",
                               "no other rig has a forward model of a single grain"));
}

Ordinates recorded_ordinates(const cases::Experiment& e) {
    if (!e.recording)
        throw InvalidInput(mistake("experiment \"" + e.id + "\"", "no recording", "must have one",
                                   "name its CSV file"));
    const cases::Recording& r = *e.recording;
    if (e.rig == "impact") return {r.values("angle"), {}};
    if (e.rig != "pull_off") return {r.values("t"), {}};
    Ordinates o{r.values(r.has("displacement") ? "displacement" : "separation"), {}};
    for (const std::string& branch : r.column("branch").words)
        o.retract.push_back(branch == "retract");
    return o;
}

double drag_curve(const cases::Experiment& e, double speed) {
    return drag_coefficient_at(reynolds(e, speed));
}

InOrder::InOrder(const std::vector<double>& given) {
    for (std::size_t k = 0; k < given.size(); ++k)
        if (std::isfinite(given[k])) from.push_back(k);
    const auto earlier = [&](std::size_t a, std::size_t b) { return given[a] < given[b]; };
    if (!std::is_sorted(from.begin(), from.end(), earlier))
        std::stable_sort(from.begin(), from.end(), earlier);
    at.reserve(from.size());
    for (const std::size_t k : from) at.push_back(given[k]);
}

World world_of(const cases::Case& c, const cases::Experiment& e) {
    World world;
    world.physics = {c.model.physics.begin(), c.model.physics.end()};
    for (const auto& [name, p] : c.model.parameters) world.parameters[name] = p.value;
    const cases::Numerics& n = c.model.numerics;
    if (n.time_step || !n.integrator.empty() || n.youngs_modulus_factor != 1.0) world.numerics = n;
    const cases::Parameter* coefficient = c.model.find("drag_coefficient");
    if (coefficient == nullptr || !c.model.includes("air_drag")) return world;
    // The speed depends on the drag: each round takes the curve's value at the last one's speed. Drag bends the speed by less
    // than itself, so that the rounds close in fast; 1e-10 is well below what a fit can see.
    double factor = 1.0;
    for (int round = 0; round < 60; ++round) {
        world.parameters["drag_factor"] = factor;
        double most = 0.0, curve = 0.0;
        const auto consider = [&](const cases::Experiment& other) {
            if (other.rig != "drop" && other.rig != "incline") return;
            const double speed = fastest(other, world);
            if (speed > most) most = speed, curve = drag_curve(other, speed);
        };
        for (const cases::Experiment& other : c.experiments) consider(other);
        if (c.find(e.id) == nullptr) consider(e);
        if (most == 0.0) break;
        const double next = coefficient->value / curve;
        const bool close = std::abs(next - factor) <= 1e-10 * next;
        factor = next;
        if (close) break;
    }
    world.parameters["drag_factor"] = factor;
    return world;
}

}  // namespace rigs
