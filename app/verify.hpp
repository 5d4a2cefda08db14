// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// `verify [CASE]`: exact answers, then scaled heaps against reference heaps. Exit 3 where a check
// fails or the heaps differ, 4 where the seeds do not decide, 130 where a signal came: --resume
// then takes up the heaps that were finished.
Verb verify_verb(CLI::App& app, const std::string& command);

}  // namespace app
