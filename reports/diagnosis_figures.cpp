// SPDX-License-Identifier: MIT
#include "reports/diagnosis_figures.hpp"

#include "cases/units.hpp"
#include "reports/numbers.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace reports {

namespace {

using diagnose::PredictedCurve;

constexpr double residual_height = 170.0;  // user units
constexpr int after_style = 0, before_style = 1, located_style = 2, recorded_style = 3;

// The unit in which the largest of the values reads well.
struct Ruler {
    double factor = 1.0;  // SI = shown * factor
    std::string unit{};

    double shown(double si) const { return si / factor; }
    std::string label(const std::string& name) const {
        if (unit.empty()) return name;
        return name + ", " + with_micro("1 " + unit).substr(2);  // it looks for numbers
    }
};

Ruler ruler(const std::vector<double>& values, const std::string& si_unit) {
    double most = 0.0;
    for (const double v : values)
        if (std::isfinite(v)) most = std::max(most, std::abs(v));
    if (!(most > 0.0) || si_unit == "1" || si_unit.empty())
        return {1.0, si_unit == "1" ? "" : si_unit};
    const std::string text = cases::format_si(most, si_unit);
    const std::size_t space = text.find(' ');
    if (space == std::string::npos) return {1.0, si_unit};
    const std::string unit = text.substr(space + 1);
    return {cases::parse_unit(unit, "axis").factor / cases::parse_unit(si_unit, "axis").factor,
            unit};
}

// Rows of one branch in rising order of the ordinate.
std::vector<std::size_t> rows_of(const PredictedCurve& c, const std::string& branch) {
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < c.at.size(); ++k)
        if (c.branch.empty() || c.branch[k] == branch) rows.push_back(k);
    std::stable_sort(rows.begin(), rows.end(),
                     [&](std::size_t a, std::size_t b) { return c.at[a] < c.at[b]; });
    return rows;
}

std::vector<double> picked(const std::vector<double>& values, const std::vector<std::size_t>& rows,
                           const Ruler& r) {
    std::vector<double> out;
    for (const std::size_t k : rows)
        out.push_back(k < values.size() ? r.shown(values[k]) : std::nan(""));
    return out;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> out(a.size(), std::nan(""));
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) out[k] = a[k] - b[k];
    return out;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
        if (std::isfinite(a[k]) && std::isfinite(b[k]) && a[k] != b[k]) return false;
    return true;
}

struct Shown {
    const PredictedCurve& curve;
    std::vector<std::size_t> rows;
    Ruler x, y;
    bool one_model;  // before and after are the same
    std::string name, id;
};

std::vector<Span> spans_of(const Shown& s, const std::vector<diagnose::Located>& located) {
    std::vector<Span> spans;
    for (const diagnose::Located& l : located) {
        if (l.experiment != s.curve.experiment || l.channel != s.curve.channel ||
            l.variable != s.curve.ordinate)
            continue;
        spans.push_back({s.x.shown(l.from), s.x.shown(l.to), located_style,
                         spans.empty() ? "where they differ" : ""});
    }
    return spans;
}

// The located intervals of another variable than the one the figure is drawn over, in words.
std::string elsewhere(const Shown& s, const std::vector<diagnose::Located>& located) {
    std::string text;
    for (const diagnose::Located& l : located)
        if (l.experiment == s.curve.experiment && l.channel == s.curve.channel &&
            l.variable != s.curve.ordinate)
            text += fmt::format(" They differ for {} from {} to {}.", words(l.variable),
                                quantity(l.from, l.unit), quantity(l.to, l.unit));
    return text;
}

Figure curve_figure(const Shown& s, const std::vector<diagnose::Located>& located) {
    const PredictedCurve& c = s.curve;
    const std::vector<double> x = picked(c.at, s.rows, s.x);
    Plot plot;
    plot.title = s.name;
    plot.description =
        fmt::format("{} against {}: recorded, and simulated {}.", words(c.channel),
                    words(c.ordinate), s.one_model ? "by the model" : "before and after");
    plot.x = {.label = s.x.label(words(c.ordinate))};
    plot.y = {.label = s.y.label(words(c.channel))};
    plot.curves = {{.x = x,
                    .y = picked(c.recorded, s.rows, s.y),
                    .style = recorded_style,
                    .label = "recorded",
                    .marked = true,
                    .fine = true},
                   {.x = x,
                    .y = picked(c.base, s.rows, s.y),
                    .style = before_style,
                    .label = s.one_model ? "simulated, refitted" : "simulated before, refitted"}};
    if (!s.one_model)
        plot.curves.push_back({.x = x,
                               .y = picked(c.extended, s.rows, s.y),
                               .style = after_style,
                               .label = "simulated after"});
    plot.spans = spans_of(s, located);
    return {svg(plot, s.id), ""};
}

Figure residual_figure(const Shown& s, const std::vector<diagnose::Located>& located) {
    const PredictedCurve& c = s.curve;
    const std::vector<double> before = difference(c.recorded, c.base);
    const std::vector<double> after = difference(c.recorded, c.extended);
    std::vector<double> all = before;
    all.insert(all.end(), after.begin(), after.end());
    const Ruler y = ruler(all, c.unit);
    const std::vector<double> x = picked(c.at, s.rows, s.x);
    Plot plot;
    plot.title = s.name + ", recorded minus simulated";
    plot.description = "Recorded minus simulated, with two standard deviations of the noise.";
    plot.x = {.label = s.x.label(words(c.ordinate))};
    plot.y = {.label = y.label("recorded - simulated")};
    plot.height = residual_height;
    const bool noise = std::isfinite(c.noise) && c.noise > 0.0 && !x.empty();
    if (noise) {
        const double two = y.shown(2.0 * c.noise);
        plot.bands = {{.x = {x.front(), x.back()},
                       .low = {-two, -two},
                       .high = {two, two},
                       .style = recorded_style,
                       .label = "noise, 2 sigma"}};
    }
    plot.curves = {{.x = x,
                    .y = picked(before, s.rows, y),
                    .style = before_style,
                    .label = s.one_model ? "difference" : "before",
                    .marked = true,
                    .fine = true}};
    if (!s.one_model)
        plot.curves.push_back({.x = x,
                               .y = picked(after, s.rows, y),
                               .style = after_style,
                               .label = "after",
                               .marked = true,
                               .fine = true});
    plot.spans = spans_of(s, located);
    if (!plot.spans.empty()) plot.spans.front().label.clear();
    const std::string of_noise =
        noise ? fmt::format("Noise: {} (standard deviation).", quantity(c.noise, c.unit))
              : std::string("The noise is not known.");
    return {svg(plot, s.id + "-rest"), with_micro(of_noise + elsewhere(s, located))};
}

std::vector<std::string> branches_of(const PredictedCurve& c) {
    std::vector<std::string> branches;
    for (const std::string& b : c.branch)
        if (std::find(branches.begin(), branches.end(), b) == branches.end()) branches.push_back(b);
    return c.branch.empty() ? std::vector<std::string>{""} : branches;
}

}  // namespace

std::vector<CurveFigures> curve_figures(const diagnose::Verdict& v) {
    std::vector<CurveFigures> all;
    for (const PredictedCurve& c : v.curves) {
        for (const std::string& branch : branches_of(c)) {
            std::string name = c.experiment + ", " + words(c.channel);
            if (!branch.empty()) name += ", " + branch;
            if (c.held_out) name += " (held out)";
            const Shown s{c,
                          rows_of(c, branch),
                          ruler(c.at, c.ordinate_unit),
                          ruler(c.recorded, c.unit),
                          same(c.base, c.extended),
                          name,
                          fmt::format("curve-{}", all.size() + 1)};
            all.push_back({name, curve_figure(s, v.located), residual_figure(s, v.located)});
        }
    }
    return all;
}

Figure missing_figure(const diagnose::MissingEstimate& m, const std::string& id) {
    const Ruler x = ruler(m.knots, m.unit), y = ruler(m.values, m.unit_of_values);
    std::vector<std::size_t> rows(m.knots.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    Plot plot;
    plot.title = "The missing " + m.what();
    plot.description = m.words;
    plot.x = {.label = x.label(words(m.variable))};
    plot.y = {.label = y.label("missing " + m.what())};
    plot.height = 220.0;
    plot.bands = {{.x = picked(m.knots, rows, x),
                   .low = picked(m.low, rows, y),
                   .high = picked(m.high, rows, y),
                   .style = 0,
                   .label = "90 % band"}};
    plot.curves = {{.x = plot.bands[0].x,
                    .y = picked(m.values, rows, y),
                    .style = 0,
                    .label = "missing " + m.what()}};
    return {svg(plot, id), m.words.empty() ? "" : with_micro(m.words + ".")};
}

}  // namespace reports
