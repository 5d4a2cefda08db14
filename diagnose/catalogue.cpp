// SPDX-License-Identifier: MIT
#include "diagnose/catalogue.hpp"

#include "diagnose/piles.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

namespace diagnose {
namespace {

constexpr double pi = std::numbers::pi;

Unknown range(const std::string& name, const std::string& unit, double low, double high,
              double start) {
    return {.name = name,
            .unit = unit,
            .key = name,
            .prior = Prior::uniform,
            .low = low,
            .high = high,
            .start = start};
}
// Gaussian about a mean, `most` from it at most.
Unknown about(const std::string& name, const std::string& unit, double mean, double deviation,
              double most) {
    Unknown x = range(name, unit, mean - most, mean + most, mean);
    x.prior = Prior::gaussian, x.mean = mean, x.deviation = deviation;
    return x;
}
// An angle of which nothing is known.
Unknown turn(const std::string& name) {
    Unknown x = range(name, "rad", 0.0, 2.0 * pi, 1.0);
    x.turns = true;
    return x;
}

// What sets the size of things in a case: its first experiment.
struct Sizes {
    double radius, speed;  // m, m/s: the fastest that any experiment states or falls to
    std::set<std::string> rigs, channels, physics;
};

double stated(const cases::Experiment& e, const std::string& key, const std::string& unit) {
    return e.conditions.has(key) ? e.conditions.at(key).si(cases::parse_unit(unit, key)) : 0.0;
}

Sizes sizes_of(const Problem& p) {
    Sizes s{.radius = 0.0, .speed = 0.0, .rigs = {}, .channels = {}, .physics = p.world.physics};
    for (const Record& r : p.records) {
        const cases::Experiment& e = *r.experiment;
        s.radius = std::max(s.radius, 0.5 * e.grain.diameter.value.value());
        s.rigs.insert(e.rig);
        for (const Channel& c : r.channels)
            if (!c.name.starts_with("z_")) s.channels.insert(c.name);
        const double speed = e.rig == "pull_off" ? 0.0 : std::abs(stated(e, "speed", "m/s"));
        const double height = e.rig == "drop" ? stated(e, "height", "m") : 0.0;
        s.speed = std::max(
            s.speed, std::hypot(speed, std::sqrt(2.0 * e.surroundings.gravity.value() * height)));
    }
    if (s.speed == 0.0) s.speed = 1.0;
    return s;
}

using Recipe = std::function<std::vector<Unknown>(const Sizes&)>;

struct Entry {
    std::string effect;
    std::vector<std::string> idle;
    bool two_sided;
    Recipe unknowns;
};

// The ranges: docs/diagnose.md.
const std::vector<Entry>& entries() {
    using U = std::vector<Unknown>;
    static const std::vector<Entry> table{
        {"air_drag",
         {},
         false,
         [](const Sizes&) { return U{log_range("drag_factor", "1", 0.1, 10.0)}; }},
        {"buoyancy", {}, false, [](const Sizes&) { return U{}; }},
        {"adhesion",
         {},
         false,
         [](const Sizes&) { return U{log_range("work_of_adhesion", "J/m^2", 1e-4, 10.0)}; }},
        {"van_der_waals",
         {},
         false,
         [](const Sizes&) { return U{log_range("hamaker_constant", "J", 1e-21, 2e-18)}; }},
        {"capillary_bridge",
         {},
         false,
         [](const Sizes& s) {
             const double r3 = s.radius * s.radius * s.radius;
             return U{log_range("surface_tension", "N/m", 0.005, 0.6),
                      log_range("liquid_volume", "m^3", 1e-7 * r3, 0.5 * r3)};
         }},
        {"electrostatic",
         {},
         false,
         [](const Sizes& s) {
             const double most =
                 26.6e-6 * 4.0 * pi * s.radius * s.radius;  // C: breakdown of air at a flat surface
             return U{log_range("charge", "C", 1e-4 * most, 100.0 * most)};
         }},
        {"rolling_resistance",
         {},
         false,
         [](const Sizes&) { return U{log_range("rolling_friction", "1", 1e-4, 0.5)}; }},
        {"viscoelastic_restitution",
         {"restitution"},
         false,
         [](const Sizes&) { return U{log_range("loss_coefficient", "(s/m)^(1/5)", 0.01, 0.9)}; }},
        {"plastic_restitution",
         {},
         false,
         [](const Sizes& s) {
             return U{log_range("yield_velocity", "m/s", 1e-3 * s.speed, s.speed)};
         }},
        {"velocity_dependent_friction",
         {},
         true,
         [](const Sizes& s) {
             return U{log_range("dynamic_friction", "1", 3e-3, 1.2),
                      log_range("friction_velocity", "m/s", 3e-3 * s.speed, 3.0 * s.speed)};
         }},
        {"tangential_compliance",
         {},
         false,
         [](const Sizes&) { return U{log_range("stiffness_ratio", "1", 0.1, 10.0)}; }},
        {"tilt",
         {},
         true,
         [](const Sizes& s) {
             // A fall shows the part along x alone, a plane leans one way or the other; both together show the azimuth.
             U list{about("tilt_angle", "rad", 0.0, 0.06, 0.26)};
             if (s.rigs.contains("drop") && s.rigs.contains("incline"))
                 list.push_back(turn("tilt_azimuth"));
             return list;
         }},
        {"vibration",
         {},
         false,
         [](const Sizes&) {
             return U{log_range("amplitude", "m", 1e-7, 0.1),
                      log_range("frequency", "Hz", 2.0, 500.0), turn("phase")};
         }},
    };
    return table;
}

bool can_act(const Problem& p, const std::string& effect) {
    return std::any_of(p.records.begin(), p.records.end(), [&](const Record& r) {
        if (r.covariance.size() > 0) return false;  // of many grains: bulk_effects.hpp
        if (effect == "buoyancy" || effect == "air_drag")
            if (r.experiment->surroundings.fluid_density.value() <= 0.0) return false;
        if (effect == "air_drag" && r.experiment->surroundings.fluid_viscosity.value() <= 0.0)
            return false;
        return r.model->effects().contains(effect);
    });
}

// Sliding friction does nothing in a drop without sideways motion, nor does what only acts through it.
bool moves_sideways(const Problem& p) {
    return std::any_of(p.records.begin(), p.records.end(), [](const Record& r) {
        const cases::Experiment& e = *r.experiment;
        return e.rig != "drop" || stated(e, "horizontal_speed", "m/s") != 0.0 ||
               stated(e, "spin", "rad/s") != 0.0;
    });
}

// Of an instrument that somebody has calibrated. Rulers in a picture and clocks are good to some per cent; the stiffness of a
// cantilever is often not known to 20 %.
Unknown instrument_factor(const std::string& name, double deviation) {
    return {.name = name,
            .unit = "1",
            .key = name,
            .prior = Prior::gaussian,
            .low = 0.5,
            .high = 2.0,
            .mean = 1.0,
            .deviation = deviation,
            .start = 1.0};
}

// `channels`: those of one instrument, commas between.
Term scale_of(const std::string& channels) {
    Unknown u = instrument_factor("scale", channels == "force" ? 0.2 : 0.08);
    u.target = Target::scale, u.key = channels;
    return {.effect = "measurement_scale", .channel = channels, .unknowns = {u}, .two_sided = true};
}

void add_measurement(std::vector<Term>& list, const Problem& p, const Sizes& s) {
    const bool over_drive = std::any_of(p.records.begin(), p.records.end(), [](const Record& r) {
        return r.ordinate == "displacement";
    });
    const bool camera = s.channels.contains("z");
    const char* heights = s.rigs.contains("pile")    ? "z,z_cos,z_sin,z_roughness"
                          : s.channels.contains("x") ? "z,x"
                                                     : "z";
    if (camera) list.push_back(scale_of(heights));
    for (const std::string& c : s.channels) {
        if (!camera || (c != "z" && c != "x")) list.push_back(scale_of(c));
        if (over_drive) continue;  // the base line is refitted
        // Where a heap's heights begin is seen to a grain or two; low heaps are no higher than that.
        const double widest = std::max(0.3 * channel_range(p, c),
                                       s.rigs.contains("pile") && c == "z" ? 4.0 * s.radius : 0.0);
        if (!(widest > 0.0)) continue;
        Unknown u = range("offset", unit_of_channel(c), -widest, widest, 0.0);
        u.target = Target::offset, u.key = c;
        list.push_back(
            {.effect = "measurement_offset", .channel = c, .unknowns = {u}, .two_sided = true});
    }
    if (s.rigs.contains("drop") || s.rigs.contains("incline")) {
        Unknown u = instrument_factor("factor", 0.08);
        u.target = Target::time_factor;
        list.push_back({.effect = "time_base", .unknowns = {u}, .two_sided = true});
    }
}

bool is_numerical(const cases::Numerics& n) {
    return n.time_step.has_value() || n.youngs_modulus_factor != 1.0 || n.integrator == "euler";
}

}  // namespace

double channel_range(const Problem& p, const std::string& name) {
    double widest = 0.0;
    for (const Record& r : p.records) {
        double low = 1e300, high = -1e300;
        for (const Channel& c : r.channels) {
            if (c.name != name) continue;
            for (const double v : c.recorded)
                if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
        }
        widest = std::max(widest, high - low);
    }
    return widest;
}

std::vector<Term> catalogue(const Problem& p) {
    const Sizes s = sizes_of(p);
    std::vector<Term> list;
    for (const Entry& e : entries()) {
        if (s.physics.contains(e.effect) || !can_act(p, e.effect)) continue;
        if (e.effect == "tangential_compliance" && !s.physics.contains("hertz_coulomb")) continue;
        const bool through_friction = e.effect == "velocity_dependent_friction" ||
                                      e.effect == "rolling_resistance" ||
                                      e.effect == "tangential_compliance";
        if (through_friction && !moves_sideways(p)) continue;
        list.push_back({.effect = e.effect,
                        .unknowns = e.unknowns(s),
                        .idle = e.idle,
                        .two_sided = e.two_sided});
    }
    if (p.piles != nullptr)
        for (const BulkEffect& e : p.piles->effects())
            if (std::none_of(list.begin(), list.end(),
                             [&](const Term& t) { return t.effect == e.effect; }))
                list.push_back(
                    {.effect = e.effect, .unknowns = e.unknowns, .two_sided = e.two_sided});
    add_measurement(list, p, s);
    const bool own_run_differs =
        std::any_of(p.records.begin(), p.records.end(), [](const Record& r) {
            return std::any_of(r.channels.begin(), r.channels.end(),
                               [](const Channel& c) { return !c.own_run_off.empty(); });
        });
    // Heaps are poured by steps of our own, whatever the user's were.
    const bool stepped = std::any_of(p.records.begin(), p.records.end(),
                                     [](const Record& r) { return r.covariance.size() == 0; });
    if (own_run_differs || (stepped && p.world.numerics && is_numerical(*p.world.numerics)))
        list.push_back({.effect = "numerical_artefact", .unknowns = {}});
    return list;
}

bool is_measurement(const std::string& effect) {
    return effect.starts_with("measurement_") || effect == "time_base" ||
           effect == "numerical_artefact";
}

double drag_coefficient(const Problem& p, const Hypothesised& h, const Eigen::VectorXd& theta,
                        double factor) {
    double fastest = 0.0;
    const cases::Experiment* where = nullptr;
    for (const Record& r : p.records) {
        const rigs::Curves state = r.model->variables(world_at(p, h, theta, r), r.ordinates);
        const auto speed = state.find("speed");
        if (speed == state.end()) continue;
        for (const double v : speed->second)
            if (std::isfinite(v) && std::abs(v) > fastest)
                fastest = std::abs(v), where = r.experiment;
    }
    return where ? factor * rigs::drag_curve(*where, fastest) : factor;
}

}  // namespace diagnose
