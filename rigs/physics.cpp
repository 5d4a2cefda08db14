// SPDX-License-Identifier: MIT
#include "rigs/physics.hpp"

#include "scaling/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rigs {
namespace {

// Critical for one pair. Ai et al. (2011) take 0.3 for stiff heaps; branches of sticky soft grains then sway for hundreds of
// sqrt(d/g) before they are at rest.
constexpr double rolling_damping_ratio = 1.0;

}  // namespace

dem_min::Laws laws(const ContactParameters& c) {
    dem_min::Laws result{contact::Hertz{c.e_star}, contact::Mindlin{c.g_star, c.sliding_friction},
                         contact::NoRolling{}, contact::DampingTsuji1992::from(c.restitution)};
    if (c.work_of_adhesion > 0.0) result.normal = contact::Jkr{c.e_star, c.work_of_adhesion};
    if (c.work_of_adhesion > 0.0 || c.bridge.acts())
        result.twisting = {c.g_star, c.sliding_friction};
    result.bridge = c.bridge;
    if (c.work_of_adhesion > 0.0) result.ageing = c.ageing;
    result.friction_cap = c.friction_cap;
    if (c.rigid_tangential) result.tangential = contact::Coulomb{c.sliding_friction};
    if (c.rolling_friction > 0.0)
        result.rolling = contact::RollingEpsd{c.rolling_friction, rolling_damping_ratio};
    if (!c.as_lammps) return result;
    if (c.work_of_adhesion > 0.0)
        result.normal = contact::Jkr{c.e_star, c.work_of_adhesion, contact::TearOff::max_tension};
    else
        result.friction_cap = contact::FrictionCap::total_plus_two_pull_off;
    if (c.rolling_friction > 0.0)
        result.rolling = contact::RollingSds{c.as_lammps->rolling_stiffness,
                                             c.as_lammps->rolling_damping, c.rolling_friction};
    return result;
}

contact::FrictionCap friction_cap(const std::string& name) {
    using enum contact::FrictionCap;
    const std::vector<std::string>& names = cases::friction_caps();
    constexpr std::array caps{elastic_plus_two_pull_off, total_plus_two_pull_off, repulsive_part,
                              elastic};
    for (std::size_t k = 0; k < caps.size(); ++k)
        if (names.at(k) == name) return caps[k];
    return elastic_plus_two_pull_off;
}

contact::Material grain_material(const cases::Experiment& e) {
    return {e.grain.youngs_modulus.value, e.grain.poisson_ratio.value.value(),
            e.grain.density.value};
}

contact::Material plate_material(const cases::Experiment& e) {
    return {e.plate.youngs_modulus, e.plate.poisson_ratio.value(), e.grain.density.value};
}

ContactParameters elastic_parameters(const contact::Material& a, const contact::Material& b) {
    ContactParameters c{};
    c.e_star = contact::e_star(a, b).value();
    c.g_star = contact::g_star(a, b).value();
    return c;
}

const std::vector<std::string>& bulk_physics() {
    static const std::vector<std::string> names{
        "gravity",       "hertz_mindlin", "hertz_coulomb",     "adhesion",
        "wall_adhesion", "wall_friction", "rolling_resistance"};
    return names;
}

BulkContacts bulk_contacts(const cases::Case& c, const cases::Experiment& experiment) {
    const cases::Model& model = c.model;
    const contact::Material grain = grain_material(experiment), plate = plate_material(experiment);
    BulkContacts s{};
    const bool rolling = model.includes("rolling_resistance");
    const bool rigid = model.includes("hertz_coulomb");
    s.grains = elastic_parameters(grain, grain);
    s.grains.work_of_adhesion =
        model.includes("adhesion") ? model.value_or("work_of_adhesion", 0.0) : 0.0;
    s.grains.sliding_friction = model.value_or("sliding_friction", 0.0);
    s.grains.rolling_friction = rolling ? model.value_or("rolling_friction", 0.0) : 0.0;
    s.grains.restitution = model.value_or("restitution", 1.0);
    s.walls = elastic_parameters(grain, plate);
    s.walls.work_of_adhesion =
        model.includes("wall_adhesion") ? model.wall_value_or("work_of_adhesion", 0.0) : 0.0;
    s.walls.sliding_friction = model.wall_value_or("sliding_friction", 0.0);
    s.walls.rolling_friction = rolling ? model.wall_value_or("rolling_friction", 0.0) : 0.0;
    s.walls.restitution = model.wall_value_or("restitution", 1.0);
    s.grains.rigid_tangential = s.walls.rigid_tangential = rigid;
    s.grains.friction_cap = s.walls.friction_cap = friction_cap(model.friction_cap);
    return s;
}

void add_pair_effects(const cases::Case& c, ContactParameters& grains, ContactParameters& walls) {
    const cases::Model& model = c.model;
    const std::string where = c.path + ": model.";
    const auto build = [&](const char* parameters, const auto& make) {
        try {
            return make();
        } catch (const scaling::InvalidParameter& mistake) {
            throw scaling::InvalidInput(where + parameters + ": " + mistake.what());
        }
    };
    if (model.includes("capillary_bridge"))
        grains.bridge = walls.bridge = build("parameters", [&] {
            return contact::CapillaryBridge::from(
                scaling::in_si<scaling::EnergyPerArea>(model.value_or("surface_tension", 0.0)),
                scaling::in_si<scaling::Volume>(model.value_or("liquid_volume", 0.0)),
                model.value_or("contact_angle", 0.0));
        });
    if (!model.includes("ageing")) return;
    if (!model.includes("adhesion") && !model.includes("wall_adhesion"))
        throw scaling::InvalidInput(
            scaling::mistake(where + "physics", "\"ageing\" without adhesion",
                             "must stand beside adhesion or wall_adhesion",
                             "name one of them: what ages is the work of adhesion"));
    grains.ageing = walls.ageing = build("parameters", [&] {
        return contact::Ageing::from(
            model.value_or("ageing_rate", 0.0),
            scaling::in_si<scaling::Time>(model.value_or("ageing_onset", 1.0)));
    });
}

void scale_attraction(ContactParameters& c, const scaling::ScaleMap& map) {
    c.work_of_adhesion *= map.factor("work_of_adhesion");
    c.bridge.pull_per_radius *= map.factor("surface_tension");
    c.bridge.volume *= map.factor("liquid_volume");
    c.bridge.rupture_gap *= map.factor("length");
    c.ageing.onset *= map.factor("time");
}

void take_lammps_rules(ContactParameters& grains, ContactParameters& walls, const NominalGrain& g,
                       double work_of_adhesion) {
    if (grains.friction_cap != contact::FrictionCap::elastic_plus_two_pull_off)
        throw scaling::InvalidInput(scaling::mistake(
            "model.friction_cap", "another than elastic_plus_two_pull_off",
            "must be that, or left out, under LAMMPS' rules", "or take --contact own"));
    const double mass = g.density * (std::numbers::pi / 6.0) * (g.d * g.d * g.d);
    const double pull_off = 1.5 * std::numbers::pi * work_of_adhesion * 0.25 * g.d;
    const double k = 100.0 * (mass * g.gravity + 2.0 * pull_off) / g.d;
    grains.as_lammps = walls.as_lammps = LammpsRules{k, std::sqrt(k * mass)};
}

void refuse_other_physics(const cases::Case& c, const std::string& rig,
                          const std::vector<std::string>& known) {
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    for (const std::string& effect : c.model.physics)
        if (std::find(known.begin(), known.end(), effect) == known.end())
            throw scaling::InvalidInput(
                scaling::mistake(c.path + ": model.physics", '"' + effect + '"',
                                 "must be one of " + list + " for the rig " + rig,
                                 "this core does not simulate it yet: take it out, and say so "
                                 "where you use the result"));
}

}  // namespace rigs
