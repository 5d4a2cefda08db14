// SPDX-License-Identifier: MIT
// How far wrong terms are from a truth: D, the square root of the least r' S^-1 r + prior penalty that one leaves, refitted on fit
// and held-out together. An upper bound: what is searched in places may be missed between them.
#pragma once

#include "prove/fit.hpp"
#include "prove/skeleton.hpp"
#include "prove/terms.hpp"

#include <string>
#include <vector>

namespace prove {

// The base model with these terms, fitted to `wanted` (shape of predict over the list) from every combination of a few starts
// beside `begin`, a fit of the base model to the same.
Fit fit_with(const Skeleton&, const std::vector<const Term*>&, const std::vector<std::size_t>& list,
             const Eigen::VectorXd& wanted, const Fit& begin, int iterations = 12);

struct Separation {
    double d;
    std::string effect, channel;
};
// The priors of stated conditions stand about their true values here: nothing is noisy, so that the truth costs nothing.
// `right`: effects that are no wrong ones. `enough`: stop as soon as d falls below; 0: never, and each term's fit begins in the best
// places of a grid, beside the user's model refitted and beside what is true but for the secret. `list`: experiments, empty: all.
Separation separation(const Skeleton&, const World& truth, const std::vector<std::string>& right,
                      double enough = 0.0, std::vector<std::size_t> list = {});
// D squared of this one term, wrong or not, by these experiments.
double left_by(const Skeleton&, const World& truth, const Term&,
               const std::vector<std::size_t>& list);
// The least over single terms and pairs of terms, of which one is among the best `first` singles, by the experiments with role
// fit: what a judge may say of the catalogue, it has to see there. `right`: two of these together are no wrong pair.
Separation pair_separation(const Skeleton&, const World& truth,
                           const std::vector<std::string>& right, int first = 4);

}  // namespace prove
