// SPDX-License-Identifier: MIT
// Least squares of a hypothesis: Levenberg-Marquardt in reduced unknowns u (0 to 1 between the ends of a uniform or
// log-uniform prior; deviations from the mean of a Gaussian one), whitened residuals, hard ends.
#pragma once

#include "diagnose/noise.hpp"
#include "diagnose/problem.hpp"

#include <Eigen/Core>

#include <vector>

namespace diagnose {

struct Fit {
    Eigen::VectorXd theta;       // [unknowns], SI
    Eigen::VectorXd prediction;  // [size]
    Eigen::VectorXd white;       // [size], whitened recorded - predicted
    Eigen::MatrixXd jacobian;    // [size][unknowns], whitened, d prediction / d u
    Eigen::MatrixXd covariance;  // [unknowns][unknowns], of u
    double chi_squared = 0.0;    // of white
    double penalty = 0.0;        // sum of u^2 over Gaussian priors
    double log_evidence = 0.0;   // Laplace: log of the integral of likelihood times prior
    double objective() const { return chi_squared + penalty; }
};

double lowest(const Unknown&);  // u of the hard ends
double highest(const Unknown&);
Eigen::VectorXd to_theta(const std::vector<Unknown>&, const Eigen::VectorXd& u);
Eigen::VectorXd to_u(const std::vector<Unknown>&,
                     const Eigen::VectorXd& theta);     // clipped to the hard ends
Eigen::VectorXd start_of(const std::vector<Unknown>&);  // theta

// [size]: 1 in the first `share` of the rows of each recording over time, and in all rows of others; else 0.
Eigen::VectorXd early_rows(const Problem&, double share);

// From `start` (theta). Where `staged`, first the early rows of each recording over time alone, then more: bounces that are
// out of step would otherwise hold the fit in a local minimum. `iterations` of the last stage at most.
Fit fit(const Problem&, const Whitener&, const Hypothesised&, const Eigen::VectorXd& start,
        bool staged = true, int iterations = 25);

// The same against another long vector in place of what was recorded.
Fit fit_to(const Problem&, const Whitener&, const Hypothesised&, const Eigen::VectorXd& recorded,
           const Eigen::VectorXd& start, bool staged = true, int iterations = 25);

// Where a fit has come to, and no more than that.
struct Place {
    double objective;  // by the rows that it was fitted to
    Eigen::VectorXd u, theta;
};

// By what is left, for sorting.
bool deeper(const Place&, const Place&);

// Whether u is further than `distance` in some unknown from each place that has been tried.
bool is_fresh(const Eigen::VectorXd& u, const std::vector<Eigen::VectorXd>& tried, double distance);

// From u, at most so many iterations, on the rows [size] that have a weight of 1; empty: on all.
Place descended(const Problem&, const Whitener&, const Hypothesised&, const Eigen::VectorXd& u,
                int iterations, const Eigen::VectorXd& rows = {});

// Unknown k stays at `at` (u), the others are refitted from `theta`.
Place fit_holding(const Problem&, const Whitener&, const Hypothesised&,
                  const Eigen::VectorXd& theta, Eigen::Index k, double at, int iterations);

// The user's model from its stated values and from a grid over the range of each free parameter; the best.
Fit fit_base(const Problem&, const Whitener&, const Hypothesised&);

// The same theta under another whitener: residual, Jacobian, evidence anew.
Fit evaluated(const Problem&, const Whitener&, const Hypothesised&, const Eigen::VectorXd& theta);

// Deviations of theta [unknowns] (SI; by the slope of theta(u)).
Eigen::VectorXd standard_errors(const std::vector<Unknown>&, const Fit&);

}  // namespace diagnose
