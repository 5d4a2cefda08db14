// SPDX-License-Identifier: MIT
// Single figures of the score table: what counts as right, recalls, places, parameters, stability.
#pragma once

#include "prove/score.hpp"

#include <string>
#include <vector>

namespace prove::score_parts {

struct Tally {
    int hits = 0, count = 0;
};

struct Judged {
    const Key* key;
    const Verdict* verdict;                 // nullptr: missing
    const Verdict* after;                   // nullptr: none
    std::vector<std::string> truth, named;  // sorted

    bool right() const;  // exactly what acts was named
    bool wrong() const;  // something was named that does not act; a missing verdict
    bool right_after() const;
    // `ambiguous`, and the truth among the hypotheses that it leaves: those that the next experiment tells apart, or those
    // with a probability of at least 5 %.
    bool ambiguous_with_truth() const;
};

// Points into keys and verdicts, which must outlive it. `after`: with the recording asked for, or nullptr.
std::vector<Judged> judged(const Keys&, const Verdicts& first, const Verdicts* after = nullptr);

template <class Takes, class Right>
Tally tally(const std::vector<Judged>& all, const Takes& takes, const Right& right) {
    Tally t;
    for (const Judged& j : all) {
        if (!takes(j)) continue;
        ++t.count;
        t.hits += right(j) ? 1 : 0;
    }
    return t;
}

// `figure` is a share of `t`, met where it lies between `least` and `most`; 0 and 1: told without a bar.
Line share(const char* figure, const char* bar, const Tally& t, double least, double most);

Line macro_recall(const std::vector<Judged>&);  // D >= 5
Line least_recall(const std::vector<Judged>&);
Line worst_pair(const std::vector<Judged>&);
Confusion confusion(const std::vector<Judged>&);

void places(const std::vector<Judged>&, std::vector<Line>&);
void parameters(const std::vector<Judged>&, std::vector<Line>&);
void stability(const Keys&, const Judgements&, std::vector<Line>&);

// Of two intervals on one axis, in any order of ends.
double overlap_over_union(double a, double b, double c, double d);

}  // namespace prove::score_parts
