// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// `photo IMAGE`: angle of repose and profile of a heap in a photograph. Exit 4 where none can be read from it.
Verb photo_verb(CLI::App& app, const std::string& command);

}  // namespace app
