// SPDX-License-Identifier: MIT
#include "reports/run_sheets.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace reports {
namespace {

struct Quantity {
    const char *name, *unit;  // as the result of a run has it
};
constexpr Quantity quantities[] = {{"at_rest", ""},       {"formed", ""},
                                   {"settled", ""},       {"ending", ""},
                                   {"settled_at", "s"},   {"packing_fraction", "1"},
                                   {"coordination", "1"}, {"grains_fed", "1"},
                                   {"grains_lost", "1"},  {"grains_in_funnel", "1"},
                                   {"slept", "1"},        {"slept_while_fed", "1"},
                                   {"impacts", "1"},      {"rows", "1"},
                                   {"steps", "1"},        {"time_step", "s"},
                                   {"base_radius", "m"},  {"grain_diameter", "m"},
                                   {"hash", ""},          {"note", ""}};

Cell cell_of(const Json& j) {
    if (j.is_number()) return j.get<double>();
    if (j.is_boolean()) return std::string(j.get<bool>() ? "yes" : "no");
    if (j.is_string()) return j.get<std::string>();
    return std::nan("");
}

void add_run(Sheet& sheet, const Json& run) {
    const auto add = [&](const std::string& name, const Json& value, const char* unit) {
        sheet.rows.push_back({cell_of(run.at("experiment")), cell_of(run.at("rig")), name,
                              cell_of(value), std::string(unit)});
    };
    const Json& result = run.at("result");
    add("finished", run.at("finished"), "");
    add("wall_time", run.at("wall_time"), "s");
    if (result.contains("angle_of_repose"))
        for (const auto& [estimator, angle] : result.at("angle_of_repose").items()) {
            add("angle_of_repose." + estimator, angle.at("angle"), "rad");
            if (angle.contains("spread"))
                add("angle_of_repose." + estimator + ".spread", angle.at("spread"), "rad");
        }
    if (result.contains("quantities"))
        for (const auto& [name, q] : result.at("quantities").items())
            add(name, q.at("value"), q.at("unit").get<std::string>().c_str());
    for (const Quantity& q : quantities)
        if (result.contains(q.name)) add(q.name, result.at(q.name), q.unit);
    if (!result.contains("engine")) return;
    for (const char* key : {"name", "version", "ranks"})
        add(std::string("engine.") + key, result.at("engine").at(key),
            std::string(key) == "ranks" ? "1" : "");
}

Sheet sheet_of(const ChannelTable& table, const std::string& name) {
    Sheet sheet{name, {}};
    std::size_t rows = 0;
    for (const cases::Column& c : table.columns) {
        sheet.heading.push_back(c.unit.empty() ? c.name : fmt::format("{} [{}]", c.name, c.unit));
        rows = std::max({rows, c.values.size(), c.words.size()});
    }
    for (std::size_t r = 0; r < rows; ++r) {
        std::vector<Cell> row;
        for (const cases::Column& c : table.columns)
            row.push_back(c.words.empty() ? Cell(c.values[r]) : Cell(c.words[r]));
        sheet.rows.push_back(std::move(row));
    }
    return sheet;
}

// Excel: at most 31 characters, none of []:*?/\, and capitals do not make another name.
std::string sheet_name(std::string wanted, const std::vector<Sheet>& taken) {
    for (char& c : wanted)
        if (std::string("[]:*?/\\'").find(c) != std::string::npos) c = '_';
    const auto lower = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return text;
    };
    for (int k = 1;; ++k) {
        const std::string end = k == 1 ? "" : fmt::format("~{}", k);
        const std::string name = wanted.substr(0, 31 - end.size()) + end;
        if (std::none_of(taken.begin(), taken.end(),
                         [&](const Sheet& s) { return lower(s.name) == lower(name); }))
            return name;
    }
}

}  // namespace

std::vector<Sheet> sheets_of_runs(const Json& manifest, const std::vector<ChannelTable>& tables) {
    std::vector<Sheet> sheets{{"runs", {"experiment", "rig", "quantity", "value", "unit"}}};
    for (const Json& run : manifest.at("runs")) add_run(sheets.front(), run);
    for (const ChannelTable& table : tables)
        sheets.push_back(sheet_of(table, sheet_name(table.name, sheets)));
    return sheets;
}

}  // namespace reports
