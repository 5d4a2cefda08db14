// SPDX-License-Identifier: MIT
#include "diagnose/bulk_effects.hpp"

#include "cases/effects.hpp"
#include "rigs/pile.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace diagnose {
namespace {

constexpr double pi = std::numbers::pi;

// What sets the size of things in a heap.
struct Scales {
    double d, weight;  // m, N
    // J/m^2 at which a contact of reduced radius `r` pulls off with so many grain weights: F = 3/2 pi w r.
    double work(double weights, double r) const { return weights * weight / (1.5 * pi * r); }
};

Scales scales_of(const cases::Experiment& e) {
    const double d = e.grain.diameter.value.value();
    return {d,
            e.grain.density.value.value() * pi / 6.0 * d * d * d * e.surroundings.gravity.value()};
}

using Unknowns = std::vector<Unknown>;

// Somebody has looked at the base: level to 3.4 deg, 15 deg at most. Any azimuth.
Unknowns tilt() {
    constexpr double most = 0.26;  // rad
    Unknown angle{.name = "tilt_angle",
                  .unit = "rad",
                  .key = "tilt_angle",
                  .prior = Prior::gaussian,
                  .low = -most,
                  .high = most,
                  .mean = 0.0,
                  .deviation = 0.06};
    Unknown azimuth{.name = "tilt_azimuth",
                    .unit = "rad",
                    .key = "tilt_azimuth",
                    .low = 0.0,
                    .high = 2.0 * pi,
                    .start = 1.0,
                    .turns = true};
    return {angle, azimuth};
}

enum class Needs { nothing, walls, one_size, fluid };

struct Row {
    std::string effect;
    Needs needs;
    std::function<Unknowns(const Scales&)> unknowns;  // the first sets the strength
    std::function<double(const Scales&)> knee;        // of the strength
    std::string beside{};
    bool two_sided = false;
};

// Strengths end where the heap no longer changes, or is none; knees lie where it begins to change.
const std::vector<Row>& rows() {
    using S = const Scales&;
    using U = Unknowns;
    static const std::vector<Row> table{
        {"adhesion", Needs::nothing,
         [](S s) {
             return U{log_range("work_of_adhesion", "J/m^2", s.work(0.03, s.d / 4.0),
                                s.work(50.0, s.d / 4.0))};
         },
         [](S s) { return s.work(1.0, s.d / 4.0); }},
        {"rolling_resistance", Needs::nothing,
         [](S) { return U{log_range("rolling_friction", "1", 1e-3, 0.5)}; },
         [](S) { return 0.03; }},
        {"polydispersity", Needs::one_size,
         [](S) { return U{log_range("size_spread", "1", 0.02, 0.4)}; }, [](S) { return 0.15; }},
        {"wall_friction", Needs::walls,
         [](S) { return U{log_range("wall_sliding_friction", "1", 0.02, 1.5)}; },
         [](S) { return 0.1; }, "sliding_friction"},
        {"wall_adhesion", Needs::walls,
         [](S s) {
             return U{log_range("wall_work_of_adhesion", "J/m^2", s.work(0.03, s.d / 2.0),
                                s.work(50.0, s.d / 2.0))};
         },
         [](S s) { return s.work(1.0, s.d / 2.0); }},
        {"tilt", Needs::nothing, [](S) { return tilt(); }, [](S) { return 0.3; }, "", true},
        {"air_drag", Needs::fluid, [](S) { return U{}; }, [](S) { return 1.0; }},
        {"buoyancy", Needs::fluid, [](S) { return U{}; }, [](S) { return 1.0; }},
    };
    return table;
}

bool has_walls(const cases::Experiment& e) {
    return e.conditions.at("base").text() != "glued_grains" || e.conditions.has("funnel") ||
           e.conditions.has("mesh");
}

bool has(Needs needs, const cases::Experiment& e) {
    if (needs == Needs::walls) return has_walls(e);
    if (needs == Needs::one_size) return e.grain.sizes.empty() && e.grain.size_distribution.empty();
    return needs != Needs::fluid || e.surroundings.fluid_density.value() > 0.0;
}

// Whether the core has the law.
bool runs(const cases::Case& c, const cases::Experiment& e, const std::string& effect,
          const Unknowns& unknowns) {
    rigs::World world = rigs::world_of(c, e);
    world.physics.insert(effect);
    for (const Unknown& u : unknowns) world.parameters[u.key] = u.start;
    cases::Experiment few = e;  // of a base that is filled until it spills, too
    for (auto& [key, value] : few.conditions.members)
        if (key == "grains") value.kind = cases::Value::Kind::number, value.written_number = 1.0;
    try {
        rigs::pile_setup(in_world(c, world), few, 1);
        return true;
    } catch (const scaling::InvalidInput&) {
        return false;
    }
}

double parameter(const rigs::World& w, const std::string& name) {
    const auto found = w.parameters.find(name);
    return found == w.parameters.end() ? 0.0 : found->second;
}

double stretched(const Axis& a, double value) { return std::log1p(std::max(0.0, value) / a.knee); }

}  // namespace

double coordinate(const Axis& a, const rigs::World& w) {
    const bool there = a.effect.empty() || w.physics.contains(a.effect);
    const double value = parameter(w, a.parameter);
    double x = -1.0;
    if (a.parameter.empty())
        x = there ? 1.0 : -1.0;
    else if (!a.beside.empty())
        x = there ? (stretched(a, value) - stretched(a, parameter(w, a.beside))) /
                        stretched(a, a.high)
                  : 0.0;
    else if (a.effect.empty())
        x = 2.0 * (value - a.low) / (a.high - a.low) - 1.0;
    else if (there)
        x = 2.0 * stretched(a, value) / stretched(a, a.high) - 1.0;
    return std::clamp(x, -1.0, 1.0);
}

double value_at(const Axis& a, double x, double other) {
    if (a.effect.empty()) return a.low + 0.5 * (x + 1.0) * (a.high - a.low);
    const double f = a.beside.empty() ? 0.5 * (x + 1.0) * stretched(a, a.high)
                                      : stretched(a, other) + x * stretched(a, a.high);
    return std::clamp(a.knee * std::expm1(f), a.low, a.high);
}

std::vector<BulkEffect> bulk_effects(const cases::Case& c, const cases::Experiment& e) {
    std::vector<BulkEffect> list;
    const Scales s = scales_of(e);
    for (const Row& row : rows()) {
        const Unknowns unknowns = row.unknowns(s);
        const bool stated = std::any_of(unknowns.begin(), unknowns.end(), [&](const Unknown& u) {
            return c.model.find(u.key) != nullptr;
        });
        if (c.model.includes(row.effect) || stated || !has(row.needs, e) ||
            !runs(c, e, row.effect, unknowns))
            continue;
        BulkEffect effect{row.effect, unknowns, row.two_sided, {}};
        if (unknowns.empty())
            effect.axes.push_back({"", row.effect, 0.0, 1.0, row.knee(s)});
        else  // azimuths are turned to, and need no axis
            effect.axes.push_back({unknowns[0].key, row.effect, std::max(0.0, unknowns[0].low),
                                   unknowns[0].high, row.knee(s), row.beside});
        list.push_back(std::move(effect));
    }
    return list;
}

std::vector<Axis> free_axes(const cases::Case& c, const cases::Experiment& e) {
    std::vector<Axis> list;
    for (const auto& [name, p] : c.model.parameters) {
        const bool at_walls = name.starts_with("wall_");
        if (!p.range || (at_walls && !has_walls(e))) continue;
        if (name.ends_with("rolling_friction") && !c.model.includes("rolling_resistance")) continue;
        if (name == "work_of_adhesion" && !c.model.includes("adhesion")) continue;
        if (name == "wall_work_of_adhesion" && !c.model.includes("wall_adhesion")) continue;
        list.push_back({name, "", p.range->first, p.range->second});
    }
    return list;
}

cases::Case in_world(const cases::Case& c, const rigs::World& w) {
    cases::Case there = c;
    there.model.physics.assign(w.physics.begin(), w.physics.end());
    for (const auto& [name, value] : w.parameters) {
        cases::Parameter& p = there.model.parameters[name];
        p.value = value, p.range.reset();
    }
    return there;
}

}  // namespace diagnose
