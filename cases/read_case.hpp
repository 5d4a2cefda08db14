// SPDX-License-Identifier: MIT
#pragma once

#include "cases/case.hpp"

#include <string>

namespace cases {

// What becomes of the recordings of experiments whose role is held_out.
enum class HeldOut {
    opened,  // read like all others
    sealed   // neither read nor looked for: they may be unreadable or absent
};

// Reads a case from its folder, or from the JSON file itself. Recordings stand relative to that
// file. Throws scaling::InvalidInput, one line: place in the input, value, rule, remedy. The first
// mistake ends the reading.
Case read_case(const std::string& path, HeldOut = HeldOut::opened);

// Reads what was sealed, once: what has been read is left as it is. Throws scaling::InvalidInput as
// reading the case would have.
void open_held_out(Case&);

}  // namespace cases
