// SPDX-License-Identifier: MIT
// Hypotheses fitted to the recordings: single effects, pairs, a force that no law explains; their evidence, and how far two of
// them are apart.
#pragma once

#include "diagnose/fit.hpp"

#include <functional>
#include <string>
#include <vector>

namespace diagnose {

struct Candidate {
    Hypothesised h;
    Fit fit;
    double log_evidence = 0.0;  // of the fit, and of strengths too small to be seen
    double unseen =
        0.0;  // share of the prior of the last term that these recordings could not show
    std::vector<Eigen::VectorXd> modes{};  // theta of further minima that were nearly as good
    std::string name() const { return h.name(); }
};

// `start`, a fitted hypothesis, and one term more. Strengths and further unknowns of the term are tried on a grid, the rest
// refitted at first order; the best go on to a fit of their own.
Candidate extended(const Problem&, const Whitener&, const Candidate& start, const Term&);

// The same in a deeper minimum, where there is one (minima.hpp); `start` as for refit.
void deepen(const Problem&, const Whitener&, Candidate&, const Candidate* start);

// Pairs of `singles` whose effects differ: the `beam` singles of most evidence with every other. All are tried at first order
// from the fits of the singles, the `most` best ones fitted.
std::vector<Candidate> pairs_of(const Problem&, const Whitener&,
                                const std::vector<Candidate>& singles, std::size_t beam,
                                std::size_t most, int threads);

// Without those of which one effect shows nothing that the other leaves: they are that other.
void drop_idle(std::vector<Candidate>& pairs, const std::vector<Candidate>& singles);

// The same from where it stands, under another whitener; `start` is what the last term was added to, itself refitted.
void refit(const Problem&, const Whitener&, Candidate&, const Candidate* start);

// sqrt(chi squared and penalty) that `other`, refitted, leaves where `truth` is what is recorded and what is stated, without
// noise: how many sigma they are apart. The problem may hold further experiments than those of the fits.
double separation(const Problem&, const Whitener&, const Candidate& truth, const Candidate& other);

// Drop in chi squared below which one effect shows nothing that another leaves: 3 sigma.
constexpr double seen = 9.0;

double log_sum(double a, double b);  // of exp(a) + exp(b)

// f(0) .. f(count - 1) on so many threads.
void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& f);

}  // namespace diagnose
