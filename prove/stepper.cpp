// SPDX-License-Identifier: MIT
#include "prove/stepper.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace prove {

Stepper::Stepper(Rates rates, std::vector<double> absolute, double relative)
    : rates_(std::move(rates)), system_{&Stepper::evaluate, nullptr, absolute.size(), this} {
    step_ = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, absolute.size());
    control_ =
        gsl_odeiv2_control_scaled_new(1.0, relative, 1.0, 0.0, absolute.data(), absolute.size());
    evolve_ = gsl_odeiv2_evolve_alloc(absolute.size());
}

Stepper::~Stepper() {
    gsl_odeiv2_evolve_free(evolve_);
    gsl_odeiv2_control_free(control_);
    gsl_odeiv2_step_free(step_);
}

int Stepper::evaluate(double t, const double* y, double* rate, void* self) {
    static_cast<Stepper*>(self)->rates_(t, y, rate);
    return GSL_SUCCESS;
}

void Stepper::advance(double& t, double until, double& h, double* y) {
    // What is left of the time may be less than a step can be.
    if (until - t <= 1e-14 * (std::abs(t) + std::abs(until))) {
        t = until;
        return;
    }
    const int status =
        gsl_odeiv2_evolve_apply(evolve_, control_, step_, &system_, &t, until, &h, y);
    if (status != GSL_SUCCESS || !std::isfinite(y[0])) throw NoStep();
}

void Stepper::restart() {
    gsl_odeiv2_step_reset(step_);
    gsl_odeiv2_evolve_reset(evolve_);
}

double root(const std::function<double(double)>& f, double a, double b) {
    struct Call {
        static double value(double x, void* p) {
            return (*static_cast<const std::function<double(double)>*>(p))(x);
        }
    };
    const double fa = f(a), fb = f(b);
    if (fa == 0.0) return a;
    if (fb == 0.0) return b;
    if ((fa > 0.0) == (fb > 0.0)) return std::abs(fa) < std::abs(fb) ? a : b;
    gsl_function g{&Call::value, const_cast<void*>(static_cast<const void*>(&f))};
    gsl_root_fsolver* solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_root_fsolver_set(solver, &g, std::min(a, b), std::max(a, b));
    double x = a;
    for (int k = 0; k < 100; ++k) {
        if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS) break;
        x = gsl_root_fsolver_root(solver);
        const double low = gsl_root_fsolver_x_lower(solver),
                     high = gsl_root_fsolver_x_upper(solver);
        if (high - low <= 1e-14 * std::max(std::abs(low), std::abs(high)) ||
            high - low <= 1e-15 * std::abs(b - a))
            break;
    }
    gsl_root_fsolver_free(solver);
    return x;
}

}  // namespace prove
