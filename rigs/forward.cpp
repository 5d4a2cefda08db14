// SPDX-License-Identifier: MIT
#include "rigs/forward.hpp"

#include "rigs/effects.hpp"
#include "rigs/one_grain.hpp"
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

const cases::Recording* rows_of(const cases::Experiment& e) {
    return e.recording ? &*e.recording : e.simulated ? &*e.simulated : nullptr;
}

Ordinates rows_as_ordinates(const cases::Experiment& e, const cases::Recording& r) {
    Ordinates o{r.values(ordinate_name(e)), {}};
    if (e.rig == "pull_off")
        for (const std::string& branch : r.column("branch").words)
            o.retract.push_back(branch == "retract");
    return o;
}

std::vector<double> even(double first, double last, int count) {
    std::vector<double> at;
    for (int k = 0; k < count; ++k) at.push_back(first + (last - first) * k / (count - 1));
    return at;
}

Ordinates there_and_back(const cases::Experiment& e) {
    const bool grain = e.conditions.at("counterpart").text() == "grain";
    const Stated stated(e);
    const OneGrain g = one_grain(stated, {}, grain ? Counterpart::grain : Counterpart::plate);
    const double d = g.resting_overlap(stated.value({}, "conditions.preload"));
    Ordinates o{even(2.0 * d, -d, 101), {}};
    for (const double s : even(-d, 2.0 * d, 101)) o.at.push_back(s);
    o.retract.assign(101, false), o.retract.resize(202, true);
    return o;
}

double fastest(const cases::Experiment& e, const World& world) {
    const Ordinates o = e.simulated ? rows_as_ordinates(e, *e.simulated) : ordinates_of(e);
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
    return rows_as_ordinates(e, *e.recording);
}

Ordinates simulated_ordinates(const cases::Experiment& e) {
    if (!e.simulated)
        throw InvalidInput(mistake("experiment \"" + e.id + "\"", "no run of your own",
                                   "must have one", "name its CSV file under simulated"));
    return rows_as_ordinates(e, *e.simulated);
}

Ordinates ordinates_of(const cases::Experiment& e) {
    if (const cases::Recording* rows = rows_of(e)) return rows_as_ordinates(e, *rows);
    if (e.rig == "impact") return {even(0.0349, 1.536, 44), {}};
    if (e.rig == "pull_off") return there_and_back(e);
    return {even(0.0, 2.0, 401), {}};
}

std::string ordinate_name(const cases::Experiment& e) {
    if (e.rig == "impact") return "angle";
    if (e.rig != "pull_off") return "t";
    const cases::Recording* rows = rows_of(e);
    return rows != nullptr && rows->has("displacement") ? "displacement" : "separation";
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
