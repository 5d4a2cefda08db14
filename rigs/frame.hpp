// SPDX-License-Identifier: MIT
// All grains at one instant, as files hold them. SI throughout.
#pragma once

#include "contact/vec3.hpp"

#include <cstdint>
#include <vector>

namespace rigs {

// Shape of every array: [grains].
struct Frame {
    std::int64_t step = 0;
    double time = 0.0;             // s
    contact::Vec3 low, high;       // m: corners of a box that holds all grains
    std::vector<std::int64_t> id;  // from 1 (LAMMPS has no grain 0), never reused
    std::vector<contact::Vec3> position, velocity, spin;  // m, m/s, rad/s
    std::vector<double> radius, mass;                     // m, kg
    std::vector<std::uint8_t> fixed;                      // 1: glued, never moves
    std::vector<int> type = {};  // as another program's file has it; empty: 1 loose, 2 fixed

    std::size_t count() const { return id.size(); }
    int type_of(std::size_t k) const { return type.empty() ? (fixed[k] ? 2 : 1) : type[k]; }
};

}  // namespace rigs
