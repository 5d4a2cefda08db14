// SPDX-License-Identifier: MIT
// What `model` may hold: the physics by name and the parameters by name. Meanings: docs/case.md.
#pragma once

#include "cases/domain.hpp"

#include <string>
#include <vector>

namespace cases {

// One name of `model.physics` and the parameters that it cannot do without.
struct Effect {
    std::string name;
    std::vector<std::string> needs;
};

struct ParameterRule {
    std::string name;
    std::string unit;  // SI; empty: any unit (the offset of a recorded channel)
    Domain domain;
};

const std::vector<Effect>& effects();  // gravity and the contact laws among them
const std::vector<ParameterRule>& parameter_rules();

std::vector<std::string> effect_names();
std::vector<std::string> parameter_names();

}  // namespace cases
