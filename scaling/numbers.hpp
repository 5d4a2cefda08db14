// SPDX-License-Identifier: MIT
// The dimensionless numbers of the field, as plain functions. Grains are alike: R* = R/2, m* = m/2,
// d = 2 R.
#pragma once

#include "scaling/quantities.hpp"

namespace scaling {

// Equilibrium separation of two solids, the z0 of the Tabor number; Israelachvili, Intermolecular
// and Surface Forces.
inline const Length equilibrium_separation = 0.165e-9 * si::meters;

Mass grain_mass(Length diameter, Density);  // pi/6 rho d^3

// E* of two like grains, E / (2 (1 - nu^2)).
Pressure effective_modulus(Pressure youngs_modulus, double poisson_ratio);
Pressure shear_modulus(Pressure youngs_modulus, double poisson_ratio);  // E / (2 (1 + nu))
Pressure youngs_modulus(Pressure shear_modulus, double poisson_ratio);  // 2 G (1 + nu)

// Granular Bond number, pull-off force over grain weight F_po / (m g). Its inverse with a surface
// energy in place of the force, rho g L^2 / gamma, is the Bond (Eotvos) number of liquids.
double weight_bond_number(Force pull_off, Mass grain, Acceleration gravity);

// Pull-off force over the force that a stress puts on a grain, F_po / (sigma R^2).
double stress_bond_number(Force pull_off, Pressure stress, Length radius);

// (w^5 / (E*^2 R^8))^(1/3) / (rho g): work to separate a pair over m g R, but for a constant.
// Behjani et al. (2017), Adv. Powder Technol. 28, 2456, in terms of w and R.
double cohesion_number(EnergyPerArea work_of_adhesion, Pressure e_star, Length radius, Density,
                       Acceleration gravity);

// (R* w^2 / (E*^2 z0^3))^(1/3): reach of adhesion in units of the elastic neck. Above about 5 JKR
// holds, below about 0.1 DMT; Johnson & Greenwood (1997), J. Colloid Interface Sci. 192, 326.
double tabor_number(EnergyPerArea work_of_adhesion, Pressure e_star, Length r_star,
                    Length separation);

// gamma_dot d sqrt(rho / P): GDR MiDi (2004), Eur. Phys. J. E 14, 341.
double inertial_number(Frequency shear_rate, Length diameter, Density, Pressure);

double froude_number(Velocity, Acceleration gravity, Length);                 // v / sqrt(g L)
double reynolds_number(Density fluid, Velocity, Length diameter, Viscosity);  // rho_f v d / eta
double stokes_number(Density grain, Velocity, Length diameter, Viscosity);    // rho v d / (18 eta)
double capillary_number(Viscosity, Velocity, EnergyPerArea surface_tension);  // eta v / sigma
double galilei_number(Density grain, Density fluid, Acceleration, Length diameter,
                      Viscosity);  // rho_f rho g d^3/eta^2
double stiffness_number(Pressure youngs_modulus, Density, Acceleration gravity,
                        Length);                                   // E / (rho g L)
double cauchy_number(Density, Velocity, Pressure youngs_modulus);  // rho v^2 / E
double elastic_adhesion_number(EnergyPerArea work_of_adhesion, Pressure youngs_modulus,
                               Length radius);  // w / (E R)

}  // namespace scaling
