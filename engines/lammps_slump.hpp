// SPDX-License-Identifier: MIT
// Many grains that fall and slump under gravity on glued ones, in LAMMPS.
#pragma once

#include "engines/lammps_contact.hpp"
#include "engines/lammps_files.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace engines {

struct Slump {
    std::vector<dem_min::Grain> grains;  // the fixed ones are the base
    LammpsContact contact;
    double gravity;    // m/s^2, along -z
    double time_step;  // s
    std::int64_t steps;
    double skin;  // m, margin of the neighbour list
    Box box;      // a grain that leaves it is gone
};

std::string slump_deck(const Slump&);
std::string slump_data(const Slump&);

// The grains that are left, in the order of their ids.
std::vector<dem_min::Grain> run_slump(const std::filesystem::path& lmp, const Slump&,
                                      const std::filesystem::path& folder, double limit_s);

}  // namespace engines
