// SPDX-License-Identifier: MIT
// `similitude measure`: angle of repose, profile, packing and contacts of grains in another program's file (docs/measure.md).
#pragma once

#include "app/common.hpp"

namespace app {

Verb measure_verb(CLI::App&, const std::string& command);

}  // namespace app
