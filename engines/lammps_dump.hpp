// SPDX-License-Identifier: MIT
// Text dumps of LAMMPS and LIGGGHTS (`dump custom`), and what our decks for Yade write in their form: frames that follow each other in
// one file. Source: LAMMPS manual, "dump", "dump_modify" (keywords units, time); LIGGGHTS' are the same without ITEM: UNITS and ITEM: TIME.
#pragma once

#include "contact/vec3.hpp"
#include "engines/grain_lines.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace engines {

// In the file's own units.
struct DumpHeading {
    std::int64_t step = 0, grains = -1;
    std::optional<double> time;
    std::optional<std::string> units;  // a style of LAMMPS
    contact::Vec3 low, high;
    std::vector<std::string> columns;
};

// Throws scaling::InvalidInput with file and line where the text is no whole dump.
class DumpLines {
  public:
    explicit DumpLines(Lines lines) : lines_(std::move(lines)) {}

    // Of the next frame; false behind the last one.
    bool next(DumpHeading&);
    // The words of the next grain of that frame, one a column; they last until the next call.
    const std::vector<std::string_view>& row();
    const Lines& lines() const { return lines_; }

  private:
    double single(const std::string& what);
    void read_box(DumpHeading&);

    Lines lines_;
    DumpHeading heading_;
    std::size_t frames_ = 0;
    std::vector<std::string_view> words_;
};

// A frame as numbers, whatever they mean; rows in the order of ids where the deck says `dump_modify sort id`.
struct LammpsFrame {
    std::int64_t step;
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;  // shape [grains][columns]

    // Throws std::runtime_error naming the column that is not there.
    std::size_t column(const std::string& name) const;
};

// All frames of what an engine wrote for us. Throws std::runtime_error, also where there is no such file.
std::vector<LammpsFrame> read_lammps_frames(const std::filesystem::path&);

}  // namespace engines
