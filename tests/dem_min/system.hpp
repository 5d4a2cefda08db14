// SPDX-License-Identifier: MIT
// Small systems for the tests of the core: their numbers as plain data, so that one can be scaled
// double by double and run on either step function.
#pragma once

#include "dem_min/simulation.hpp"

#include <vector>

namespace samples {

// Grains about 0.1 mm across, E/(rho g d) about 1e5: soft, so that a fall takes a few thousand
// steps. The pull-off force is 8 grain weights.
struct Powder {
    double diameter = 1e-4;    // m
    double density = 2500.0;   // kg/m^3
    double gravity = 9.81;     // m/s^2, along -z
    double e_star = 1.3e5;     // Pa
    double g_star = 2.3e4;     // Pa
    double work_of_adhesion;   // J/m^2; 0: Hertz
    double restitution = 0.5;  // 1
    double sliding_friction = 0.5;
    double rolling_friction = 0.1;
};
Powder sticky();  // JKR
Powder dry();     // Hertz

// Mindlin, EPSD if there is rolling friction, and with adhesion twisting resistance.
dem_min::Laws laws(const Powder&);

// A bridge that pulls with `weights` of a grain of the powder when closed, of a thousandth of R^3 of liquid: it ruptures at R/10.
contact::CapillaryBridge bridge(const Powder&, double weights);

struct System {
    dem_min::Laws between_grains, at_walls;
    std::vector<dem_min::Wall> walls;
    std::vector<dem_min::Grain> grains;
    double gravity;                      // m/s^2, along -z
    double time_step, skin, lost_below;  // s, m, m
};

// The shortest of dem_min::step_limits for equal grains that meet at `fastest` m/s. s.
double recommended_step(const Powder&, double fastest);

// Two grains that meet at `speed` after `gap` m, off centre and spinning where `oblique`.
System two_grains(const Powder&, double speed, double gap, bool oblique);

// `count` spinning grains in layers above a base, on their way down at 3 sqrt(g d): 6 x 6 glued grains, or a disc with a rim if
// `walled`; diameters spread by up to 30 % if `polydisperse`.
System rain(const Powder&, int count, bool walled, bool polydisperse);

// Every double times the factor of its quantity; the density is kept.
System scaled(const System&, double length, double time);

dem_min::Simulation simulation(const System&, int threads = 1, bool ledger = false);

}  // namespace samples
