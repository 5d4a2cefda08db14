// SPDX-License-Identifier: MIT
// The two grains of verify/against_lammps.hpp on our core, and the conditions that they meet under.
#pragma once

#include "engines/lammps_two_grains.hpp"

#include <string>

namespace verify {

// The core on the same ways and rules as engines::led_deck, thrown_deck and thrown_at_wall_deck.
engines::PairStates led_by_core(const engines::TwoGrains&);
engines::PairStates thrown_by_core(const engines::TwoGrains&, bool wall = false);

// Brought together to four times the overlap of equilibrium, then apart until they have parted: the
// paper's scaled grain. Each step moves them by 1/400 of the length that sets the gap.
engines::TwoGrains led_pair(double skin);

// Led past one another and back with an overlap of 1 % of R at the closest, so that the normal turns
// by 12 deg and springs must turn with it. Without spin the lever of the slip velocity plays no part,
// without friction it has no force to act on.
struct Pass {
    std::string name;
    double sliding_friction, rolling_friction;
    double spin;  // of both grains, in turns of the normal
};
engines::TwoGrains passing_pair(const Pass&);

// An impact at `angle_deg` to the normal, about an axis that lies along no coordinate.
struct Throw {
    std::string name;
    double angle_deg;
    double depth = 3e-7;  // overlap over R of the head-on impact
    double sliding_friction = 0.3, rolling_friction = 0.1;
    double adhesion = 1.0;                         // 0: Hertz
    double damping = 0.0, tangential_ratio = 0.0;  // share of critical; x_gammat
    double spin = 0.0;                             // of both grains, over v/R, about all axes
    double screw = 0.0;  // of the first grain, likewise, about the normal alone
    bool wall = false, twisting = false;
    double poisson_ratio = 0.3;
    bool stiffness_as_number = false;
};
engines::TwoGrains thrown_pair(const Throw&);

// Largest difference of two runs over the whole way, each over its scale.
struct Apart {
    double force, torque;   // over the peak of each
    double velocity, spin;  // over the speed at the start, over that by R
};
Apart apart(const engines::PairStates& a, const engines::PairStates& b, const engines::TwoGrains&);

}  // namespace verify
