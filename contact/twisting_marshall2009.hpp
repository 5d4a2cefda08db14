// SPDX-License-Identifier: MIT
// Twisting resistance: the torque along n by which a contact of finite area resists being screwed. It follows from the
// tangential law without a parameter of its own.
//   theta <- theta where the contact shrinks, theta (a_prev/a)^3 where it grows, plus omega_t dt;   omega_t = (omega_j - omega_i) . n
//   M = -(k theta + c omega_t),   k = k_t a^2/2 = 4 G* a^3,   c = c_t a^2/2,   |k theta| and |M| <= (2/3) a mu N
// k and c: Mindlin's spring and dashpot spread over a disc of radius a; 2/3 a mu N: Coulomb friction under an even
// pressure on that disc. The spring gives up strain as the contact grows, so that the torque is kept and no energy comes of it.
// Without it a branch of sticky grains that hangs on one contact swings about its normal for ever, and a heap never rests.
// Marshall (2009), J. Comput. Phys. 228, 1541, doi:10.1016/j.jcp.2008.10.020.
#pragma once

#include "contact/concepts.hpp"
#include "contact/damping_tsuji1992.hpp"
#include "scaling/quantities.hpp"

namespace contact {

struct TwistingInput {
    double angle;                // rad, of the spring, as the last step left it
    double previous_radius;      // m, contact radius of the last step
    double contact_radius;       // m
    double spin;                 // rad/s, (omega_j - omega_i) . n
    double cap_force;            // N, >= 0
    double damping_factor;       // of DampingTsuji1992
    double m_star;               // kg
    double dt;                   // s
    double extra_dashpot = 0.0;  // kg/s, tangential, beside Tsuji's
};

struct TwistingState {
    double torque_on_j;  // N m, along n; the opposite acts on i
    double angle;        // rad
    double stored;       // J
    double dissipated;   // J in this step
};

struct TwistingMarshall2009 {
    double g_star;            // Pa; 0: no resistance
    double sliding_friction;  // 1

    // Throws InvalidParameter unless G* > 0 and friction >= 0, both finite.
    static TwistingMarshall2009 from(scaling::Pressure g_star, double sliding_friction);

    TwistingState step(const TwistingInput& in) const {
        const double a = in.contact_radius;
        const double limit = 2.0 / 3.0 * a * sliding_friction * in.cap_force;
        const double k = 4.0 * g_star * a * a * a;
        const double c = 0.5 * a * a *
                         (DampingTsuji1992{in.damping_factor}.tangential(g_star, a, in.m_star) +
                          in.extra_dashpot);
        const double ratio = a > in.previous_radius ? in.previous_radius / a : 1.0;
        const double start = ratio * ratio * ratio * in.angle;
        const double turn = in.dt * in.spin;
        const double trial = start + turn;
        const double trial_torque = std::abs(k * trial);
        const double angle = trial_torque > limit ? trial * (limit / trial_torque) : trial;
        const double elastic = k * angle, sum = elastic + c * in.spin;
        const double size = std::abs(sum);
        const double resisting = size > limit ? sum * (limit / size) : sum;

        const double r3 = in.previous_radius * in.previous_radius * in.previous_radius;
        const double stored_before = 2.0 * g_star * r3 * in.angle * in.angle;
        const double stiffness_change = stored_before - 0.5 * k * start * start;
        return {.torque_on_j = -resisting,
                .angle = angle,
                .stored = 0.5 * k * angle * angle,
                .dissipated =
                    stiffness_change + elastic * (trial - angle) + (resisting - elastic) * turn};
    }
};

}  // namespace contact
