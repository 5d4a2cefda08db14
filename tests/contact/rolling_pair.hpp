// SPDX-License-Identifier: MIT
// Two solid spheres in contact along z, or one at a wall, as input of the rolling laws.
#pragma once

#include "contact/concepts.hpp"
#include "contact/effective.hpp"

namespace rolling_pair {

// Inertia of a solid sphere of 2500 kg/m^3, kg m^2.
inline double inertia(double radius) {
    return 0.4 * 4.0 / 3.0 * 3.14159265358979324 * 2500.0 * radius * radius * radius * radius *
           radius;
}

// At rest, springs unloaded; E* = 1e9 Pa, a = 2 um, N = 0.1 mN.
inline contact::RollingInput spheres(double r_i, double r_j) {
    return {.spring = {},
            .n = {0.0, 0.0, 1.0},
            .spin_i = {},
            .spin_j = {},
            .r_i = r_i,
            .r_j = r_j,
            .r_star = contact::r_star(r_i, r_j),
            .inverse_inertia_i = 1.0 / inertia(r_i),
            .inverse_inertia_j = 1.0 / inertia(r_j),
            .e_star = 1e9,
            .previous_radius = 2e-6,
            .contact_radius = 2e-6,
            .cap_force = 1e-4,
            .dt = 1e-7};
}

inline contact::RollingInput at_wall(double r_i) {
    contact::RollingInput in = spheres(r_i, contact::wall_radius);
    in.inverse_inertia_j = 0.0;
    return in;
}

// Kinetic energy of the spins after the torques acted for one step (none: before it), J. Walls do
// not count.
inline double spin_energy(const contact::RollingInput& in, contact::Vec3 torque_on_i,
                          contact::Vec3 torque_on_j) {
    const auto energy = [&](contact::Vec3 spin, contact::Vec3 torque, double inverse_inertia) {
        const contact::Vec3 w = spin + in.dt * inverse_inertia * torque;
        return inverse_inertia > 0.0 ? 0.5 * contact::dot(w, w) / inverse_inertia : 0.0;
    };
    return energy(in.spin_i, torque_on_i, in.inverse_inertia_i) +
           energy(in.spin_j, torque_on_j, in.inverse_inertia_j);
}

}  // namespace rolling_pair
