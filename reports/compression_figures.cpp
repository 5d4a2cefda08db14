// SPDX-License-Identifier: MIT
#include "reports/compression_figures.hpp"

#include "reports/numbers.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reports {

namespace {

constexpr double kilo = 1e3;
constexpr int points = 60;  // of a line

using Which = verify::StressStrain verify::CompressionSample::*;

// Pa at a strain of one sample, by straight lines between its points; NaN beyond them.
double stress_at(const verify::StressStrain& curve, double strain) {
    for (std::size_t k = 1; k < curve.strain.size(); ++k) {
        const double from = curve.strain[k - 1], to = curve.strain[k];
        if (strain < from || strain > to || to <= from) continue;
        return curve.stress[k - 1] +
               (strain - from) / (to - from) * (curve.stress[k] - curve.stress[k - 1]);
    }
    return std::nan("");
}

// The strains that every sample has.
std::pair<double, double> common_strains(const verify::CompressionSide& side, Which which) {
    double low = 0.0, high = 1.0;
    for (const verify::CompressionSample& s : side.samples) {
        const std::vector<double>& strain = (s.*which).strain;
        if (strain.empty()) continue;
        low = std::max(low, strain.front());
        high = std::min(high, strain.back());
    }
    return {low, high};
}

void draw(Plot& plot, const verify::CompressionSide& side, Which which, double from, int style) {
    const auto [low, high] = common_strains(side, which);
    Curve mean{.x = {}, .y = {}, .style = style, .label = fmt::format("h = {:g}", side.h)};
    Band band{.x = {}, .low = {}, .high = {}, .style = style, .label = ""};
    for (int k = 0; k <= points; ++k) {
        const double strain = std::max(low, from) + (high - std::max(low, from)) * k / points;
        double sum = 0.0, least = INFINITY, most = -INFINITY;
        for (const verify::CompressionSample& s : side.samples) {
            const double stress = stress_at(s.*which, strain) / kilo;
            sum += stress, least = std::min(least, stress), most = std::max(most, stress);
        }
        if (!std::isfinite(sum)) continue;
        mean.x.push_back(strain), band.x.push_back(strain);
        mean.y.push_back(sum / static_cast<double>(side.samples.size()));
        band.low.push_back(least), band.high.push_back(most);
    }
    plot.curves.push_back(std::move(mean));
    plot.bands.push_back(std::move(band));
}

Figure curves_figure(const verify::RuleResult& rule, Which which, double from,
                     const std::string& title, const std::string& strain,
                     const std::string& caption, const std::string& id) {
    Plot plot{
        .title = title,
        .description = fmt::format("Stress of the piston over strain for {}.", rule.rule.what),
        .x = {.label = strain},
        .y = {.label = "stress of the piston, kPa"},
        .bands = {},
        .curves = {}};
    draw(plot, rule.reference, which, from, 0);
    for (std::size_t k = 0; k < rule.cells.size(); ++k)
        draw(plot, rule.cells[k].side, which, from, static_cast<int>(k) + 1);
    return {svg(plot, fmt::format("{}-{}", id, rule.rule.name)), caption};
}

}  // namespace

Figure strength_figure(const verify::CompressionStudy& study) {
    Plot plot{.title = "Unconfined strength over grain size",
              .description = "",
              .x = {.label = "h, grain size over that of the reference"},
              .y = {.label = "unconfined strength, kPa"},
              .bands = {},
              .curves = {}};
    int style = 0;
    for (const verify::RuleResult& r : study.rules) {
        if (!r.rule.adhesive) continue;
        Curve mean{.x = {}, .y = {}, .style = style, .label = r.rule.what};
        Curve all{.x = {}, .y = {}, .style = style, .label = "", .marked = true, .fine = true};
        const auto take = [&](const verify::CompressionSide& side) {
            double sum = 0.0;
            for (const verify::CompressionSample& s : side.samples) {
                all.x.push_back(side.h), all.y.push_back(s.strength / kilo);
                sum += s.strength / kilo;
            }
            mean.x.push_back(side.h);
            mean.y.push_back(sum / static_cast<double>(side.samples.size()));
        };
        take(r.reference);
        for (const verify::CompressionCellResult& cell : r.cells) take(cell.side);
        plot.description += fmt::format("{}: from {} to {} kPa. ", r.rule.what,
                                        number(mean.y.front()), number(mean.y.back()));
        plot.curves.push_back(std::move(mean));
        plot.curves.push_back(std::move(all));
        ++style;
    }
    double highest = 0.0;
    for (const Curve& c : plot.curves)
        highest = std::max(highest, *std::max_element(c.y.begin(), c.y.end()));
    plot.y.range = std::pair{0.0, 1.05 * highest};
    return {svg(plot, "strength"), "Means as lines, one small mark for each sample."};
}

// Below this the powder is still the loose one that was filled in, and the piston carries nothing.
constexpr double first_strain = 0.2;

Figure confined_figure(const verify::RuleResult& rule) {
    return curves_figure(rule, &verify::CompressionSample::confined, first_strain,
                         "Confined compression", "axial strain, from the cell as filled",
                         "Mean over seeds; the band reaches from the lowest to the highest.",
                         "confined");
}

Figure crushed_figure(const verify::RuleResult& rule) {
    return curves_figure(rule, &verify::CompressionSample::crushed, 0.0, "Unconfined crushing",
                         "axial strain, from where it stood free",
                         "Mean over seeds; the band reaches from the lowest to the highest. The "
                         "strength is the largest stress of each sample, not of the mean.",
                         "crushed");
}

}  // namespace reports
