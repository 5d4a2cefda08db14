// SPDX-License-Identifier: MIT
// Main effects of a design whose runs all gave a response. The effect of a factor is the change of
// the response from its low to its high level, twice the coefficient b of the coded factor.
//   y = X b + e,  b = (X'X)^-1 X'y,  s^2 = |y - X b|^2 / nu,  nu = runs - terms
//   se(2 b_j) = 2 s sqrt((X'X)^-1_jj),  t = 2 b_j / se,  interval 2 b_j +- t_{0.975, nu} se
#pragma once

#include "calibrate/trials.hpp"
#include "statistics/intervals.hpp"

#include <limits>
#include <string>
#include <vector>

namespace calibrate {

// Sums, counts and means at the two levels of a factor, as Table 7 of Niu et al. (2026) prints
// them. It is the effect of least squares only where the design is orthogonal.
struct LevelMeans {
    std::string factor;
    double sum_high, sum_low;
    int count_high, count_low;
    double mean_high, mean_low, effect;
    int rank;  // 1: the largest |effect|
};

std::vector<LevelMeans> level_means(const Trials&);

struct Effect {
    std::string factor;
    double estimate;
    double standard_error, t, p;    // of a two-sided test; NaN without degrees of freedom
    statistics::Interval interval;  // 95 %
};

struct EffectFit {
    std::string left_out;         // the term forced to zero; empty: none
    std::vector<Effect> effects;  // [factors], without the one left out
    double constant;
    double sum_of_squares;  // of the residuals
    int degrees_of_freedom;
    double spread;  // s
};

// `left_out`: a term (0: the constant, k: factor k - 1), or -1 for none. Throws
// scaling::InvalidParameter where what is left has not full rank or more terms than runs.
EffectFit fit_effects(const Trials&, int left_out = -1);

struct VarianceRow {
    std::string source;
    double sum_of_squares;
    int degrees_of_freedom;  // 0: nothing is left of the factor once the others are in
    double mean_square, f, p;
};

struct AnalysisOfVariance {
    std::vector<VarianceRow> factors;
    VarianceRow residual, total;  // f and p are NaN
    double spread;                // sqrt of the residual mean square
};

// Every level of a factor has a mean of its own; a factor's sum of squares is what the residuals
// gain when it leaves the model of all main effects. In an orthogonal design the sums add up.
AnalysisOfVariance analysis_of_variance(const Trials&);

// Probability that a two-sided test at `alpha` finds an effect of that size: noncentral t with
// noncentrality effect / standard_error.
double power_of(double effect, double standard_error, int degrees_of_freedom, double alpha = 0.05);

// The effect that is found with probability `power`.
double detectable_effect(double standard_error, int degrees_of_freedom, double power = 0.8,
                         double alpha = 0.05);

}  // namespace calibrate
