// SPDX-License-Identifier: MIT
// EDEM's File > Export > Results Data as text (.csv), one query for each quantity of the particles: lines "TIME:, 0.4" and
// "Q01 : Particle Position X:, 12.1, 13.4, ..."; or the label alone, its values below it behind an empty cell. Altair publishes the
// dialog, not the layout; the layout is that of files which others read (docs/formats.md). EDEM writes numbers in the units of its
// dialog, the label need not say them.
#include "cases/messages.hpp"
#include "cases/units.hpp"
#include "engines/grain_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace engines {
namespace {

struct Known {
    Slot slot;
    const char* si_unit;  // "1": none
};

const std::map<std::string, Known>& known_queries() {
    static const std::map<std::string, Known> known{
        {"Particle ID", {Slot::id, "1"}},
        {"Particle Position X", {Slot::x, "m"}},
        {"Particle Position Y", {Slot::y, "m"}},
        {"Particle Position Z", {Slot::z, "m"}},
        {"Particle Velocity X", {Slot::vx, "m/s"}},
        {"Particle Velocity Y", {Slot::vy, "m/s"}},
        {"Particle Velocity Z", {Slot::vz, "m/s"}},
        {"Particle Angular Velocity X", {Slot::wx, "rad/s"}},
        {"Particle Angular Velocity Y", {Slot::wy, "rad/s"}},
        {"Particle Angular Velocity Z", {Slot::wz, "rad/s"}},
        {"Particle Radius", {Slot::radius, "m"}},
        {"Particle Diameter", {Slot::diameter, "m"}},
        {"Particle Volume", {Slot::volume, "m^3"}},
        {"Particle Mass", {Slot::mass, "kg"}}};
    return known;
}

bool is_time(std::string_view cell) { return cell.starts_with("TIME"); }

// "Q01 : Particle Position X:", "Q01:Particle Position X (mm):"
bool is_query(std::string_view cell) {
    if (cell.size() < 3 || cell[0] != 'Q') return false;
    std::size_t k = 1;
    while (k < cell.size() && std::isdigit(static_cast<unsigned char>(cell[k]))) ++k;
    const std::size_t digits = k - 1;
    while (k < cell.size() && cell[k] == ' ') ++k;
    return digits > 0 && k < cell.size() && cell[k] == ':';
}

struct Label {
    std::string name, unit;  // unit: empty where none is written
};

Label label_of(std::string_view cell) {
    std::string text(cell.substr(cell.find(':') + 1));
    const auto trim = [&] {
        while (!text.empty() && (text.back() == ' ' || text.back() == ':')) text.pop_back();
        while (!text.empty() && text.front() == ' ') text.erase(0, 1);
    };
    trim();
    Label label{text, ""};
    const char last = text.empty() ? ' ' : text.back();
    const std::size_t bracket =
        last == ']' ? text.rfind('[') : (last == ')' ? text.rfind('(') : std::string::npos);
    if (bracket == std::string::npos) return label;
    label.unit = text.substr(bracket + 1, text.size() - bracket - 2);
    text.resize(bracket);
    trim();
    label.name = text;
    return label;
}

class EdemCsv : public GrainReader {
  public:
    EdemCsv(Lines lines, const GrainOptions& options)
        : lines_(std::move(lines)), options_(options) {}

    GrainFormat format() const override { return GrainFormat::edem_csv; }

    bool next(GrainFrame& f) override {
        if (!find_block()) return false;
        std::optional<double> time;
        std::vector<Query> queries;
        std::optional<double> total;
        std::vector<std::string> passed;
        read_block(time, queries, total, passed);
        if (queries.empty())
            refuse(lines_.at(), "no query of particles", "must hold Particle Position X, Y and Z",
                   "export these queries; see docs/formats.md");
        const std::size_t grains = queries.front().values.size();
        std::vector<Column> columns;
        for (const Query& q : queries) {
            columns.push_back(q.column);
            if (q.values.size() != grains)
                refuse(q.at, fmt::format("{} values", q.values.size()),
                       fmt::format("must be {}, as of {}", grains, queries.front().column.name),
                       "export all queries of the same particles");
        }
        if (total && *total != static_cast<double>(grains))
            refuse(queries.front().at, fmt::format("{} values", grains),
                   fmt::format("must be {}, the file's Total Number of Particles", *total),
                   "the file may be cut off");
        const Table table(columns, options_, lines_.at());
        table.begin(f);
        f.unused = passed;
        f.has_time = time.has_value(), f.frame.time = time.value_or(0.0);
        f.frame.step = frames_++;
        std::vector<double> row(columns.size());
        std::size_t k = 0;
        const Table::Where where = [&] {
            return fmt::format("{}: value {}", queries.front().at, k + 1);
        };
        for (k = 0; k < grains; ++k) {
            for (std::size_t i = 0; i < queries.size(); ++i) row[i] = queries[i].values[k];
            table.add(f, row, where);
        }
        enclose(f.frame, false);
        return true;
    }

  private:
    struct Query {
        Column column;
        std::string at;
        std::vector<double> values;  // [grains], as written
    };

    // Leaves the block's first line in lines_. What stands before the first block is the header of the export.
    bool find_block() {
        while (lines_.next()) {
            split_cells(lines_.text(), cells_);
            if (is_time(cells_[0]) || is_query(cells_[0])) return true;
            if (frames_ > 0 && !lines_.text().empty()) refuse_line();
        }
        return false;
    }

    [[noreturn]] void refuse_line() const {
        refuse(lines_.at(), cases::in_quotes(lines_.text()),
               "must be TIME:, a query \"Q01 : NAME:\" or its values",
               "export with Omit All Text off; with Output Data in Columns one query at a time");
    }

    // From here to the next TIME or the end.
    void read_block(std::optional<double>& time, std::vector<Query>& queries,
                    std::optional<double>& total, std::vector<std::string>& passed) {
        bool first = true, below = false;
        std::vector<double> values;
        std::string at;
        Label label;
        const auto close = [&] {
            if (!below) return;
            take(label, at, std::move(values), queries, total, passed);
            values.clear(), below = false;
        };
        do {
            if (lines_.text().find_first_not_of(" \t,") == std::string::npos) continue;
            split_cells(lines_.text(), cells_);
            if (is_time(cells_[0])) {
                if (!first) {
                    lines_.put_back();
                    break;
                }
                if (cells_.size() < 2)
                    refuse(lines_.at(), cases::in_quotes(lines_.text()),
                           "must hold the time behind a comma", "in seconds");
                time = lines_.number(cells_[1], "time");
            } else if (is_query(cells_[0])) {
                close();
                if (cells_.size() > 1 && is_query(cells_[1])) refuse_line();
                at = lines_.at(), label = label_of(cells_[0]), below = true;
                take_values(1, label.name, values);
            } else if (below && cells_[0].empty()) {
                take_values(1, label.name, values);
            } else {
                refuse_line();
            }
            first = false;
        } while (lines_.next());
        close();
    }

    void take_values(std::size_t from, const std::string& what, std::vector<double>& values) const {
        std::size_t to = cells_.size();
        while (to > from && cells_[to - 1].empty()) --to;  // a comma behind the last
        const bool wanted = known_queries().count(what) > 0 || what == total_name;
        for (std::size_t k = from; wanted && k < to; ++k)
            values.push_back(lines_.number(cells_[k], what));
    }

    void take(const Label& label, const std::string& at, std::vector<double> values,
              std::vector<Query>& queries, std::optional<double>& total,
              std::vector<std::string>& passed) const {
        if (label.name == total_name && values.size() == 1) {
            total = values.front();
            return;
        }
        const auto found = known_queries().find(label.name);
        if (found == known_queries().end()) {
            passed.push_back(label.name);
            return;
        }
        const auto& [slot, si_unit] = found->second;
        Column column{slot, 1.0, label.name};
        if (si_unit != std::string("1")) {
            const bool length = slot == Slot::x || slot == Slot::y || slot == Slot::z ||
                                slot == Slot::radius || slot == Slot::diameter;
            const std::string where = at + ": " + label.name;
            if (!label.unit.empty()) {
                column.factor =
                    cases::to_si("1 " + label.unit, cases::parse_unit(si_unit, where), where);
            } else if (length && options_.length_unit) {
                column.factor = *options_.length_unit;
            } else if (options_.units && !options_.length_unit) {
                column.factor = factor_of(slot, *options_.units);
            } else if (length) {
                refuse(where, "no unit", "must have its unit stated",
                       "state --length-unit mm, or what EDEM's dialog showed");
            } else {  // mm and m/s stand side by side in EDEM: the one does not tell the other
                passed.push_back(label.name + " (no unit: write it into the label, (" + si_unit +
                                 "), or state --units)");
                return;
            }
        }
        queries.push_back({column, at, std::move(values)});
    }

    static constexpr const char* total_name = "Total Number of Particles";
    Lines lines_;
    GrainOptions options_;
    std::vector<std::string_view> cells_;
    std::int64_t frames_ = 0;
};

}  // namespace

std::unique_ptr<GrainReader> read_edem_csv(Lines lines, const GrainOptions& options) {
    return std::make_unique<EdemCsv>(std::move(lines), options);
}

}  // namespace engines
