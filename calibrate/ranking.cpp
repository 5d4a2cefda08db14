// SPDX-License-Identifier: MIT
#include "calibrate/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace calibrate {

namespace {

const Effect* effect_of(const EffectFit& fit, const std::string& factor) {
    for (const Effect& e : fit.effects)
        if (e.factor == factor) return &e;
    return nullptr;
}

// The first of the claimed effects that does not differ from zero, or not in size from the next, in
// words; empty where there is none.
std::string weakest(const std::vector<std::string>& claimed, const EffectFit& fit, double t) {
    const Effect* before = nullptr;
    for (const std::string& factor : claimed) {
        const Effect* e = effect_of(fit, factor);
        if (e == nullptr || !(std::abs(e->t) > t))
            return fmt::format("{} does not differ from zero at 95 %", factor);
        if (before != nullptr) {
            const double apart = std::abs(before->estimate) - std::abs(e->estimate);
            const double error = std::hypot(before->standard_error, e->standard_error);
            if (!(apart > t * error))
                return fmt::format("{} is not larger than {} at 95 %", before->factor, factor);
        }
        before = e;
    }
    return "";
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
        const int terms = static_cast<int>(n.coefficients.size());
        const std::vector<std::string> names = linear_terms(terms - 1);
        for (int k = 1; k < terms; ++k) {
            const std::string& name = names[static_cast<std::size_t>(k)];
            const bool new_one = std::find(tangled.begin(), tangled.end(), name) == tangled.end();
            const bool asked = std::find(claimed.begin(), claimed.end(), name) != claimed.end();
            if (n.coefficients(k) != 0.0 && asked && new_one) tangled.push_back(name);
        }
    }
    r.structural = tangled.empty();
    for (const EffectFit& fit : fits) {
        r.other.push_back(order_of(fit, claimed.size()));
        if (fit.degrees_of_freedom < 1) continue;
        r.t_needed = statistics::student_quantile(0.975, fit.degrees_of_freedom);
        for (const Effect& e : fit.effects) r.largest_t = std::max(r.largest_t, std::abs(e.t));
    }
    if (!r.structural) {
        r.why = fmt::format("{} cannot be told apart, since {}", fmt::join(tangled, ", "),
                            null_vectors.front().text);
        std::vector<std::string> orders;
        for (const std::string& order : r.other)
            if (std::find(orders.begin(), orders.end(), order) == orders.end())
                orders.push_back(order);
        if (!orders.empty())
            r.why += fmt::format(": fits with the same residuals order the effects {}",
                                 fmt::join(orders, "; or "));
        return r;
    }
    const std::string weak = fits.empty() || r.t_needed == 0.0
                                 ? "no degree of freedom is left to judge by"
                                 : weakest(claimed, fits.front(), r.t_needed);
    r.identifiable = weak.empty();
    r.why = weak.empty() ? "each effect differs from zero and from the next at 95 %" : weak;
    return r;
}

}  // namespace calibrate
