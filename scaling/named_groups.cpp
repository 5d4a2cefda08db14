// SPDX-License-Identifier: MIT
#include "scaling/pi_groups.hpp"

#include <cmath>
#include <numbers>

namespace scaling {

namespace {

constexpr double pi = std::numbers::pi;

PiGroup group(const char* name, const char* formula, double prefactor, std::vector<Power> powers) {
    return {name, formula, prefactor, std::move(powers)};
}

// The prefactors turn R = d/2, R* = d/4, m* = pi/12 rho d^3, F_po = 3/2 pi w R* = 3/8 pi w d into
// powers of d.
std::vector<PiGroup> adhesion_groups(double nu) {
    const double e_over_e_star = 2.0 * (1.0 - nu * nu);
    const double softness = std::pow(e_over_e_star, 2.0 / 3.0);
    // sqrt(2 W / m*) = sqrt(24 c / (pi 4^(4/3)) w^(5/3) / (E*^(2/3) rho d^(5/3))), c as in
    // jkr_estimates.cpp.
    const double c = std::pow(2.0 * pi, 5.0 / 3.0) * (0.3 + 0.2 * std::pow(2.0, -8.0 / 3.0));
    const double sticking = std::sqrt(24.0 * c / pi * std::pow(4.0, -4.0 / 3.0) * softness);
    return {
        group("weight_bond", "F_po / (m g)", 9.0 / 4.0,
              {{"work_of_adhesion", 1}, {"density", -1}, {"gravity", -1}, {"grain_diameter", -2}}),
        group("stress_bond", "F_po / (sigma R^2), sigma = rho g D", 1.5 * pi,
              {{"work_of_adhesion", 1},
               {"density", -1},
               {"gravity", -1},
               {"apparatus_length", -1},
               {"grain_diameter", -1}}),
        group("cohesion_number", "(w^5 / (E*^2 R^8))^(1/3) / (rho g)",
              softness * std::pow(2.0, 8.0 / 3.0),
              {{"work_of_adhesion", {5, 3}},
               {"youngs_modulus", {-2, 3}},
               {"grain_diameter", {-8, 3}},
               {"density", -1},
               {"gravity", -1}}),
        group("sticking_velocity", "v_stick / v", sticking,
              {{"work_of_adhesion", {5, 6}},
               {"youngs_modulus", {-1, 3}},
               {"density", {-1, 2}},
               {"grain_diameter", {-5, 6}},
               {"velocity", -1}}),
        group("elastic_adhesion", "w / (E R)", 2.0,
              {{"work_of_adhesion", 1}, {"youngs_modulus", -1}, {"grain_diameter", -1}}),
        group("tabor", "(R* w^2 / (E*^2 z0^3))^(1/3), z0 growing with the grain",
              softness * std::cbrt(0.25),
              {{"grain_diameter", {1, 3}},
               {"work_of_adhesion", {2, 3}},
               {"youngs_modulus", {-2, 3}},
               {"equilibrium_separation", -1}}),
    };
}

std::vector<PiGroup> motion_groups() {
    return {
        group("size_ratio", "D / d", 1.0, {{"apparatus_length", 1}, {"grain_diameter", -1}}),
        group("stiffness", "E / (rho g D)", 1.0,
              {{"youngs_modulus", 1}, {"density", -1}, {"gravity", -1}, {"apparatus_length", -1}}),
        group("grain_stiffness", "E / (rho g d)", 1.0,
              {{"youngs_modulus", 1}, {"density", -1}, {"gravity", -1}, {"grain_diameter", -1}}),
        group("froude", "v / sqrt(g D)", 1.0,
              {{"velocity", 1}, {"gravity", {-1, 2}}, {"apparatus_length", {-1, 2}}}),
        group("inertial_number", "(v/D) d sqrt(rho / P), P = rho g D", 1.0,
              {{"velocity", 1},
               {"grain_diameter", 1},
               {"apparatus_length", {-3, 2}},
               {"gravity", {-1, 2}}}),
        group("cauchy", "rho v^2 / E", 1.0,
              {{"density", 1}, {"velocity", 2}, {"youngs_modulus", -1}}),
    };
}

std::vector<PiGroup> fluid_groups() {
    return {
        group("density_ratio", "rho_f / rho", 1.0, {{"fluid_density", 1}, {"density", -1}}),
        group("reynolds", "rho_f v d / eta", 1.0,
              {{"fluid_density", 1},
               {"velocity", 1},
               {"grain_diameter", 1},
               {"fluid_viscosity", -1}}),
        group("stokes", "rho v d / (18 eta)", 1.0 / 18.0,
              {{"density", 1}, {"velocity", 1}, {"grain_diameter", 1}, {"fluid_viscosity", -1}}),
        group("galilei", "rho_f rho g d^3 / eta^2", 1.0,
              {{"fluid_density", 1},
               {"density", 1},
               {"gravity", 1},
               {"grain_diameter", 3},
               {"fluid_viscosity", -2}}),
        group("capillary", "eta v / sigma", 1.0,
              {{"fluid_viscosity", 1}, {"velocity", 1}, {"surface_tension", -1}}),
        // A closed bridge of wetting liquid between like spheres pulls with 2 pi sigma R.
        group("capillary_bond", "2 pi sigma R / (m g)", 6.0,
              {{"surface_tension", 1}, {"density", -1}, {"gravity", -1}, {"grain_diameter", -2}}),
        group("liquid_content", "V / R^3", 8.0, {{"liquid_volume", 1}, {"grain_diameter", -3}}),
    };
}

}  // namespace

std::vector<PiGroup> named_groups(double poisson_ratio) {
    std::vector<PiGroup> all = adhesion_groups(poisson_ratio);
    for (const auto& more : {motion_groups(), fluid_groups()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace scaling
