// SPDX-License-Identifier: MIT
// RVD: a constant torque against the relative rolling spin (type A of Ai et al.).
//   torque on j = -mu_r N R* omega_r/|omega_r|, on i the opposite
// omega_r rolling part of omega_j - omega_i, N cap force. Two grains that turn as one rigid body
// feel nothing. Never more torque than stops omega_r within the step:
// |torque| (1/I_i + 1/I_j) dt <= |omega_r|. At a wall R* = R, and 1/I of the wall is 0.
// Altair EDEM manual, RVD Rolling Friction Model, after Ai, Chen, Rotter & Ooi (2011), Powder
// Technol. 206, 269. The manual appears to print the sum of the spins; their difference is rolling.
#pragma once

#include "contact/concepts.hpp"

namespace contact {

struct RollingRvd {
    double rolling_friction;  // 1

    // Throws InvalidParameter unless >= 0 and finite.
    static RollingRvd from(double rolling_friction);

    RollingState step(const RollingInput& in) const {  // no spring
        const Vec3 spin = tangential_part(in.spin_j - in.spin_i, in.n);
        const double inverse_inertia = in.inverse_inertia_i + in.inverse_inertia_j;
        const double constant = rolling_friction * in.cap_force * in.r_star / norm(spin);
        const double stopping = inverse_inertia > 0.0 ? 1.0 / (inverse_inertia * in.dt) : 0.0;
        const double c = constant < stopping ? constant : stopping;  // kg m^2/s
        // Torque times the mean relative spin over the step, which it has changed by c spin dt
        // (1/I_i + 1/I_j).
        const double loss = c * dot(spin, spin) * in.dt * (1.0 - 0.5 * c * inverse_inertia * in.dt);
        return {.torque_on_i = c * spin,
                .torque_on_j = -c * spin,
                .spring = {},
                .stored = 0.0,
                .dissipated = loss};
    }
};

}  // namespace contact
