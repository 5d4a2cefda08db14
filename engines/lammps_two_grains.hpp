// SPDX-License-Identifier: MIT
// Two grains in LAMMPS: led together and apart, or thrown at one another.
#pragma once

#include "engines/lammps_contact.hpp"
#include "engines/lammps_files.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace engines {

struct TwoGrains {
    std::array<dem_min::Grain, 2> grains;
    LammpsContact contact;
    double time_step;  // s
    int steps;         // together, for `led`
    int steps_apart = 0;
    double skin;  // m, margin of LAMMPS' neighbour list
};

// State of one grain after a step: velocities belong to the instant of the positions, and force and
// torque to the positions.
struct GrainState {
    dem_min::Vec3 position, velocity, spin;  // m, m/s, rad/s
    dem_min::Vec3 force, torque;             // N, N m
};
using PairStates = std::vector<std::array<GrainState, 2>>;  // shape [steps + 1]

// Both grains keep the velocities they start with for `steps` and the opposite ones for
// `steps_apart`, whatever the forces.
std::string led_deck(const TwoGrains&);
// Free flight under the forces of the contact alone.
std::string thrown_deck(const TwoGrains&);
// The same over the wall z = 0, which has the grains' own rules.
std::string thrown_at_wall_deck(const TwoGrains&);

// Writes the data file and the deck into `folder`, runs `lmp` there, reads the dump. Throws
// std::runtime_error with what LAMMPS said where it fails.
PairStates run_two_grains(const std::filesystem::path& lmp, const TwoGrains&,
                          const std::string& deck, const std::filesystem::path& folder);

}  // namespace engines
