// SPDX-License-Identifier: MIT
// The names that a mismatch may have, their evidence and probability.
#pragma once

#include "diagnose/judge.hpp"

#include <string>
#include <vector>

namespace diagnose {

// A name with all that carries it: the variants of a single, a pair in either order, the forces along each variable.
struct Group {
    std::vector<std::string> effects;
    const Candidate* best = nullptr;
    double log_weight = -1e300;  // log of prior times evidence
    double probability = 0.0;
};

// What is believed before any recording: nothing left out, something unknown, or one of these effects. Pairs are not listed.
std::vector<Hypothesis> prior_hypotheses(const std::vector<std::string>& effects);

// Falling log_weight. Priors: docs/diagnose.md.
std::vector<Group> groups_of(const Judge&);

}  // namespace diagnose
