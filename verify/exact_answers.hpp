// SPDX-License-Identifier: MIT
// The core against answers that are known: closed forms, and ordinary differential equations that GSL
// integrates to round-off. The expected values share no code with contact/ and dem_min/; each formula is
// written anew from its source.
#pragma once

#include "verify/check.hpp"

#include <vector>

namespace verify {

// All of them, in a few seconds on one thread. The groups: impact, adhesion, friction, flight_and_rolling, surroundings.
std::vector<Check> exact_answers();

std::vector<Check> impact_answers();
std::vector<Check> adhesion_answers();
std::vector<Check> friction_answers();
std::vector<Check> flight_and_rolling_answers();
std::vector<Check> surroundings_answers();

}  // namespace verify
