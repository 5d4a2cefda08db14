// SPDX-License-Identifier: MIT
// Fall of a sphere through a fluid, integrated by GSL (Prince-Dormand 8, relative error 1e-11). The law is written here anew: nothing
// is shared with what is tested.
//   m v' = (m - rho_f V) g - Cd pi/8 rho_f d^2 v^2,   Cd = 24/Re (1 + 0.15 Re^0.687), 0.44 from Re = 1000   (Schiller & Naumann 1935)
#pragma once

namespace verify {

struct FallingSphere {
    double diameter, density;               // m, kg/m^3
    double fluid_density, fluid_viscosity;  // kg/m^3, Pa s
    double gravity;                         // m/s^2
    bool buoyant;
};

struct Fallen {
    double way, speed;  // m, m/s
};
// From rest. Throws std::runtime_error if GSL fails.
Fallen integrate_fall(const FallingSphere&, double duration);

}  // namespace verify
