// SPDX-License-Identifier: MIT
// Calibration by a surrogate (surrogate.hpp), one batch of runs after the other:
//   1. start       a Latin hypercube, of 64 the one whose nearest runs are furthest apart (Johnson, Moore
//                  & Ylvisaker 1990, J. Stat. Plan. Inference 26, 131)
//   2. answer and  in turns: a run at the best answer so far, and a run where it teaches most about the
//      learning    parameters (teaching.hpp). The answer x makes
//                  sum_j E[(f_j(x) - measured_j)^2] / s_j^2 - 2 log P(a heap forms) least
//   3. confirming  at the answer, with fresh seeds, once it is settled or the budget is spent. It is
//                  settled where the root of E[(f_j - measured_j)^2] is below `settled` s_j for each
//                  target and no run is expected to take away a tenth of what is open
// A batch is decided on by the batches before it alone.
#pragma once

#include "calibrate/identify.hpp"
#include "calibrate/posterior.hpp"

#include <optional>
#include <string>
#include <vector>

namespace calibrate {

struct SurrogateOptions {
    int budget = 34;        // runs in all, those that form no heap too
    int start = 0;          // 0: half the budget, 2 + 2 factors at most
    int batch = 1;          // runs at a time; the answer is run in every batch of two or more
    int confirmations = 1;  // runs
    double settled = 0.5;   // of the standard deviation of a measurement
};

struct Foretold {
    double mean,
        standard_deviation;  // at the answer, unit of the target, without the scatter of a run
};

struct SurrogateResult {
    Eigen::VectorXd answer;  // [factors], in their units
    double forms;            // probability that a heap forms there
    // 95 %, in the units of the factors: whatever the others are, and with the others as in the answer.
    std::vector<statistics::Interval> free, held;  // [factors]
    std::size_t lead;  // the factor that is fixed best by the data with the others held
    std::vector<Foretold> foretold;  // [targets], by the runs before the confirming ones
    std::vector<Foretold> found;     // [targets], by all runs
    std::vector<std::vector<double>> confirmed;  // [targets], of the confirming runs with a heap
    std::vector<std::string> dead;  // factors that move no target by its measurement's deviation
    Identification identification;
    std::vector<std::string> notes;
    bool settled = false;  // before the budget was spent
    int runs = 0, formed = 0;
};

struct SurrogateStep {
    std::vector<Request> requests;          // to be run, in any order; empty: finished
    std::optional<SurrogateResult> result;  // nothing where fewer than two heaps formed
};

SurrogateStep next(const Problem&, const SurrogateOptions&, const std::vector<Run>& history);

// The answer by all runs: coded, [factors].
Eigen::VectorXd best_answer(const Surrogate&, const Posterior&);

}  // namespace calibrate
