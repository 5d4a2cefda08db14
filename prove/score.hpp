// SPDX-License-Identifier: MIT
// Keys against verdicts. A case without a verdict (crash, time-out, a file cut short) counts as wrong in every line that it
// belongs to. Which cases a line takes, and what counts as right, is said in docs/prove.md. Intervals: Wilson (1927), J. Am.
// Stat. Assoc. 22, 209, doi:10.1080/01621459.1927.10502953.
#pragma once

#include "prove/verdict.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace prove {

struct Wilson {
    double low, high;
};
// Of `hits` among `count`, 95 %. 0 to 1 where there is none.
Wilson wilson(int hits, int count);

struct Line {
    std::string figure, bar;
    double value = 0.0;              // a share, or the figure itself
    std::optional<Wilson> bounds{};  // of a share
    int count = 0;                   // cases it rests on
    std::optional<bool> met{};       // nothing: told without a bar, or no case
    std::string note{};
};

struct Calibration {
    double expected_error = 0.0;      // over all hypotheses given, ten bins of probability
    double expected_error_top = 0.0;  // over the most probable one of each case
    double brier = 0.0;               // mean over cases of the sum over hypotheses
    struct Bin {
        double probability, frequency;
        int count;
    };
    std::vector<Bin> bins{};
};

// What was concealed -> what was named ("none", "ambiguous", "unknown", "missing", "a + b"), D >= 5.
using Confusion = std::map<std::string, std::map<std::string, int>>;

struct ScoreTable {
    std::vector<Line> lines;
    Confusion confusion;
    Calibration calibration;
    int missing = 0, cases = 0, wrong_names = 0;
};

struct Judgements {
    Verdicts first;                               // the judge's
    Verdicts after{};                             // with the recording that it asked for
    std::vector<Verdicts> other_seeds{};          // for the stability
    std::map<std::string, Verdicts> baselines{};  // "bic", "sparse regression", ...
};

ScoreTable score(const Keys&, const Judgements&);
// Of blind heaps (docs/prove-heaps.md).
ScoreTable heap_score(const Keys&, const Verdicts&);
// Told plainly, a line each, then confusion matrix and reliability.
std::string text(const ScoreTable&);

Calibration calibration(const Keys&, const Verdicts&);
// Named something that does not act, or named on a null.
int wrong_names(const Keys&, const Verdicts&);

}  // namespace prove
