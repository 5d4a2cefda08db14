// SPDX-License-Identifier: MIT
// What failed runs say. A run in which no heap formed has no response, but it is not without
// information: its response would have lain below some bound. Whether a run fails depends on the
// parameters themselves, so that leaving it out biases the effects (missing not at random; Rubin
// 1976, Biometrika 63, 581). Four readings stand side by side: dropped (effects.hpp), imputed,
// censored, and as a class of its own.
#pragma once

#include "calibrate/trials.hpp"
#include "statistics/intervals.hpp"

#include <optional>
#include <string>
#include <vector>

namespace calibrate {

// Differences of level means with one value in place of every failed response. Linear in the value:
// effect(v) = effect(0) + slope v.
struct Imputed {
    double value;
    std::vector<double> effects;  // [factors]
};

std::vector<Imputed> imputed(const Trials&, const std::vector<double>& values);

// The value at which an effect is zero: below and above it the sign differs. Empty where the failed
// runs are as many at the high as at the low level, so that the value does not matter.
std::vector<std::optional<double>> sign_changes(const Trials&);  // [factors]

// Censored regression (Tobin 1958, Econometrica 26, 24), with a normal prior on slopes:
//   log L = - nu log s - sum_formed (y - x'b)^2 / (2 s^2) + sum_failed log Phi((bound - x'b) / s)
//           - sum_j b_j^2 / (2 prior^2)
// b_j are coded slopes, half of the effects. Maximised by GSL's BFGS; errors from the curvature at
// the maximum.
enum class Spread {
    maximum_likelihood,  // nu = formed runs: Tobin's own, too small where runs are few
    least_squares        // nu = formed runs - rank: s is that of least squares where nothing failed
};

struct CensoredEffect {
    std::string factor;
    double estimate, standard_error;  // high minus low
};

struct CensoredFit {
    double bound;
    std::optional<double> prior;  // standard deviation of a coded slope; none: no prior
    std::vector<CensoredEffect> effects;
    double constant, spread;
    std::vector<double> failed_predictions;  // [failed runs]
};

// Throws scaling::InvalidParameter where fewer than one degree of freedom is left, and, without a
// prior, where the formed runs have not full rank: then the likelihood grows without end along
// what only failed runs tell.
CensoredFit censored_fit(const Trials&, double bound, std::optional<double> prior,
                         Spread spread = Spread::least_squares);

// The same without a prior and without a spread, where the formed runs leave one combination n
// free: all least-squares fits b + c n have the same residuals, and each failed run says x'(b + c
// n) <= bound. What is left of c is one interval, and so is what is left of each effect, from -inf
// or to +inf on one side.
struct ImpliedRange {
    std::string factor;
    statistics::Interval effect;
};

// Empty unless exactly one combination is free. Throws scaling::InvalidParameter where no c meets
// all failed runs.
std::vector<ImpliedRange> implied_ranges(const Trials&, double bound);

// Logistic regression of formed against failed on coded factors, with a normal prior on slopes of
// standard deviation 1.25: Gelman et al. (2008), Ann. Appl. Stat. 2, 1360, recommend a scale of 2.5
// for a change from low to high. The constant has their 10.
struct Feasibility {
    double constant;
    std::vector<CensoredEffect> slopes;  // change of log odds of forming from low to high
    std::vector<double> probability;     // of forming, [runs]
};

// Throws scaling::InvalidParameter where no run failed or none formed.
Feasibility feasibility(const Trials&);

double probability_of_forming(const Feasibility&, const Eigen::VectorXd& coded);

}  // namespace calibrate
