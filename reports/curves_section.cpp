// SPDX-License-Identifier: MIT
#include "reports/runs.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace reports {

namespace {

std::string with_unit(const cases::Column& c) {
    return c.unit.empty() || c.unit == "1" ? c.name : c.name + ", " + c.unit;
}

// Of values that are all alike an axis needs a range of its own.
std::optional<std::pair<double, double>> range_of(const std::vector<double>& values) {
    double low = 1e300, high = -1e300;
    for (const double v : values)
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    if (low > high || high - low > 1e-9 * std::max(std::abs(low), std::abs(high)))
        return std::nullopt;
    const double margin = high != 0.0 ? 0.1 * std::abs(high) : 1.0;
    return std::pair{low - margin, high + margin};
}

Figure figure_of(const std::string& name, const cases::Column& x, const cases::Column& y,
                 const cases::Recording* recording) {
    Plot plot;
    plot.title = y.name + " against " + x.name;
    plot.description = fmt::format("{} of {}, {} rows.", y.name, name, x.values.size());
    plot.x = {.label = with_unit(x)};
    const bool compared = recording != nullptr && recording->has(y.name);
    plot.y = {.label = with_unit(y)};
    if (!compared) plot.y.range = range_of(y.values);
    if (compared)
        plot.curves.push_back({.x = recording->values(x.name),
                               .y = recording->values(y.name),
                               .style = 1,
                               .label = "recorded",
                               .marked = true});
    plot.curves.push_back({.x = x.values, .y = y.values, .style = 0, .label = "simulated"});
    return {svg(plot, y.name + "-" + name),
            compared ? "The recording is only shown here, not fitted." : ""};
}

}  // namespace

RunSection curves_section(const std::string& name, const std::vector<cases::Column>& columns,
                          const cases::Recording* recording) {
    RunSection section{
        name,
        {Answer::yes, "The experiment was run", "a single grain, every channel of its rig"},
        {fmt::format("{} rows", columns.front().values.size())},
        {},
        {},
        {}};
    for (std::size_t k = 1; k < columns.size(); ++k) {
        if (columns[k].values.empty()) continue;
        Figure figure = figure_of(name, columns.front(), columns[k], recording);
        if (section.figure.svg.empty())
            section.figure = std::move(figure);
        else
            section.intervals.push_back(std::move(figure));
    }
    return section;
}

}  // namespace reports
