// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// `verify scaling-map`: which scaling rule keeps which pile (docs/scaling-map.md). Exit 4 where the budget left heaps out, 130
// where a signal came: --resume goes on heap by heap.
Verb scaling_map_verb(CLI::App& verify, const std::string& command);

}  // namespace app
