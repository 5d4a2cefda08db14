// SPDX-License-Identifier: MIT
// `similitude advise CASE`: which grain to simulate in place of the powder's (docs/advise.md).
#pragma once

#include "app/common.hpp"

namespace app {

Verb advise_verb(CLI::App&, const std::string& command);

}  // namespace app
