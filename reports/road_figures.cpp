// SPDX-License-Identifier: MIT
#include "reports/road_figures.hpp"

#include "reports/numbers.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reports {

namespace {

using calibrate::Calibration;
using calibrate::Factor;
using calibrate::Run;
using calibrate::Slice;
using calibrate::Target;

constexpr double of_95 = 1.96;  // standard deviations of a normal

std::string label_of(const Factor& f) {
    const std::string label =
        f.unit == "1" ? words(f.name) : fmt::format("{}, {}", words(f.name), f.unit);
    return f.logarithmic ? "decimal logarithm of " + label : label;
}

std::vector<double> along(const Factor& f, std::vector<double> values) {
    if (f.logarithmic)
        for (double& v : values) v = std::log10(v);
    return values;
}

double moved(const Slice& s) {
    const auto [low, high] = std::minmax_element(s.mean.begin(), s.mean.end());
    return *high - *low;
}

Figure response_figure(const Calibration& c, std::size_t target, std::size_t factor,
                       const Slice& s) {
    const Target& t = c.pile.problem.targets[target];
    const Factor& f = c.pile.problem.factors[factor];
    const std::vector<double> at = along(f, s.at);
    Plot plot;
    plot.title = words(t.name) + " against " + words(f.name);
    plot.x = {.label = label_of(f)};
    plot.y = {.label = fmt::format("{}, {}", words(t.name), t.unit)};
    plot.bands.push_back({at, s.low, s.high, 0, ""});
    plot.curves.push_back({at, s.mean, 0, "surrogate, others as in the answer"});
    Curve heaps{{}, {}, 1, "runs, others anywhere", true}, none{{}, {}, 3, "no heap formed", true};
    double lowest = *std::min_element(s.low.begin(), s.low.end());
    double highest = *std::max_element(s.high.begin(), s.high.end());
    for (const Run& run : c.history)
        if (run.values) {
            lowest = std::min(lowest, (*run.values)[target]);
            highest = std::max(highest, (*run.values)[target]);
        }
    const double edge = lowest - 0.06 * (highest - lowest);
    for (const Run& run : c.history) {
        Curve& there = run.values ? heaps : none;
        there.x.push_back(along(f, {run.request.point[static_cast<Eigen::Index>(factor)]}).front());
        there.y.push_back(run.values ? (*run.values)[target] : edge);
    }
    plot.curves.push_back(std::move(heaps));
    if (!none.x.empty()) plot.curves.push_back(std::move(none));
    if (t.value) {
        const double wide = of_95 * t.standard_deviation;
        const std::vector<double> ends{at.front(), at.back()};
        plot.bands.push_back({ends,
                              {*t.value - wide, *t.value - wide},
                              {*t.value + wide, *t.value + wide},
                              2,
                              "measured"});
    }
    plot.description =
        fmt::format("{} moves by {} {} from end to end.", plot.title, number(moved(s)), t.unit);
    return {svg(plot, fmt::format("response-{}-{}", target, factor)),
            "Line and band: surrogate of all runs with 95 %. Runs at other values of the other "
            "parameters do not lie on the line; what formed no heap lies on the lower edge."};
}

}  // namespace

Figure confirmation_figure(const Calibration& c) {
    const Target& t = c.pile.problem.targets.front();
    const double wide = of_95 * t.standard_deviation;
    std::vector<IntervalRow> rows{
        {"measured", *t.value, *t.value - wide, *t.value + wide, c.pile.angles, 0}};
    if (const auto there = calibrate::confirmed(c, 0)) {
        std::vector<double> heaps;
        for (const Run& run : c.confirming())
            if (run.values) heaps.push_back(run.values->front());
        rows.push_back({"fresh heaps", there->mean,
                        there->interval ? there->interval->low : there->mean,
                        there->interval ? there->interval->high : there->mean, heaps, 1});
    }
    return {interval_svg("Measured and simulated",
                         "The measured mean and that of heaps with fresh seeds, with 95 %.",
                         fmt::format("{}, {}", words(t.name), t.unit), rows, "confirmation"),
            "Means with 95 %; small marks are single readings and single heaps."};
}

Figure range_figure(const Calibration& c) {
    if (!c.surrogate) return {};
    std::vector<IntervalRow> rows;
    const auto& factors = c.pile.problem.factors;
    for (std::size_t k = 0; k < factors.size(); ++k) {
        const auto share = [&](double v) { return calibrate::share_of_range(factors[k], v); };
        const auto& i = c.surrogate->free[k];
        rows.push_back({words(factors[k].name),
                        share(c.surrogate->answer[static_cast<Eigen::Index>(k)]),
                        share(i.low),
                        share(i.high),
                        {},
                        0});
    }
    return {
        interval_svg("What the recordings fix",
                     "Each parameter's answer and 95 % interval as a share of its range.",
                     "share of the range, 0 to 1", rows, "ranges"),
        "Answer and 95 % with the other parameters free, on a logarithmic range where that spans a "
        "decade. An interval from end to end: these recordings say nothing of it."};
}

std::vector<Figure> response_figures(const Calibration& c, std::size_t target) {
    constexpr std::size_t most = 3;
    constexpr int points = 41;
    if (c.given || !c.pile.problem.targets[target].value) return {};
    std::vector<std::pair<double, std::size_t>> order;
    std::vector<Slice> slices;
    for (std::size_t k = 0; k < c.pile.problem.factors.size(); ++k) {
        const auto s = calibrate::slice(c, target, k, points);
        if (!s) return {};
        order.emplace_back(-moved(*s), k);
        slices.push_back(*s);
    }
    std::sort(order.begin(), order.end());
    std::vector<Figure> figures;
    for (std::size_t n = 0; n < std::min(most, order.size()); ++n)
        figures.push_back(response_figure(c, target, order[n].second, slices[order[n].second]));
    return figures;
}

}  // namespace reports
