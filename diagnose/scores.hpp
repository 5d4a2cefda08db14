// SPDX-License-Identifier: MIT
// How well a hypothesis predicts recordings, in the units of people: NRMSE in per cent, and the curves themselves.
#pragma once

#include "diagnose/candidates.hpp"
#include "diagnose/verdict.hpp"

#include <vector>

namespace diagnose {

// theta of the same hypothesis for another set of recordings: shared unknowns from the fit, what belongs to the others alone
// at the mean of its prior.
Candidate carried_over(const Problem& to, const Candidate&);

// Of all recordings of the problem.
Scores scores(const Problem&, const Noise&, const Candidate& base, const Candidate& extended);
std::vector<PredictedCurve> curves(const Problem&, const Noise&, const Candidate& base,
                                   const Candidate& extended, bool held_out);

// Noise of another set of recordings: as stated there, else as found for the same channel here.
Noise noise_like(const Problem& to, const Problem& known, const Noise&);

// Gaussian log density of each recording of `to` under the candidate, given the noise; sum over its rows.
double log_predictive(const Problem& to, const Noise&, const Candidate&);

}  // namespace diagnose
