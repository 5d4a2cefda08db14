// SPDX-License-Identifier: MIT
// Mindlin: tangential force of an elastic contact that sticks until friction yields.
//   xi <- turned into the contact plane, times a/a_prev where the contact shrinks, plus v_t dt
//   F = -(k_t xi + c_t v_t),   k_t = 8 G* a,   |k_t xi| <= mu N and |F| <= mu N
// xi spring, v_t slip velocity, c_t dashpots (contact/damping.hpp), N the cap force
// (contact/friction_cap.hpp).
// A spring beyond the limit is set back to it, and so is the sum of spring and dashpot: at full
// sliding the dashpot adds nothing. Neither can give energy (contact/yield.hpp).
// Rejected: the spring set back to (mu N - c_t v_t)/k_t, as LAMMPS does; where the dashpot alone
// exceeds the limit (grazing impacts) that stretches it backwards, from nothing.
// A contact that grows under a loaded spring stiffens it, which is not free of energy: the gain
// stands in `dissipated` as a negative loss, so that a ledger closes.
// Mindlin (1949), J. Appl. Mech. 16, 259 (k_t); Thornton, Cummins & Cleary (2013), Powder Technol.
// 233, 30 (shrinking contact).
#pragma once

#include "contact/concepts.hpp"
#include "contact/damping_tsuji1992.hpp"
#include "contact/yield.hpp"
#include "scaling/quantities.hpp"

namespace contact {

struct Mindlin {
    double g_star;            // Pa
    double sliding_friction;  // 1

    // Throws InvalidParameter unless G* > 0 and friction >= 0, both finite.
    static Mindlin from(scaling::Pressure g_star, double sliding_friction);

    // The work of the spring is counted at the middle of the step, so that sticking without a
    // dashpot costs nothing.
    template <class AnySlider = Slider>
    TangentialState step(const TangentialInput& in, AnySlider&& slider = {}) const {
        const double limit = sliding_friction * in.cap_force;
        const double k = 8.0 * g_star * in.contact_radius;
        const double c =
            DampingTsuji1992{in.damping_factor}.tangential(g_star, in.contact_radius, in.m_star) +
            in.extra_dashpot;
        const double shrunk =
            in.contact_radius < in.previous_radius ? in.contact_radius / in.previous_radius : 1.0;
        const Vec3 start = shrunk * turned_into_plane(in.spring, in.n);
        const Vec3 slip = in.dt * in.slip_velocity;
        const Vec3 trial = start + slip;
        const Vec3 spring = slider.share(k * k * dot(trial, trial), limit) * trial;
        const Vec3 elastic = k * spring;
        const Vec3 resisting = clipped(elastic + c * in.slip_velocity, limit, slider);

        const double stored_before = 4.0 * g_star * in.previous_radius * dot(in.spring, in.spring);
        const double stiffness_change = stored_before - 0.5 * k * dot(start, start);
        const double sliding = dot(elastic, trial - spring);
        const double dashpot = dot(resisting - elastic, slip);
        return {.force_on_j = -resisting,
                .spring = spring,
                .stored = 0.5 * k * dot(spring, spring),
                .dissipated = stiffness_change + sliding + dashpot};
    }
};

}  // namespace contact
