// SPDX-License-Identifier: MIT
// JSON file -> Value. The only file pair of this room that sees the JSON library.
#pragma once

#include "cases/value.hpp"

#include <string>

namespace cases {

// The object in the file. Throws scaling::InvalidInput where the file cannot be read, is no JSON (with line and column),
// holds a key twice in one object, is nested deeper than 32, or is no object.
Value read_json(const std::string& path);

}  // namespace cases
