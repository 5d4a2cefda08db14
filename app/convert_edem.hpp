// SPDX-License-Identifier: MIT
// `similitude convert edem`: what one types into EDEM for a case (docs/formats.md).
#pragma once

#include "app/common.hpp"

namespace app {

// A sub-command of `convert`.
Verb convert_edem_verb(CLI::App& convert);

}  // namespace app
