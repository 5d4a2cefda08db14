// SPDX-License-Identifier: MIT
#include "verify/two_sphere_ode.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace verify {
namespace {

constexpr double pi = std::numbers::pi;

double fold_radius(const TwoSpheres& p) {
    return std::cbrt(pi * p.work_of_adhesion * p.r_star * p.r_star / (8.0 * p.e_star));
}

double jkr_overlap(const TwoSpheres& p, double a) {
    return a * a / p.r_star - std::sqrt(2.0 * pi * p.work_of_adhesion * a / p.e_star);
}

double jkr_force(const TwoSpheres& p, double a) {
    return 4.0 * p.e_star * a * a * a / (3.0 * p.r_star) -
           std::sqrt(8.0 * pi * p.work_of_adhesion * p.e_star * a * a * a);
}

// The contact radius at overlap d on the branch beyond the fold, by bisection to the last bit.
double contact_radius(const TwoSpheres& p, double d) {
    if (p.work_of_adhesion == 0.0) return std::sqrt(p.r_star * std::max(d, 0.0));
    double low = fold_radius(p), high = 2.0 * low;
    while (jkr_overlap(p, high) < d) high *= 2.0;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (jkr_overlap(p, middle) < d ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double force(const TwoSpheres& p, double d, double a) {
    if (p.work_of_adhesion == 0.0)
        return 4.0 / 3.0 * p.e_star * std::sqrt(p.r_star) * std::pow(std::max(d, 0.0), 1.5);
    return jkr_force(p, a);
}

// y = (d, d').
int motion(double /*t*/, const double y[], double dydt[], void* parameters) {
    const TwoSpheres& p = *static_cast<const TwoSpheres*>(parameters);
    const double a = contact_radius(p, y[0]);
    const double l = std::log(p.restitution);
    const double beta = -l / std::sqrt(l * l + pi * pi);
    const double c = 2.0 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(2.0 * p.e_star * a * p.m_star);
    dydt[0] = y[1];
    dydt[1] = -(force(p, y[0], a) + c * y[1]) / p.m_star;
    return GSL_SUCCESS;
}

// GSL's default is to abort the program; here its return codes are looked at instead.
class QuietGsl {
  public:
    QuietGsl() : before_(gsl_set_error_handler_off()) {}
    ~QuietGsl() { gsl_set_error_handler(before_); }
    QuietGsl(const QuietGsl&) = delete;
    QuietGsl& operator=(const QuietGsl&) = delete;

  private:
    gsl_error_handler_t* before_;
};

using Driver = std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)>;

struct State {
    double t, d, v;
};

State advanced(gsl_odeiv2_driver* driver, State s, double duration) {
    double t = s.t, y[2] = {s.d, s.v};
    gsl_odeiv2_driver_reset(driver);
    if (gsl_odeiv2_driver_apply(driver, &t, s.t + duration, y) != GSL_SUCCESS)
        throw std::runtime_error("verify: GSL could not integrate the impact of two spheres");
    return {t, y[0], y[1]};
}

// Halves the last stride until `reached` begins to hold within a 2^-40th of it.
template <class Reached>
State located(gsl_odeiv2_driver* driver, State before, double stride, Reached&& reached) {
    for (int k = 0; k < 40; ++k) {
        stride *= 0.5;
        const State middle = advanced(driver, before, stride);
        if (!reached(middle)) before = middle;
    }
    return before;
}

}  // namespace

Impact integrate_impact(const TwoSpheres& spheres, double impact_speed) {
    const QuietGsl quiet;
    TwoSpheres p = spheres;
    gsl_odeiv2_system system{motion, nullptr, 2, &p};
    // Johnson (1985), eq. 11.24: a Hertz impact lasts about 2.87 (m*^2/(R* E*^2 v))^(1/5).
    const double scale =
        2.87 * std::pow(p.m_star * p.m_star / (p.r_star * p.e_star * p.e_star * impact_speed), 0.2);
    const double stride = scale / 200.0;
    const Driver driver(gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3 * stride,
                                                      1e-13 * impact_speed * scale, 1e-12),
                        gsl_odeiv2_driver_free);
    const double end = p.work_of_adhesion > 0.0 ? -tear_off_gap(p) : 0.0;
    const auto turned = [](const State& s) { return s.v <= 0.0; };
    const auto torn = [&](const State& s) { return s.d <= end && s.v < 0.0; };
    State s{0.0, 0.0, impact_speed};
    double largest = 0.0;
    while (true) {
        const State next = advanced(driver.get(), s, stride);
        if (largest == 0.0 && turned(next))
            largest = located(driver.get(), s, stride, turned).d;
        else if (largest > 0.0 && s.v < 0.0 && next.v > 0.0)
            return {0.0, next.t, largest};  // pulled back: they stick
        if (torn(next)) break;
        s = next;
    }
    const State last = located(driver.get(), s, stride, torn);
    return {-last.v, last.t, largest};
}

double tear_off_gap(const TwoSpheres& p) {
    const double a = fold_radius(p);
    return 3.0 * a * a / p.r_star;
}

double sticking_work(const TwoSpheres& spheres) {
    // At touch d = 0: a^3 = 2 pi w R*^2/E*. dd/da = 2 a/R* - sqrt(pi w/(2 E* a)).
    const QuietGsl quiet;
    TwoSpheres p = spheres;
    const auto integrand = [](double a, void* parameters) {
        const TwoSpheres& q = *static_cast<const TwoSpheres*>(parameters);
        const double slope =
            2.0 * a / q.r_star - std::sqrt(pi * q.work_of_adhesion / (2.0 * q.e_star * a));
        return jkr_force(q, a) * slope;
    };
    gsl_function function{integrand, &p};
    const double touch = std::cbrt(2.0 * pi * p.work_of_adhesion * p.r_star * p.r_star / p.e_star);
    double result = 0.0, error = 0.0;
    std::size_t evaluations = 0;
    if (gsl_integration_qng(&function, fold_radius(p), touch, 0.0, 1e-10, &result, &error,
                            &evaluations) != GSL_SUCCESS)
        throw std::runtime_error("verify: GSL could not integrate the work of tear-off");
    return -result;
}

}  // namespace verify
