// SPDX-License-Identifier: MIT
// Which known name a mistyped one was meant to be.
#pragma once

#include <string>
#include <vector>

namespace scaling {

// The known name with the fewest edited characters (the first of equals); empty where `known` is.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

// "a, b, c"
std::string joined(const std::vector<std::string>& names);

}  // namespace scaling
