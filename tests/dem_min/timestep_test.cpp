// SPDX-License-Identifier: MIT
#include "dem_min/timestep.hpp"

#include <catch2/catch.hpp>

#include <limits>

// By hand, glass bead: R = 1 mm, rho = 2500 kg/m^3, E = 60 GPa, nu = 0.25, v = 1 m/s, w = 0.1 J/m^2
//   G = 24 GPa, T_R = pi R sqrt(rho/G)/(0.1631 nu + 0.8766) = 1.105267e-6 s
//   E* = 32 GPa, R* = 0.5 mm, m* = 5.235988e-6 kg
//   T_H = 2.87 (m*^2/(R* E*^2 v))^(1/5) = 2.87 * 2.216897e-6 s = 6.362494e-6 s
//   gap = 3/4 (pi^2 w^2 R*/E*^2)^(1/3) = 2.729299e-9 m
//   W = 7.0922 (w^5 R*^4/E*^2)^(1/3) = 6.015998e-13 J, v_s = sqrt(2 W/m*) = 4.793685e-4 m/s
//   gap/(5 v_s) = 1.138706e-6 s
// 1e-6: the digits carried; 1e-5 where the 7.0922, printed to five digits, comes in.
TEST_CASE("time step: the three limits of a glass bead", "[dem_min][timestep][exact]") {
    const dem_min::StepLimits limits = dem_min::step_limits({.radius = 1e-3,
                                                             .density = 2500.0,
                                                             .youngs_modulus = 60e9,
                                                             .poisson_ratio = 0.25,
                                                             .work_of_adhesion = 0.1,
                                                             .fastest_impact = 1.0});
    REQUIRE(limits.rayleigh == Approx(0.2 * 1.105267e-6).epsilon(1e-6));
    REQUIRE(limits.hertz == Approx(6.362494e-6 / 20.0).epsilon(1e-6));
    REQUIRE(limits.adhesive_gap == Approx(1.138706e-6).epsilon(1e-5));
    REQUIRE(limits.shortest() == limits.rayleigh);
}

TEST_CASE("time step: without adhesion there is no gap to jump", "[dem_min][timestep][limit]") {
    const dem_min::StepLimits limits = dem_min::step_limits({.radius = 1e-3,
                                                             .density = 2500.0,
                                                             .youngs_modulus = 60e9,
                                                             .poisson_ratio = 0.25,
                                                             .work_of_adhesion = 0.0,
                                                             .fastest_impact = 1.0});
    REQUIRE(limits.adhesive_gap == std::numeric_limits<double>::infinity());
}

// By hand, the same bead with water: gamma = 0.072 N/m, V = 1e-13 m^3, theta = 0
//   F_c = 4 pi gamma R* = 4.523893e-4 N, A = V/(pi R*) = 6.366198e-11 m^2, h_r = V^(1/3) = 4.641589e-5 m
//   W = F_c (h_r - sqrt(h_r^2 + A) + sqrt(A)) = 3.301565e-9 J, v = sqrt(2 W/m*) = 3.551204e-2 m/s
//   h_r/(5 v) = 2.614093e-4 s
TEST_CASE("time step: the limit of a bridge's rupture gap", "[dem_min][timestep][bridge][exact]") {
    const auto limits = [](contact::CapillaryBridge bridge) {
        return dem_min::step_limits({.radius = 1e-3,
                                     .density = 2500.0,
                                     .youngs_modulus = 60e9,
                                     .poisson_ratio = 0.25,
                                     .work_of_adhesion = 0.0,
                                     .fastest_impact = 1.0,
                                     .bridge = bridge});
    };
    const double pull_per_radius = 0.904778684;  // N/m, 4 pi gamma
    REQUIRE(limits({pull_per_radius, 1e-13, 4.641589e-5}).bridge_gap ==
            Approx(2.614093e-4).epsilon(1e-6));
    REQUIRE(limits({}).bridge_gap == std::numeric_limits<double>::infinity());
}
