// SPDX-License-Identifier: MIT
// Two one-sided tests: are two means equal to within a margin that was written down beforehand?
//   difference D = mean(scaled) - mean(reference),   s = sqrt(s1^2/n1 + s2^2/n2)
//   nu = s^4 / [ (s1^2/n1)^2/(n1 - 1) + (s2^2/n2)^2/(n2 - 1) ]
//   p  = max( P(T_nu >= (D + margin)/s), P(T_nu <= (D - margin)/s) )
// p < alpha is the same as: the interval D +- t_{1-alpha, nu} s, of confidence 1 - 2 alpha, lies
// inside (-margin, margin). Equality is what has to be shown: with too few seeds the answer is "not
// equivalent", never the other way round. Schuirmann (1987), J. Pharmacokinet. Biopharm. 15, 657,
// doi:10.1007/BF01068419; degrees of freedom: Welch (1947), Biometrika 34, 28,
// doi:10.1093/biomet/34.1-2.28.
#pragma once

#include "statistics/intervals.hpp"

#include <cstddef>

namespace statistics {

struct Equivalence {
    double difference;          // scaled minus reference
    double standard_error;      // of the difference
    double degrees_of_freedom;  // Welch's; n1 + n2 - 2 when neither side has any spread
    Interval interval;          // confidence 1 - 2 alpha
    double p;                   // the larger of the two one-sided ones
    double margin, alpha;       // as given
    bool equivalent;            // p < alpha
};

// Independent groups; spreads and counts may differ. With no spread on either side (two runs of the
// same bits) the difference is certain: p is 0 inside the margin and 1 on or beyond it. Throws
// scaling::InvalidParameter unless margin > 0, 0 < alpha < 0.5 and both sides have at least two
// values.
Equivalence two_one_sided_tests(const Summary& reference, const Summary& scaled, double margin,
                                double alpha = 0.05);

// Probability that the test finds equivalence with `per_side` seeds a side, when both sides have
// the true spread `standard_deviation` and the true means differ by `true_difference`:
//   power = E_S[ max(0, Phi((margin - true_difference)/s - t S) - Phi(t S - (margin +
//   true_difference)/s)) ] s = standard_deviation sqrt(2/n), t = t_{1-alpha, nu}, nu = 2n - 2, nu
//   S^2 ~ chi^2_nu
// the bivariate noncentral t, written as one integral: Phillips (1990), J. Pharmacokinet. Biopharm.
// 18, 137, doi:10.1007/BF01063556. It is exact for pooled variances; Welch's test has the same
// standard error at equal n and slightly fewer degrees of freedom, hence slightly less power
// (docs/equivalence.md). Throws scaling::InvalidParameter unless standard_deviation > 0, per_side
// >= 2, margin > 0 and 0 < alpha < 0.5.
double equivalence_power(double standard_deviation, std::size_t per_side, double margin,
                         double alpha = 0.05, double true_difference = 0.0);

// The fewest seeds a side (2 to 100000) with at least that power. Throws scaling::InvalidParameter
// as above, and where no such number gives it (a true difference on or beyond the margin).
std::size_t seeds_per_side(double standard_deviation, double margin, double power,
                           double alpha = 0.05, double true_difference = 0.0);

}  // namespace statistics
