// SPDX-License-Identifier: MIT
// What an effect must pass before it is named (docs/diagnose.md): a gate is passed, failed, or untestable with these recordings.
#pragma once

#include "diagnose/judge.hpp"
#include "diagnose/verdict.hpp"

#include <vector>

namespace diagnose {

struct GateInput {
    const Problem& problem;
    const Whitener& whiten;
    const Candidate& base;
    const Candidate& winner;
    double own_p_value;  // of the winner's own test of mismatch
    double
        refined_base_p_value;  // of the user's model run without its numerics; NaN where it has none
};

// Of the `which`-th term of the winner.
std::vector<Gate> gates(const GateInput&, std::size_t which);

// One value of each of the winner's parameters serves all recordings: no term fails `regimes` or `scaling`.
bool serves_all(const GateInput&);

bool passes(const std::vector<Gate>&);  // none failed; range and own_mismatch passed

}  // namespace diagnose
