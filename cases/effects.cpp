// SPDX-License-Identifier: MIT
#include "cases/effects.hpp"

namespace cases {

const std::vector<Effect>& effects() {
    static const std::vector<Effect> table{
        {"gravity", {}},
        {"hertz_mindlin", {}},
        {"hertz_coulomb", {}},
        {"air_drag", {}},
        {"buoyancy", {}},
        {"adhesion", {"work_of_adhesion"}},
        {"wall_adhesion", {"wall_work_of_adhesion"}},
        {"van_der_waals", {"hamaker_constant"}},
        {"capillary_bridge", {"surface_tension", "liquid_volume"}},
        {"electrostatic", {"charge"}},
        {"rolling_resistance", {"rolling_friction"}},
        {"viscoelastic_restitution", {"loss_coefficient"}},
        {"plastic_restitution", {"restitution", "yield_velocity"}},
        {"velocity_dependent_friction", {"friction_velocity", "dynamic_friction"}},
        {"tangential_compliance", {"stiffness_ratio"}},
        {"polydispersity", {"size_spread"}},
        {"shape", {"aspect_ratio"}},
        {"wall_friction", {"wall_sliding_friction"}},
        {"tilt", {"tilt_angle"}},
        {"vibration", {"amplitude", "frequency"}},
        {"ageing", {"ageing_rate"}},
        {"measurement_scale", {"scale"}},
        {"measurement_offset", {"offset"}},
        {"time_base", {"factor"}},
    };
    return table;
}

const std::vector<ParameterRule>& parameter_rules() {
    static const std::vector<ParameterRule> table{
        {"restitution", "1", Domain::unit_interval},
        {"sliding_friction", "1", Domain::not_negative},
        {"rolling_friction", "1", Domain::not_negative},
        {"work_of_adhesion", "J/m^2", Domain::not_negative},
        {"wall_restitution", "1", Domain::unit_interval},
        {"wall_sliding_friction", "1", Domain::not_negative},
        {"wall_rolling_friction", "1", Domain::not_negative},
        {"wall_work_of_adhesion", "J/m^2", Domain::not_negative},
        {"drag_coefficient", "1", Domain::not_negative},
        {"hamaker_constant", "J", Domain::not_negative},
        {"surface_tension", "N/m", Domain::not_negative},
        {"liquid_volume", "m^3", Domain::not_negative},
        {"contact_angle", "rad", Domain::not_negative},
        {"charge", "C", Domain::any},
        {"loss_coefficient", "(s/m)^(1/5)", Domain::not_negative},
        {"yield_velocity", "m/s", Domain::positive},
        {"friction_velocity", "m/s", Domain::positive},
        {"dynamic_friction", "1", Domain::not_negative},
        {"stiffness_ratio", "1", Domain::positive},
        {"size_spread", "1", Domain::not_negative},
        {"aspect_ratio", "1", Domain::at_least_one},
        {"tilt_angle", "rad", Domain::steepness},
        {"tilt_azimuth", "rad", Domain::any},
        {"amplitude", "m", Domain::not_negative},
        {"frequency", "Hz", Domain::not_negative},
        {"phase", "rad", Domain::any},
        {"ageing_rate", "1", Domain::any},
        {"ageing_onset", "s", Domain::positive},
        {"scale", "1", Domain::positive},
        {"offset", "", Domain::any},
        {"factor", "1", Domain::positive},
    };
    return table;
}

std::vector<std::string> effect_names() {
    std::vector<std::string> names;
    for (const Effect& effect : effects()) names.push_back(effect.name);
    return names;
}

std::vector<std::string> parameter_names() {
    std::vector<std::string> names;
    for (const ParameterRule& rule : parameter_rules()) names.push_back(rule.name);
    return names;
}

}  // namespace cases
