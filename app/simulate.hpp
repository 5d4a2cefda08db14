// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// `simulate CASE`: runs the case's experiments and writes channels, grains and a manifest. Exit 4
// where a heap had not come to rest when it was given up, 130 where a signal came: --resume then
// goes on.
Verb simulate_verb(CLI::App& app, const std::string& command);

}  // namespace app
