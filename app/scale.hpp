// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// `scale CASE`: factors, groups, adhesion, scale number, cost. Exit 5 where the predicted adhesion
// makes no usable grain.
Verb scale_verb(CLI::App& app, const std::string& command);

}  // namespace app
