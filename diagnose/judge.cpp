// SPDX-License-Identifier: MIT
#include "diagnose/judge.hpp"

#include "diagnose/gates.hpp"
#include "diagnose/mismatch.hpp"
#include "diagnose/missing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace diagnose {

using Eigen::VectorXd;

namespace {

constexpr double much =
    25.0;  // chi squared by which two effects do better than one: the noise is looked at again

// In log evidence behind the best: a search for deeper minima is not begun there.
constexpr double out_of_reach = 300.0;

// How many singles of most evidence, and pairs, go on to deeper minima, how many singles are paired with all others and how many
// pairs are fitted: bounces and micro-slip take their time.
struct Effort {
    std::size_t singles, pairs, beam, fitted;
};
Effort effort(const Problem& p) {
    const auto any = [&](const char* rig) {
        return std::any_of(p.records.begin(), p.records.end(),
                           [&](const Record& r) { return r.experiment->rig == rig; });
    };
    constexpr std::size_t many_rows = 600;
    return any("drop")     ? Effort{3, 1, 4, 10}
           : any("impact") ? (p.size < many_rows ? Effort{8, 1, 5, 14} : Effort{5, 1, 4, 8})
                           : Effort{10, 10, 8, 40};
}

std::vector<std::size_t> best_of(const std::vector<Candidate>& list, std::size_t most) {
    std::vector<std::size_t> order(list.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return list[a].log_evidence > list[b].log_evidence;
    });
    order.resize(std::min(order.size(), most));
    return order;
}

}  // namespace

const Candidate* Judge::artefact() const {
    for (const Candidate& c : singles)
        if (c.h.terms.front()->effect == "numerical_artefact") return &c;
    return nullptr;
}

void Judge::fit_base() {
    base = {.h = problem.hypothesis({}), .fit = {}};
    base.fit = diagnose::fit_base(problem, *whiten, base.h);
    deepen(problem, *whiten, base, nullptr);
}

void Judge::fit_singles() {
    singles.assign(terms.size(), {});
    in_parallel(terms.size(), settings.threads,
                [&](std::size_t k) { singles[k] = extended(problem, *whiten, base, terms[k]); });
    std::vector<std::size_t> best = best_of(singles, effort(problem).singles);
    std::erase_if(best, [&](std::size_t k) {
        return singles[k].log_evidence < singles[best.front()].log_evidence - out_of_reach;
    });
    in_parallel(best.size(), settings.threads,
                [&](std::size_t k) { deepen(problem, *whiten, singles[best[k]], &base); });
    // An effect's fit may have found a better place for the base parameters, too.
    for (const Candidate& c : singles) {
        if (c.fit.theta.size() == 0 || c.h.unknowns.size() < base.h.unknowns.size()) continue;
        VectorXd theta = c.fit.theta.head(base.fit.theta.size());
        if (c.h.terms.front()->idle.empty()) {
            Candidate again{.h = base.h, .fit = fit(problem, *whiten, base.h, theta, false)};
            if (again.fit.objective() < base.fit.objective() - 1e-3)
                again.log_evidence = again.fit.log_evidence, base = std::move(again);
        }
    }
}

void Judge::fit_pairs() {
    const Effort most = effort(problem);
    pairs = pairs_of(problem, *whiten, singles, most.beam, most.fitted, settings.threads);
    const std::vector<std::size_t> best = best_of(pairs, most.pairs);
    in_parallel(best.size(), settings.threads,
                [&](std::size_t k) { deepen(problem, *whiten, pairs[best[k]], nullptr); });
    drop_idle(pairs, singles);
    // What one effect alone leaves looks like noise with a correlation: with two there may be none.
    double single = base.fit.objective(), two = single;
    for (const Candidate& c : singles) single = std::min(single, c.fit.objective());
    for (const Candidate& c : pairs) two = std::min(two, c.fit.objective());
    if (two > single - much) return;
    for (int k = 0; k < 2; ++k) {
        estimate_noise();
        refit_all();
    }
    forces = with_missing(problem, *whiten, base, force_terms);
}

// Every other effect added to the best singles and to the members of the best pair, from as many places as a single is. Vibrations
// have had their own wide search.
void Judge::search_pairs_again() {
    constexpr std::size_t most_rows = 1200;  // more take longer than a case may
    if (problem.size > most_rows) return;
    std::vector<std::size_t> members = best_of(singles, 2);
    for (const std::size_t k : best_of(pairs, 1))
        for (const Term* t : pairs[k].h.terms) {
            const auto at = static_cast<std::size_t>(t - terms.data());
            if (std::find(members.begin(), members.end(), at) == members.end())
                members.push_back(at);
        }
    std::vector<std::pair<std::size_t, std::size_t>> list;
    for (const std::size_t a : members)
        for (std::size_t b = 0; b < terms.size(); ++b)
            if (terms[a].effect != terms[b].effect && terms[a].effect != "vibration" &&
                terms[b].effect != "vibration")
                list.push_back({a, b});
    std::vector<Candidate> found(list.size());
    in_parallel(list.size(), settings.threads, [&](std::size_t k) {
        found[k] = extended(problem, *whiten, singles[list[k].first], terms[list[k].second]);
        found[k].unseen = 0.0;
        found[k].log_evidence = found[k].fit.log_evidence;
    });
    constexpr std::size_t deepened = 3;
    const std::vector<std::size_t> best = best_of(found, deepened);
    in_parallel(best.size(), settings.threads,
                [&](std::size_t k) { deepen(problem, *whiten, found[best[k]], nullptr); });
    pairs.insert(pairs.end(), found.begin(), found.end());
    drop_idle(pairs, singles);
}

void Judge::estimate_noise() {
    const Candidate& rich = richest();
    noise = estimated(problem, problem.recorded - rich.fit.prediction, rich.h.unknowns.size());
    whiten = std::make_unique<Whitener>(problem, noise);
}

// A recorded value that stands alone, six deviations off between neighbours that do not: a reading gone wrong. Physics that was
// left out moves neighbours too.
void Judge::set_outliers_aside() {
    constexpr double far_off = 6.0, near = 3.5;
    const VectorXd white = richest().fit.white;
    for (Record& r : problem.records)
        for (Channel& c : r.channels) {
            if (r.covariance.size() > 0) continue;
            const auto off = [&](std::size_t k) {
                return k < c.recorded.size()
                           ? std::abs(white[static_cast<Eigen::Index>(c.first + k)])
                           : 0.0;
            };
            for (std::size_t k = 1; k + 1 < c.recorded.size(); ++k) {
                if (off(k) < far_off || off(k - 1) > near || off(k + 1) > near) continue;
                verdict.warnings.push_back(
                    fmt::format("{}: one value of {} stands {:.1f} times the noise off, its "
                                "neighbours do not: it was set aside "
                                "({} = {:.4g}).",
                                r.experiment->id, c.name, off(k), r.ordinate, r.ordinates.at[k]));
                c.recorded[k] = std::nan("");
                problem.recorded[static_cast<Eigen::Index>(c.first + k)] = std::nan("");
            }
        }
    whiten = std::make_unique<Whitener>(problem, noise);
}

void Judge::refit_all() {
    refit(problem, *whiten, base, nullptr);
    in_parallel(singles.size(), settings.threads,
                [&](std::size_t k) { refit(problem, *whiten, singles[k], &base); });
    in_parallel(pairs.size(), settings.threads,
                [&](std::size_t k) { refit(problem, *whiten, pairs[k], nullptr); });
}

double Judge::test(const Candidate& c, const std::vector<Shape>& list, int n) const {
    return p_of_mismatch(problem, *whiten, c.h, c.fit, list, innovations, settings.seed, n);
}

std::vector<Shape> Judge::shapes_about(const Candidate& c) const {
    return shapes(problem, *whiten, c.h, c.fit, terms);
}

// Of the largest drop in chi squared by a single effect, where nothing was left out: chi squared of its unknowns and one more,
// times the places looked at.
double Judge::p_of_best_gain() const {
    constexpr double frequencies = 250.0;
    double least = 1.0;
    for (const Candidate& c : singles) {
        const Term& term = *c.h.terms.front();
        const double gain = std::max(0.0, base.fit.objective() - c.fit.objective());
        const double z = normal_of_squares(gain, static_cast<double>(term.unknowns.size()) + 1.0);
        const double looks =
            static_cast<double>(singles.size()) * (term.effect == "vibration" ? frequencies : 1.0);
        least = std::min(least, looks * 0.5 * std::erfc(z / std::numbers::sqrt2));
    }
    return std::max(least, 1e-4);  // the tails of real noise are not known further out
}

double Judge::own_p(const Candidate& c) const {
    const std::vector<Shape> list = shapes_about(c);
    const double p = test(c, list, few_draws);
    return p > 10.0 * own_level ? p : test(c, list, many_draws);
}

// Whether what explains most fails its own test of mismatch.
bool Judge::best_fails() const {
    const Candidate* best = &base;
    for (const std::vector<Candidate>* list : {&singles, &pairs})
        for (const Candidate& c : *list)
            if (c.log_evidence > best->log_evidence) best = &c;
    return own_p(*best) < own_level;
}

// Whether the effect of most evidence leaves nothing to a second one: it passes its own test of mismatch and all gates, and no
// force that nobody has named does better.
bool Judge::one_is_enough() const {
    const auto best = std::max_element(
        singles.begin(), singles.end(),
        [](const Candidate& a, const Candidate& b) { return a.log_evidence < b.log_evidence; });
    if (best == singles.end()) return false;
    if (!forces.empty() && forces.front().log_evidence > best->log_evidence) return false;
    const double p = own_p(*best);
    return p >= 0.05 && passes(gates({problem, *whiten, base, *best, p, std::nan("")}, 0));
}

}  // namespace diagnose
