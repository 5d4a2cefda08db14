// SPDX-License-Identifier: MIT
#include "diagnose/pile_questions.hpp"

#include "cases/rig_table.hpp"
#include "diagnose/bulk_effects.hpp"
#include "diagnose/catalogue.hpp"
#include "diagnose/hypotheses.hpp"
#include "diagnose/next_experiment.hpp"
#include "diagnose/pile_profile.hpp"
#include "diagnose/words.hpp"
#include "statistics/intervals.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>

namespace diagnose {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr int rounds = 2;
constexpr std::size_t hypotheses_asked = 4, heaps_each = 3;
constexpr double worth_asking = 12.0;  // log evidence behind the best
constexpr int fresh_heaps = 8;
constexpr double told_apart = 4.4;      // chi squared: odds of nine to one
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

// What the instrument adds to each recording's numbers, by this fit, to what the heap itself shows.
std::vector<VectorXd> added_by_instrument(const Problem& p, const Candidate& c,
                                          const std::vector<const Record*>& list) {
    std::vector<VectorXd> all;
    for (const Record* r : list) {
        const rigs::Curves bare =
            r->model->predict(world_at(p, c.h, c.fit.theta, *r), r->ordinates);
        const auto rings = static_cast<Index>(r->ordinates.at.size());
        VectorXd added = VectorXd::Zero(static_cast<Index>(Rings::channels().size()) * rings);
        for (std::size_t k = 0; k < Rings::channels().size(); ++k)
            for (const Channel& channel : r->channels) {
                if (channel.name != Rings::channels()[k]) continue;
                const std::vector<double>& heap = bare.at(channel.name);
                for (Index i = 0; i < rings; ++i)
                    added[static_cast<Index>(k) * rings + i] =
                        c.fit.prediction[static_cast<Index>(channel.first) + i] -
                        heap[static_cast<std::size_t>(i)];
            }
        all.push_back(std::move(added));
    }
    return all;
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
    if (std::none_of(c.experiments.begin(), c.experiments.end(),
                     [&](const cases::Experiment& e) { return !e.held_out && is_profile(e); }))
        return;
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

Confirmed confirm_by_fresh_heaps(Judge& j, const Candidate& found) {
    const Problem& p = j.problem;
    std::vector<std::vector<const Record*>> piles;  // by apparatus
    for (const Record& r : p.records) {
        if (r.covariance.size() == 0 || !p.piles->knows(*r.experiment)) continue;
        const auto same =
            std::find_if(piles.begin(), piles.end(), [&](const std::vector<const Record*>& list) {
                return p.piles->same_apparatus(*list.front()->experiment, *r.experiment);
            });
        if (same == piles.end())
            piles.push_back({&r});
        else
            same->push_back(&r);
    }
    if (piles.empty()) return {};
    const auto check = [&](const Candidate& c) {
        Piles::Check all{0, 1.0, 1.0, 0.0};
        for (const std::vector<const Record*>& list : piles) {
            const Piles::Check one =
                p.piles->confirmed(list, world_at(p, c.h, c.fit.theta, *list.front()),
                                   added_by_instrument(p, c, list), fresh_heaps);
            all.heaps += one.heaps, all.chi_squared += one.chi_squared;
            all.emulator = std::min(all.emulator, one.emulator);
            all.recording = std::min(all.recording, one.recording);
        }
        const auto looks = static_cast<double>(piles.size());
        all.emulator = std::min(1.0, looks * all.emulator);
        all.recording = std::min(1.0, looks * all.recording);
        j.verdict.warnings.push_back(fmt::format(
            "{} fresh heaps with {}: their means are what the emulator says with p = {:.2g}, the "
            "recordings are of their kind with p = {:.2g}.",
            all.heaps, plain_name(c.name()), all.emulator, all.recording));
        return all;
    };
    j.report(0.93, "fresh heaps");
    const Piles::Check of = check(found);
    Confirmed confirmed{of.emulator >= contradicted, of.recording >= contradicted};
    for (const Group& g : groups_of(j)) {
        if (g.best->h.terms == found.h.terms) continue;
        const Piles::Check other = check(*g.best);
        confirmed.foreseen = confirmed.foreseen && other.emulator >= contradicted;
        if (j.verdict.answer == Answer::explained &&
            other.chi_squared - of.chi_squared < told_apart)
            make_ambiguous(j, found, g);
        break;
    }
    return confirmed;
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
    v.warnings.push_back(
        "The recordings are not like fresh heaps of what was found: nothing is named.");
    if (v.answer == Answer::explained) v.answer = Answer::undecided;
    for (Effect& e : v.effects) e.named = false;
}

namespace {

// What angles say, and what they cannot.
std::vector<std::string> words_of_angles(const std::vector<double>& angles,
                                         const std::vector<Axis>& free,
                                         const std::vector<std::string>& effects) {
    constexpr double degrees = 180.0 / std::numbers::pi;
    std::vector<std::string> list;
    if (angles.size() > 1) {
        const statistics::Summary s = statistics::summary(angles);
        const statistics::Interval i = statistics::student_interval(s, 0.95);
        list.push_back(fmt::format(
            "What {} angles say: their mean is {:.1f} deg, {:.1f} to {:.1f} deg with 95 % "
            "confidence, and single heaps scatter by {:.1f} deg.",
            s.count, s.mean * degrees, i.low * degrees, i.high * degrees,
            s.standard_deviation * degrees));
    }
    std::vector<std::string> names;
    for (const Axis& a : free) names.push_back(plain_name(a.parameter));
    std::string text = "What they cannot: they are one number, and many kinds of physics meet it.";
    if (!names.empty())
        text += fmt::format(" Of the {} free parameters ({}) they fix one combination at most.",
                            names.size(), fmt::join(names, ", "));
    if (!effects.empty()) {
        std::vector<std::string> plain;
        for (const std::string& e : effects) plain.push_back(plain_name(e));
        text += fmt::format(" And {} could each be given the strength that makes this angle.",
                            fmt::join(plain, ", "));
    }
    list.push_back(text + " All probabilities are those from before any recording.");
    return list;
}

}  // namespace

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
    std::vector<double> angles;  // rad
    for (const cases::Experiment& e : c.experiments) {
        if (e.held_out || !is_lone_angle(e)) continue;
        if (pile == nullptr) pile = &e;
        const std::vector<double>& one = e.recording->values("angle_of_repose");
        std::copy_if(one.begin(), one.end(), std::back_inserter(angles),
                     [](double angle) { return std::isfinite(angle); });
    }
    std::vector<std::string> singles;
    for (const BulkEffect& e : bulk_effects(c, *pile)) singles.push_back(e.effect);
    v.hypotheses = prior_hypotheses(singles);
    std::vector<std::string> between{"none"};
    between.insert(between.end(), singles.begin(), singles.end());
    v.warnings = words_of_angles(angles, free_axes(c, *pile), singles);
    const double d = pile->grain.diameter.value.value();
    const double radius =
        0.5 * pile->conditions.at("base_diameter").quantity<scaling::Length>().value();
    // Grain by grain on a small base; on a large one as fine as its shape needs.
    const double radii = std::clamp(radius / d, 8.0, 64.0);
    NextExperiment next{.rig = "pile",
                        .conditions = {},
                        .grain = {},
                        .channels = {"azimuth", "z"},
                        .ordinate = "r",
                        .ordinate_unit = "m",
                        .from = 0.0,
                        .to = radius,
                        .rows = 12 * static_cast<int>(std::lround(radii)),
                        .noise = {{"z", 0.05 * d}},
                        .between = between,
                        .separation_sigma = std::nan(""),
                        .why =
                            "The same heap, its height along twelve radii: the whole profile, "
                            "its lean and its roughness tell apart what gives one angle, and no "
                            "heap more has to be poured."};
    for (const auto& [key, value] : pile->conditions.members)
        if (!value.written_text.empty()) next.conditions[key] = value.written_text;
    v.next_experiment = std::move(next);
    v.summary = summary_of(v);
    v.flips = flips_of(v);
    return v;
}

}  // namespace diagnose
