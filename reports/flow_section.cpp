// SPDX-License-Identifier: MIT
#include "reports/numbers.hpp"
#include "reports/runs.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace reports {

namespace {

Verdict verdict_of(const std::string& ending) {
    if (ending == "not_at_rest")
        return {Answer::cannot_tell, "Still moving when the run was given up",
                "the grains did not come to rest"};
    if (ending == "jammed")
        return {Answer::no, "The outlet jammed",
                "nothing more came out, and grains still stand above the outlet"};
    if (ending == "drained")
        return {Answer::yes, "The silo drained",
                "nothing more came out, and what is left stands beside the outlet"};
    if (ending == "at_rest")
        return {Answer::yes, "The column collapsed and came to rest", "its wall is above it"};
    return {Answer::yes, "The experiment was run to the last instant asked for",
            "no end of its own came before"};
}

std::string axis(const cases::Column& c) { return c.name + ", " + c.unit; }

// One line for each instant of a column, of which the figure has room for four: the first, the last and two between.
std::vector<Curve> profiles(const std::vector<cases::Column>& channels) {
    const std::vector<double>& t = channels[0].values;
    std::vector<double> instants = t;
    instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
    std::vector<Curve> curves;
    const std::size_t most = std::min<std::size_t>(4, instants.size());
    for (std::size_t k = 0; k < most; ++k) {
        const std::size_t which = most < 2 ? 0 : k * (instants.size() - 1) / (most - 1);
        Curve curve{.x = {}, .y = {}, .style = static_cast<int>(k)};
        curve.label = "t = " + quantity(instants[which], "s");
        for (std::size_t row = 0; row < t.size(); ++row)
            if (t[row] == instants[which]) {
                curve.x.push_back(channels[1].values[row]);
                curve.y.push_back(channels[2].values[row]);
            }
        curves.push_back(std::move(curve));
    }
    return curves;
}

Figure figure_of(const std::string& name, const std::vector<cases::Column>& channels,
                 const cases::Recording* recording) {
    const std::size_t x = channels.size() - 2, y = channels.size() - 1;
    Plot plot;
    plot.title = channels[y].name + " against " + channels[x].name;
    plot.description =
        fmt::format("{} of {}, {} rows.", channels[y].name, name, channels[y].values.size());
    plot.x = {.label = axis(channels[x])};
    plot.y = {.label = axis(channels[y])};
    const bool one_line = channels.size() == 2;
    const bool compared = one_line && recording != nullptr && recording->has(channels[x].name) &&
                          recording->has(channels[y].name) &&
                          recording->column(channels[y].name).unit == channels[y].unit;
    if (compared)
        plot.curves.push_back({.x = recording->values(channels[x].name),
                               .y = recording->values(channels[y].name),
                               .style = 1,
                               .label = "recorded",
                               .marked = true});
    if (one_line)
        plot.curves.push_back(
            {.x = channels[x].values, .y = channels[y].values, .style = 0, .label = "simulated"});
    else
        plot.curves = profiles(channels);
    return {svg(plot, channels[y].name + "-" + name),
            compared ? "The recording is only shown here, not fitted." : ""};
}

}  // namespace

RunSection flow_section(const std::string& name, const rigs::FlowRecord& record,
                        const cases::Recording* recording) {
    RunSection section{name, verdict_of(record.ending), {}, {}, {}, {}};
    section.notes.push_back(fmt::format("{} steps", count(static_cast<double>(record.steps))));
    if (record.channels.empty()) return section;
    section.figure = figure_of(name, record.channels, recording);
    if (!record.profile.empty())
        section.intervals.push_back(figure_of(name, record.profile, recording));
    section.quantities = {{"quantity", "value", "unit"}};
    for (const rigs::FlowQuantity& q : record.quantities) {
        const bool angle = q.unit == "rad";
        section.quantities.push_back({words(q.name), angle ? degrees(q.value) : number(q.value),
                                      angle           ? "degrees"
                                      : q.unit == "1" ? ""
                                                      : q.unit});
    }
    return section;
}

}  // namespace reports
