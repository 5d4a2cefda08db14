// SPDX-License-Identifier: MIT
// What the messages of this room share: how a value is shown and which known name was meant.
#pragma once

#include <string>
#include <vector>

namespace cases {

// In quotes, on one line, of at most 80 bytes: control characters become '?', the rest "...".
std::string in_quotes(const std::string& text);

// The nearest of `known`, or "" where none is near enough to be what was meant. A letter of the wrong case counts half
// an edit; ties go to the first.
std::string nearest(const std::string& written, const std::vector<std::string>& known);

// "did you mean \"NAME\"?" where one is near, else "known: a, b, c".
std::string suggestion(const std::string& written, const std::vector<std::string>& known);

}  // namespace cases
