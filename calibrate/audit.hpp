// SPDX-License-Identifier: MIT
// The audit of a two-level screening: what its runs, failed ones included, can say of the factors.
// Nothing here knows a particular study.
#pragma once

#include "calibrate/effects.hpp"
#include "calibrate/failed_runs.hpp"
#include "calibrate/identifiability.hpp"
#include "calibrate/ranking.hpp"

namespace calibrate {

struct AuditInput {
    Trials trials;
    std::vector<std::string> claimed;  // order of effects that was concluded; may be empty
    std::vector<double> impute;        // values for failed responses
    double bound;                      // a failed response lies below it
};

struct Audit {
    int runs, failed, terms;
    int planned_rank, rank;  // of [1 X], with and without the failed runs
    double planned_d_efficiency, d_efficiency;
    bool planned_orthogonal;
    std::vector<NullVector> null_vectors;  // of the runs that formed
    std::vector<bool> estimable;           // [terms]
    std::vector<std::string> estimable_pairs;
    std::vector<Alias> aliases;  // of the planned design
    // Runs that formed. `fits`: one of full rank; else, for one null vector, one for each factor
    // in it that may be left out: all have the same residuals.
    std::vector<LevelMeans> means;
    std::vector<EffectFit> fits;
    AnalysisOfVariance variance;
    // The effect that the planned design would have found with probability 0.8, with the spread of
    // the fits; 0 without degrees of freedom.
    double detectable;
    Ranking ranking;
    // Empty without failed runs.
    std::vector<Imputed> imputed;
    std::vector<std::optional<double>> sign_changes;  // [factors]
    std::vector<ImpliedRange> implied;
    std::optional<CensoredFit> censored;
    std::optional<Feasibility> feasibility;
};

// The censored fit has a prior only where the formed runs have not full rank: a coded slope of
// standard deviation half the range of the responses.
Audit audit(const AuditInput&);

}  // namespace calibrate
