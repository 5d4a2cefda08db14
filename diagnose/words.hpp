// SPDX-License-Identifier: MIT
// A verdict in plain words, as a powder engineer would say it.
#pragma once

#include "diagnose/verdict.hpp"

#include <string>
#include <vector>

namespace diagnose {

std::string plain_name(const std::string& effect);  // "air drag"

// What the effect does and why it is believed here, a sentence each.
std::vector<std::string> reasons(const std::string& effect, double probability, double gain,
                                 const std::vector<Located>&);

// Sign, variable and shape of what is missing.
std::string described(const MissingEstimate&);

// The whole verdict in a few sentences; `flips`: what would change it.
std::vector<std::string> summary_of(const Verdict&);
std::vector<std::string> flips_of(const Verdict&);

}  // namespace diagnose
