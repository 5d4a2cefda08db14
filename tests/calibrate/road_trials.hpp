// SPDX-License-Identifier: MIT
// Both roads on synthetic powders, one trial after the other. "Miss" is the angle that the powder has at
// a road's answer, without scatter, minus the measured one.
#pragma once

#include "calibrate/paper_road.hpp"
#include "calibrate/surrogate_road.hpp"
#include "synthetic_powder.hpp"

#include <vector>

namespace synthetic {

struct PaperTrial {
    int runs;
    double miss_deg;
    bool answered;  // an answer at which a heap forms
    bool passed;    // the target lay between two of its runs
};
// Screening levels as the paper takes them (the low end and twice that), or, `quarters`, at the first
// quarter and the middle of each range (of its logarithm where it has one): more heaps form there.
PaperTrial paper_trial(const Powder&, bool quarters = false);

struct SurrogateTrial {
    int runs;
    double miss_deg;
    bool answered;
    // The optimum lies in the interval. `held`: with all other factors as in the answer, the place where
    // the lead factor gives the true angle; it lies in the 95 % interval, or there is none in the range
    // and the interval reaches the end that is nearest to it. `foretold`: the angle at the answer, without scatter, lies
    // within 1.96 deviations of what was foretold before it was confirmed. `region`: the parameters of
    // the powder lie in the 95 % region of highest posterior density.
    bool held, foretold, region;
    double held_share;  // width of the interval, of the range
    double
        known_share;  // the same for one who knows the powder's formula: what the measurement leaves
};
SurrogateTrial surrogate_trial(const Powder&, const calibrate::SurrogateOptions&);

std::vector<calibrate::Run> history_of(const Powder&, const calibrate::SurrogateOptions&);

}  // namespace synthetic
