// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// `convert adhesion|rolling|damping`: the number that another engine needs for the same pull-off force, the same largest rolling
// torque, the same restitution. Exit 5 where a target cannot mean it.
Verb convert_verb(CLI::App& app, const std::string& command);

}  // namespace app
