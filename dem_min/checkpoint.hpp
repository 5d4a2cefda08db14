// SPDX-License-Identifier: MIT
// The moving part of a simulation on disk: grains, planes, shells, contacts with their whole history, sums, clock. Laws, meshes and
// settings are not in it: they come from the case again. A run that goes on from a checkpoint gives the bits of one that
// was never interrupted (the neighbour list is made anew, which changes no force).
#pragma once

#include "dem_min/simulation.hpp"

#include <filesystem>

namespace dem_min {

// Written to `file`.tmp and renamed, so that an interrupt never leaves half a checkpoint.
void write_checkpoint(const Simulation&, const std::filesystem::path& file);

// Fills the moving part of `simulation`. Throws scaling::InvalidInput if the file is not a whole checkpoint of this format.
void read_checkpoint(Simulation& simulation, const std::filesystem::path& file);

}  // namespace dem_min
