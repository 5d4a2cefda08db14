// SPDX-License-Identifier: MIT
#include "app/predictions.hpp"

#include "scaling/errors.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace app {

namespace {

using diagnose::PredictedCurve;

[[noreturn]] void refuse_folder(const std::string& path) {
    throw scaling::InvalidInput(scaling::mistake(path, "a place that cannot be written",
                                                 "must be writable",
                                                 "choose another folder for --predict"));
}

struct Row {
    double at;
    std::string branch;  // empty where there is none

    bool operator==(const Row&) const = default;
};

Row row_of(const PredictedCurve& c, std::size_t k) {
    return {c.at[k], k < c.branch.size() ? c.branch[k] : ""};
}

// Channels may lack rows: the rows of all, each channel's in its own order.
std::vector<Row> rows_of(const std::vector<const PredictedCurve*>& curves) {
    std::vector<Row> rows;
    for (const PredictedCurve* c : curves) {
        auto next = rows.begin();
        for (std::size_t k = 0; k < c->at.size(); ++k) {
            const auto found = std::find(next, rows.end(), row_of(*c, k));
            next = found != rows.end() ? found + 1 : rows.insert(next, row_of(*c, k)) + 1;
        }
    }
    return rows;
}

// `values` of a curve where they stand among all rows.
std::vector<double> placed(const std::vector<Row>& rows, const PredictedCurve& c,
                           const std::vector<double>& values) {
    std::vector<double> out(rows.size(), std::numeric_limits<double>::quiet_NaN());
    auto next = rows.begin();
    for (std::size_t k = 0; k < std::min(c.at.size(), values.size()); ++k) {
        next = std::find(next, rows.end(), row_of(c, k));
        if (next == rows.end()) break;
        out[static_cast<std::size_t>(next - rows.begin())] = values[k];
        ++next;
    }
    return out;
}

std::vector<cases::Column> table_of(const std::vector<const PredictedCurve*>& curves) {
    const std::vector<Row> rows = rows_of(curves);
    const PredictedCurve& first = *curves.front();
    std::vector<cases::Column> table = {{first.ordinate, first.ordinate_unit}};
    for (const Row& row : rows) table[0].values.push_back(row.at);
    if (!first.branch.empty()) {
        table.push_back({"branch", ""});
        for (const Row& row : rows) table[1].words.push_back(row.branch);
    }
    for (const PredictedCurve* c : curves) {
        table.push_back({c->channel + "_base", c->unit, placed(rows, *c, c->base)});
        table.push_back({c->channel + "_extended", c->unit, placed(rows, *c, c->extended)});
    }
    return table;
}

}  // namespace

std::vector<std::pair<std::string, std::vector<cases::Column>>> prediction_tables(
    const std::vector<PredictedCurve>& curves) {
    std::vector<std::pair<std::string, std::vector<const PredictedCurve*>>> groups;
    for (const PredictedCurve& c : curves) {
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const auto& g) { return g.first == c.experiment; });
        if (group == groups.end()) group = groups.insert(group, {c.experiment, {}});
        group->second.push_back(&c);
    }
    std::vector<std::pair<std::string, std::vector<cases::Column>>> tables;
    for (const auto& [id, members] : groups) tables.emplace_back(id, table_of(members));
    return tables;
}

void make_folder(const std::string& folder) {
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    if (!std::filesystem::is_directory(folder)) refuse_folder(folder);
}

void write_predictions(const std::string& folder, const std::vector<PredictedCurve>& curves) {
    make_folder(folder);
    for (const auto& [id, table] : prediction_tables(curves)) {
        const std::string path = (std::filesystem::path(folder) / (id + ".csv")).string();
        try {
            cases::write_csv(path, table);
        } catch (const std::runtime_error&) {
            refuse_folder(path);
        }
    }
}

}  // namespace app
