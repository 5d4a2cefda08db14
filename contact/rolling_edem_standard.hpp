// SPDX-License-Identifier: MIT
// EDEM's Standard rolling friction: a constant torque on each grain against its own spin.
//   torque on i = -mu_r N R_i omega_i/|omega_i|, and the same for j with R_j and omega_j
// Own radius, own absolute spin with its twisting part: two grains that turn as one rigid body are
// braked too, the two torques do not add up to zero, and for equal spheres rolling on each other
// each is twice that of RollingRvd (R = 2 R*). Never more torque than stops the grain's spin within
// the step. Nothing acts on walls and fixed grains (inverse inertia 0). N cap force.
// Altair EDEM manual, Standard Rolling Friction Model, after Sakaguchi, Ozaki & Igarashi (1993),
// Int. J. Mod. Phys. B 7, 1949.
#pragma once

#include "contact/concepts.hpp"

namespace contact {

struct RollingEdemStandard {
    double rolling_friction;  // 1

    // Throws InvalidParameter unless >= 0 and finite.
    static RollingEdemStandard from(double rolling_friction);

    RollingState step(const RollingInput& in) const {  // no spring
        const double force = rolling_friction * in.cap_force;
        const double c_i = braking(force, in.r_i, in.inverse_inertia_i, in.spin_i, in.dt);
        const double c_j = braking(force, in.r_j, in.inverse_inertia_j, in.spin_j, in.dt);
        return {.torque_on_i = -c_i * in.spin_i,
                .torque_on_j = -c_j * in.spin_j,
                .spring = {},
                .stored = 0.0,
                .dissipated = loss(c_i, in.inverse_inertia_i, in.spin_i, in.dt) +
                              loss(c_j, in.inverse_inertia_j, in.spin_j, in.dt)};
    }

  private:
    // Torque over spin, kg m^2/s; 0 for a body that cannot turn, whose radius may be infinite.
    static double braking(double force, double radius, double inverse_inertia, Vec3 spin,
                          double dt) {
        const double lever = inverse_inertia > 0.0 ? radius : 0.0;
        const double constant = force * lever / norm(spin);  // not a number without spin
        const double stopping = inverse_inertia > 0.0 ? 1.0 / (inverse_inertia * dt) : 0.0;
        return constant < stopping ? constant : stopping;
    }

    // Torque times the mean spin over the step, which it has changed by c spin dt/I.
    static double loss(double c, double inverse_inertia, Vec3 spin, double dt) {
        return c * dot(spin, spin) * dt * (1.0 - 0.5 * c * inverse_inertia * dt);
    }
};

}  // namespace contact
