// SPDX-License-Identifier: MIT
#include "reports/calibration_figures.hpp"

#include "reports/numbers.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

namespace {

using namespace calibrate;

std::string axis_label(const PublishedFactor& f) {
    std::string unit = f.unit;
    if (const std::size_t at = unit.find("^2"); at != std::string::npos)
        unit.replace(at, 2, "\u00b2");
    return unit.empty() ? f.name : f.name + ", " + unit;
}

std::size_t index_of(const Published& p, const std::string& letter) {
    std::size_t k = 0;
    while (k + 1 < p.factors.size() && p.factors[k].letter != letter) ++k;
    return k;
}

// One marked curve per value of the first factor.
void add_orthogonal(Plot& plot, const PublishedTable& t) {
    int style = 1;
    for (std::size_t k = 0; k < t.rows.size(); ++k) {
        const double first = t.rows[k].values[0].value;
        if (k == 0 || t.rows[k - 1].values[0].value != first) {
            plot.curves.push_back({{}, {}, std::min(style++, 3), "", true});
            plot.curves.back().label = fmt::format("{}, {} = {:g}", t.table, t.factors[0], first);
        }
        plot.curves.back().x.push_back(t.rows[k].values[1].value);
        plot.curves.back().y.push_back(t.rows[k].response->value);
    }
}

}  // namespace

Figure effects_figure(const Replayed& r) {
    const std::string& unit = r.published.unit;
    std::vector<IntervalRow> rows;
    for (std::size_t k = 0; k < r.published.claimed.size(); ++k) {
        const std::string& letter = r.published.claimed[k];
        for (const EffectFit& fit : r.audit.fits) {
            for (const Effect& e : fit.effects) {
                if (e.factor != letter) continue;
                const std::string with = fit.left_out.empty() ? "" : ", without " + fit.left_out;
                rows.push_back({letter + with,
                                e.estimate,
                                e.interval.low,
                                e.interval.high,
                                {},
                                static_cast<int>(k % 4)});
            }
        }
    }
    Figure f;
    if (rows.empty()) return f;
    f.svg = interval_svg("Effects that fit the runs equally well",
                         "effects of the claimed factors with 95 % intervals, by fit",
                         "effect from low to high level, " + unit, rows, "calibration-effects");
    f.caption =
        r.audit.fits.size() > 1
            ? "Least squares over the runs that formed, each time without another of the factors "
              "that cannot be told apart; 95 % intervals. All these fits have the same residuals."
            : "Least squares over the runs that formed; 95 % intervals.";
    return f;
}

Figure imputed_figure(const Replayed& r) {
    const Published& p = r.published;
    if (r.audit.failed == 0) return {};
    const std::vector<double> values{0.0, r.audit.bound};
    Plot plot{
        .title = "Effects against what a failed run counts as",
        .description = "the effects of the claimed factors are straight lines that cross zero",
        .x = {.label = "value counted for a failed run, " + p.unit, .range = {}},
        .y = {.label = "effect, " + p.unit, .range = {}},
        .bands = {},
        .curves = {}};
    const std::vector<Imputed> ends = imputed(p.screening, values);
    for (std::size_t k = 0; k < p.claimed.size() && k < 3; ++k) {
        const std::size_t j = index_of(p, p.claimed[k]);
        plot.curves.push_back({values,
                               {ends[0].effects[j], ends[1].effects[j]},
                               static_cast<int>(k),
                               p.claimed[k] + ", " + p.factors[j].name});
    }
    plot.curves.push_back({values, {0.0, 0.0}, 3, "no effect"});
    return {svg(plot, "calibration-imputed"),
            "A failed run is no missing number: no heap formed there. Counted as an angle, it "
            "changes the effects and even their signs; the right end is the smallest angle of a "
            "heap that formed."};
}

Figure response_figure(const Replayed& r) {
    const Published& p = r.published;
    const PublishedFactor& second = p.factor(p.orthogonal.factors[1]);
    Plot plot{.title = "The way to the target",
              .description = "responses rise with the second factor and cross the target",
              .x = {.label = axis_label(second), .range = {}},
              .y = {.label = p.response + ", " + p.unit, .range = {}},
              .bands = {},
              .curves = {}};
    const auto column = std::find(p.second_ascent.factors.begin(), p.second_ascent.factors.end(),
                                  p.orthogonal.factors[1]) -
                        p.second_ascent.factors.begin();
    Curve ascent{{}, {}, 0, p.second_ascent.table + ", both factors rising", true};
    for (const PublishedRow& row : p.second_ascent.rows) {
        if (!row.response) continue;
        ascent.x.push_back(row.values[static_cast<std::size_t>(column)].value);
        ascent.y.push_back(row.response->value);
    }
    const auto [low, high] =
        std::minmax_element(p.experiment.readings.begin(), p.experiment.readings.end());
    const double from = *std::min_element(ascent.x.begin(), ascent.x.end());
    const double to = *std::max_element(ascent.x.begin(), ascent.x.end());
    plot.bands.push_back(
        {{from, to}, {*low, *low}, {*high, *high}, 2, "readings of the experiment"});
    const double target = p.experiment.target.value;
    plot.curves.push_back({{from, to}, {target, target}, 3, "target"});
    plot.curves.push_back(ascent);
    add_orthogonal(plot, p.orthogonal);
    const double a = p.orthogonal.rows[static_cast<std::size_t>(p.line.first - 1)].values[1].value;
    const double b = p.orthogonal.rows[static_cast<std::size_t>(p.line.second - 1)].values[1].value;
    const Line& line = r.replay.line;
    plot.curves.push_back({{a, b},
                           {line.intercept + line.slope * a, line.intercept + line.slope * b},
                           2,
                           "line of " + p.line.table});
    return {
        svg(plot, "calibration-response"),
        fmt::format("The line through two runs meets the target of {} {} at {:.4f}; the band is "
                    "what the experiment's readings span.",
                    p.experiment.target.text, p.unit, line.solution)};
}

}  // namespace reports
