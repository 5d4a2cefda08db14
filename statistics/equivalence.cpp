// SPDX-License-Identifier: MIT
#include "statistics/equivalence.hpp"

#include "scaling/errors.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace statistics {
namespace {

using scaling::InvalidParameter;
using scaling::mistake;

void require_margin_and_alpha(double margin, double alpha) {
    if (!(margin > 0.0)) {
        throw InvalidParameter(mistake("equivalence.margin", std::to_string(margin), "must be > 0",
                                       "say beforehand how large a difference does not matter"));
    }
    if (!(alpha > 0.0 && alpha < 0.5)) {
        throw InvalidParameter(mistake("equivalence.alpha", std::to_string(alpha),
                                       "must lie between 0 and 0.5, both excluded",
                                       "0.05 is usual"));
    }
}

void require_sample(const char* side, const Summary& s) {
    if (s.count < 2 || !(s.standard_deviation >= 0.0) || !std::isfinite(s.mean)) {
        throw InvalidParameter(mistake(std::string("equivalence.") + side,
                                       std::to_string(s.count) + " values with mean " +
                                           std::to_string(s.mean) + " and spread " +
                                           std::to_string(s.standard_deviation),
                                       "must be at least 2 finite values", "run more seeds"));
    }
}

void require_spread(double standard_deviation) {
    if (!(standard_deviation > 0.0)) {
        throw InvalidParameter(mistake("equivalence.standard_deviation",
                                       std::to_string(standard_deviation), "must be > 0",
                                       "measure it from a few seeds first"));
    }
}

}  // namespace

Equivalence two_one_sided_tests(const Summary& reference, const Summary& scaled, double margin,
                                double alpha) {
    require_margin_and_alpha(margin, alpha);
    require_sample("reference", reference);
    require_sample("scaled", scaled);
    const double n1 = static_cast<double>(reference.count), n2 = static_cast<double>(scaled.count);
    const double v1 = reference.standard_deviation * reference.standard_deviation / n1;
    const double v2 = scaled.standard_deviation * scaled.standard_deviation / n2;
    const double difference = scaled.mean - reference.mean, s = std::sqrt(v1 + v2);
    if (s == 0.0) {
        const bool inside = std::abs(difference) < margin;
        return {difference,         0.0,    n1 + n2 - 2.0, {difference, difference},
                inside ? 0.0 : 1.0, margin, alpha,         inside};
    }
    // Shares instead of variances, so that tiny units (angles in rad, areas in m^2) do not
    // underflow when squared.
    const double share = v1 / (v1 + v2);
    const double nu =
        1.0 / (share * share / (n1 - 1.0) + (1.0 - share) * (1.0 - share) / (n2 - 1.0));
    const boost::math::students_t t(nu);
    const double above_lower = boost::math::cdf(complement(t, (difference + margin) / s));
    const double below_upper = boost::math::cdf(t, (difference - margin) / s);
    const double p = std::max(above_lower, below_upper);
    const double half = student_quantile(1.0 - alpha, nu) * s;
    return {difference, s, nu, {difference - half, difference + half}, p, margin, alpha, p < alpha};
}

double equivalence_power(double standard_deviation, std::size_t per_side, double margin,
                         double alpha, double true_difference) {
    require_margin_and_alpha(margin, alpha);
    require_spread(standard_deviation);
    if (per_side < 2) {
        throw InvalidParameter(mistake("equivalence.per_side", std::to_string(per_side),
                                       "must be at least 2", "one seed has no spread"));
    }
    const double n = static_cast<double>(per_side), nu = 2.0 * n - 2.0;
    const double s = standard_deviation * std::sqrt(2.0 / n);
    const double t = student_quantile(1.0 - alpha, nu);
    const double to_upper = (margin - true_difference) / s,
                 to_lower = (margin + true_difference) / s;
    const boost::math::normal phi;
    const boost::math::chi_squared chi2(nu);
    // At S = margin / (t s) the interval is as wide as the margins, and nothing passes beyond. The
    // density of S is 2 nu S f_chi2(nu S^2).
    const auto integrand = [&](double x) {
        const double pass = cdf(phi, to_upper - t * x) - cdf(phi, t * x - to_lower);
        return std::max(0.0, pass) * 2.0 * nu * x * pdf(chi2, nu * x * x);
    };
    // Outside these quantiles of S lies 2e-14 of its weight; within, the density is one smooth
    // hump.
    const double first = std::sqrt(quantile(chi2, 1e-14) / nu);
    const double last =
        std::min(margin / (t * s), std::sqrt(quantile(complement(chi2, 1e-14)) / nu));
    if (last <= first) return 0.0;
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, first, last, 10,
                                                                         1e-10);
}

std::size_t seeds_per_side(double standard_deviation, double margin, double power, double alpha,
                           double true_difference) {
    require_margin_and_alpha(margin, alpha);
    require_spread(standard_deviation);
    if (!(power > 0.0 && power < 1.0)) {
        throw InvalidParameter(mistake("seeds_per_side.power", std::to_string(power),
                                       "must lie between 0 and 1, both excluded", "0.95 is usual"));
    }
    const auto enough = [&](std::size_t n) {
        return equivalence_power(standard_deviation, n, margin, alpha, true_difference) >= power;
    };
    constexpr std::size_t most = 100000;
    if (!(std::abs(true_difference) < margin) || !enough(most)) {
        throw InvalidParameter(mistake("seeds_per_side.true_difference",
                                       std::to_string(true_difference),
                                       "must leave room inside the margin for 100000 seeds a side",
                                       "such a difference cannot be shown to be none"));
    }
    // Power grows with the number of seeds: bisection between too few and enough.
    std::size_t too_few = 1, plenty = most;
    while (plenty - too_few > 1) {
        const std::size_t middle = too_few + (plenty - too_few) / 2;
        (enough(middle) ? plenty : too_few) = middle;
    }
    return plenty;
}

}  // namespace statistics
