// SPDX-License-Identifier: MIT
// One contact, from its motion to its load: the normal, tangential and rolling law put together. Every path of the core
// (blocks of contacts, the all-pairs reference, walls) calls `evaluate`, so that they give the same bits.
#pragma once

#include "contact/concepts.hpp"
#include "contact/coulomb.hpp"
#include "contact/damping.hpp"
#include "contact/friction_cap.hpp"
#include "contact/hertz.hpp"
#include "contact/jkr.hpp"
#include "contact/mindlin.hpp"
#include "contact/no_rolling.hpp"
#include "contact/no_twisting.hpp"
#include "contact/rolling_edem_standard.hpp"
#include "contact/rolling_epsd.hpp"
#include "contact/rolling_rvd.hpp"
#include "contact/rolling_sds.hpp"
#include "contact/twisting_marshall2009.hpp"
#include "dem_min/contacts.hpp"

#include <cmath>
#include <type_traits>
#include <variant>

namespace dem_min {

template <contact::NormalLaw Normal, contact::TangentialLaw Tangential, contact::RollingLaw Rolling,
          class Twisting>
struct Interaction {
    Normal normal;
    Tangential tangential;
    Rolling rolling;
    contact::Damping damping;
    contact::FrictionCap friction_cap = contact::FrictionCap::elastic_plus_two_pull_off;
    Twisting twisting;
};

using AnyNormal = std::variant<contact::Hertz, contact::Jkr>;
using AnyTangential = std::variant<contact::Mindlin, contact::Coulomb>;
using AnyRolling = std::variant<contact::NoRolling, contact::RollingEpsd, contact::RollingSds,
                                contact::RollingRvd, contact::RollingEdemStandard>;

// The laws of one kind of contact, chosen at run time; the loops take the typed Interaction that `with_laws` makes of it.
struct Laws {
    AnyNormal normal;
    AnyTangential tangential;
    AnyRolling rolling;
    contact::Damping damping;
    contact::FrictionCap friction_cap = contact::FrictionCap::elastic_plus_two_pull_off;
    contact::TwistingMarshall2009 twisting{0.0, 0.0};  // G* = 0: none
};

template <class Function>
decltype(auto) with_laws(const Laws& laws, Function&& function) {
    return std::visit(
        [&](const auto& normal, const auto& tangential, const auto& rolling) {
            const auto typed = [&](const auto& twisting) {
                // Spelt out: clang 14 does not deduce the arguments of an aggregate.
                using Typed =
                    Interaction<std::decay_t<decltype(normal)>, std::decay_t<decltype(tangential)>,
                                std::decay_t<decltype(rolling)>, std::decay_t<decltype(twisting)>>;
                return function(
                    Typed{normal, tangential, rolling, laws.damping, laws.friction_cap, twisting});
            };
            return laws.twisting.g_star > 0.0 ? typed(laws.twisting) : typed(contact::NoTwisting{});
        },
        laws.normal, laws.tangential, laws.rolling);
}

// Motion of one contact; n, signs and slip as in contact/concepts.hpp.
struct Motion {
    Vec3 n;
    double overlap;           // m
    double approach_speed;    // m/s
    Vec3 slip_velocity;       // m/s
    Vec3 spin_i, spin_j;      // rad/s
    double lever_i, lever_j;  // m, from the centre to the contact, half of the overlap taken off
};

struct History {
    Vec3 tangential_spring;  // m
    Vec3 rolling_spring;     // rad or m
    double twist;            // rad
    double previous_radius;  // m
};

struct Load {
    Vec3 force_on_j;                // N
    Vec3 torque_on_i, torque_on_j;  // N m
    History history;
    double dashpot;                            // N, the part of the normal force that is damping
    double stored_tangential, stored_rolling;  // J
};

template <class Normal, class Tangential, class Rolling, class Twisting>
inline Load evaluate(const Interaction<Normal, Tangential, Rolling, Twisting>& law,
                     const ContactConstants& c, const Motion& m, const History& h, double dt) {
    const contact::NormalState elastic = law.normal.at(c.r_star, c.length_scale, m.overlap);
    const double a = elastic.contact_radius;
    const double normal_damping = law.damping.normal(law.normal.e_star, a, c.m_star);
    const double dashpot = normal_damping * m.approach_speed;
    const double repulsive = contact::repulsive_force(law.normal.e_star, c.r_star, a);
    const double cap = contact::cap_force(law.friction_cap, elastic.force, dashpot,
                                          law.normal.pull_off_force(c.r_star), repulsive);
    const double extra_dashpot = law.damping.viscoelastic.tangential(a, c.m_star);
    const contact::TangentialState slip =
        law.tangential.step({.spring = h.tangential_spring,
                             .previous_radius = h.previous_radius,
                             .contact_radius = a,
                             .n = m.n,
                             .slip_velocity = m.slip_velocity,
                             .cap_force = cap,
                             .damping_factor = law.damping.tsuji.factor,
                             .m_star = c.m_star,
                             .dt = dt,
                             .extra_dashpot = extra_dashpot});
    const contact::RollingState roll = law.rolling.step({.spring = h.rolling_spring,
                                                         .n = m.n,
                                                         .spin_i = m.spin_i,
                                                         .spin_j = m.spin_j,
                                                         .r_i = c.r_i,
                                                         .r_j = c.r_j,
                                                         .r_star = c.r_star,
                                                         .inverse_inertia_i = c.inverse_inertia_i,
                                                         .inverse_inertia_j = c.inverse_inertia_j,
                                                         .e_star = law.normal.e_star,
                                                         .previous_radius = h.previous_radius,
                                                         .contact_radius = a,
                                                         .cap_force = cap,
                                                         .dt = dt});
    const contact::TwistingState twist =
        law.twisting.step({.angle = h.twist,
                           .previous_radius = h.previous_radius,
                           .contact_radius = a,
                           .spin = contact::dot(m.spin_j - m.spin_i, m.n),
                           .cap_force = cap,
                           .damping_factor = law.damping.tsuji.factor,
                           .m_star = c.m_star,
                           .dt = dt,
                           .extra_dashpot = extra_dashpot});
    const Vec3 moment = contact::cross(m.n, slip.force_on_j), screw = twist.torque_on_j * m.n;
    return {.force_on_j = (elastic.force + dashpot) * m.n + slip.force_on_j,
            .torque_on_i = roll.torque_on_i - screw - m.lever_i * moment,
            .torque_on_j = roll.torque_on_j + screw - m.lever_j * moment,
            .history = {slip.spring, roll.spring, twist.angle, a},
            .dashpot = dashpot,
            .stored_tangential = slip.stored,
            .stored_rolling = roll.stored + twist.stored};
}

}  // namespace dem_min
