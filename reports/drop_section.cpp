// SPDX-License-Identifier: MIT
#include "reports/numbers.hpp"
#include "reports/runs.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

namespace {

constexpr double mm = 1e-3;

std::vector<double> in_millimetres(std::vector<double> lengths) {
    for (double& length : lengths) length /= mm;
    return lengths;
}

Figure height_figure(const std::string& name, const rigs::DropRecord& record,
                     const cases::Recording* recording) {
    Plot plot;
    plot.title = "Height against time";
    plot.description =
        fmt::format("The lowest point of the grain over {}, {} impacts.",
                    record.t.empty() ? "no time" : quantity(record.t.back(), "s"), record.impacts);
    plot.x = {.label = "time, s"};
    plot.y = {.label = "height of the lowest point, mm"};
    if (recording != nullptr)
        plot.curves.push_back({.x = recording->values("t"),
                               .y = in_millimetres(recording->values("z")),
                               .style = 1,
                               .label = "recorded",
                               .marked = true});
    plot.curves.push_back(
        {.x = record.t, .y = in_millimetres(record.z), .style = 0, .label = "simulated"});
    return {svg(plot, "height-" + name),
            recording == nullptr ? "" : "The recording is only shown here, not fitted."};
}

}  // namespace

RunSection drop_section(const std::string& name, const rigs::DropRecord& record,
                        const cases::Recording* recording) {
    const double top = record.z.empty() ? 0.0 : *std::max_element(record.z.begin(), record.z.end());
    RunSection section{name,
                       {Answer::yes, "The grain has settled",
                        fmt::format("it lies still or rolls steadily from {} on",
                                    quantity(record.settled_at, "s"))},
                       {fmt::format("{} impacts, highest {}", record.impacts, quantity(top, "m"))},
                       height_figure(name, record, recording),
                       {},
                       {}};
    if (!record.settled)
        section.verdict = {Answer::yes, "The grain was followed as long as asked for",
                           "it was still moving at the end"};
    return section;
}

}  // namespace reports
