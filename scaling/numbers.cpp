// SPDX-License-Identifier: MIT
#include "scaling/numbers.hpp"

#include <cmath>
#include <numbers>

namespace scaling {

Mass grain_mass(Length diameter, Density density) {
    return std::numbers::pi / 6.0 * density * diameter * diameter * diameter;
}

Pressure effective_modulus(Pressure youngs, double poisson_ratio) {
    return youngs / (2.0 * (1.0 - poisson_ratio * poisson_ratio));
}

Pressure shear_modulus(Pressure youngs, double poisson_ratio) {
    return youngs / (2.0 * (1.0 + poisson_ratio));
}

Pressure youngs_modulus(Pressure shear, double poisson_ratio) {
    return 2.0 * (1.0 + poisson_ratio) * shear;
}

double weight_bond_number(Force pull_off, Mass grain, Acceleration gravity) {
    return Dimensionless(pull_off / (grain * gravity)).value();
}

double stress_bond_number(Force pull_off, Pressure stress, Length radius) {
    return Dimensionless(pull_off / (stress * radius * radius)).value();
}

double cohesion_number(EnergyPerArea w, Pressure e_star, Length radius, Density density,
                       Acceleration gravity) {
    // With x = w / (E* R), without dimension, the number is x^(5/3) E* / (rho g R).
    const double x = Dimensionless(w / (e_star * radius)).value();
    return std::cbrt(x * x * x * x * x) *
           Dimensionless(e_star / (density * gravity * radius)).value();
}

double tabor_number(EnergyPerArea w, Pressure e_star, Length r_star, Length separation) {
    const double x = Dimensionless(w / (e_star * separation)).value();
    return std::cbrt(x * x * Dimensionless(r_star / separation).value());
}

double inertial_number(Frequency shear_rate, Length diameter, Density density, Pressure pressure) {
    const Velocity sheared = shear_rate * diameter;
    return std::sqrt(Dimensionless(density * sheared * sheared / pressure).value());
}

double froude_number(Velocity v, Acceleration gravity, Length length) {
    return std::sqrt(Dimensionless(v * v / (gravity * length)).value());
}

double reynolds_number(Density fluid, Velocity v, Length diameter, Viscosity viscosity) {
    return Dimensionless(fluid * v * diameter / viscosity).value();
}

double stokes_number(Density grain, Velocity v, Length diameter, Viscosity viscosity) {
    return Dimensionless(grain * v * diameter / (18.0 * viscosity)).value();
}

double capillary_number(Viscosity viscosity, Velocity v, EnergyPerArea surface_tension) {
    return Dimensionless(viscosity * v / surface_tension).value();
}

double galilei_number(Density grain, Density fluid, Acceleration gravity, Length diameter,
                      Viscosity viscosity) {
    return Dimensionless(grain * fluid * gravity * diameter * diameter * diameter /
                         (viscosity * viscosity))
        .value();
}

double stiffness_number(Pressure youngs, Density density, Acceleration gravity, Length length) {
    return Dimensionless(youngs / (density * gravity * length)).value();
}

double cauchy_number(Density density, Velocity v, Pressure youngs) {
    return Dimensionless(density * v * v / youngs).value();
}

double elastic_adhesion_number(EnergyPerArea w, Pressure youngs, Length radius) {
    return Dimensionless(w / (youngs * radius)).value();
}

}  // namespace scaling
