// SPDX-License-Identifier: MIT
// The heap of verify/against_lammps.hpp: 2000 like grains in a column on glued ones of the same
// kind; it is let go, slumps over the rim, and what stays is a heap.
#pragma once

#include "engines/lammps_slump.hpp"

#include <cstdint>

namespace verify {

// Soft and moderately sticky, so that a heap takes a minute on one core. There is no tangential
// dashpot, so that both codes have one rule for sliding.
struct SlumpPowder {
    double diameter = 200e-6, density = 2500.0;  // m, kg/m^3
    double gravity = 9.81;                       // m/s^2
    double elasticity = 3e4;                     // E/(rho g d)
    double bond_number = 3.0;                    // F_po/(m g)
    double sliding_friction = 0.5, rolling_friction = 0.1;
    double damping = 0.3;               // share of critical at the contact radius without load
    double base = 20.0, column = 14.0;  // diameters, in d
    double duration = 100.0;            // in sqrt(d/g)
};

engines::LammpsContact contact_of(const SlumpPowder&);
engines::Slump slump_of(const SlumpPowder&, std::uint64_t seed);

}  // namespace verify
