// SPDX-License-Identifier: MIT
// SDS, the rolling resistance of LAMMPS: a pseudo-force that makes a torque and pushes nothing.
//   v_r = R* (omega_i - omega_j) x n
//   xi <- turned into the contact plane, plus v_r dt
//   f = -k xi - gamma v_r, shortened to mu_r N where it is longer; then xi = -(f + gamma v_r)/k
//   torque on i = R* n x f, on j the opposite
// k [N/m] and gamma [kg/s] are given, not derived from the contact. N cap force. At a wall R* = R.
// The slider follows LAMMPS to the letter, so that the two can be compared: where gamma v_r exceeds
// mu_r N the spring is stretched backwards, and `dissipated` may be negative in that step. Keep
// gamma v_r below mu_r N, or use RollingEpsd.
// LAMMPS manual, pair_style granular, rolling sds, after Luding (2008), Granul. Matter 10, 235.
#pragma once

#include "contact/concepts.hpp"
#include "contact/yield.hpp"
#include "scaling/quantities.hpp"

namespace contact {

struct RollingSds {
    double stiffness;         // N/m
    double damping;           // kg/s
    double rolling_friction;  // 1

    // Throws InvalidParameter unless stiffness > 0, damping and rolling friction >= 0, all finite.
    static RollingSds from(scaling::Stiffness, scaling::Damping, double rolling_friction);

    template <class AnySlider = Slider>
    RollingState step(const RollingInput& in, AnySlider&& slider = {}) const {  // spring: xi, m
        const Vec3 velocity = in.r_star * cross(in.spin_i - in.spin_j, in.n);
        const Vec3 path = in.dt * velocity;
        const Vec3 trial = turned_into_plane(in.spring, in.n) + path;
        const Vec3 sum = stiffness * trial + damping * velocity;
        const Vec3 resisting = clipped(sum, rolling_friction * in.cap_force, slider);  // -f
        // (resisting - damping velocity)/stiffness, and to the last bit the trial while it sticks
        const Vec3 spring = trial - (1.0 / stiffness) * (sum - resisting);
        const Vec3 elastic = stiffness * spring;
        const Vec3 torque_on_j = in.r_star * cross(in.n, resisting);

        return {.torque_on_i = -torque_on_j,
                .torque_on_j = torque_on_j,
                .spring = spring,
                .stored = 0.5 * stiffness * dot(spring, spring),
                .dissipated = dot(elastic, trial - spring) + dot(resisting - elastic, path)};
    }
};

}  // namespace contact
