// SPDX-License-Identifier: MIT
// The runs of `simulate` as sheets of a workbook: what was measured, and every channel.
#pragma once

#include "cases/csv.hpp"
#include "reports/workbook.hpp"

#include <string>
#include <vector>

namespace reports {

struct ChannelTable {
    std::string name;  // of the file without .csv: "heap", "heap-grains"
    std::vector<cases::Column> columns;
};

// `runs`, a row a quantity of each run of a run.json, then a sheet a table, headed `name [unit]` as in the CSV. Sheets whose
// names a workbook cannot hold, or holds already, get the nearest that it can.
std::vector<Sheet> sheets_of_runs(const Json& manifest, const std::vector<ChannelTable>&);

}  // namespace reports
