// SPDX-License-Identifier: MIT
#include "calibrate/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace calibrate {

namespace {

bool differs_from_zero(const EffectFit& fit, const std::string& factor) {
    for (const Effect& e : fit.effects)
        if (e.factor == factor) return e.p < 0.05;
    return false;
}

}  // namespace

std::string order_of(const EffectFit& fit, std::size_t count) {
    std::vector<Effect> sorted = fit.effects;
    std::sort(sorted.begin(), sorted.end(), [](const Effect& a, const Effect& b) {
        return std::abs(a.estimate) > std::abs(b.estimate);
    });
    std::vector<std::string> names;
    for (const Effect& e : sorted)
        if (names.size() < count) names.push_back(e.factor);
    return fmt::format("{}", fmt::join(names, " > "));
}

Ranking judged_ranking(const std::vector<std::string>& claimed,
                       const std::vector<NullVector>& null_vectors,
                       const std::vector<EffectFit>& fits) {
    Ranking r{};
    r.claimed = fmt::format("{}", fmt::join(claimed, " > "));
    std::vector<std::string> tangled;
    for (const NullVector& n : null_vectors) {
        for (const std::string& factor : claimed) {
            const std::vector<std::string> names =
                linear_terms(static_cast<int>(n.coefficients.size()) - 1);
            const auto at = std::find(names.begin(), names.end(), factor) - names.begin();
            if (n.coefficients(at) != 0.0) tangled.push_back(factor);
        }
    }
    r.structural = tangled.empty();
    for (const EffectFit& fit : fits) {
        r.other.push_back(order_of(fit, claimed.size()));
        if (fit.degrees_of_freedom < 1) continue;
        r.t_needed = statistics::student_quantile(0.975, fit.degrees_of_freedom);
        for (const Effect& e : fit.effects) r.largest_t = std::max(r.largest_t, std::abs(e.t));
    }
    bool all_differ = fits.size() == 1;
    for (const std::string& factor : claimed)
        all_differ = all_differ && differs_from_zero(fits.front(), factor);
    r.identifiable = r.structural && all_differ;
    if (!r.structural)
        r.why = fmt::format(
            "{} cannot be told apart, since {}: fits with the same residuals order the effects {}",
            fmt::join(tangled, ", "), null_vectors.front().text, fmt::join(r.other, "; or "));
    else if (!r.identifiable)
        r.why = "not every claimed effect differs from zero at 95 %";
    else
        r.why = "each claimed effect can be estimated and differs from zero at 95 %";
    return r;
}

}  // namespace calibrate
