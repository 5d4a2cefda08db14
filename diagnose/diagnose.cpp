// SPDX-License-Identifier: MIT
#include "diagnose/diagnose.hpp"

#include "diagnose/catalogue.hpp"
#include "diagnose/intervals.hpp"
#include "diagnose/judge.hpp"
#include "diagnose/missing.hpp"
#include "diagnose/own_run.hpp"
#include "diagnose/pile_questions.hpp"
#include "diagnose/piles.hpp"
#include "diagnose/scores.hpp"
#include "diagnose/words.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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

// The case with one experiment held back where its author holds back none: the last recorded one of the rig that has most, of
// three recordings or more. `words` tells which, or why none.
cases::Case held_back(const cases::Case& given, std::string& words) {
    cases::Case c = given;
    std::map<std::string, int> recorded;  // by rig
    int all = 0;
    for (const cases::Experiment& e : c.experiments) {
        if (e.held_out) return c;
        if (e.recording) ++recorded[e.rig], ++all;
    }
    constexpr int enough = 3;
    if (all < enough) {
        words = "Nothing is held out: with fewer than three recordings all take part in the fits.";
        return c;
    }
    std::string rig;
    for (const auto& [name, count] : recorded)
        if (rig.empty() || count > recorded[rig]) rig = name;
    for (auto e = c.experiments.rbegin(); e != c.experiments.rend(); ++e)
        if (e->rig == rig && e->recording && recorded[rig] > 1) {
            e->held_out = true;
            words = fmt::format(
                "The case holds nothing out, so {} was held back: it took no part in any fit and "
                "was "
                "predicted once.",
                e->id);
            break;
        }
    return c;
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

// All up to the answer; returns the model that it stands for.
const Candidate& judged(Judge& j, const std::string& words_of_held_back) {
    Verdict& v = j.verdict;
    const Settings& settings = j.settings;
    j.report(0.02, "the user's model");
    j.terms = catalogue(j.problem);
    j.noise = first_guess(j.problem);
    j.whiten = std::make_unique<Whitener>(j.problem, j.noise);
    j.fit_base();
    v.warnings = words_of_own_runs(j.problem);
    if (!words_of_held_back.empty()) v.warnings.push_back(words_of_held_back);
    j.report(0.1, "single effects");
    j.fit_singles();
    j.estimate_noise();
    j.set_outliers_aside();
    j.refit_all();
    j.estimate_noise();
    j.refit_all();
    j.innovations = heavy_tails(j.richest(), *j.whiten);
    j.report(0.45, "is there a mismatch");
    // The test by draws knows effects at first order only; what a whole fit gains is the rest. The chance of a false alarm is
    // shared out between them, 4 to 1.
    v.p_value = std::min(
        {1.0, j.test(j.base, j.shapes_about(j.base), many_draws) / 0.8, j.p_of_best_gain() / 0.2});
    if (v.p_value <= settings.alpha) {
        j.report(0.5, "what no law explains");
        j.forces = with_missing(j.problem, *j.whiten, j.base, j.force_terms);
        if (!j.one_is_enough()) {
            j.report(0.55, "pairs of effects");
            j.fit_pairs();
            // What one effect left could hide the tails, or look like them.
            j.innovations = heavy_tails(j.richest(), *j.whiten);
            if (j.best_fails()) {
                j.report(0.7, "pairs of effects, from more places");
                j.search_pairs_again();
                j.refit_all();
            }
        }
    }
    j.report(0.8, "weighing");
    return decide(j);
}

}  // namespace

Verdict diagnose(const cases::Case& stated, const Settings& settings,
                 const std::function<void(cases::Case&)>& open_held_out) {
    std::string words_of_held_back;
    const cases::Case given = held_back(stated, words_of_held_back);
    if (only_angles(given)) return undecided_by_angles(given, settings);
    std::unique_ptr<Piles> piles;
    if (has_piles(given)) {
        piles = std::make_unique<Piles>(given, settings);
        ask_where_it_matters(*piles, given, settings);
    }
    auto judge = std::make_unique<Judge>(given, settings, piles.get());
    judge->verdict.title = given.title, judge->verdict.seed = settings.seed;
    judge->verdict.p_value = 1.0;
    if (const std::string why = cannot_show(judge->problem); !why.empty()) {
        Verdict& v = judge->verdict;
        v.answer = Answer::undecided;
        v.warnings.push_back(why);
        v.hypotheses.push_back({{}, 1.0});
        v.summary = summary_of(v);
        return v;
    }
    const Candidate* found = &judged(*judge, words_of_held_back);
    if (piles) {
        // Where fresh heaps are not what the emulator said, more are told to it, and all is judged once more.
        if (const Confirmed c = confirm_by_fresh_heaps(*judge, *found);
            !c.foreseen || !c.recorded) {
            learn_about(*judge, *found);
            judge = std::make_unique<Judge>(given, settings, piles.get());
            judge->verdict.title = given.title, judge->verdict.seed = settings.seed;
            found = &judged(*judge, words_of_held_back);
            if (!confirm_by_fresh_heaps(*judge, *found).recorded) withdraw_names(judge->verdict);
        }
        for (std::string& w : piles->words()) judge->verdict.warnings.push_back(std::move(w));
    }
    Judge& j = *judge;
    Verdict& v = j.verdict;
    const Candidate& chosen = *found;

    // What the winner says, for plots and figures.
    if (v.answer != Answer::consistent) {
        VectorXd shown = (&chosen == &j.base ? j.problem.recorded : chosen.fit.prediction) -
                         j.base.fit.prediction;
        for (Index k = 0; k < shown.size(); ++k)
            if (!std::isfinite(shown[k])) shown[k] = 0.0;
        v.located = located(j.problem, (*j.whiten)(shown), shown, v.p_value);
    }
    v.refitted = refitted(j.problem, j.base);
    v.fit = scores(j.problem, j.noise, j.base, chosen);
    v.curves = curves(j.problem, j.noise, j.base, chosen, false);
    for (const auto& row : j.noise)
        for (const ChannelNoise& n : row)
            v.noise_correlation = std::max(v.noise_correlation, n.correlation);
    for (Effect& e : v.effects) {
        e.why = reasons(e.name, e.probability, j.base.fit.objective() - chosen.fit.objective(),
                        v.located);
        if (std::isfinite(j.left_out_base + j.left_out_winner) && j.left_out_base > 0.0)
            e.why.push_back(
                fmt::format("Each recording predicted by what the others say: chi squared {:.0f} "
                            "in all with {}, {:.0f} without.",
                            j.left_out_winner, plain_name(chosen.name()), j.left_out_base));
        for (const Gate& g : e.gates)
            if (g.result == GateResult::untestable)
                v.warnings.push_back(fmt::format("{}: gate \"{}\" cannot be tested. {}",
                                                 plain_name(e.name), g.name, g.why));
    }
    if (j.left_out_winner > j.left_out_base)
        v.warnings.push_back(
            fmt::format("Recordings left out one at a time are predicted worse with {} (chi "
                        "squared {:.0f}) than without ({:.0f}): what it "
                        "needs may be known from one of them alone.",
                        plain_name(chosen.name()), j.left_out_winner, j.left_out_base));
    j.report(0.97, "what was held out");
    cases::Case opened = given;
    open_held_out(opened);
    const Problem held = problem_of(opened, true, piles.get());
    if (!held.records.empty()) {
        const Noise known = noise_like(held, j.problem, j.noise);
        const Candidate base = carried_over(held, j.base),
                        extended_there = carried_over(held, chosen);
        v.held_out = scores(held, known, base, extended_there);
        const double missed = v.held_out->nrmse_extended / v.held_out->noise_floor;
        constexpr double much =
            3.0;  // their conditions are as stated, not refitted: they are missed by more than noise
        if (missed > much && v.held_out->nrmse_extended > much * v.fit->nrmse_extended)
            v.warnings.push_back(fmt::format(
                "What was held out is missed by {:.1f} times its noise, what was fitted is not: "
                "the "
                "recordings differ from one another in something that the case does not state.",
                missed));
        for (PredictedCurve& c : curves(held, known, base, extended_there, true))
            v.curves.push_back(std::move(c));
    }
    v.summary = summary_of(v);
    v.flips = flips_of(v);
    return v;
}

}  // namespace diagnose
