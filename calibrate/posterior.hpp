// SPDX-License-Identifier: MIT
// The parameters, given what was measured: prior uniform over the coded ranges (log-uniform where a
// factor is logarithmic), likelihood of the surrogate. Weighted samples from a Latin hypercube and, where
// few of those carry weight, from kernels around them: population Monte Carlo, Cappe, Guillin, Marin &
// Robert (2004), J. Comput. Graph. Stat. 13, 907, doi:10.1198/106186004X12803.
#pragma once

#include "calibrate/surrogate.hpp"
#include "statistics/intervals.hpp"

#include <cstdint>
#include <vector>

namespace calibrate {

struct Posterior {
    Eigen::MatrixXd points;       // coded, [samples][factors]
    Eigen::VectorXd weights;      // [samples], sum 1
    Eigen::VectorXd log_density;  // [samples], up to a constant that is the same for all
    double effective() const { return 1.0 / weights.squaredNorm(); }  // samples
};

Posterior posterior(const Surrogate&, std::uint64_t seed);

// Mean [factors] and covariance [factors][factors] of the coded factors.
Eigen::VectorXd mean(const Posterior&);
Eigen::MatrixXd covariance(const Posterior&);

// Between the quantiles (1 - confidence)/2 and (1 + confidence)/2 of one coded factor.
statistics::Interval marginal(const Posterior&, Eigen::Index factor, double confidence);

// The same with all other factors held at `point` (coded).
statistics::Interval conditional(const Surrogate&, const Eigen::VectorXd& point,
                                 Eigen::Index factor, double confidence);

// Share of the posterior that is denser than `point` (coded). The region of highest density with
// probability c holds the point if this is below c.
double mass_above(const Posterior&, const Surrogate&, const Eigen::VectorXd& point);

// `count` rows, each taken as often as its weight says, evenly (systematic resampling); `shift` in
// [0, 1).
std::vector<Eigen::Index> resampled(const Eigen::VectorXd& weights, int count, double shift);

}  // namespace calibrate
