// SPDX-License-Identifier: MIT
// What the readers of grain files share: lines with their numbers, cells, and a row of a table that becomes a grain.
#pragma once

#include "engines/grain_file.hpp"

#include <array>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace engines {

[[noreturn]] void refuse(const std::string& where, const std::string& got, const std::string& rule,
                         const std::string& remedy);

// One line in memory at a time. Line ends of Windows and a byte-order mark are taken off.
class Lines {
  public:
    explicit Lines(const std::string& path);  // throws where it cannot be read

    bool next();  // false behind the last line
    void put_back() { again_ = true; }
    const std::string& text() const { return text_; }
    std::string at() const;  // "pile.dump:12"
    const std::string& path() const { return path_; }

    // The next line; throws where the file ends, `what` being cut off.
    const std::string& need(const std::string& what);
    // A finite number, all of `text`, which stands in this line and means `what`.
    double number(std::string_view text, std::string_view what) const;

  private:
    std::string path_, text_;
    std::ifstream in_;
    std::size_t number_ = 0;
    bool again_ = false;
};

// Pieces between blanks; between commas, without blanks and quotes around each.
void split_words(std::string_view line, std::vector<std::string_view>& words);
void split_cells(std::string_view line, std::vector<std::string_view>& cells);

// A finite number and nothing else.
bool is_number(std::string_view text);

// What a column can mean. `scaled`: a share of the box; `volume`: of the grain.
enum class Slot : std::size_t {
    id,
    type,
    x,
    y,
    z,
    scaled_x,
    scaled_y,
    scaled_z,
    vx,
    vy,
    vz,
    wx,
    wy,
    wz,
    radius,
    diameter,
    volume,
    mass,
    density,
    unused
};
constexpr std::size_t slot_count = static_cast<std::size_t>(Slot::unused);

struct Column {
    Slot slot;
    double factor;     // to SI
    std::string name;  // as the file has it
};

// Turns rows of a table with these columns into grains. The file's columns must hold a place, and a size unless one is stated.
class Table {
  public:
    Table(std::vector<Column>, const GrainOptions&, const std::string& where);

    void begin(GrainFrame&) const;  // empty, with what the columns hold
    // `values`: [columns], in the file's own units; those of unused columns do not matter. `where` is asked for a message only.
    using Where = std::function<std::string()>;
    void add(GrainFrame&, const std::vector<double>& values, const Where& where) const;
    const std::vector<Column>& columns() const { return columns_; }

  private:
    double size_of(const std::array<double, slot_count>& row, const Where& where) const;
    bool has(Slot) const;
    std::vector<Column> columns_;
    const GrainOptions& options_;
};

// Corners of the smallest box around all grains, joined with what `low` and `high` hold where `box` is true.
void enclose(rigs::Frame&, bool box);

// The factor from the file's own to SI of what a column holds.
double factor_of(Slot, const FileUnits&);

// One maker for each format; told by open_grains.
std::unique_ptr<GrainReader> read_lammps_dump(Lines, const GrainOptions&);
std::unique_ptr<GrainReader> read_lammps_data(Lines, const GrainOptions&);
std::unique_ptr<GrainReader> read_edem_csv(Lines, const GrainOptions&);
std::unique_ptr<GrainReader> read_csv(Lines, const GrainOptions&);
std::unique_ptr<GrainReader> read_mercury_data(Lines, const GrainOptions&);
std::unique_ptr<GrainReader> read_yade_text(Lines, const GrainOptions&);

}  // namespace engines
