// SPDX-License-Identifier: MIT
// Grains out of files of other programs (docs/formats.md): one frame at a time, in SI. Nothing is guessed: a file that does not
// say its units or its sizes needs them stated.
#pragma once

#include "rigs/frame.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace engines {

enum class GrainFormat { lammps_dump, lammps_data, edem_csv, csv, mercury_data, yade_text };

// In the order of the enumeration: "lammps_dump" (also LIGGGHTS), "lammps_data", "edem_csv", "csv", "mercury_data", "yade_text".
const std::vector<std::string>& grain_format_names();

// What one of the file's own is in SI; velocities are length/time, densities mass/length^3. LAMMPS' styles si, cgs, micro and nano
// are such sets (its manual, "units"); its lj has no size of its own.
struct FileUnits {
    std::string name;           // "si", or "stated"
    double length, time, mass;  // m, s, kg, > 0
};

// Throws scaling::InvalidInput for a style that is none of si, cgs, micro, nano; `where` stands first in the message.
FileUnits units_named(const std::string& style, const std::string& where);

struct GrainOptions {
    std::optional<GrainFormat> format;        // left out: told by the file's first line
    std::optional<FileUnits> units;           // of files that do not say them
    std::optional<double> length_unit;        // m: of lengths alone, where units have to be no set
    std::optional<double> diameter, density;  // m, kg/m^3: of all grains, where the file has none
    std::vector<int> fixed_types = {};        // types of grains that never move
};

struct GrainFrame {
    rigs::Frame frame;  // velocity and spin are 0, mass is NaN where the file has none
    bool has_time = false, has_velocity = false, has_spin = false, has_mass = false;
    std::vector<std::string> unused;  // columns and sections that were passed over
};

class GrainReader {
  public:
    virtual ~GrainReader() = default;
    GrainReader() = default;
    GrainReader(const GrainReader&) = delete;
    GrainReader& operator=(const GrainReader&) = delete;

    // The next frame in place of what is there; behind the last one false, and that one stays. Throws scaling::InvalidInput: file:line, what stands
    // there, the rule, the remedy.
    virtual bool next(GrainFrame&) = 0;
    virtual GrainFormat format() const = 0;
};

// Throws scaling::InvalidInput where there is no such file or its format cannot be told.
std::unique_ptr<GrainReader> open_grains(const std::string& path, const GrainOptions&);

}  // namespace engines
