// SPDX-License-Identifier: MIT
#include "reports/proof.hpp"

#include "reports/numbers.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace reports {

namespace {

using prove::Line;
using prove::ScoreTable;

std::string three(double value) { return fmt::format("{:.3f}", value); }

Verdict verdict_of(const ScoreTable& table) {
    int bars = 0, met = 0;
    for (const Line& line : table.lines)
        if (line.met) ++bars, met += *line.met ? 1 : 0;
    return {bars == 0    ? Answer::cannot_tell
            : met < bars ? Answer::no
                         : Answer::yes,
            bars == 0 ? "No bar could be tested" : fmt::format("{} of {} bars are met", met, bars),
            fmt::format("{} blind cases, {} of them without a verdict, which counts as a wrong one",
                        table.cases, table.missing)};
}

std::vector<std::string> row_of(const Line& line) {
    return {line.figure,
            line.count > 0 ? three(line.value) : "",
            line.bounds && line.count > 0
                ? fmt::format("[{:.3f}, {:.3f}]", line.bounds->low, line.bounds->high)
                : "",
            fmt::format("{}", line.count),
            line.bar,
            line.met ? (*line.met ? "met" : "missed") : line.note};
}

RunSection bars(const ScoreTable& table) {
    RunSection s{.name = "Figures with a bar",
                 .verdict = verdict_of(table),
                 .notes = {},
                 .figure = {},
                 .quantities = {{"figure", "found", "95 % (Wilson)", "cases", "bar", ""}},
                 .intervals = {}};
    for (const Line& line : table.lines) s.quantities.push_back(row_of(line));
    return s;
}

RunSection names(const ScoreTable& table) {
    RunSection s{.name = "What was concealed, and what was named",
                 .verdict = {},
                 .notes = {"Single effects that the recordings tell apart (D at or above the "
                           "limit of the table), by what the judge said."},
                 .figure = {},
                 .quantities = {{"concealed", "cases", "right", "what was said, how often"}},
                 .intervals = {}};
    int all = 0, right = 0;
    for (const auto& [truth, answers] : table.confusion) {
        std::vector<std::pair<int, std::string>> order;
        int total = 0;
        for (const auto& [answer, n] : answers) total += n, order.emplace_back(-n, answer);
        std::sort(order.begin(), order.end());
        std::string said;
        for (const auto& [n, answer] : order)
            said += fmt::format("{}{} {}", said.empty() ? "" : ", ", words(answer), -n);
        const auto hit = answers.find(truth == "none" ? "consistent" : truth);
        const int named = hit == answers.end() ? 0 : hit->second;
        s.quantities.push_back(
            {words(truth), fmt::format("{}", total), fmt::format("{}", named), said});
        all += total, right += named;
    }
    s.verdict = {all == 0       ? Answer::cannot_tell
                 : right == all ? Answer::yes
                                : Answer::no,
                 all == 0 ? "none" : fmt::format("{} of {} answers are right", right, all), ""};
    return s;
}

// Straight up the diagonal where a probability of p comes true in a share p of the cases.
Figure reliability(const prove::Calibration& c) {
    Curve told{.x = {}, .y = {}, .style = 0, .label = "told by the judge", .marked = true};
    Band bounds{.x = {}, .low = {}, .high = {}, .style = 0, .label = "95 % (Wilson)"};
    for (const prove::Calibration::Bin& bin : c.bins) {
        const prove::Wilson w =
            prove::wilson(static_cast<int>(std::lround(bin.frequency * bin.count)), bin.count);
        told.x.push_back(bin.probability), told.y.push_back(bin.frequency);
        bounds.x.push_back(bin.probability);
        bounds.low.push_back(w.low), bounds.high.push_back(w.high);
    }
    const Plot plot{
        .title = "Reliability of the probabilities",
        .description =
            "Share of hypotheses that were true, against the probability they were given",
        .x = {"probability told", std::pair{0.0, 1.0}},
        .y = {"share that came true", std::pair{0.0, 1.0}},
        .bands = {bounds},
        .curves = {{.x = {0.0, 1.0}, .y = {0.0, 1.0}, .style = 1, .label = "as told"}, told}};
    std::string counts;
    for (const prove::Calibration::Bin& bin : c.bins)
        counts +=
            fmt::format("{}{:.2f}: {}", counts.empty() ? "" : ", ", bin.probability, bin.count);
    return {svg(plot, "reliability"),
            fmt::format("Above the diagonal the judge is too cautious, below it too sure. "
                        "Hypotheses behind each point (probability: how many): {}.",
                        counts)};
}

RunSection probabilities(const prove::Calibration& c) {
    return {.name = "Can the probabilities be believed?",
            .verdict = {Answer::cannot_tell,
                        fmt::format("expected calibration error {:.3f}", c.expected_error),
                        fmt::format("over the most probable hypothesis of each case {:.3f}; Brier "
                                    "score {:.3f}",
                                    c.expected_error_top, c.brier)},
            .notes = {},
            .figure = reliability(c),
            .quantities = {},
            .intervals = {}};
}

}  // namespace

Page page_of(const ScoreTable& table, const std::string& cost, std::vector<std::string> limits,
             const Provenance& who) {
    Page page{.title = "Blind cases with concealed effects",
              .verdict = verdict_of(table),
              .runs = {bars(table)},
              .runs_heading = "The score",
              .limits = std::move(limits),
              .provenance = who};
    page.runs.front().notes.push_back(cost);
    if (!table.confusion.empty()) page.runs.push_back(names(table));
    if (!table.calibration.bins.empty()) page.runs.push_back(probabilities(table.calibration));
    return page;
}

}  // namespace reports
