// SPDX-License-Identifier: MIT
#include "diagnose/hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace diagnose {
namespace {

// Prior over hypotheses, before any recording is seen (docs/diagnose.md).
constexpr double prior_none = 0.35, prior_unknown = 0.07, prior_singles = 0.53, prior_pairs = 0.05;

// Log evidence of the strengths of an effect that would show. Where its fit gains little, Laplace's integral counts those that
// would not, too: it is at most the likelihood of the fit over an e-fold of the strength, or over all that would show.
double shown(const Candidate& c, const Candidate& base) {
    const Unknown* strength = c.h.terms.size() == 1 && !c.h.terms.front()->unknowns.empty()
                                  ? &c.h.terms.front()->unknowns.front()
                                  : nullptr;
    if (!strength || strength->prior != Prior::log_uniform) return c.log_evidence;
    const double share = std::min(1.0 - c.unseen, 1.0 / std::log(strength->high / strength->low));
    const double gain = std::max(0.0, base.fit.objective() - c.fit.objective());
    return std::min(c.fit.log_evidence,
                    base.fit.log_evidence + 0.5 * gain + std::log(std::max(share, 1e-6)));
}

}  // namespace

std::vector<Hypothesis> prior_hypotheses(const std::vector<std::string>& effects) {
    const double all = prior_none + prior_unknown + prior_singles;
    std::vector<Hypothesis> list{{{}, prior_none / all}};
    for (const std::string& e : effects)
        list.push_back({{e}, prior_singles / all / static_cast<double>(effects.size())});
    list.push_back({{"unknown"}, prior_unknown / all});
    if (effects.empty()) list.front().probability += prior_singles / all;
    std::stable_sort(list.begin(), list.end(), [](const Hypothesis& a, const Hypothesis& b) {
        return a.probability > b.probability;
    });
    return list;
}

std::vector<Group> groups_of(const Judge& j) {
    std::map<std::vector<std::string>, std::vector<const Candidate*>> sorted;
    const auto add = [&](const Candidate& c) {
        std::vector<std::string> names;
        for (const Term* t : c.h.terms) names.push_back(t->effect);
        std::sort(names.begin(), names.end());
        sorted[names].push_back(&c);
    };
    add(j.base);
    // Whatever is added is run with a fine step, too. What does no more than that is the artefact alone.
    const Candidate* artefact = j.artefact();
    for (const Candidate& c : j.singles)
        if (!artefact || &c == artefact || c.fit.objective() < artefact->fit.objective() - seen ||
            artefact->fit.objective() > j.base.fit.objective() - seen)
            add(c);
    for (const Candidate& c : j.pairs) add(c);
    for (const Candidate& c : j.forces) add(c);
    std::set<std::string> names;
    for (const Term& t : j.terms) names.insert(t.effect);
    const double singles = static_cast<double>(std::max<std::size_t>(1, names.size()));
    const double all_pairs = std::max(1.0, 0.5 * singles * (singles - 1.0));
    std::vector<Group> list;
    double prior_hidden = 0.0;  // of effects too weak to show: to these recordings they are none
    for (const auto& [effects, candidates] : sorted) {
        Group g{.effects = effects};
        const bool unknown = effects == std::vector<std::string>{"unknown"};
        const double prior = effects.empty()       ? prior_none
                             : unknown             ? prior_unknown
                             : effects.size() == 1 ? prior_singles / singles
                                                   : prior_pairs / all_pairs;
        for (const Candidate* c : candidates) {
            if (!g.best || c->log_evidence > g.best->log_evidence) g.best = c;
            g.log_weight = log_sum(g.log_weight, shown(*c, j.base));
            if (effects.size() == 1 && !unknown)
                prior_hidden += prior * c->unseen / static_cast<double>(candidates.size());
        }
        g.log_weight += std::log(prior) - std::log(static_cast<double>(candidates.size()));
        list.push_back(std::move(g));
    }
    for (Group& g : list)
        if (g.effects.empty()) g.log_weight += std::log1p(prior_hidden / prior_none);
    double all = -1e300;
    for (const Group& g : list) all = log_sum(all, g.log_weight);
    for (Group& g : list) g.probability = std::exp(g.log_weight - all);
    std::stable_sort(list.begin(), list.end(),
                     [](const Group& a, const Group& b) { return a.log_weight > b.log_weight; });
    return list;
}

}  // namespace diagnose
