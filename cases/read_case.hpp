// SPDX-License-Identifier: MIT
#pragma once

#include "cases/case.hpp"

#include <string>

namespace cases {

// Reads a case from its folder, or from the JSON file itself. Recordings stand relative to that
// file. Throws scaling::InvalidInput, one line: place in the input, value, rule, remedy. The first
// mistake ends the reading.
Case read_case(const std::string& path);

}  // namespace cases
