// SPDX-License-Identifier: MIT
// What a diagnosis has found so far: the noise, every hypothesis as fitted, whether there is a mismatch. decide.cpp turns it into
// a verdict.
#pragma once

#include "diagnose/candidates.hpp"
#include "diagnose/diagnose.hpp"
#include "diagnose/locate.hpp"
#include "diagnose/noise.hpp"
#include "diagnose/problem.hpp"

#include <memory>
#include <string>
#include <vector>

namespace diagnose {

constexpr double own_level = 0.003;  // below it a model fails its own test of mismatch

constexpr int few_draws = 399, many_draws = 1999;

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
    double left_out_base = 0.0,
           left_out_winner = 0.0;  // left_out.hpp; NaN where there is nothing to leave out
    Verdict verdict{};

    Judge(const cases::Case& c, const Settings& s, const Piles* piles)
        : given(c), settings(s), problem(problem_of(c, false, piles)) {}
    // Tells how far the work is; throws Interrupted where it is to stop.
    void report(double share, const std::string& what) const {
        if (settings.progress && !settings.progress(share, what)) throw Interrupted{};
    }
    // That of the best fit, at 2 in chi squared for each unknown.
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
    const Candidate* artefact() const;  // the single numerical_artefact; null where there is none
    void fit_base();
    void fit_singles();
    void fit_pairs();
    void search_pairs_again();  // where even the best two leave a mismatch
    void estimate_noise();
    void
    set_outliers_aside();  // single values far from what even the best fit says; the verdict warns
    void refit_all();
    std::vector<Shape> shapes_about(const Candidate&) const;
    double test(const Candidate&, const std::vector<Shape>&, int draws) const;
    // Of its own test of mismatch; more draws where a few leave it near own_level.
    double own_p(const Candidate&) const;
    bool one_is_enough() const;
    bool best_fails() const;
    double p_of_best_gain() const;
};

// Fills in answer, hypotheses, effects, next experiment; returns the model that the verdict stands for: the winner, the missing
// force, or the user's own.
const Candidate& decide(Judge&);

}  // namespace diagnose
