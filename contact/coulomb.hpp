// SPDX-License-Identifier: MIT
// Coulomb: rigid friction. It opposes the slip with mu N, and never with more than stops it:
//   F = min(mu N, (2/7) m* |v_t|/dt) against v_t
// N cap force (contact/friction_cap.hpp), v_t slip velocity. An impulse J at the contact of a solid
// sphere changes the velocity of its surface there by J/m through the centre and by
// R^2 J/I = (5/2) J/m through the spin (I = 2/5 m R^2): (7/2) J/m for one sphere, (7/2) J/m* for
// the pair. J = (2/7) m* |v_t| stops the slip and takes half of J |v_t| in energy. A wall has
// m* = m, and the same holds.
// No spring, no micro-slip: radius and damping factor of the input take no part.
#pragma once

#include "contact/concepts.hpp"

namespace contact {

struct Coulomb {
    double sliding_friction;  // 1

    // Throws InvalidParameter unless >= 0 and finite.
    static Coulomb from(double sliding_friction);

    // Spring and stored energy are zero; radius and damping factor of the input are not used.
    TangentialState step(const TangentialInput& in) const {
        const double speed = norm(in.slip_velocity);
        const double sliding =
            sliding_friction * in.cap_force / speed;  // kg/s; not a number at rest
        const double stopping = 2.0 / 7.0 * in.m_star / in.dt;
        const double c = sliding < stopping ? sliding : stopping;
        // Force times the mean slip velocity over the step, which the impulse c v_t dt has changed
        // by (7/2) c v_t dt/m*.
        const double loss = c * speed * speed * in.dt * (1.0 - 1.75 * c * in.dt / in.m_star);
        return {
            .force_on_j = -c * in.slip_velocity, .spring = {}, .stored = 0.0, .dissipated = loss};
    }
};

}  // namespace contact
