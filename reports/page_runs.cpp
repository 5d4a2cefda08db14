// SPDX-License-Identifier: MIT
#include "reports/numbers.hpp"
#include "reports/page_parts.hpp"

#include <utility>

namespace reports {

namespace {

data figure_data(const Figure& figure) {
    data d;
    d["figure"] = figure.svg;
    d["caption"] = figure.caption;
    return d;
}

// A line may break between a mean and its interval, not inside the interval.
std::string unbroken(std::string cell) {
    for (std::size_t at = cell.find(", "); at != std::string::npos && cell.back() == ']';
         at = cell.find(", ", at))
        cell.replace(at, 2, ",\u00a0");
    return cell;
}

// The first and the last column are words, what stands between them numbers.
data cells(const std::vector<std::string>& row, const char* key) {
    data list{data::type::list};
    for (std::size_t k = 0; k < row.size(); ++k) {
        data d;
        d[key] = std::string(key) == "text" ? typeset(unbroken(row[k])) : row[k];
        d["class"] = k == 0 || k + 1 == row.size() ? "" : "r";
        list << d;
    }
    return list;
}

void set_table(data& d, const TextTable& table) {
    data rows{data::type::list};
    for (std::size_t k = 1; k < table.size(); ++k) rows << data("cells", cells(table[k], "text"));
    if (!table.empty()) d["heads"] = cells(table.front(), "name");
    set_list(d, "quantities", std::move(rows));
}

data section_data(const RunSection& s) {
    data d;
    d["name"] = s.name;
    d["why"] = optional_text(typeset(s.verdict.why));
    d["headline"] = s.verdict.headline;
    d["class"] = class_of(s.verdict.answer);
    data sides{data::type::list}, intervals{data::type::list};
    for (const std::string& note : s.notes) sides << data("text", typeset(note));
    d["sides"] = std::move(sides);
    d["has_figure"] = !s.figure.svg.empty();
    d["figure"] = s.figure.svg;
    d["caption"] = s.figure.caption;
    set_table(d, s.quantities);
    for (const Figure& f : s.intervals) intervals << figure_data(f);
    d["intervals"] = std::move(intervals);
    return d;
}

}  // namespace

data runs_part(const std::vector<RunSection>& sections) {
    data list{data::type::list};
    for (const RunSection& section : sections) list << section_data(section);
    return list;
}

}  // namespace reports
