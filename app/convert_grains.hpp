// SPDX-License-Identifier: MIT
// `similitude convert grains`: frames of other programs' files in the formats that yet others open (docs/formats.md).
#pragma once

#include "app/common.hpp"

namespace app {

// A sub-command of `convert`.
Verb convert_grains_verb(CLI::App& convert);

}  // namespace app
