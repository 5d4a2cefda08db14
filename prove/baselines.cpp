// SPDX-License-Identifier: MIT
#include "prove/baselines.hpp"

#include "prove/terms.hpp"

#include <Eigen/QR>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace prove {
namespace {

// What is seen of a blind case: start values for the truth, white noise of the stated or an estimated size.
struct Seen {
    Skeleton sk;
    std::vector<std::size_t> list, later;
    Eigen::VectorXd recorded, unseen;
};

Seen seen_of(const BlindCase& blind) {
    Seen s{
        blind.skeleton, with_role(blind.skeleton, false), with_role(blind.skeleton, true), {}, {}};
    for (Stated& p : s.sk.parameters) s.sk.world.*p.place = p.truth = p.start;
    s.sk.noise = {};
    Eigen::Index split = 0;
    for (const std::size_t e : s.list) split += static_cast<Eigen::Index>(s.sk.stated[e].size());
    s.recorded = blind.recordings.head(split);
    s.unseen = blind.recordings.tail(blind.recordings.size() - split);
    if (s.sk.states_noise) return s;
    // From the differences of neighbours, which the motion hardly changes.
    Eigen::Index k = 0;
    for (const std::size_t e : s.list) {
        Setup& setup = s.sk.stated[e];
        for (double& noise : setup.noise) {
            double sum = 0.0;
            int n = 0;
            for (std::size_t row = 0; row + 2 < setup.at.size(); ++row) {
                const Eigen::Index at = k + static_cast<Eigen::Index>(row);
                const double d = s.recorded[at] - 2.0 * s.recorded[at + 1] + s.recorded[at + 2];
                if (std::isfinite(d)) sum += d * d / 6.0, ++n;
            }
            if (n > 0) noise = std::sqrt(sum / n);
            k += static_cast<Eigen::Index>(setup.at.size());
        }
    }
    return s;
}

struct Model {
    std::vector<const Term*> terms;
    Fit fit;
    double bic;
};

Model model_of(const Seen& s, const std::vector<const Term*>& terms, const Fit& begin) {
    Model m{terms, terms.empty() ? begin : fit_with(s.sk, terms, s.list, s.recorded, begin, 10),
            0.0};
    std::size_t k = base_unknowns(s.sk, s.list).size();
    for (const Term* t : terms) k += t->unknowns.size();
    m.bic =
        m.fit.cost() + static_cast<double>(k) * std::log(static_cast<double>(s.recorded.size()));
    return m;
}

std::vector<std::string> names_of(const Model& m) {
    std::vector<std::string> names;
    for (const Term* t : m.terms) names.push_back(t->effect);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

void name(Verdict& v, const Seen& s, const Model& m) {
    v.verdict = m.terms.empty() ? "consistent" : "explained";
    const Eigen::VectorXd errors = standard_errors(m.fit);
    Eigen::Index k = static_cast<Eigen::Index>(base_unknowns(s.sk, s.list).size());
    for (const Term* t : m.terms) {
        JudgedEffect e{.name = t->effect, .probability = 1.0, .named = true};
        for (const Unknown& u : t->unknowns) {
            const double value = m.fit.theta[k], half = 1.645 * errors[k];
            // drag_coefficient is told at the fastest speed, which this method does not look up.
            if (u.name != "drag_coefficient")
                e.parameters.push_back({u.name, value, value - half, value + half});
            ++k;
        }
        v.effects.push_back(std::move(e));
    }
    const std::vector<Setup> later = chosen(s.sk.stated, s.later);
    v.held_out_extended = mean_nrmse(later, predict(m.fit.world, later), s.unseen);
}

// Whitened change of the recordings by each free parameter of the model, then by each term at its weakest start.
Eigen::MatrixXd derivatives(const Seen& s, const std::vector<Term>& all, const Fit& begin) {
    const Eigen::VectorXd here = predict(begin.world, begin.setups);
    const std::vector<Unknown> base = base_unknowns(s.sk, s.list);
    const Eigen::Index fixed = static_cast<Eigen::Index>(base.size());
    Eigen::MatrixXd columns(here.size(), fixed + static_cast<Eigen::Index>(all.size()));
    for (Eigen::Index k = 0; k < fixed; ++k) {
        Fit moved = begin;
        const Unknown& u = base[static_cast<std::size_t>(k)];
        moved.theta[k] += 1e-4 * (u.high - u.low);
        put(base, moved.theta, moved.world, moved.setups);
        columns.col(k) = whitened(begin.setups, {}, predict(moved.world, moved.setups) - here);
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        World w = begin.world;
        enable(all[k], w);
        std::vector<Setup> setups = begin.setups;
        Eigen::VectorXd start(static_cast<Eigen::Index>(all[k].unknowns.size()));
        for (Eigen::Index i = 0; i < start.size(); ++i)
            start[i] = all[k].unknowns[static_cast<std::size_t>(i)].starts.front();
        put(all[k].unknowns, start, w, setups);
        columns.col(fixed + static_cast<Eigen::Index>(k)) =
            whitened(begin.setups, {}, predict(w, setups) - here);
    }
    return columns;
}

// Columns that stay, with their coefficients; the first `fixed` always do.
std::vector<std::pair<Eigen::Index, double>> thresholded(Eigen::MatrixXd columns,
                                                         const Eigen::VectorXd& residual,
                                                         Eigen::Index fixed) {
    std::vector<Eigen::Index> active;
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
        const double length = columns.col(k).norm();
        if (!(length > 1e-9) || !std::isfinite(length)) continue;
        columns.col(k) /= length;
        active.push_back(k);
    }
    std::vector<std::pair<Eigen::Index, double>> kept;
    for (int round = 0; round < 20 && !active.empty(); ++round) {
        Eigen::MatrixXd x(columns.rows(), static_cast<Eigen::Index>(active.size()));
        for (std::size_t k = 0; k < active.size(); ++k)
            x.col(static_cast<Eigen::Index>(k)) = columns.col(active[k]);
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors(x);
        const Eigen::VectorXd coefficients = factors.solve(residual);
        const Eigen::MatrixXd inverse = factors.pseudoInverse();
        kept.clear();
        for (std::size_t k = 0; k < active.size(); ++k) {
            const Eigen::Index row = static_cast<Eigen::Index>(k);
            const double error = inverse.row(row).norm();
            if (active[k] < fixed || std::abs(coefficients[row]) > 3.0 * error)
                kept.emplace_back(active[k], coefficients[row]);
        }
        if (kept.size() == active.size()) break;
        active.clear();
        for (const auto& [column, coefficient] : kept) active.push_back(column);
    }
    return kept;
}

}  // namespace

Verdict bic_verdict(const BlindCase& blind) {
    const Seen s = seen_of(blind);
    const std::vector<Term> all = terms(s.sk.stated, s.sk.physics);
    const Fit begin = base_fit(s.sk, s.list, s.recorded);
    std::vector<Model> models{model_of(s, {}, begin)};
    for (const Term& t : all) models.push_back(model_of(s, {&t}, begin));
    std::vector<std::size_t> order;
    for (std::size_t k = 1; k < models.size(); ++k) order.push_back(k);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return models[a].bic < models[b].bic; });
    for (std::size_t first = 0; first < std::min<std::size_t>(3, order.size()); ++first) {
        const Term* one = models[order[first]].terms.front();
        for (const Term& other : all) {
            const bool done =
                std::any_of(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(first),
                            [&](std::size_t k) { return models[k].terms.front() == &other; });
            if (&other == one || done) continue;
            models.push_back(model_of(s, {one, &other}, models[order[first]].fit));
        }
    }
    const auto best = std::min_element(models.begin(), models.end(),
                                       [](const auto& a, const auto& b) { return a.bic < b.bic; });
    Verdict v;
    double sum = 0.0;
    for (const Model& m : models) sum += std::exp(-0.5 * (m.bic - best->bic));
    for (const Model& m : models) {
        const double p = std::exp(-0.5 * (m.bic - best->bic)) / sum;
        if (p > 1e-6) v.hypotheses.push_back({names_of(m), p});
    }
    name(v, s, *best);
    return v;
}

Verdict sparse_verdict(const BlindCase& blind) {
    const Seen s = seen_of(blind);
    const std::vector<Term> all = terms(s.sk.stated, s.sk.physics);
    const Fit begin = base_fit(s.sk, s.list, s.recorded);
    const Eigen::VectorXd residual =
        whitened(begin.setups, {}, s.recorded - predict(begin.world, begin.setups));
    const Eigen::Index fixed = static_cast<Eigen::Index>(base_unknowns(s.sk, s.list).size());
    std::vector<std::pair<double, std::string>> found;
    for (const auto& [column, coefficient] :
         thresholded(derivatives(s, all, begin), residual, fixed))
        if (column >= fixed)
            found.emplace_back(-std::abs(coefficient),
                               all[static_cast<std::size_t>(column - fixed)].effect);
    std::sort(found.begin(), found.end());
    if (found.size() > 2) found.resize(2);
    Verdict v{.verdict = found.empty() ? "consistent" : "explained"};
    Hypothesis h{{}, 1.0};
    for (const auto& [size, effect] : found) {
        if (std::find(h.effects.begin(), h.effects.end(), effect) != h.effects.end()) continue;
        h.effects.push_back(effect);
        v.effects.push_back({.name = effect, .probability = 1.0, .named = true});
    }
    std::sort(h.effects.begin(), h.effects.end());
    v.hypotheses = {h};
    return v;
}

Verdict commonest_verdict(const Keys& keys) {
    std::map<std::vector<std::string>, int> counts;
    for (const auto& [name, key] : keys) {
        std::vector<std::string> effects = key.effects;
        std::sort(effects.begin(), effects.end());
        ++counts[effects];
    }
    Verdict v{.verdict = "explained"};
    const std::vector<std::string>* best = nullptr;
    for (const auto& [effects, n] : counts) {
        v.hypotheses.push_back(
            {effects, static_cast<double>(n) / static_cast<double>(keys.size())});
        if (effects.size() != 1 || effects.front() == "unknown") continue;
        if (best == nullptr || n > counts[*best]) best = &effects;
    }
    if (best != nullptr)
        v.effects.push_back({.name = best->front(), .probability = 1.0, .named = true});
    return v;
}

Verdict oracle_verdict(const Key& key) {
    Hypothesis truth{key.effects, 1.0};
    std::sort(truth.effects.begin(), truth.effects.end());
    const double p =
        gsl_cdf_chisq_Q(std::max(0.0, key.oracle_statistic), std::max(1, key.oracle_freedom));
    // Of a null it knows no term: a fair test alarms in one of twenty, which the table of the nulls shows by itself.
    if (key.kind == Kind::null || p >= 0.05)
        return {.verdict = "consistent", .hypotheses = {{{}, 1.0}}};
    Verdict v{.verdict = key.kind == Kind::outside ? "unexplained" : "explained"};
    v.hypotheses = {truth};
    for (const std::string& effect : key.effects)
        v.effects.push_back({.name = effect, .probability = 1.0, .named = effect != "unknown"});
    for (const TrueParameter& t : key.parameters)
        for (JudgedEffect& e : v.effects)
            if (e.name == t.effect) e.parameters.push_back({t.name, t.value, NAN, NAN});
    v.held_out_extended = key.oracle_held_out;
    return v;
}

}  // namespace prove
