// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

namespace app {

// `prove --cases N --seed S --out DIR --write-only`: blind cases in DIR/cases, their keys in DIR/keys.
Verb prove_verb(CLI::App& app, const std::string& command);

}  // namespace app
