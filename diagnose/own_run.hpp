// SPDX-License-Identifier: MIT
// The user's own run of the model (`simulated` in a case) against this tool's.
#pragma once

#include "diagnose/problem.hpp"

#include <string>
#include <vector>

namespace diagnose {

// Fills Channel::own_run_off of the experiments that have a run of the user: that run minus this tool's, both at the stated
// values and numerics, interpolated to the recorded rows; left empty where it is below a tenth of the noise. What is not empty
// belongs to the base model and goes with `numerical_artefact`.
void compare_own_runs(Problem&);

// A sentence for each experiment with a run of the user: by how much the two differ.
std::vector<std::string> words_of_own_runs(const Problem&);

}  // namespace diagnose
