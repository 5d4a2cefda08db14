// SPDX-License-Identifier: MIT
#include "reports/text.hpp"

#include "reports/numbers.hpp"
#include "reports/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

namespace {

using scaling::Cost;
using scaling::Finding;
using scaling::ScaleStudy;
using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t width = 100;

std::string kept_text(const ScaleStudy& study) {
    std::string text;
    for (const scaling::Demand& d : study.scheme.demands) {
        text += (text.empty() ? "" : ", ") + d.quantity;
        if (!(d.exponents == scaling::Exponents{})) text += " x " + scaling::to_string(d.exponents);
    }
    return text;
}

std::string factors_text(const ScaleStudy& study) {
    Rows rows = {{"quantity", "factor", "", ""}};
    for (const scaling::FactorRow& row : study.factors)
        rows.push_back({row.quantity, scaling::to_string(row.exponents), number(row.factor),
                        row.imposed ? "set apart from the rest" : ""});
    return columns(rows, {false, false, true, false});
}

std::string groups_text(const ScaleStudy& study) {
    Rows rows = {{"group", "original", "scaled", "ratio", "", "formula"}};
    for (const scaling::GroupChange& g : study.groups)
        rows.push_back({g.group.name, number(g.original), number(g.scaled), number(g.ratio),
                        g.kept ? "kept" : "BROKEN",
                        g.group.formula == g.group.name ? "" : g.group.formula});
    return columns(rows, {false, true, true, true, false, false});
}

std::string findings_text(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& f : findings) {
        const std::string line =
            fmt::format("  {:8} {} = {} ({}): {}", scaling::to_string(f.judgement), f.name,
                        number(f.value), f.rule, tidy(f.text));
        text += wrapped(line, width, 11) + "\n";
    }
    return text;
}

std::string adhesion_text(const ScaleStudy& study) {
    if (!study.adhesion) return "no work of adhesion is stated, so none is predicted\n";
    const scaling::AdhesionPrediction& p = *study.adhesion;
    const auto row = [](const char* name, double original, double scaled, const char* unit) {
        return std::vector<std::string>{name, quantity(original, unit), quantity(scaled, unit)};
    };
    const Rows rows = {{p.invariant ? std::string("kept: ") + scaling::to_string(*p.invariant)
                                    : "kept: all groups",
                        "original grain", "scaled grain"},
                       row("work of adhesion w", p.original.work_of_adhesion.value(),
                           p.scaled.work_of_adhesion.value(), "J/m^2"),
                       row("surface energy w/2", p.original.surface_energy.value(),
                           p.scaled.surface_energy.value(), "J/m^2"),
                       row("pull-off force", p.original.pull_off_force.value(),
                           p.scaled.pull_off_force.value(), "N"),
                       row("in grain weights", p.original.pull_off_in_grain_weights,
                           p.scaled.pull_off_in_grain_weights, "1")};
    std::string text = columns(rows, {false, true, true}) + "\n" + findings_text(p.findings);
    if (study.other_invariants.empty()) return text;
    Rows others = {{"had it been kept instead", "original w", "scaled w", "w goes as", "usable"}};
    for (const scaling::AdhesionPrediction& o : study.other_invariants)
        others.push_back({scaling::to_string(*o.invariant),
                          quantity(o.original.work_of_adhesion.value(), "J/m^2"),
                          quantity(o.scaled.work_of_adhesion.value(), "J/m^2"),
                          scaling::to_string(o.exponents), o.physically_usable ? "yes" : "no"});
    return text + "\n" + columns(others, {false, true, true, false, false});
}

std::string cost_text(const ScaleStudy& study) {
    const auto time = [](const std::optional<scaling::Time>& t) {
        return t ? quantity(t->value(), "s") : std::string("not known");
    };
    const auto many = [](const std::optional<double>& n) {
        return n ? count(*n) : std::string("not known");
    };
    const Cost &a = study.original_cost, &b = study.scaled_cost;
    return columns(
        {{"cost", "original", "scaled"},
         {"grains", many(a.grains), many(b.grains)},
         {"time step", quantity(a.time_step.value(), "s"), quantity(b.time_step.value(), "s")},
         {"steps", many(a.steps), many(b.steps)},
         {"wall time on this machine", time(a.wall_time), time(b.wall_time)}},
        {false, true, true});
}

}  // namespace

std::string columns(const std::vector<std::vector<std::string>>& rows,
                    const std::vector<bool>& right) {
    std::vector<std::size_t> widths(right.size(), 0);
    for (const auto& row : rows)
        for (std::size_t j = 0; j < row.size(); ++j) widths[j] = std::max(widths[j], row[j].size());
    std::string text;
    for (const auto& row : rows) {
        std::string line = " ";
        for (std::size_t j = 0; j < row.size(); ++j)
            line += right[j] ? fmt::format(" {:>{}} ", row[j], widths[j])
                             : fmt::format(" {:<{}} ", row[j], widths[j]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string wrapped(const std::string& text, std::size_t limit, std::size_t indent) {
    std::string out;
    std::size_t from = 0;
    for (std::size_t room = limit; text.size() - from > room; room = limit - indent) {
        std::size_t cut = text.rfind(' ', from + room);
        if (cut == std::string::npos || cut <= from + indent) cut = text.find(' ', from + room);
        if (cut == std::string::npos) break;
        out += text.substr(from, cut - from) + "\n" + std::string(indent, ' ');
        from = cut + 1;
    }
    return out + text.substr(from);
}

std::string text_of(const ScaleStudy& study) {
    const Verdict verdict = verdict_of(study);
    const scaling::ScaleNumber &before = study.original_scale_number,
                               &after = study.scaled_scale_number;
    return fmt::format(
        "{}\n{}\n\nkept by demand: {}\n\n{}\n{}\n{}\n{}\n  scale number D/R: {} ({}) -> {} "
        "({})\n\n{}",
        verdict.headline, wrapped(verdict.why, width, 0), kept_text(study), factors_text(study),
        groups_text(study), adhesion_text(study), cost_text(study), number(before.value),
        scaling::to_string(before.size_class), number(after.value),
        scaling::to_string(after.size_class), findings_text(study.findings));
}

}  // namespace reports
