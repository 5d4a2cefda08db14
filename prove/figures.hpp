// SPDX-License-Identifier: MIT
// What the generator knows of a case and the judge does not: how hidden the secret is, and what nobody could do better.
//   IDR        sqrt(r' S^-1 r/n_eff), r the noise-free truth minus the refitted base, n_eff = n (1 - rho)/(1 + rho)
//   lambda     n_eff IDR^2
//   power      of the likelihood-ratio test at 5 % that knows the true term: noncentral chi^2 (Wilks 1938)
#pragma once

#include "prove/skeleton.hpp"
#include "prove/terms.hpp"

#include <span>
#include <string>
#include <vector>

namespace prove {

struct Mismatch {
    Fit base;                  // refitted on the fit experiments
    Eigen::VectorXd residual;  // truth minus base, shape of predict()
    Eigen::VectorXd whitened;
    double n_eff, idr, lambda;
};

// Of the truth in `world` against the user's model of the skeleton. `list`: experiments, empty: those with role fit.
Mismatch mismatch(const Skeleton&, const World&, std::vector<std::size_t> list = {});

double effective_count(const std::vector<Setup>&, const Noise&);
// P(reject at 5 %) with `freedom` degrees of freedom and noncentrality lambda.
double likelihood_ratio_power(double lambda, int freedom);

// The user's model fitted to `wanted` from where it starts and from the best places of a grid over its free parameters, by all
// rows and by early ones: bounces that are out of step, and a pull-off that comes between two others, hold a fit in one of many
// minima.
Fit base_fit(const Skeleton&, const std::vector<std::size_t>& list, const Eigen::VectorXd& wanted);

// Worlds with the free parameters of the user's model elsewhere in their ranges, the `most` that leave least once the stated
// conditions have answered at first order; none where no parameter is free.
std::vector<World> far_from(const Skeleton&, const std::vector<std::size_t>& list, const World&,
                            std::vector<Setup>, const Eigen::VectorXd& wanted, std::size_t most);

struct TrueInterval {
    std::string experiment, channel, ordinate, unit;
    double from, to;
    double share;  // of the whole sum of squares, of this channel of this experiment
    int sign;      // of truth minus base
};
// Shortest interval of the ordinate that holds 80 % of the sum of squares. `squares` are those at `at`, in any order.
struct Span80 {
    double from, to;
};
Span80 shortest_span(std::span<const double> at, std::span<const double> squares,
                     double share = 0.8);
std::vector<TrueInterval> true_intervals(const Skeleton&, const Mismatch&);

// 100 rms(a - b)/(max - min of b), mean over experiments and channels, rows that are no numbers left out.
double mean_nrmse(const std::vector<Setup>&, const Eigen::VectorXd& predicted,
                  const Eigen::VectorXd& recorded);

const char* ordinate_of(const Setup&);

}  // namespace prove
