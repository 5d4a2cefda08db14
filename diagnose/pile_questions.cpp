// SPDX-License-Identifier: MIT
#include "diagnose/pile_questions.hpp"

#include "cases/rig_table.hpp"
#include "diagnose/bulk_effects.hpp"
#include "diagnose/catalogue.hpp"
#include "diagnose/hypotheses.hpp"
#include "diagnose/next_experiment.hpp"
#include "diagnose/words.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace diagnose {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr int rounds = 2;
constexpr std::size_t hypotheses_asked = 4, heaps_each = 3;
constexpr double worth_asking = 12.0;  // log evidence behind the best
constexpr int fresh_heaps = 8;
constexpr double told_apart = 9.0;      // chi squared: 3 sigma
constexpr double contradicted = 0.003;  // p-value

// Worlds about a fit, spread as its covariance says; for every pile that an emulator knows.
void ask(std::vector<Piles::Asked>& list, const Problem& p, const Candidate& c, std::size_t count,
         std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const VectorXd u = to_u(c.h.unknowns, c.fit.theta);
    const Eigen::MatrixXd spread = c.fit.covariance.size() > 0
                                       ? Eigen::MatrixXd(c.fit.covariance.llt().matrixL())
                                       : Eigen::MatrixXd();
    std::vector<const Record*> asked;
    for (const Record& r : p.records)
        if (r.covariance.size() > 0 && p.piles->knows(*r.experiment) &&
            std::none_of(asked.begin(), asked.end(), [&](const Record* other) {
                return p.piles->same_apparatus(*other->experiment, *r.experiment);
            }))
            asked.push_back(&r);
    for (std::size_t k = 0; k < count; ++k) {
        VectorXd step(u.size());
        for (Index n = 0; n < step.size(); ++n) step[n] = normal(random);
        VectorXd there = u;
        if (k > 0 && u.size() > 0) there += spread * step;  // the first where the fit ends
        const VectorXd theta =
            to_theta(c.h.unknowns, to_u(c.h.unknowns, to_theta(c.h.unknowns, there)));
        for (const Record* r : asked) list.push_back({r->experiment, world_at(p, c.h, theta, *r)});
    }
}

// Fresh heaps of the runner-up are as near to the recordings as those of the found model.
void make_ambiguous(Judge& j, const Candidate& found, const Group& other) {
    Verdict& v = j.verdict;
    v.answer = Answer::ambiguous;
    for (Effect& e : v.effects) e.named = false;
    std::vector<std::string> names;
    for (const Term* t : found.h.terms) names.push_back(t->effect);
    v.alike = {names, other.effects};
    v.next_experiment =
        next_experiment(j.problem, j.noise, {&found, other.best}, j.settings.threads);
    v.warnings.push_back(fmt::format(
        "Fresh heaps with {} are as near to the recordings as those with {}: no name is given.",
        plain_name(other.best->name()), plain_name(found.name())));
}

}  // namespace

void ask_where_it_matters(const Piles& piles, const cases::Case& c, const Settings& settings) {
    Settings quiet = settings;
    quiet.progress = {};
    std::mt19937_64 random(settings.seed);
    for (int round = 0; round < rounds; ++round) {
        Judge j(c, quiet, &piles);
        j.terms = catalogue(j.problem);
        j.noise = first_guess(j.problem);
        j.whiten = std::make_unique<Whitener>(j.problem, j.noise);
        j.base = {.h = j.problem.hypothesis({}), .fit = {}};
        j.base.fit = fit_base(j.problem, *j.whiten, j.base.h);
        j.base.log_evidence = j.base.fit.log_evidence;
        std::vector<Candidate> all(j.terms.size());
        in_parallel(all.size(), settings.threads, [&](std::size_t k) {
            all[k] = extended(j.problem, *j.whiten, j.base, j.terms[k]);
        });
        std::erase_if(
            all, [](const Candidate& one) { return is_measurement(one.h.terms.front()->effect); });
        all.push_back(j.base);
        std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
            return a.fit.log_evidence > b.fit.log_evidence;
        });
        std::vector<Piles::Asked> list;
        for (std::size_t k = 0; k < std::min(hypotheses_asked, all.size()); ++k)
            if (all[k].fit.log_evidence > all.front().fit.log_evidence - worth_asking)
                ask(list, j.problem, all[k], heaps_each, random);
        piles.learn(list, round + 1 == rounds);
    }
}

bool confirm_by_fresh_heaps(Judge& j, const Candidate& found) {
    const Problem& p = j.problem;
    std::vector<const Record*> piles;  // of one apparatus
    for (const Record& r : p.records)
        if (r.covariance.size() > 0 &&
            (piles.empty() || p.piles->same_apparatus(*piles.front()->experiment, *r.experiment)))
            piles.push_back(&r);
    if (piles.empty()) return true;
    const auto check = [&](const Candidate& c) {
        const Piles::Check of =
            p.piles->confirmed(piles, world_at(p, c.h, c.fit.theta, *piles.front()), fresh_heaps);
        j.verdict.warnings.push_back(fmt::format(
            "{} fresh heaps with {}: their mean is what the emulator says with p = {:.2g}, {} is "
            "one of them with p = {:.2g}.",
            of.heaps, plain_name(c.name()), of.emulator, piles.front()->experiment->id,
            of.recording));
        return of;
    };
    j.report(0.93, "fresh heaps");
    // What an instrument did is in no heap.
    const auto measured = [](const Candidate& c) {
        return std::any_of(c.h.terms.begin(), c.h.terms.end(),
                           [](const Term* t) { return is_measurement(t->effect); });
    };
    const Piles::Check of = check(found);
    bool foreseen = of.emulator >= contradicted;
    const bool named = j.verdict.answer == Answer::explained && !measured(found);
    for (const Group& g : groups_of(j)) {
        if (g.best->h.terms == found.h.terms || measured(*g.best)) continue;
        const Piles::Check other = check(*g.best);
        foreseen = foreseen && other.emulator >= contradicted;
        if (named && other.chi_squared - of.chi_squared < told_apart) make_ambiguous(j, found, g);
        break;
    }
    return foreseen && (!named || of.recording >= contradicted);
}

void learn_about(const Judge& j, const Candidate& found) {
    std::mt19937_64 random(j.settings.seed + 1);
    std::vector<Piles::Asked> list;
    ask(list, j.problem, found, 2 * heaps_each, random);
    for (const Group& g : groups_of(j)) {
        if (g.best->h.terms == found.h.terms) continue;
        ask(list, j.problem, *g.best, 2 * heaps_each, random);
        break;
    }
    j.problem.piles->learn(list, true);
}

void withdraw_names(Verdict& v) {
    v.warnings.push_back("Fresh heaps contradict what the emulator said: nothing is named.");
    if (v.answer == Answer::explained) v.answer = Answer::undecided;
    for (Effect& e : v.effects) e.named = false;
}

bool only_angles(const cases::Case& c) {
    bool any = false;
    for (const cases::Experiment& e : c.experiments) {
        if (e.held_out || !e.recording) continue;
        if (!is_lone_angle(e)) return false;
        any = true;
    }
    return any;
}

Verdict undecided_by_angles(const cases::Case& c, const Settings& settings) {
    Verdict v;
    v.title = c.title, v.seed = settings.seed, v.answer = Answer::undecided, v.p_value = 1.0;
    const cases::Experiment* pile = nullptr;
    for (const cases::Experiment& e : c.experiments)
        if (pile == nullptr && !e.held_out && is_lone_angle(e)) pile = &e;
    std::vector<std::string> effects{"none"};
    for (const BulkEffect& e : bulk_effects(c, *pile)) effects.push_back(e.effect);
    v.hypotheses.push_back({{}, 1.0});
    v.warnings.push_back(fmt::format(
        "Only angles of repose were recorded. One number is met by many kinds of physics: each of "
        "{} can be given the strength that makes this angle, and so can the model's own free "
        "parameters.",
        fmt::join(effects.begin() + 1, effects.end(), ", ")));
    const double d = pile->grain.diameter.value.value();
    const double radius =
        0.5 * pile->conditions.at("base_diameter").quantity<scaling::Length>().value();
    NextExperiment next{.rig = "pile",
                        .conditions = {},
                        .grain = {},
                        .channels = {"azimuth", "z"},
                        .ordinate = "r",
                        .ordinate_unit = "m",
                        .from = 0.0,
                        .to = radius,
                        .rows = static_cast<int>(std::lround(12.0 * std::max(8.0, radius / d))),
                        .noise = {{"z", 0.05 * d}},
                        .between = effects,
                        .separation_sigma = std::nan(""),
                        .why =
                            "The same heap, its height along twelve radii: the whole profile, "
                            "its lean and its roughness tell apart what gives one angle."};
    for (const auto& [key, value] : pile->conditions.members)
        if (!value.written_text.empty()) next.conditions[key] = value.written_text;
    v.next_experiment = std::move(next);
    v.summary = summary_of(v);
    v.flips = flips_of(v);
    return v;
}

}  // namespace diagnose
