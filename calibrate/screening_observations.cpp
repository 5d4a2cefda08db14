// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "calibrate/observations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace calibrate {

namespace {

using scaling::Judgement;

constexpr const char* topic = "screening";

std::size_t index_of(const Published& p, const std::string& letter) {
    std::size_t k = 0;
    while (p.factors[k].letter != letter) ++k;
    return k;
}

std::string letters_where(const Published& p, const std::vector<bool>& able, bool wanted) {
    std::vector<std::string> letters;
    for (std::size_t k = 0; k < p.factors.size(); ++k)
        if (able[k + 1] == wanted) letters.push_back(p.factors[k].letter);
    return fmt::format("{}", fmt::join(letters, ", "));
}

void add_design(std::vector<Observation>& all, const Published& p, const Audit& a) {
    const bool power_of_two = (a.runs & (a.runs - 1)) == 0;
    all.push_back(
        {topic, "planned_d_efficiency", a.planned_d_efficiency, "1", p.screening_table,
         a.planned_orthogonal ? Judgement::fine : Judgement::caution,
         fmt::format(
             "the planned {} runs are {}; a fraction of 2^k has a power of two "
             "of runs, so {}",
             a.runs,
             a.planned_orthogonal ? "balanced and orthogonal: a good design" : "not orthogonal",
             power_of_two ? "this can be one" : "this is a Plackett-Burman design")});
    const std::size_t others = (p.factors.size() - 1) * (p.factors.size() - 2) / 2;
    const double largest = a.aliases.empty()
                               ? 0.0
                               : std::abs(std::max_element(a.aliases.begin(), a.aliases.end(),
                                                           [](const Alias& x, const Alias& y) {
                                                               return std::abs(x.coefficient) <
                                                                      std::abs(y.coefficient);
                                                           })
                                              ->coefficient);
    all.push_back({topic, "aliases_of_main_effects", static_cast<double>(a.aliases.size()), "1",
                   p.screening_table, Judgement::caution,
                   fmt::format("each main effect carries {} two-factor interactions (of the {} "
                               "without its factor), at most {:.3g} of each; they may be ignored "
                               "only where they are small. Folding the design over, {} runs, frees "
                               "main effects of all of them",
                               a.aliases.size() / p.factors.size(), others, largest, 2 * a.runs)});
}

void add_rank(std::vector<Observation>& all, const Published& p, const Audit& a) {
    if (a.null_vectors.empty()) return;
    const std::string null = a.null_vectors.front().text;
    all.push_back(
        {topic, "rank_without_failed_runs", static_cast<double>(a.rank), "1", p.effects_table,
         Judgement::unusable,
         fmt::format("rank {} of {}: without the {} failed runs every run has {}, so "
                     "that the effects of {} cannot be told apart. By themselves only {} "
                     "can be estimated; of two others only {}",
                     a.rank, a.terms, a.failed, null, letters_where(p, a.estimable, false),
                     letters_where(p, a.estimable, true), fmt::join(a.estimable_pairs, ", "))});
    all.push_back({topic, "d_efficiency_without_failed_runs", a.d_efficiency, "1", p.effects_table,
                   Judgement::unusable,
                   "differences of means over the runs that are left mix the effects of factors "
                   "that are no longer balanced against each other"});
}

void add_ranking(std::vector<Observation>& all, const Published& p, const Audit& a) {
    const Ranking& r = a.ranking;
    std::string fits;
    for (const EffectFit& fit : a.fits) {
        std::string effects;
        for (const Effect& e : fit.effects)
            effects +=
                fmt::format("{}{} {:+.2f}", effects.empty() ? "" : ", ", e.factor, e.estimate);
        fits += fmt::format("{}without {}: {}", fits.empty() ? "" : "; ", fit.left_out, effects);
    }
    if (!fits.empty() && a.fits.size() > 1)
        all.push_back({topic, "sum_of_squares_of_all_these_fits", a.fits.front().sum_of_squares,
                       p.unit + "^2", p.effects_table, Judgement::caution,
                       "fits that nothing in the data tells apart: " + fits});
    all.push_back({topic, "claimed_ranking_identifiable", r.identifiable ? 1.0 : 0.0, "1",
                   p.effects_table, r.identifiable ? Judgement::fine : Judgement::unusable,
                   fmt::format("{}: {}", r.claimed, r.why)});
    if (r.t_needed > 0.0)
        all.push_back(
            {topic, "largest_t_of_any_effect", r.largest_t, "1", p.effects_table,
             r.largest_t > r.t_needed ? Judgement::fine : Judgement::caution,
             fmt::format("t = {:.2f} would be needed at 95 % with {} degrees of freedom and s = "
                         "{:.2f} {}; the planned design would have found effects of {:.1f} {} with "
                         "probability 0.8. No run was repeated with another seed, and no centre "
                         "run was made",
                         r.t_needed, a.fits.front().degrees_of_freedom, a.fits.front().spread,
                         p.unit, a.detectable, p.unit)});
}

// For how many of the imputed values the claimed order comes out.
void add_failed(std::vector<Observation>& all, const Published& p, const Audit& a) {
    for (const std::string& letter : p.claimed) {
        const std::size_t k = index_of(p, letter);
        if (a.failed == 0 || !a.sign_changes[k]) continue;
        const double zero = *a.sign_changes[k], effect = a.means[k].effect;
        const bool below = a.imputed.front().effects[k] * effect < 0.0;
        std::string values;
        for (const Imputed& i : a.imputed)
            values +=
                fmt::format("{}{:g}: {:+.2f}", values.empty() ? "" : ", ", i.value, i.effects[k]);
        all.push_back(
            {topic, "effect_of_" + letter + "_is_zero_at", zero, p.unit, p.effects_table,
             below ? Judgement::caution : Judgement::fine,
             fmt::format(
                 "{} has {:+.2f} {} with the failed runs dropped. Counted as an angle, they "
                 "give ({} -> effect) {}{}",
                 letter, effect, p.unit, p.unit, values,
                 below ? fmt::format("; below {:.1f} {} its sign is the other one", zero, p.unit)
                       : "")});
    }
    for (const ImpliedRange& r : a.implied) {
        if (r.effect.low == r.effect.high) continue;
        const bool up = std::isfinite(r.effect.low);
        const double edge = up ? r.effect.low : r.effect.high;
        if (std::find(p.claimed.begin(), p.claimed.end(), r.factor) == p.claimed.end()) continue;
        all.push_back({topic, "censored_bound_of_effect_of_" + r.factor, edge, p.unit,
                       p.screening_table, Judgement::caution,
                       fmt::format("if the failed heaps would have lain below {:.2f} {}, the "
                                   "smallest that formed, least squares allows effects of {} {} "
                                   "{:+.2f} {} only",
                                   a.censored->bound, p.unit, r.factor, up ? "from" : "up to", edge,
                                   p.unit)});
    }
}

void add_levels(std::vector<Observation>& all, const Published& p) {
    for (const auto& [letter, value] : p.confirmed_values) {
        const PublishedFactor& f = p.factor(letter);
        if (value >= f.low && value <= f.high) continue;
        all.push_back({topic, "answer_over_high_level_of_" + letter, value / f.high, "1", "Table 5",
                       Judgement::caution,
                       fmt::format("{} was screened at {:g} and {:g} and calibrated to {:g}: the "
                                   "screening does not reach where the answer lies",
                                   f.name, f.low, f.high, value)});
    }
    for (const PublishedFactor& f : p.factors) {
        const double middle = 0.5 * (f.range_low + f.range_high);
        if (!f.fixed || std::abs(f.fixed->value - middle) <= 1e-9) continue;
        all.push_back({topic, "fixed_over_middle_of_range_of_" + f.letter, f.fixed->value / middle,
                       "1", "section 4.5.2", Judgement::fine,
                       fmt::format("{} was fixed at {:g}, the middle of its screening levels; the "
                                   "middle of the range that was thought possible is {:g}",
                                   f.name, f.fixed->value, middle)});
    }
}

}  // namespace

AuditInput audit_input(const Published& p) {
    const Eigen::VectorXd y = responses_of(usable(p.screening));
    return {p.screening, p.claimed, {0.0, 5.0, 10.0, 15.0, 18.0}, y.minCoeff()};
}

std::vector<Observation> screening_observations(const Published& p, const Replay& r,
                                                const Audit& a) {
    std::vector<Observation> all;
    const int compared =
        static_cast<int>(std::count_if(r.digits.begin(), r.digits.end(), [&](const Recomputed& d) {
            return d.table == p.effects_table;
        }));
    const int wrong =
        static_cast<int>(std::count_if(r.digits.begin(), r.digits.end(), [&](const Recomputed& d) {
            return d.table == p.effects_table && !d.agrees;
        }));
    all.push_back({topic, "printed_numbers_that_differ", static_cast<double>(wrong), "1",
                   p.effects_table, wrong == 0 ? Judgement::fine : Judgement::caution,
                   fmt::format("{} printed numbers were computed again from the runs", compared)});
    add_design(all, p, a);
    add_rank(all, p, a);
    add_ranking(all, p, a);
    add_failed(all, p, a);
    add_levels(all, p);
    return all;
}

}  // namespace calibrate
