// SPDX-License-Identifier: MIT
// The bed in LAMMPS' language. Its JKR takes the surface energy (w is twice that), its Tsuji
// dashpot `restitution_to_tell`; friction of a JKR contact is capped at mu (F + 2 F_po), as with us.
// LAMMPS manual: pair_style granular, fix wall/gran, compute contact/atom.
#pragma once

#include "engines/bed_engine.hpp"

namespace engines {

BedEngine lammps();

// What LAMMPS and LIGGGHTS have in common.
std::vector<std::string> lammps_like_command(const std::string& program, int threads);
// The number that `damping tsuji` must be told for an impact to have restitution e. Debian's LAMMPS (29 Sep 2021) leaves the root
// of 2 out, so that its dashpots are those of a larger e. 0 where no number gives e, below 0.113.
double restitution_to_tell(double e);

// Lines that run the bed, time it, and print what came of it in one line that starts with "bed:".
std::string timed_runs(const Bed&);
// The wall time of the last run of bed.steps steps and that line; `version_at`: what the line with
// the version begins with.
BedFigures read_lammps_like(const Bed&, const std::string& output, const std::string& version_at);

}  // namespace engines
