// SPDX-License-Identifier: MIT
// The recording that would tell hypotheses apart: among designs on the four rigs, the one in which, recorded beside what
// there is, the nearest two are the most sigma apart (T-optimality: Atkinson & Fedorov 1975, Biometrika 62, 57).
#pragma once

#include "diagnose/candidates.hpp"
#include "diagnose/verdict.hpp"

#include <optional>

namespace diagnose {

// Noise is that of the case for the same channel, else what a careful laboratory has. Nothing where no design helps.
std::optional<NextExperiment> next_experiment(const Problem&, const Noise&,
                                              const std::vector<const Candidate*>& alike,
                                              int threads);

// The problem with the experiments that are held out as if they had been recorded at ordinates like those of the fits: how
// far hypotheses will be apart is asked before they are opened. The Case must outlive the Problem; nothing where none is held out.
struct Planned {
    cases::Case with;
    Problem problem;
    Noise noise;
};
std::unique_ptr<Planned> with_held_out(const Problem&, const Noise&);

}  // namespace diagnose
