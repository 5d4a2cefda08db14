// SPDX-License-Identifier: MIT
// What can be left out of the four rigs, as unknowns of a fit: names and parameters of docs/effects.md, ranges of this room.
#pragma once

#include "prove/fit.hpp"

#include <string>
#include <vector>

namespace prove {

struct Term {
    std::string effect;
    std::string channel{};            // of a measurement effect
    std::vector<Unknown> unknowns{};  // the first is the strength; buoyancy has none
    bool micro_slip = false;          // switches it on
};

double smallest_radius(const std::vector<Setup>&);  // m
double fastest(const std::vector<Setup>&);          // m/s, that any experiment states or falls to

// All that can act in these experiments (one rig) and is not in `listed`. Ranges follow from the grains: the charge from the
// breakdown of air, the bridge from the size, offsets from what is recorded.
std::vector<Term> terms(const std::vector<Setup>&, const std::vector<std::string>& listed);

// The world with the term at absent strength, ready for its unknowns.
void enable(const Term&, World&);

// SI unit of a parameter by its name in a verdict; "" for the offset.
std::string unit_of_parameter(const std::string& name);

// Ranges of the recorded channels over all experiments, from a prediction of the shape of predict(). [channels]
std::vector<double> channel_ranges(const std::vector<Setup>&, const Eigen::VectorXd& predicted);

}  // namespace prove
