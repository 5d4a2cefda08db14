// SPDX-License-Identifier: MIT
#include "reports/workbook.hpp"

#include "scaling/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <xlsxwriter.h>

namespace reports {
namespace {

[[noreturn]] void cannot_write(const std::string& path, const std::string& why) {
    throw scaling::InvalidInput(scaling::mistake(
        path, why, "must be a workbook that can be written", "choose another file or folder"));
}

void write_cell(lxw_worksheet* sheet, std::size_t row, std::size_t column, const Cell& cell) {
    const auto r = static_cast<lxw_row_t>(row);
    const auto c = static_cast<lxw_col_t>(column);
    if (const auto* text = std::get_if<std::string>(&cell))
        worksheet_write_string(sheet, r, c, text->c_str(), nullptr);
    else if (std::isfinite(std::get<double>(cell)))
        worksheet_write_number(sheet, r, c, std::get<double>(cell), nullptr);
}

std::size_t width_of(const Sheet& s, std::size_t column) {
    std::size_t width = s.heading[column].size();
    for (const auto& row : s.rows)
        if (const auto* text = std::get_if<std::string>(&row[column]))
            width = std::max(width, text->size());
    return std::min<std::size_t>(width + 2, 60);
}

Cell cell_of(const Json& j) {
    if (j.is_number()) return j.get<double>();
    if (j.is_boolean()) return std::string(j.get<bool>() ? "yes" : "no");
    if (j.is_string()) return j.get<std::string>();
    return std::nan("");
}

Cell cell_at(const Json& j, const char* key) {
    return j.is_object() && j.contains(key) ? cell_of(j.at(key)) : Cell(std::nan(""));
}

}  // namespace

void write_workbook(const std::string& path, const std::vector<Sheet>& sheets) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code ignored;  // libxlsxwriter says what is wrong
    if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
    lxw_workbook* book = workbook_new(path.c_str());
    if (book == nullptr) cannot_write(path, "no memory");
    lxw_format* bold = workbook_add_format(book);
    format_set_bold(bold);
    for (const Sheet& s : sheets) {
        lxw_worksheet* sheet = workbook_add_worksheet(book, s.name.c_str());
        if (sheet == nullptr) {
            workbook_close(book);
            cannot_write(path, "a sheet named \"" + s.name + "\"");
        }
        for (std::size_t k = 0; k < s.heading.size(); ++k) {
            const auto column = static_cast<lxw_col_t>(k);
            worksheet_set_column(sheet, column, column, static_cast<double>(width_of(s, k)),
                                 nullptr);
            worksheet_write_string(sheet, 0, column, s.heading[k].c_str(), bold);
        }
        worksheet_freeze_panes(sheet, 1, 0);
        for (std::size_t r = 0; r < s.rows.size(); ++r)
            for (std::size_t k = 0; k < s.rows[r].size(); ++k)
                write_cell(sheet, r + 1, k, s.rows[r][k]);
    }
    const lxw_error error = workbook_close(book);
    if (error != LXW_NO_ERROR) cannot_write(path, lxw_strerror(error));
}

std::vector<Sheet> sheets_of_scale(const Json& j) {
    Sheet factors{"factors", {"quantity", "exponent of h", "factor", "factor's unit"}};
    for (const auto& [name, f] : j.at("factors").items())
        factors.rows.push_back({name, cell_at(f, "exponent"), cell_at(f, "factor"),
                                std::string("scaled over original")});
    Sheet groups{"groups", {"group", "formula", "original", "scaled", "ratio", "status", "unit"}};
    for (const auto& [name, g] : j.at("groups").items())
        groups.rows.push_back({name, cell_at(g, "formula"), cell_at(g, "original"),
                               cell_at(g, "scaled"), cell_at(g, "ratio"), cell_at(g, "status"),
                               std::string("1")});
    std::vector<Sheet> sheets{std::move(factors), std::move(groups)};
    if (!j.contains("adhesion") || !j.at("adhesion").is_object()) return sheets;
    const Json& a = j.at("adhesion");
    Sheet adhesion{"adhesion", {"quantity", "unit", "original", "scaled"}};
    const std::pair<const char*, const char*> rows[] = {{"work_of_adhesion", "J/m^2"},
                                                        {"surface_energy", "J/m^2"},
                                                        {"pull_off_force", "N"},
                                                        {"pull_off_in_grain_weights", "1"}};
    for (const auto& [name, unit] : rows)
        adhesion.rows.push_back({std::string(name), std::string(unit),
                                 cell_at(a.value("original", Json()), name),
                                 cell_at(a.value("scaled", Json()), name)});
    adhesion.rows.push_back({std::string("invariant"), std::string(), cell_at(a, "invariant"),
                             cell_at(a, "invariant")});
    sheets.push_back(std::move(adhesion));
    return sheets;
}

std::vector<Sheet> sheets_of_convert(const Json& j) {
    Sheet s{j.at("what").get<std::string>(),
            {"role", "convention", "engine", "parameter", "value", "unit", "pull-off force [N]",
             "pull-off in grain weights [1]", "work of adhesion [J/m^2]", "differs", "source"}};
    const auto add = [&](const char* role, const Json& c) {
        Cell unit = cell_at(c, "unit");
        if (!std::holds_alternative<std::string>(unit)) unit = std::string("1");
        s.rows.push_back({std::string(role), cell_at(c, "name"), cell_at(c, "engine"),
                          cell_at(c, "parameter"), cell_at(c, "value"), unit,
                          cell_at(c, "pull_off_force"), cell_at(c, "pull_off_in_grain_weights"),
                          cell_at(c, "work_of_adhesion"), cell_at(c, "differs"),
                          cell_at(c, "source")});
    };
    if (j.contains("from")) add("from", j.at("from"));
    for (const Json& c : j.at("to")) add("to", c);
    if (j.contains("unpublished"))
        for (const Json& u : j.at("unpublished"))
            s.rows.push_back({std::string("to"), cell_at(u, "name"), cell_at(u, "engine"),
                              std::string(), std::nan(""), std::string(), std::nan(""),
                              std::nan(""), std::nan(""), cell_at(u, "instead"), std::string()});
    return {s};
}

std::string csv_of(const Sheet& s) {
    const auto quoted = [](std::string text) {
        if (text.find_first_of(",\"\n") == std::string::npos) return text;
        for (std::size_t k = 0; (k = text.find('"', k)) != std::string::npos; k += 2)
            text.insert(k, 1, '"');
        return fmt::format("\"{}\"", text);
    };
    std::string csv;
    for (std::size_t k = 0; k < s.heading.size(); ++k) {
        if (k > 0) csv += ',';
        csv += quoted(s.heading[k]);
    }
    csv += '\n';
    for (const auto& row : s.rows) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            if (k > 0) csv += ',';
            if (const auto* text = std::get_if<std::string>(&row[k]))
                csv += quoted(*text);
            else if (std::isfinite(std::get<double>(row[k])))
                csv += fmt::format("{}", std::get<double>(row[k]));
        }
        csv += '\n';
    }
    return csv;
}

}  // namespace reports
