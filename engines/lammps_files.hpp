// SPDX-License-Identifier: MIT
// What LAMMPS reads and leaves: a data file of spheres, the last grains of a run.
#pragma once

#include "dem_min/particles.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace engines {

// The box that grains may fill; LAMMPS counts as lost what leaves it.
struct Box {
    dem_min::Vec3 low, high;  // m
};

// A file for read_data under atom_style sphere: loose grains have type 1, fixed ones type 2, and
// `types` says how many types there are. Ids from 1 in the order given.
std::string lammps_data(const std::vector<dem_min::Grain>&, const Box&, int types);

// How a deck of a few spheres begins: start.data, one set of `rules` (what follows `pair_coeff * *`), margin of the list in m, step in s.
// LAMMPS' defaults must not throw away a deck's grains (newton on, communication of velocities) nor thin its list.
std::string opening_of_few(double skin, const std::string& rules, double time_step);

// The grains of `final.dump` in `folder`, one frame of `id type x y z vx vy vz omegax omegay omegaz radius` and what else: fixed is what has v_glued 1, or type 2 where there is no such column. Shape of
// `extra`: [grains], the column of that name, where it is asked for. Throws std::runtime_error.
struct FinalGrains {
    std::int64_t step;
    std::vector<dem_min::Grain> grains;
    std::vector<double> extra;
};
FinalGrains read_final_grains(const std::filesystem::path& folder, double density,
                              const std::string& extra = "");

// Of every frame of a file with these columns.
std::vector<FinalGrains> read_grains(const std::filesystem::path&, double density);

}  // namespace engines
