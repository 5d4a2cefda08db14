// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// `export CASE --engine lammps --out DIR`: a pile as a deck that another engine runs, with a script for SLURM where it is asked for.
Verb export_verb(CLI::App& app, const std::string& command);

}  // namespace app
