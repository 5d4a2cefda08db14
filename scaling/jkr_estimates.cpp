// SPDX-License-Identifier: MIT
#include "scaling/jkr_estimates.hpp"

#include <cmath>
#include <numbers>

namespace scaling {

namespace {

constexpr double pi = std::numbers::pi;

// w / (E* R*): every JKR length over R* is a function of this number alone.
double reduced(const JkrPair& pair) {
    return Dimensionless(pair.work_of_adhesion / (pair.e_star * pair.r_star)).value();
}

}  // namespace

Force JkrPair::pull_off_force() const { return 1.5 * pi * work_of_adhesion * r_star; }

Length JkrPair::zero_load_contact_radius() const {
    return std::cbrt(4.5 * pi * reduced(*this)) * r_star;
}

Length JkrPair::overlap_under(Force load) const {
    const double w = reduced(*this);
    const double p = Dimensionless(load / (e_star * r_star * r_star)).value();
    const double adhesion = 3.0 * pi * w;
    const double a = std::cbrt(0.75 * (p + adhesion + std::sqrt(adhesion * (2.0 * p + adhesion))));
    return (a * a - std::sqrt(2.0 * pi * w * a)) * r_star;
}

Length JkrPair::tear_off_gap() const {
    const double w = reduced(*this);
    return 0.75 * std::cbrt(pi * pi * w * w) * r_star;
}

Energy JkrPair::separation_work() const {
    // The antiderivative of F over delta is U(a) = (E* a1^5 / R*^2) (8/15 x^5 - 4/3 x^(7/2) + 1/2
    // x^2) with x = a / a1 and a1^3 = 2 pi w R*^2 / E* where delta = 0; the fold is at x^3 = 1/16.
    // U(fold) - U(a1) = 2^(-8/3)/5 + 3/10.
    const double a1 = std::cbrt(2.0 * pi * reduced(*this));
    const double a1_5 = a1 * a1 * a1 * a1 * a1;
    return (0.3 + 0.2 * std::pow(2.0, -8.0 / 3.0)) * a1_5 * e_star * r_star * r_star * r_star;
}

Velocity JkrPair::sticking_speed(Mass m_star) const {
    const auto square = 2.0 * separation_work() / m_star;
    return in_si<Velocity>(std::sqrt(square.value()));
}

Length hertz_impact_overlap(Mass m_star, Velocity approach, Pressure e_star, Length r_star) {
    const Energy kinetic = m_star * approach * approach;
    const double x = Dimensionless(kinetic / (e_star * r_star * r_star * r_star)).value();
    return std::pow(15.0 / 16.0 * x, 0.4) * r_star;
}

}  // namespace scaling
