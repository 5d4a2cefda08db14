// SPDX-License-Identifier: MIT
// `diagnose --engine lammps`: the base simulation is LAMMPS' run of the model at its stated values.
#pragma once

#include "cases/case.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace app {

struct LammpsBase {
    bool interrupted;
    std::vector<std::string> statements;  // what ran where, a sentence each
};

// Puts LAMMPS' run of every fitted drop, incline and impact in the place of the user's own run (`simulated`), at the recording's rows, and
// the step that was used, one for all, into model.numerics: what stands there, else a fifth of the shortest that a deck would take. Other rigs keep this tool's model, and a statement says so. Decks stay
// in `folder`/ID-lammps. `show` hears which experiment is next, of how many. Throws scaling::InvalidInput where an experiment has a run of the
// user's own, where no rig has a deck, and for what a deck cannot take.
LammpsBase simulate_base_in_lammps(
    cases::Case&, const std::filesystem::path& folder,
    const std::function<void(std::size_t, std::size_t, const std::string& id)>& show);

}  // namespace app
