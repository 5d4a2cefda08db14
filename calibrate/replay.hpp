// SPDX-License-Identifier: MIT
// A published calibration computed again from its own runs, and every printed digit compared.
#pragma once

#include "calibrate/effects.hpp"
#include "calibrate/published.hpp"
#include "scaling/scale_study.hpp"

#include <string>
#include <vector>

namespace calibrate {

struct Recomputed {
    std::string table, what;
    Printed printed;
    double value;
    bool agrees;
};

// Of one factor of the ascent: the step that was taken, and the one that goes along the effects.
struct AscentStep {
    std::string factor;
    double taken, by_effects;  // in the factor's unit
};

// response = intercept + slope x through two runs.
struct Line {
    double slope, intercept;
    double solution;    // x at the target
    double at_printed;  // response at the printed x
};

// Rows of the orthogonal table that share the first factor's value: where the response crosses the
// target along the second factor, between the two levels around it.
struct Crossing {
    double first;   // value of the first factor
    double second;  // of the second, at the target
    double slope;   // response per unit of the second, there
};

struct Replay {
    std::vector<Recomputed> digits;
    int mismatches;
    std::vector<LevelMeans> means;
    std::vector<AscentStep> steps;
    Line line;
    AnalysisOfVariance orthogonal;  // its sources are the letters of the factors
    std::vector<Crossing> crossings;
    double pooled_solution;  // second factor at the target by a quadratic through all nine runs
};

// `study`: of the same case, for the time step and the scale number. The steps by effects go with
// the first ascent factor's: in coded units steps are in the ratio of the effects (Box & Wilson
// 1951, J. R. Stat. Soc. B 13, 1).
Replay replay(const Published&, const scaling::ScaleStudy& study);

// 100 |response - target| / target, %.
double relative_error(double response, double target);

// The two-factor table as trials, levels coded between -1 and +1.
Trials trials_of(const PublishedTable&);

}  // namespace calibrate
