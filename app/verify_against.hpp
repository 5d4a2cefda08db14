// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

#include <string>

namespace app {

// `verify --against lammps`: the core beside LAMMPS on the same rules. Without `heaps` it takes
// seconds. Decks, data and dumps stay under `out`. Exit 3 where a figure is outside its bar.
int verify_against(const CommonOptions&, const std::string& out, bool with_heaps,
                   const std::string& command);

}  // namespace app
