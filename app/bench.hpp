// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// `bench`: our core against other engines on one bed, or with --scaling and --polydisperse against
// itself. Always exit 0 where it ran: a speed is no verdict. 130 where a signal came; nothing is
// kept of a bench that was not finished.
Verb bench_verb(CLI::App& app, const std::string& command);

}  // namespace app
