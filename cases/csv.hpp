// SPDX-License-Identifier: MIT
// Recordings: CSV with one header row of `name [unit]` or `name (unit)`, in SI once read.
#pragma once

#include <string>
#include <vector>

namespace cases {

struct Column {
    std::string name;  // "z"
    std::string unit;  // of `values`, SI: "m", "rad", "1"; empty where the column holds words
    std::vector<double> values{};      // [rows]; NaN where the cell was empty
    std::vector<std::string> words{};  // [rows] instead of values: `branch`, `estimator`
};

struct Recording {
    std::vector<Column> columns;  // in the order of the file

    std::size_t rows() const;
    bool has(const std::string& name) const;
    const Column& column(
        const std::string& name) const;  // throws scaling::InvalidInput where there is none
    const std::vector<double>& values(const std::string& name) const { return column(name).values; }
};

// Reads the channels of `rig` (cases/rig_table.hpp). Accepts a UTF-8 byte-order mark, CRLF,
// quotes, columns in any order. An empty cell and "nan" are NaN, a row without any value is left out. Throws scaling::InvalidInput for a file that is missing or empty, a column
// that the rig does not have, a unit of another dimension, a cell that is no number, a row that is
// too long or too short, and channels that are missing. A force may be in volts of a photodiode where
// `newtons_per_volt` (deflection sensitivity x stiffness of the cantilever, > 0) is stated; 0: it is not.
Recording read_recording(const std::string& path, const std::string& rig,
                         double newtons_per_volt = 0.0);

// Writes `name [unit]` and the columns as they are (SI), 17 digits where they are needed and no
// more; NaN as an empty cell. Throws std::runtime_error where the file cannot be written.
void write_csv(const std::string& path, const std::vector<Column>& columns);

}  // namespace cases
