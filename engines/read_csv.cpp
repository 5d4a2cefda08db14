// SPDX-License-Identifier: MIT
// A table of grains, one row each, with a header of `name [unit]` or `name (unit)`: what a script, a spreadsheet or EDEM's Python
// library writes. One frame.
#include "cases/messages.hpp"
#include "cases/units.hpp"
#include "engines/grain_lines.hpp"

#include <fmt/format.h>

#include <map>

namespace engines {
namespace {

struct Known {
    Slot slot;
    const char* si_unit;  // "1": none
};

const std::map<std::string, Known>& known_columns() {
    static const std::map<std::string, Known> known{{"id", {Slot::id, "1"}},
                                                    {"type", {Slot::type, "1"}},
                                                    {"x", {Slot::x, "m"}},
                                                    {"y", {Slot::y, "m"}},
                                                    {"z", {Slot::z, "m"}},
                                                    {"vx", {Slot::vx, "m/s"}},
                                                    {"vy", {Slot::vy, "m/s"}},
                                                    {"vz", {Slot::vz, "m/s"}},
                                                    {"omegax", {Slot::wx, "rad/s"}},
                                                    {"omegay", {Slot::wy, "rad/s"}},
                                                    {"omegaz", {Slot::wz, "rad/s"}},
                                                    {"radius", {Slot::radius, "m"}},
                                                    {"diameter", {Slot::diameter, "m"}},
                                                    {"mass", {Slot::mass, "kg"}},
                                                    {"density", {Slot::density, "kg/m^3"}}};
    return known;
}

// "x [mm]", "x (mm)" or "x"
Column column_of(std::string_view cell, const std::string& where) {
    const std::string text(cell);
    const char last = text.empty() ? ' ' : text.back();
    const std::size_t bracket =
        last == ']' ? text.rfind('[') : (last == ')' ? text.rfind('(') : std::string::npos);
    std::string name = text.substr(0, bracket);
    while (!name.empty() && name.back() == ' ') name.pop_back();
    const auto found = known_columns().find(name);
    if (found == known_columns().end()) return {Slot::unused, 1.0, text};
    const auto& [slot, si_unit] = found->second;
    if (si_unit == std::string("1")) return {slot, 1.0, text};
    const std::string here = where + ": column " + cases::in_quotes(text);
    if (bracket == std::string::npos)
        refuse(here, "no unit", "must carry its unit",
               fmt::format("write the header as \"{} [{}]\"", name, si_unit));
    const std::string unit = text.substr(bracket + 1, text.size() - bracket - 2);
    return {slot, cases::to_si("1 " + unit, cases::parse_unit(si_unit, here), here), text};
}

class Csv : public GrainReader {
  public:
    Csv(Lines lines, const GrainOptions& options) : lines_(std::move(lines)), options_(options) {}

    GrainFormat format() const override { return GrainFormat::csv; }

    bool next(GrainFrame& f) override {
        if (read_) return false;
        read_ = true;
        std::vector<std::string_view> cells;
        split_cells(lines_.need("the header"), cells);
        std::vector<Column> columns;
        for (const std::string_view cell : cells) columns.push_back(column_of(cell, lines_.at()));
        const Table table(columns, options_, lines_.at());
        table.begin(f);
        const Table::Where where = [this] { return lines_.at(); };
        std::vector<double> values(columns.size());
        while (lines_.next()) {
            if (lines_.text().empty()) continue;
            split_cells(lines_.text(), cells);
            if (cells.size() != columns.size())
                refuse(lines_.at(), fmt::format("{} cells", cells.size()),
                       fmt::format("must have {}, as the header", columns.size()),
                       "write one cell per column, no comma within a number");
            for (std::size_t k = 0; k < cells.size(); ++k)
                if (columns[k].slot != Slot::unused)
                    values[k] = lines_.number(cells[k], columns[k].name);
            table.add(f, values, where);
        }
        enclose(f.frame, false);
        return true;
    }

  private:
    Lines lines_;
    GrainOptions options_;
    bool read_ = false;
};

}  // namespace

std::unique_ptr<GrainReader> read_csv(Lines lines, const GrainOptions& options) {
    return std::make_unique<Csv>(std::move(lines), options);
}

}  // namespace engines
