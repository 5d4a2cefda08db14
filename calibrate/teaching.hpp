// SPDX-License-Identifier: MIT
// The run that teaches most about the parameters. The density of the posterior is uncertain as long as
// the surrogate is; of each candidate x* is asked how much of that variance, integrated over the ranges, a
// run there is expected to take away ("expected integrated variance": Jarvenpaa et al. 2019, Bayesian
// Anal. 14, 595, doi:10.1214/18-BA1121). With p_j(x) = N(t_j; f_j(x), s_j^2) and f ~ N(m, v):
//   now    E p^2 = N(t; m, s^2/2 + v) / (2 s sqrt(pi)),   (E p)^2 = N(t; m, s^2 + v)^2
//   later  v -> v - tau^2,  m -> N(m, tau^2),  tau^2 = cov(x, x*)^2 / (v(x*) + noise^2):
//          E p^2 stays, (E p)^2 -> N(t; m, (s^2 + v + tau^2)/2) / (2 sqrt(pi (s^2 + v - tau^2)))
// so that a run takes away the growth of (E p)^2. Several targets: products over j. All is averaged over
// the draws of hyperparameters, and counts as often as a heap is expected to form at x*.
#pragma once

#include "calibrate/posterior.hpp"

namespace calibrate {

struct Lesson {
    Eigen::VectorXd point;  // coded, [factors]
    double gain;            // share of the integrated variance that is expected to go, 0 to 1
};

Lesson best_lesson(const Surrogate&, const Posterior&, std::uint64_t seed);

}  // namespace calibrate
