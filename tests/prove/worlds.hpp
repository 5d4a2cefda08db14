// SPDX-License-Identifier: MIT
// Small experiments for the tests of this folder.
#pragma once

#include "prove/world.hpp"

#include <vector>

inline std::vector<double> evenly(double from, double to, int count) {
    std::vector<double> at;
    for (int k = 0; k < count; ++k) at.push_back(from + (to - from) * k / (count - 1));
    return at;
}

// A glass bead of 4 mm over glass, no air.
inline prove::Setup bead(prove::Rig rig, std::vector<prove::Channel> recorded) {
    prove::Setup s;
    s.rig = rig;
    s.id = "one";
    s.diameter = 4e-3, s.density = 2500.0, s.youngs_modulus = 63e9, s.poisson_ratio = 0.23;
    s.plate_youngs_modulus = 70e9, s.plate_poisson_ratio = 0.22;
    s.recorded = std::move(recorded);
    s.noise.assign(s.recorded.size(), 1.0);
    return s;
}
