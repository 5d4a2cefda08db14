// SPDX-License-Identifier: MIT
// Calibration as Niu et al. (2026), Coatings 16, 1016, section 4.5 do it, against the first target:
//   1. screening   Plackett-Burman, 12 runs (more than 11 factors: 16 and up); effect = mean at the
//                  high minus mean at the low level, over the runs that formed a heap (equation 32)
//   2. ascent      the three factors of largest effect move together, in six runs of equal steps,
//                  from their screening level to the end of their range, towards the target; the
//                  others at the middle of their levels. It ends early one run after the target is
//                  passed, or after two runs in a row without a heap, never before the third
//   3. ascent      where the first met a missing heap and did not pass the target: the third factor
//                  goes to the middle of its levels, the two strongest ascend alone
//   4. orthogonal  3 x 3 in the two strongest factors, around the run nearest to the target, levels
//                  from its neighbours on the ascent (first two columns of L9); runs there are reused
//   5. line        between two neighbours of the 3 x 3 on both sides of the target that differ in one
//                  factor, the pair with the smallest sum of errors; else on the ascent
//   6. confirming run there, or several
// Runs without a heap are dropped from the effects, as the paper does. That can leave the effects
// without a unique value (docs/calibrate-roads.md); surrogate_road.hpp keeps what they say.
#pragma once

#include "calibrate/problem.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace calibrate {

struct PaperOptions {
    // [factors], in their units. Empty: low end and twice the low end, or the middle of the range
    // where twice does not lie in it.
    std::vector<std::array<double, 2>> screening_levels{};
    int confirmations = 1;  // runs, each with a fresh seed
};

struct Effect {
    std::string factor;
    double value;  // unit of the target; 0 where all heaps that formed are at one level
};

struct Line {  // target = slope * factor + intercept
    std::string factor;
    double slope, intercept;
};

struct PaperResult {
    std::vector<Effect> ranking;            // largest first
    std::optional<Eigen::VectorXd> answer;  // [factors]; nothing: no heap in any run
    std::optional<Line> line;               // nothing: interpolated on the ascent, or not at all
    std::optional<double> predicted;        // at the answer, unit of the target
    std::vector<double> confirmed;          // those of the confirming runs that formed a heap
    bool passed = false;                    // the target lies between two runs
    std::vector<std::string> notes;         // what was dropped, what was decided and why
    int runs = 0;
};

struct PaperStep {
    std::vector<Request> requests;  // to be run, in any order; empty: finished
    std::optional<PaperResult> result;
};

// Runs that the road may take at most, for an estimate of the time left.
int most_runs(const Problem&, const PaperOptions&);

PaperStep next(const Problem&, const PaperOptions&, const std::vector<Run>& history);

}  // namespace calibrate
