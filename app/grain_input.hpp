// SPDX-License-Identifier: MIT
// Options of the verbs that read grains out of other programs' files.
#pragma once

#include "engines/grain_file.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace app {

struct GrainInput {
    std::string path, format;
    std::string units, length_unit, time_unit, mass_unit;
    std::string diameter, density, fixed_type;
    std::string frame = "last";
};

// All but the path and the format, whose names are the verb's.
void add_grain_input(CLI::App&, GrainInput&);

// Throws scaling::InvalidInput. `format_option` is what the verb calls it.
engines::GrainOptions grain_options(const GrainInput&, const std::string& format_option);

// Which frame is asked for, counted from 0; nothing for the last one. Throws scaling::InvalidInput.
std::optional<std::size_t> frame_wanted(const std::string& frame);

struct ChosenFrame {
    engines::GrainFrame grains;
    std::size_t number = 0;  // from 0
    engines::GrainFormat format{};
};

// The frame that is asked for. Throws scaling::InvalidInput where the file has no such frame.
ChosenFrame read_frame(const GrainInput&, const std::string& format_option);

}  // namespace app
