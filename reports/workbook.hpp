// SPDX-License-Identifier: MIT
// Tables as a workbook for Excel, LibreOffice and pandas (.xlsx), written by libxlsxwriter. Numbers stay numbers, whatever the
// reader's decimal sign; units stand in a column of their own, never within a cell.
#pragma once

#include "reports/json.hpp"

#include <string>
#include <variant>
#include <vector>

namespace reports {

using Cell = std::variant<std::string, double>;  // a number that is not finite is left empty

struct Sheet {
    std::string name;                       // at most 31 characters, none of []:*?/
    std::vector<std::string> heading;       // [columns]
    std::vector<std::vector<Cell>> rows{};  // [rows][columns]
};

// Throws scaling::InvalidInput where the file cannot be written.
void write_workbook(const std::string& path, const std::vector<Sheet>&);

// The result of `scale` and of `convert adhesion|rolling|damping`, as their JSON has it.
std::vector<Sheet> sheets_of_scale(const Json&);
std::vector<Sheet> sheets_of_convert(const Json&);

// A sheet as CSV, cells with commas or quotes in quotes.
std::string csv_of(const Sheet&);

}  // namespace reports
