// SPDX-License-Identifier: MIT
#include "verify/fall_ode.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace verify {
namespace {

// y = (way, speed).
int motion(double /*t*/, const double y[], double dydt[], void* parameters) {
    const FallingSphere& p = *static_cast<const FallingSphere*>(parameters);
    const double v = y[1], re = p.fluid_density * v * p.diameter / p.fluid_viscosity;
    const double area = std::numbers::pi / 4.0 * p.diameter * p.diameter;
    const double mass = p.density * std::numbers::pi / 6.0 * std::pow(p.diameter, 3);
    const double cd = re >= 1000.0 ? 0.44
                      : re > 0.0   ? 24.0 / re * (1.0 + 0.15 * std::pow(re, 0.687))
                                   : 0.0;
    const double weight = p.gravity * (p.buoyant ? 1.0 - p.fluid_density / p.density : 1.0);
    dydt[0] = v;
    dydt[1] = weight - 0.5 * p.fluid_density * v * v * cd * area / mass;
    return GSL_SUCCESS;
}

}  // namespace

Fallen integrate_fall(const FallingSphere& sphere, double duration) {
    FallingSphere p = sphere;
    gsl_odeiv2_system system{motion, nullptr, 2, &p};
    const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-6 * duration, 1e-13,
                                      1e-11),
        gsl_odeiv2_driver_free);
    double t = 0.0, y[2] = {0.0, 0.0};
    if (gsl_odeiv2_driver_apply(driver.get(), &t, duration, y) != GSL_SUCCESS)
        throw std::runtime_error("verify: GSL could not integrate the fall of a sphere");
    return {y[0], y[1]};
}

}  // namespace verify
