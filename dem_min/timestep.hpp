// SPDX-License-Identifier: MIT
// How long a step may be. SI doubles; call with the smallest grain.
#pragma once

#include "contact/capillary_bridge.hpp"

namespace dem_min {

struct StepLimits {
    double rayleigh;  // s, 0.2 of the Rayleigh time
    double hertz;     // s, 1/20 of a Hertz collision at the fastest impact
    double
        adhesive_gap;  // s, a fifth of the tear-off gap at sticking speed; infinite without adhesion
    double bridge_gap;  // s, likewise of the gap at which a capillary bridge ruptures
    double shortest() const;
};

struct StepInput {
    double radius, density, youngs_modulus, poisson_ratio;  // m, kg/m^3, Pa, 1
    double work_of_adhesion;                                // J/m^2, >= 0
    double fastest_impact;                                  // m/s, > 0
    contact::CapillaryBridge bridge = {};
};

// Between two equal grains.
//   T_R = pi R sqrt(rho/G) / (0.1631 nu + 0.8766)          Rayleigh wave over half a circumference (Thornton & Randall 1988)
//   T_H = 2.87 (m*^2 / (R* E*^2 v))^(1/5)                  duration of a Hertz impact (Johnson 1985, eq. 11.24)
//   gap = 3/4 (pi^2 w^2 R*/E*^2)^(1/3), v = sqrt(2 W/m*)   JKR tear-off; W = 7.0922 (w^5 R*^4/E*^2)^(1/3), the work of it:
// a step that jumps the gap leaves adhesion out, which no criterion of the DEM codes looks at. A bridge: gap and W its own.
StepLimits step_limits(const StepInput&);

double rayleigh_time(double radius, double density, double shear_modulus,
                     double poisson_ratio);  // s

}  // namespace dem_min
