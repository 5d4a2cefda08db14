// SPDX-License-Identifier: MIT
#include "rigs/one_grain.hpp"

#include "cases/rig_table.hpp"
#include "cases/units.hpp"
#include "contact/effective.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigs {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double vacuum_permittivity = 8.8541878128e-12;  // F/m, CODATA 2018

using scaling::in_si;
using scaling::InvalidInput;
using scaling::mistake;

contact::Material material(double youngs_modulus, double poisson_ratio) {
    return {in_si<scaling::Pressure>(youngs_modulus), poisson_ratio, scaling::Density{}};
}

bool acts(const World& world, const char* effect) { return world.physics.count(effect) > 0; }

Drag drag(const Stated& stated, const World& world, double diameter) {
    if (!acts(world, "air_drag")) return {};
    const Drag law{parameter_or(world, "drag_factor", 1.0),
                   stated.value(world, "surroundings.fluid_density", 0.0),
                   stated.value(world, "surroundings.fluid_viscosity", 0.0), diameter};
    if (law.density <= 0.0 && law.viscosity <= 0.0)
        throw InvalidInput(mistake("experiment " + stated.id() + ": surroundings", "no fluid",
                                   "must hold the fluid that drags",
                                   "add fluid_density and fluid_viscosity"));
    return law;
}

Attraction attraction(const World& world, const OneGrain& g, Counterpart counterpart) {
    Attraction a;
    if (acts(world, "van_der_waals")) a.hamaker_r = parameter(world, "hamaker_constant") * g.r_star;
    if (acts(world, "capillary_bridge")) {
        const double volume = parameter(world, "liquid_volume");
        const double angle = parameter_or(world, "contact_angle", 0.0);
        a.bridge = 4.0 * pi * parameter(world, "surface_tension") * g.r_star * std::cos(angle);
        a.bridge_area = volume / (pi * g.r_star);
        a.rupture = (1.0 + 0.5 * angle) * std::cbrt(volume);
    }
    if (acts(world, "electrostatic")) {
        const double q = parameter(world, "charge"), unit = q * q / (pi * vacuum_permittivity);
        const bool image = counterpart == Counterpart::plate;
        a.charge_term = image ? unit / 16.0 : -unit / 4.0;
        a.charge_distance = image ? g.radius : 2.0 * g.radius;
    }
    return a;
}

Restitution restitution(const World& world) {
    Restitution r{.slow = parameter_or(world, "restitution", 1.0)};
    if (acts(world, "viscoelastic_restitution")) r.loss = parameter(world, "loss_coefficient");
    if (acts(world, "plastic_restitution")) r.yield_velocity = parameter(world, "yield_velocity");
    return r;
}

Friction friction(const World& world) {
    const double mu = parameter_or(world, "sliding_friction", 0.0);
    if (!acts(world, "velocity_dependent_friction")) return {mu, mu, 0.0};
    return {mu, parameter(world, "dynamic_friction"), parameter(world, "friction_velocity")};
}

}  // namespace

double OneGrain::pull_off_force() const { return 1.5 * pi * work_of_adhesion * r_star; }

double OneGrain::resting_overlap(double load) const {
    if (work_of_adhesion <= 0.0) {
        const double pressed = std::max(0.0, load);
        return std::cbrt(std::pow(0.75 * pressed / e_star, 2) / r_star);
    }
    // F = (2/3) pi w R* x (x - 3) with x = s^3 (contact/jkr.hpp), the stable root.
    const double f = load / (2.0 / 3.0 * pi * work_of_adhesion * r_star);
    const double x = 1.5 + std::sqrt(std::max(0.0, 2.25 + f)), s = std::cbrt(x);
    const double length = jkr().length_scale(r_star);
    return length * length / r_star * s * (x - 2.0);
}

Stated::Stated(const cases::Experiment& e) : id_(e.id) {
    numbers_ = {{"grain.diameter", e.grain.diameter.value.value()},
                {"grain.density", e.grain.density.value.value()},
                {"grain.youngs_modulus", e.grain.youngs_modulus.value.value()},
                {"grain.poisson_ratio", e.grain.poisson_ratio.value.value()},
                {"plate.youngs_modulus", e.plate.youngs_modulus.value()},
                {"plate.poisson_ratio", e.plate.poisson_ratio.value()},
                {"surroundings.gravity", e.surroundings.gravity.value()},
                {"surroundings.fluid_density", e.surroundings.fluid_density.value()},
                {"surroundings.fluid_viscosity", e.surroundings.fluid_viscosity.value()}};
    for (const cases::Condition& rule : cases::rig_rule(e.rig).conditions) {
        if (rule.unit.empty() || !e.conditions.has(rule.name)) continue;
        const cases::Value& v = e.conditions.at(rule.name);
        numbers_["conditions." + rule.name] = v.si(cases::parse_unit(rule.unit, v.where));
    }
}

double Stated::value(const World& world, const std::string& key, double otherwise) const {
    if (const auto other = world.stated.find(key); other != world.stated.end())
        return other->second;
    const auto own = numbers_.find(key);
    return own != numbers_.end() ? own->second : otherwise;
}

double Stated::value(const World& world, const std::string& key) const {
    const double v = value(world, key, std::nan(""));
    if (std::isnan(v))
        throw InvalidInput(
            mistake("experiment " + id_ + ": " + key, "nothing", "must be given", "add it"));
    return v;
}

double parameter(const World& world, const std::string& name) {
    const auto p = world.parameters.find(name);
    if (p == world.parameters.end())
        throw InvalidInput(mistake("model.parameters." + name, "nothing",
                                   "must be given for the physics named",
                                   "add it, or take its effect out of model.physics"));
    return p->second;
}

double parameter_or(const World& world, const std::string& name, double otherwise) {
    const auto p = world.parameters.find(name);
    return p == world.parameters.end() ? otherwise : p->second;
}

namespace {

// What is missing as a function of one variable of the state.
void check_function(const std::string& what, const std::string& variable,
                    const std::vector<std::string>& variables, const std::vector<double>& knots,
                    const std::vector<double>& values) {
    std::string list;
    for (const std::string& name : variables) list += (list.empty() ? "" : ", ") + name;
    if (std::find(variables.begin(), variables.end(), variable) == variables.end())
        throw InvalidInput(
            mistake(what, variable,
                    list.empty() ? "must not be asked for" : "must depend on one of " + list,
                    "name a variable that the rig has"));
    if (knots.size() != values.size() || !std::is_sorted(knots.begin(), knots.end()))
        throw InvalidInput(mistake(what, "its knots", "must rise, one value each", "sort them"));
}

}  // namespace

void check_missing(const World& world, const std::string& rig,
                   const std::vector<std::string>& variables) {
    if (const auto& m = world.missing)
        check_function("missing force on " + rig, m->variable, variables, m->knots, m->newtons);
}

OneGrain one_grain(const Stated& stated, const World& world, Counterpart counterpart) {
    OneGrain g{};
    const double diameter = stated.value(world, "grain.diameter");
    const double density = stated.value(world, "grain.density");
    g.radius = 0.5 * diameter;
    const double volume = 4.0 / 3.0 * pi * g.radius * g.radius * g.radius;
    g.mass = density * volume;
    g.inertia = 0.4 * g.mass * g.radius * g.radius;
    const bool plate = counterpart == Counterpart::plate;
    const double softer = world.numerics ? world.numerics->youngs_modulus_factor : 1.0;
    const contact::Material grain = material(softer * stated.value(world, "grain.youngs_modulus"),
                                             stated.value(world, "grain.poisson_ratio"));
    const contact::Material other =
        plate ? material(softer * stated.value(world, "plate.youngs_modulus"),
                         stated.value(world, "plate.poisson_ratio"))
              : grain;
    g.r_star = plate ? g.radius : 0.5 * g.radius;
    g.e_star = contact::e_star(grain, other).value();
    g.g_star = contact::g_star(grain, other).value();
    if (acts(world, "gravity")) {
        const double fluid =
            acts(world, "buoyancy") ? stated.value(world, "surroundings.fluid_density", 0.0) : 0.0;
        g.gravity = stated.value(world, "surroundings.gravity", 0.0) * (1.0 - fluid / density);
    }
    if (acts(world, "tilt")) {
        g.tilt_angle = parameter(world, "tilt_angle");
        g.tilt_azimuth = parameter_or(world, "tilt_azimuth", 0.0);
    }
    if (acts(world, "adhesion")) g.work_of_adhesion = parameter(world, "work_of_adhesion");
    if (acts(world, "rolling_resistance"))
        g.rolling_friction = parameter(world, "rolling_friction");
    const bool named = acts(world, "tangential_compliance");
    g.compliant = named || !acts(world, "hertz_coulomb");
    g.stiffness_ratio = named ? parameter_or(world, "stiffness_ratio", 1.0) : 1.0;
    g.restitution = restitution(world);
    g.friction = friction(world);
    g.drag = drag(stated, world, diameter);
    g.attraction = attraction(world, g, counterpart);
    if (acts(world, "vibration"))
        g.vibration = {parameter(world, "amplitude"), 2.0 * pi * parameter(world, "frequency"),
                       parameter_or(world, "phase", 0.0)};
    if (const auto& m = world.missing_restitution)
        check_function("missing restitution", m->variable, {"impact_angle", "impact_speed"},
                       m->knots, m->shares);
    g.missing_restitution = world.missing_restitution;
    return g;
}

}  // namespace rigs
