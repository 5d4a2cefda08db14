// SPDX-License-Identifier: MIT
// What the decks of all engines print alike.
#pragma once

#include "engines/bed.hpp"

#include <string>

namespace engines {

// "bed: grains N neighbours X kinetic Y", with "seconds Z" behind it or without. False where the
// line is another one.
bool read_bed_line(const std::string& line, BedFigures&);

// Throws std::runtime_error with the last lines of the output.
[[noreturn]] void throw_unreadable(const std::string& output);

}  // namespace engines
