// SPDX-License-Identifier: MIT
#include "diagnose/diagnose.hpp"

#include "diagnose/candidates.hpp"
#include "diagnose/catalogue.hpp"
#include "diagnose/gates.hpp"
#include "diagnose/locate.hpp"
#include "diagnose/next_experiment.hpp"
#include "diagnose/scores.hpp"
#include "diagnose/words.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <set>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Prior over hypotheses, before any recording is seen (docs/diagnose.md).
constexpr double prior_none = 0.35, prior_unknown = 0.07, prior_singles = 0.48, prior_pairs = 0.10;
constexpr double own_level = 0.01;    // below it a model fails its own test of mismatch
constexpr double far_apart = 3.0;     // sigma between two hypotheses that recordings can tell apart
constexpr double sure = 0.75;         // probability at which rivals that recordings can tell apart are out
constexpr double close_odds = 3.0;    // log odds of a rival that is not to be left aside where the winner is not sure
constexpr int draws = 1999;

struct Judge {
    const cases::Case& given;
    const Settings& settings;
    Problem problem;
    std::vector<Term> terms;
    Noise noise;
    std::unique_ptr<Whitener> whiten;
    Candidate base;
    std::vector<Candidate> singles;  // [terms]
    std::vector<Candidate> pairs;
    std::vector<Term> force_terms;
    std::vector<Candidate> forces;  // falling evidence
    std::vector<double> innovations;
    Mismatch mismatch{};
    Verdict verdict{};

    Judge(const cases::Case& c, const Settings& s)
        : given(c), settings(s), problem(problem_of(c)) {}
    void report(double share, const std::string& what) const {
        if (settings.progress && !settings.progress(share, what)) throw Interrupted{};
    }
    const Candidate& richest() const {
        const Candidate* best = &base;
        const auto cost = [](const Candidate& c) {
            return c.fit.objective() + 2.0 * static_cast<double>(c.h.unknowns.size());
        };
        for (const std::vector<Candidate>* list : {&singles, &pairs, &forces})
            for (const Candidate& c : *list)
                if (cost(c) < cost(*best) - 2.0) best = &c;
        return *best;
    }
    void fit_singles();
    void estimate_noise();
    void refit_all();
    double own_p(const Candidate&, int n) const;
    bool one_is_enough() const;
    Mismatch test(const Candidate&, int n) const;
};

Candidate base_of(const Problem& p, const Whitener& w) {
    Candidate c{.h = p.hypothesis({}), .fit = {}};
    c.fit = fit_base(p, w, c.h);
    c.log_evidence = c.fit.log_evidence;
    return c;
}

void Judge::fit_singles() {
    singles.assign(terms.size(), {});
    in_parallel(terms.size(), settings.threads,
                [&](std::size_t k) { singles[k] = extended(problem, *whiten, base, terms[k]); });
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

void Judge::estimate_noise() {
    const Candidate& rich = richest();
    noise = estimated(problem, problem.recorded - rich.fit.prediction, rich.h.unknowns.size());
    whiten = std::make_unique<Whitener>(problem, noise);
}

void Judge::refit_all() {
    refit(problem, *whiten, base, nullptr);
    in_parallel(singles.size(), settings.threads,
                [&](std::size_t k) { refit(problem, *whiten, singles[k], &base); });
}

Mismatch Judge::test(const Candidate& c, int n) const {
    const std::vector<Shape> list = shapes(problem, *whiten, c.h, c.fit, terms);
    return test_of_mismatch(problem, *whiten, c.h, c.fit, list, innovations, settings.seed, n);
}

double Judge::own_p(const Candidate& c, int n) const { return test(c, n).p_value; }

// Whether the effect of most evidence leaves nothing to a second one: it passes its own test of mismatch and all gates.
bool Judge::one_is_enough() const {
    const auto best = std::max_element(singles.begin(), singles.end(),
                                       [](const Candidate& a, const Candidate& b) {
                                           return a.log_evidence < b.log_evidence;
                                       });
    if (best == singles.end()) return false;
    const double p = own_p(*best, 399);
    return p >= 0.05 && passes(gates({problem, *whiten, base, *best, p, std::nan("")}, 0));
}

// A name with all that carries it: the variants of a single, a pair in either order, the forces along each variable.
struct Group {
    std::vector<std::string> effects;
    const Candidate* best = nullptr;
    double log_weight = -1e300;  // log of prior times evidence
    double probability = 0.0;
};

double log_sum(double a, double b) {
    const double top = std::max(a, b);
    return top + std::log(std::exp(a - top) + std::exp(b - top));
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
    for (const Candidate& c : j.singles) add(c);
    for (const Candidate& c : j.pairs) add(c);
    for (const Candidate& c : j.forces) add(c);
    std::set<std::string> names;
    for (const Term& t : j.terms) names.insert(t.effect);
    const double singles = static_cast<double>(std::max<std::size_t>(1, names.size()));
    const double all_pairs = std::max(1.0, 0.5 * singles * (singles - 1.0));
    std::vector<Group> list;
    for (const auto& [effects, candidates] : sorted) {
        Group g{.effects = effects};
        const bool unknown = effects == std::vector<std::string>{"unknown"};
        const double prior = effects.empty()       ? prior_none
                             : unknown             ? prior_unknown
                             : effects.size() == 1 ? prior_singles / singles
                                                   : prior_pairs / all_pairs;
        for (const Candidate* c : candidates) {
            if (!g.best || c->log_evidence > g.best->log_evidence) g.best = c;
            g.log_weight = log_sum(g.log_weight, c->log_evidence);
        }
        g.log_weight += std::log(prior) - std::log(static_cast<double>(candidates.size()));
        list.push_back(std::move(g));
    }
    double all = -1e300;
    for (const Group& g : list) all = log_sum(all, g.log_weight);
    for (Group& g : list) g.probability = std::exp(g.log_weight - all);
    std::stable_sort(list.begin(), list.end(),
                     [](const Group& a, const Group& b) { return a.log_weight > b.log_weight; });
    return list;
}

bool same(const std::vector<std::string>& a, const char* one) {
    return a.size() == 1 && a.front() == one;
}

// Wider than the other: the same effects and one more.
bool contains(const std::vector<std::string>& wide, const std::vector<std::string>& narrow) {
    return std::all_of(narrow.begin(), narrow.end(), [&](const std::string& n) {
        return std::find(wide.begin(), wide.end(), n) != wide.end();
    });
}

std::vector<Estimate> estimates(const Judge& j, const Candidate& c, const Term* term) {
    std::vector<Estimate> list;
    const VectorXd errors = standard_errors(c.h.unknowns, c.fit);
    std::size_t first = 0, last = c.h.unknowns.size();
    if (term) {
        for (std::size_t k = c.h.terms.size(); k-- > 0;) {
            first = last - c.h.terms[k]->unknowns.size();
            if (c.h.terms[k] == term) break;
            last = first;
        }
    } else {
        for (const Term* t : c.h.terms) last -= t->unknowns.size();
    }
    for (std::size_t k = first; k < last; ++k) {
        const Unknown& x = c.h.unknowns[k];
        if (x.target == Target::missing_force_knot) continue;
        const auto i = static_cast<Index>(k);
        const double value = c.fit.theta[i], reach = 1.645 * errors[i];
        Estimate e{x.name, x.unit, value, value - reach, value + reach};
        if (x.prior == Prior::log_uniform) {
            const double ratio = std::exp(reach / value);
            e.low = value / ratio, e.high = value * ratio;
        }
        e.low = std::max(e.low, x.low), e.high = std::min(e.high, x.high);
        if (x.key == "drag_factor") {
            const double cd = drag_coefficient(j.problem, c.h, c.fit.theta, 1.0);
            e.name = "drag_coefficient", e.value *= cd, e.low *= cd, e.high *= cd;
        }
        list.push_back(e);
    }
    return list;
}

MissingForceEstimate missing_of(const Candidate& c) {
    const Term& term = *c.h.terms.back();
    MissingForceEstimate m{.variable = term.missing_variable,
                           .unit = "",
                           .knots = term.missing_knots,
                           .force = {},
                           .low = {},
                           .high = {},
                           .words = ""};
    m.unit = m.variable == "t"                               ? "s"
             : m.variable == "speed" || m.variable == "slip" ? "m/s"
             : m.variable == "spin"                          ? "rad/s"
                                                             : "m";
    const VectorXd errors = standard_errors(c.h.unknowns, c.fit);
    const auto n = static_cast<Index>(term.unknowns.size());
    for (Index k = c.fit.theta.size() - n; k < c.fit.theta.size(); ++k) {
        m.force.push_back(c.fit.theta[k]);
        m.low.push_back(c.fit.theta[k] - 1.645 * errors[k]);
        m.high.push_back(c.fit.theta[k] + 1.645 * errors[k]);
    }
    m.words = described(m);
    return m;
}

// Why recordings cannot show left-out physics; empty where they can.
std::string cannot_show(const Problem& p) {
    if (p.records.empty())
        return "No experiment with role fit has a recording: what is held out takes no part in any "
               "fit.";
    std::size_t rows = 0, moving = 0;
    for (const Record& r : p.records)
        for (const Channel& c : r.channels) {
            std::set<double> values, places;
            for (std::size_t k = 0; k < c.recorded.size(); ++k)
                if (std::isfinite(c.recorded[k]))
                    values.insert(c.recorded[k]), places.insert(r.ordinates.at[k]), ++rows;
            if (values.size() > 2 && places.size() > 2) ++moving;
        }
    if (rows < 6)
        return fmt::format(
            "There are {} recorded values in all: a few scalars can be fitted by many kinds of "
            "physics.",
            rows);
    if (moving == 0)
        return "No recorded channel varies: a constant can be fitted by many kinds of physics.";
    return {};
}

// Standardised residuals to draw from where their tails are heavier than a normal's; else none.
std::vector<double> heavy_tails(const Candidate& c, const Whitener& w) {
    std::vector<double> z;
    for (Index k = 0; k < c.fit.white.size(); ++k)
        if (w.measured()[static_cast<std::size_t>(k)]) z.push_back(c.fit.white[k]);
    double two = 0.0, four = 0.0;
    for (const double v : z) two += v * v, four += v * v * v * v;
    const auto n = static_cast<double>(z.size());
    if (n < 60.0) return {};
    const double kurtosis = four / n / (two / n * two / n);
    if (kurtosis < 3.0 + 3.0 * std::sqrt(24.0 / n)) return {};
    const double scale = std::sqrt(n / two);
    for (double& v : z) v *= scale;
    return z;
}

void decide(Judge& j) {
    Verdict& v = j.verdict;
    std::vector<Group> groups = groups_of(j);
    const auto publish = [&] {
        for (const Group& g : groups) v.hypotheses.push_back({g.effects, g.probability});
    };
    const auto effect_of = [&](const Group& g, const Term* term, const std::string& name) {
        double marginal = 0.0;
        for (const Group& other : groups)
            if (std::find(other.effects.begin(), other.effects.end(), name) != other.effects.end())
                marginal += other.probability;
        Effect e{.name = name,
                 .probability = marginal,
                 .named = false,
                 .parameters = {},
                 .gates = {},
                 .why = {},
                 .missing = {}};
        if (term && term->missing_variable.empty()) e.parameters = estimates(j, *g.best, term);
        if (term && !term->missing_variable.empty()) e.missing = missing_of(*g.best);
        return e;
    };
    if (v.p_value > j.settings.alpha) {
        v.answer = Answer::consistent;
        publish();
        return;
    }
    // Candidates that explain: those that pass their own test. Asked of the best few only.
    const Group* winner = nullptr;
    const Group* unknown = nullptr;
    std::map<const Group*, double> own;
    int asked = 0;
    for (const Group& g : groups) {
        if (same(g.effects, "unknown")) unknown = &g;
        if (g.effects.empty() || same(g.effects, "unknown") || asked >= 6) continue;
        if (winner && g.log_weight < winner->log_weight - 8.0) continue;
        own[&g] = j.own_p(*g.best, 999);
        ++asked;
        if (own[&g] >= own_level && !winner) winner = &g;
    }
    const bool beaten_by_unknown =
        winner && unknown && unknown->log_weight > winner->log_weight + 5.0;
    if (!winner || beaten_by_unknown) {
        v.answer = Answer::unexplained;
        if (unknown) {
            // Nothing passed its own test: what is left of their probability is that of none of these.
            double moved = 0.0;
            for (Group& g : groups)
                if (&g != unknown) moved += g.probability * 0.9, g.probability *= 0.1;
            const_cast<Group*>(unknown)->probability += moved;
        } else {
            for (Group& g : groups) g.probability *= 0.1;
            groups.push_back(
                {.effects = {"unknown"}, .best = &j.base, .log_weight = 0.0, .probability = 0.9});
        }
        std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
            return a.probability > b.probability;
        });
        for (const Group& g : groups)
            if (same(g.effects, "unknown")) {
                v.effects.push_back(effect_of(
                    g, g.best->h.terms.empty() ? nullptr : g.best->h.terms.back(), "unknown"));
                break;
            }
        publish();
        return;
    }
    j.report(0.85, "rivals");
    // Rivals: hypotheses that explain, too, and that these recordings and those held out cannot tell from the winner.
    const std::unique_ptr<Planned> planned = with_held_out(j.problem, j.noise);
    const Problem& both = planned ? planned->problem : j.problem;
    const Whitener w(both, planned ? planned->noise : j.noise);
    const Candidate truth = carried_over(both, *winner->best);
    const Group* rival = nullptr;
    double nearest = 1e300;
    for (const Group& g : groups) {
        if (&g == winner || same(g.effects, "unknown") || contains(g.effects, winner->effects))
            continue;
        const double behind = winner->log_weight - g.log_weight;
        if (behind > 14.0) continue;
        const bool explains = g.effects.empty()  ? v.p_value > own_level
                              : own.contains(&g) ? own[&g] >= own_level
                                                 : j.own_p(*g.best, 399) >= own_level;
        double apart = separation(both, w, truth, carried_over(both, *g.best));
        const bool close = behind < close_odds && winner->probability < sure;
        // Chance is the first rival of any name.
        const bool by_chance = g.effects.empty() && behind < close_odds;
        if (by_chance) apart = 0.0;
        if (((apart < far_apart && explains) || close || by_chance) && apart < nearest)
            nearest = apart, rival = &g;
    }
    std::vector<const Term*> named_terms = winner->best->h.terms;
    const GateInput input{j.problem, *j.whiten, j.base, *winner->best, own[winner], [&] {
                              for (const Candidate& c : j.singles)
                                  if (c.h.terms.front()->effect == "numerical_artefact")
                                      return j.own_p(c, 399);
                              return std::nan("");
                          }()};
    const double gain = j.base.fit.objective() - winner->best->fit.objective();
    bool all_pass = true;
    for (std::size_t k = 0; k < named_terms.size(); ++k) {
        Effect e = effect_of(*winner, named_terms[k], named_terms[k]->effect);
        e.gates = gates(input, k);
        e.named = passes(e.gates);
        all_pass = all_pass && e.named;
        v.effects.push_back(std::move(e));
    }
    const bool certain = v.p_value < own_level && all_pass;
    v.answer = rival || !certain ? Answer::ambiguous : Answer::explained;
    if (v.answer == Answer::ambiguous) {
        for (Effect& e : v.effects) e.named = false;
        if (!rival)
            for (const Group& g : groups)
                if (&g != winner && !rival) rival = &g;
        for (const Term* t : rival->best->h.terms)
            if (std::none_of(v.effects.begin(), v.effects.end(),
                             [&](const Effect& e) { return e.name == t->effect; }))
                v.effects.push_back(effect_of(*rival, t, t->effect));
        // The two that are alike stand first.
        std::stable_sort(groups.begin(), groups.end(), [&](const Group& a, const Group& b) {
            const auto rank = [&](const Group& g) {
                return g.effects == winner->effects ? 0 : g.effects == rival->effects ? 1 : 2;
            };
            return rank(a) < rank(b);
        });
        j.report(0.9, "the next experiment");
    }
    const Candidate* first = winner->best;
    const Candidate* second = rival ? rival->best : nullptr;
    if (v.answer == Answer::ambiguous && second)
        v.next_experiment =
            next_experiment(j.problem, j.noise, *first, *second, j.settings.threads);
    publish();
    for (Effect& e : v.effects) e.why = reasons(e.name, e.probability, gain, {});
}

}  // namespace

Verdict diagnose(const cases::Case& given, const Settings& settings,
                 const std::function<void(cases::Case&)>& open_held_out) {
    Judge j(given, settings);
    Verdict& v = j.verdict;
    v.title = given.title, v.seed = settings.seed, v.p_value = 1.0;
    if (const std::string why = cannot_show(j.problem); !why.empty()) {
        v.answer = Answer::undecided;
        v.warnings.push_back(why);
        v.hypotheses.push_back({{}, 1.0});
        v.summary = summary_of(v);
        return v;
    }
    j.report(0.02, "the user's model");
    j.terms = catalogue(j.problem);
    j.noise = first_guess(j.problem);
    j.whiten = std::make_unique<Whitener>(j.problem, j.noise);
    j.base = base_of(j.problem, *j.whiten);
    j.report(0.1, "single effects");
    j.fit_singles();
    j.estimate_noise();
    j.refit_all();
    j.estimate_noise();
    j.refit_all();
    j.innovations = heavy_tails(j.richest(), *j.whiten);
    j.report(0.45, "is there a mismatch");
    j.mismatch = j.test(j.base, draws);
    v.p_value = j.mismatch.p_value;
    if (v.p_value <= settings.alpha) {
        j.report(0.5, "forces that no law explains");
        j.forces = with_missing_force(j.problem, *j.whiten, j.base, j.force_terms);
        if (!j.one_is_enough()) {
            j.report(0.55, "pairs of effects");
            j.pairs = pairs_of(j.problem, *j.whiten, j.singles, 4, 10, settings.threads);
        }
    }
    j.report(0.8, "weighing");
    decide(j);

    // What the winner says, for plots and figures.
    const Candidate* extended_model = &j.base;
    if (v.answer != Answer::consistent && !v.hypotheses.empty()) {
        std::vector<std::string> names;
        for (const Effect& e : v.effects)
            if (v.answer == Answer::ambiguous ? names.empty() : true) names.push_back(e.name);
        std::sort(names.begin(), names.end());
        double best = -1e300;
        for (const std::vector<Candidate>* list : {&j.singles, &j.pairs, &j.forces})
            for (const Candidate& c : *list) {
                std::vector<std::string> own;
                for (const Term* t : c.h.terms) own.push_back(t->effect);
                std::sort(own.begin(), own.end());
                if (own == names && c.log_evidence > best)
                    best = c.log_evidence, extended_model = &c;
            }
        const VectorXd difference = extended_model->fit.prediction - j.base.fit.prediction;
        const VectorXd shown = extended_model == &j.base
                                   ? VectorXd(j.problem.recorded - j.base.fit.prediction)
                                   : difference;
        VectorXd clean = shown;
        for (Index k = 0; k < clean.size(); ++k)
            if (!std::isfinite(clean[k])) clean[k] = 0.0;
        v.located = located(j.problem, (*j.whiten)(clean), clean, v.p_value);
    }
    v.refitted = estimates(j, j.base, nullptr);
    v.fit = scores(j.problem, j.noise, j.base, *extended_model);
    v.curves = curves(j.problem, j.noise, j.base, *extended_model, false);
    for (const auto& row : j.noise)
        for (const ChannelNoise& n : row)
            v.noise_correlation = std::max(v.noise_correlation, n.correlation);
    for (Effect& e : v.effects) {
        e.why = reasons(e.name, e.probability,
                        j.base.fit.objective() - extended_model->fit.objective(), v.located);
        for (const Gate& g : e.gates)
            if (g.result == GateResult::untestable)
                v.warnings.push_back(fmt::format("{}: gate \"{}\" cannot be tested. {}",
                                                 plain_name(e.name), g.name, g.why));
    }
    j.report(0.97, "what was held out");
    cases::Case opened = given;
    open_held_out(opened);
    const Problem held = problem_of(opened, true);
    if (!held.records.empty()) {
        const Noise known = noise_like(held, j.problem, j.noise);
        const Candidate base = carried_over(held, j.base),
                        extended_there = carried_over(held, *extended_model);
        v.held_out = scores(held, known, base, extended_there);
        for (PredictedCurve& c : curves(held, known, base, extended_there, true))
            v.curves.push_back(std::move(c));
    }
    v.summary = summary_of(v);
    v.flips = flips_of(v);
    return v;
}

}  // namespace diagnose
