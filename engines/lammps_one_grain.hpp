// SPDX-License-Identifier: MIT
// The rigs `drop`, `incline` and `impact` in LAMMPS: one grain, or one for each angle, over the wall z = 0 (docs/export.md). One run of a
// deck, so that the wall damps as it is told to. Written for the release of 29 September 2021.
#pragma once

#include "cases/case.hpp"
#include "engines/lammps_pile.hpp"
#include "rigs/forward.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace engines {

// deck.in, start.data and, for a drop or an incline, the steps at which the grain is written, rows.txt. Throws scaling::InvalidInput, which names
// `option`, for another rig, for physics beyond gravity, buoyancy and hertz_mindlin, for Euler steps, and for a restitution below 0.12.
LammpsDeck lammps_one_grain(const cases::Case&, const cases::Experiment&, const rigs::Ordinates&,
                            const std::string& option = "--engine");

bool has_one_grain_deck(const cases::Experiment&);

// The step of that deck, s: model.numerics.time_step, or its own choice.
double lammps_time_step(const cases::Case&, const cases::Experiment&,
                        const std::string& option = "--engine");

struct LammpsCurvesRun {
    std::string release;  // "29 Sep 2021 - Update 2"
    bool interrupted;     // by a signal to us
    double seconds;       // wall time
    std::vector<std::string> command;
    rigs::Curves curves;  // the rig's channels, [ordinates]; none where interrupted
};

// Writes the deck into `folder` and runs it there on one rank. Throws std::runtime_error with LAMMPS' error where it fails.
LammpsCurvesRun run_lammps_one_grain(const std::filesystem::path& lmp, const cases::Case&,
                                     const cases::Experiment&, const rigs::Ordinates&,
                                     const std::filesystem::path& folder);

}  // namespace engines
