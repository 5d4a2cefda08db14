// SPDX-License-Identifier: MIT
// What recomputing a published calibration shows, one computed number and one sentence each. They
// say what the printed numbers can and cannot carry, not whether anybody worked badly: each also
// names the remedy or what was done well.
#pragma once

#include "calibrate/audit.hpp"
#include "calibrate/published.hpp"
#include "calibrate/replay.hpp"
#include "cases/case.hpp"
#include "scaling/finding.hpp"
#include "scaling/scale_study.hpp"

#include <string>
#include <vector>

namespace calibrate {

struct Observation {
    std::string topic;  // "screening", "ascent", "orthogonal test", "experiment", "numerics",
                        // "similarity"
    std::string name;   // snake_case, stable
    double value;       // NaN where it is a reader's remark alone
    std::string unit;   // SI, "deg" or "%"; "1" without
    std::string where;  // in the publication
    scaling::Judgement judgement;
    std::string text;
};

// The screening of a publication as input of audit(): failed responses lie below the smallest one
// that formed, since a heap that had formed would have been read.
AuditInput audit_input(const Published&);

std::vector<Observation> screening_observations(const Published&, const Replay&, const Audit&);

// Ascents, orthogonal test, interpolation, and the experiment behind the target.
std::vector<Observation> refinement_observations(const Published&, const Replay&);

// Numerics and counts, similarity. `input` and `study` are those of the case under its own scheme;
// the study's findings are among them.
std::vector<Observation> scaling_observations(const Published&, const cases::Case&,
                                              const scaling::ScaleInput& input,
                                              const scaling::ScaleStudy& study);

// The whole of it.
struct Replayed {
    Published published;
    Replay replay;
    Audit audit;
    std::vector<Observation> observations;

    // Every printed number comes out again, and the ranking that was concluded can be.
    bool holds() const { return replay.mismatches == 0 && audit.ranking.identifiable; }
};

// `published` of the same case (read_published). Throws scaling::InvalidInput and as audit() and study().
Replayed replayed(Published published, const cases::Case&, const scaling::ScaleInput&);

}  // namespace calibrate
