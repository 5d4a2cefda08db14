// SPDX-License-Identifier: MIT
// EPSD, the elastic-plastic spring-dashpot of rolling resistance (type C of Ai et al.).
//   theta <- turned into the contact plane, plus omega_r dt
//   M = -(k_r theta + c_r omega_r),   |k_r theta| and |M| <= M_max = mu_r R* N
//   k_r = 3 E* a (mu_r R*)^2
//   c_r = 2 eta_r sqrt(I_r k_r), but 0 at full mobilisation, |k_r theta| = M_max
// omega_r rolling part of omega_j - omega_i (twisting is left alone), M torque on j, N cap force,
// I_r both solid spheres about the contact: 1/I_r = sum 1/(I + m R^2) = (2/7) sum 1/I.
// k_r is 9/4 k_n (mu_r R*)^2 with the secant k_n = 4/3 E* a. a is the true contact radius, so that
// k_r stays finite under adhesion at zero overlap. At a wall R* = R, and 1/I of the wall is 0.
// Iwashita & Oda (1998), J. Eng. Mech. 124, 285; Ai, Chen, Rotter & Ooi (2011), Powder Technol.
// 206, 269 (k_r, c_r).
// A contact that grows under a loaded spring stiffens it, which is not free of energy: the gain
// stands in `dissipated` as a negative loss, so that a ledger closes.
#pragma once

#include "contact/concepts.hpp"
#include "contact/yield.hpp"

namespace contact {

struct RollingEpsd {
    double rolling_friction;  // mu_r, 1
    double damping_ratio;     // eta_r, 1; critical at 1

    // Throws InvalidParameter unless both are >= 0 and finite.
    static RollingEpsd from(double rolling_friction, double damping_ratio);

    template <class AnySlider = Slider>
    RollingState step(const RollingInput& in,
                      AnySlider&& slider = {}) const {  // spring: theta, rad
        const double arm = rolling_friction * in.r_star;
        const double limit = arm * in.cap_force;
        const double k_per_radius = 3.0 * in.e_star * arm * arm;
        const double k = k_per_radius * in.contact_radius;
        const Vec3 spin = tangential_part(in.spin_j - in.spin_i, in.n);
        const Vec3 turn = in.dt * spin;
        const Vec3 trial = turned_into_plane(in.spring, in.n) + turn;
        const double share = slider.share(k * k * dot(trial, trial), limit);
        const Vec3 spring = share * trial;
        const Vec3 elastic = k * spring;

        const double inverse_inertia = in.inverse_inertia_i + in.inverse_inertia_j;
        const double inertia = inverse_inertia > 0.0 ? 3.5 / inverse_inertia : 0.0;
        const double c = share < 1.0 ? 0.0 : 2.0 * damping_ratio * std::sqrt(inertia * k);
        const Vec3 resisting = clipped(elastic + c * spin, limit, slider);

        const double stiffness_change = 0.5 * k_per_radius *
                                        (in.previous_radius - in.contact_radius) *
                                        dot(in.spring, in.spring);
        const double sliding = dot(elastic, trial - spring);
        const double dashpot = dot(resisting - elastic, turn);

        return {.torque_on_i = resisting,
                .torque_on_j = -resisting,
                .spring = spring,
                .stored = 0.5 * k * dot(spring, spring),
                .dissipated = stiffness_change + sliding + dashpot};
    }
};

}  // namespace contact
