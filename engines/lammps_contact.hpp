// SPDX-License-Identifier: MIT
// One set of contact rules in two languages: LAMMPS' pair style `granular` (package GRANULAR,
// release of 29 September 2021) and the laws of our core. Where the two cannot say the same, the
// difference is listed in docs/verify.md.
//   jkr E eta nu gamma            Jkr with w = 2 gamma, torn off at the deepest tension
//   hertz/material E eta nu       Hertz, where gamma is 0
//   damping viscoelastic          DampingViscoelastic
//   tangential mindlin_rescale    Mindlin; NULL: k_t = 8 G* a from E and nu
//   rolling sds k gamma mu_r      RollingSds
//   twisting marshall             TwistingMarshall2009
// Friction multiplies F_e + 2 F_po under jkr and F_e + F_d under hertz/material.
#pragma once

#include "dem_min/interaction.hpp"

#include <string>

namespace engines {

// Of two like grains.
struct LammpsContact {
    double youngs_modulus, poisson_ratio;  // Pa, 1
    double surface_energy = 0.0;           // J/m^2, half of the work of adhesion
    double eta = 0.0;                      // 1/(m s)
    double tangential_ratio = 0.0;         // 1
    double sliding_friction = 0.0;         // 1
    double rolling_stiffness = 0.0;        // N/m; 0: no rolling resistance
    double rolling_damping = 0.0;          // kg/s
    double rolling_friction = 0.0;         // 1
    bool twisting = false;                 // Marshall's, from Mindlin's spring and dashpot
    // Mindlin's k_t/a = 8 G* as a number in place of NULL: at walls LAMMPS takes half of it for NULL.
    bool stiffness_as_number = false;

    double work_of_adhesion() const { return 2.0 * surface_energy; }  // J/m^2
    double e_star() const;                                            // Pa
    double g_star() const;                                            // Pa
};

// What follows `pair_coeff * *`, and `granular` in `fix wall/gran`.
std::string granular_arguments(const LammpsContact&);

dem_min::Laws laws(const LammpsContact&);

}  // namespace engines
