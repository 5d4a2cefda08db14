// SPDX-License-Identifier: MIT
#include "cases/csv.hpp"

#include "cases/messages.hpp"
#include "cases/rig_table.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <csv.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <new>
#include <stdexcept>

namespace cases {
namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& got, const std::string& rule,
                         const std::string& remedy) {
    throw scaling::InvalidInput(scaling::mistake(where, got, rule, remedy));
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

using Rows = std::vector<std::vector<std::string>>;

struct Gathered {
    Rows rows;
    std::vector<std::string> row;
};

void take_cell(void* bytes, std::size_t size, void* gathered) {
    static_cast<Gathered*>(gathered)->row.emplace_back(static_cast<const char*>(bytes), size);
}

void take_row(int, void* gathered) {
    Gathered& g = *static_cast<Gathered*>(gathered);
    g.rows.push_back(std::move(g.row));
    g.row.clear();
}

// Cells as written; blank lines are left out.
Rows split(const std::string& path, std::string bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
    csv_parser parser;
    Gathered gathered;
    if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
    const std::size_t read =
        csv_parse(&parser, bytes.data(), bytes.size(), take_cell, take_row, &gathered);
    const bool ended =
        read == bytes.size() && csv_fini(&parser, take_cell, take_row, &gathered) == 0;
    const std::string trouble = ended ? "" : csv_strerror(csv_error(&parser));
    csv_free(&parser);
    if (!ended) {
        refuse(fmt::format("{}: row {}", path, gathered.rows.size() + 1), trouble, "must be CSV",
               "close every quote, and write a quote inside quotes twice");
    }
    return gathered.rows;
}

std::string read_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file.is_open() || std::filesystem::is_directory(path)) {
        refuse(path, "no readable file", "must be a recording",
               "check the name; it stands relative to case.json");
    }
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

struct Heading {
    const ChannelRule* channel;
    std::string si_unit;  // empty: words
    double factor;
};

bool is_voltage(const Unit& unit) {
    const Unit volt = parse_unit("V", "");
    return unit.dimension == volt.dimension && unit.current == volt.current;
}

// "z [mm]", "z (mm)" or "z"
Heading heading(const std::string& written, const RigRule& rig, const std::string& path,
                double newtons_per_volt) {
    const std::string text = trimmed(written);
    const char last = text.empty() ? ' ' : text.back();
    const std::size_t bracket =
        last == ']' ? text.find('[') : (last == ')' ? text.find('(') : std::string::npos);
    const std::string name = trimmed(text.substr(0, bracket));
    const std::string where = path + ": column " + in_quotes(text);
    const ChannelRule* channel = find_channel(rig, name);
    if (channel == nullptr) {
        refuse(where, in_quotes(name), "must be a channel of the rig " + rig.name,
               suggestion(name, channel_names(rig)));
    }
    if (!channel->words.empty()) return {channel, "", 1.0};
    std::string unit;
    if (bracket != std::string::npos) unit = text.substr(bracket + 1, text.size() - bracket - 2);
    const std::string& si_unit = channel->units.front();
    if (unit.empty() && si_unit != "1") {
        refuse(where, "no unit", "must carry its unit",
               "write the header as \"" + name + " [" + si_unit + "]\"");
    }
    for (const std::string& candidate : channel->units) {
        if (parse_unit(candidate, where).dimension == parse_unit(unit, where).dimension) {
            return {channel, candidate, to_si("1 " + unit, parse_unit(candidate, where), where)};
        }
    }
    const bool volts = si_unit == "N" && is_voltage(parse_unit(unit, where));
    if (volts && newtons_per_volt > 0.0)
        return {channel, si_unit, newtons_per_volt * parse_unit(unit, where).factor};
    if (volts) {
        refuse(where, in_quotes(unit), "must be a force: a photodiode's voltage is none by itself",
               "state the conditions deflection_sensitivity (nm/V) and cantilever_stiffness (N/m), "
               "both; force = voltage x sensitivity x stiffness");
    }
    refuse(where,
           fmt::format("{} [{}]", in_quotes(unit),
                       scaling::to_string(parse_unit(unit, where).dimension)),
           fmt::format("must have the dimension of {} [{}]", si_unit,
                       scaling::to_string(parse_unit(si_unit, where).dimension)),
           "correct the unit in the header");
}

double cell_value(const std::string& written, const std::string& where) {
    const std::string text = trimmed(written);
    if (text.empty() || text == "nan" || text == "NaN")
        return std::numeric_limits<double>::quiet_NaN();
    const std::size_t from = text.front() == '+' ? 1 : 0;
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
        refuse(where, in_quotes(text), "must be a finite number",
               "use a decimal point; leave the cell empty where nothing was measured");
    }
    return value;
}

bool blank(const std::vector<std::string>& row) {
    return std::all_of(row.begin(), row.end(),
                       [](const std::string& cell) { return trimmed(cell).empty(); });
}

void check_sets(const Recording& recording, const RigRule& rig, const std::string& path) {
    std::string sets;
    for (const std::vector<std::string>& set : rig.recorded) {
        if (std::all_of(set.begin(), set.end(),
                        [&](const std::string& name) { return recording.has(name); }))
            return;
        sets += (sets.empty() ? "" : " or ");
        for (std::size_t i = 0; i < set.size(); ++i) sets += (i == 0 ? "" : ", ") + set[i];
    }
    std::string given;
    for (const Column& column : recording.columns)
        given += (given.empty() ? "" : ", ") + column.name;
    refuse(path, given, "must hold " + sets, "add the missing columns");
}

}  // namespace

std::size_t Recording::rows() const {
    return columns.empty() ? 0
                           : std::max(columns.front().values.size(), columns.front().words.size());
}

bool Recording::has(const std::string& name) const {
    return std::any_of(columns.begin(), columns.end(),
                       [&](const Column& c) { return c.name == name; });
}

const Column& Recording::column(const std::string& name) const {
    for (const Column& c : columns) {
        if (c.name == name) return c;
    }
    refuse("recording", "no column \"" + name + "\"", "must hold this channel", "record it");
}

Recording read_recording(const std::string& path, const std::string& rig_name,
                         double newtons_per_volt) {
    const RigRule& rig = rig_rule(rig_name);
    const Rows rows = split(path, read_bytes(path));
    if (rows.empty())
        refuse(path, "an empty file", "must have a header and rows", "export the recording again");
    Recording recording;
    std::vector<Heading> headings;
    for (const std::string& cell : rows.front()) {
        headings.push_back(heading(cell, rig, path, newtons_per_volt));
        const Heading& h = headings.back();
        if (recording.has(h.channel->name)) {
            refuse(path + ": column " + in_quotes(cell), "the channel a second time",
                   "must stand once", "remove one of the two");
        }
        recording.columns.push_back({h.channel->name, h.si_unit});
    }
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const std::vector<std::string>& row = rows[i];
        if (blank(row)) continue;
        const std::string where = fmt::format("{}: row {}", path, i + 1);
        if (row.size() != headings.size()) {
            refuse(where, fmt::format("{} cells", row.size()),
                   fmt::format("must have {}", headings.size()),
                   "write one cell per column; leave a cell empty where nothing was measured");
        }
        for (std::size_t j = 0; j < row.size(); ++j) {
            Column& column = recording.columns[j];
            const std::string cell_where = where + ", " + column.name;
            if (column.unit.empty()) {
                Value word{.where = cell_where,
                           .kind = Value::Kind::text,
                           .written_text = trimmed(row[j])};
                column.words.push_back(checked_word(word, headings[j].channel->words));
            } else {
                column.values.push_back(cell_value(row[j], cell_where) * headings[j].factor);
            }
        }
    }
    if (recording.rows() == 0)
        refuse(path, "a header only", "must have rows", "export the recording again");
    check_sets(recording, rig, path);
    return recording;
}

void write_csv(const std::string& path, const std::vector<Column>& columns) {
    std::string text;
    std::size_t rows = 0;
    for (const Column& column : columns) {
        text += (text.empty() ? "" : ",") + column.name;
        if (!column.unit.empty() && column.unit != "1") text += " [" + column.unit + "]";
        rows = std::max({rows, column.values.size(), column.words.size()});
    }
    text += '\n';
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns.size(); ++j) {
            const Column& column = columns[j];
            if (j > 0) text += ',';
            if (i < column.words.size()) text += column.words[i];
            if (i < column.values.size() && !std::isnan(column.values[i]))
                text += fmt::format("{}", column.values[i]);
        }
        text += '\n';
    }
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace cases
