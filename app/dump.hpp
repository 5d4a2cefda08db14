// SPDX-License-Identifier: MIT
// Frames of a run on disk, one after the other: ID.lammpstrj and ID.extxyz grow, a VTP frame is a
// file of its own in ID-vtp/, listed in ID.pvd. A frame is whole or absent. Frames stand at fixed
// steps, so that a run that was interrupted leaves the files of one that was not.
#pragma once

#include "contact/vec3.hpp"
#include "dem_min/simulation.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace app {

enum class DumpFormat { lammps, vtp, extxyz };

struct DumpPlan {
    std::vector<DumpFormat> formats;  // in the order of the enumeration; empty: nothing is dumped
    double every = 0.0;               // s of simulated time
};

// From --dump ("lammps,vtp") and --dump-every ("1 ms"), both empty or neither. Throws
// scaling::InvalidInput.
DumpPlan dump_plan(const std::string& formats, const std::string& every);

struct Box {
    contact::Vec3 low, high;  // m
};

struct Dump {
    DumpPlan plan;
    std::filesystem::path folder;
    std::string id;                                    // of the experiment: names the files
    double time_step;                                  // s
    Box box;                                           // of a frame, unless its grains need more
    std::vector<std::int64_t> steps{};                 // of the frames written, [frames]
    std::map<DumpFormat, std::uintmax_t> end_bytes{};  // of a file that grows
};

// Takes the frames of an earlier run away. `every` must not be shorter than a time step.
void begin(Dump&);

// Goes on from what `described` said at a checkpoint: frames written after it are taken away.
// Throws scaling::InvalidInput where it is of another plan or files have been cut meanwhile.
void resume(Dump&, const nlohmann::json& described);
nlohmann::json described(const Dump&);

// The step of the next frame: frame k stands at the step nearest to k `every`, k = 0, 1, ... Far away
// where nothing is dumped.
std::int64_t next_frame(const Dump&);

// Writes a frame, unless the last one is of this very step. Throws std::runtime_error, and leaves no
// part of a frame, where the disk is full.
void add_frame(Dump&, const dem_min::Simulation&);

// The file to open, for each format in turn.
std::vector<std::filesystem::path> files(const Dump&);

}  // namespace app
