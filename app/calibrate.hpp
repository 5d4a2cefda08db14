// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// A calibration that was published beside the case, computed again and audited.
Verb calibrate_verb(CLI::App& app, const std::string& command);

}  // namespace app
