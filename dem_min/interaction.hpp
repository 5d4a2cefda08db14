// SPDX-License-Identifier: MIT
// One contact, from its motion to its load: the normal, tangential and rolling law put together. Every path of the core
// (blocks of contacts, the all-pairs reference, walls) calls `push` and `turn`, so that they give the same bits.
#pragma once

#include "contact/ageing.hpp"
#include "contact/capillary_bridge.hpp"
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
    contact::CapillaryBridge bridge = {};              // as constructed: none
    contact::Ageing ageing = {};                       // as constructed: none

    // A contact may then be one of a bridge alone, or has its own work of adhesion: it is loaded singly.
    bool singly() const { return bridge.acts() || ageing.acts(); }
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

// What the normal and the tangential law make of a contact.
struct Push {
    double normal_force;  // N, elastic and damping, > 0 in compression
    double dashpot;       // N, the part of it that is damping
    double cap_force;     // N, >= 0: what friction multiplies
    Vec3 friction_on_j;   // N
    Vec3 spring;          // m, tangential
    double stored;        // J, tangential
};

// What the rolling and the twisting law make of it, friction's torques included.
struct Turn {
    Vec3 torque_on_i, torque_on_j;  // N m
    Vec3 spring;                    // rad or m, of rolling, as the law says
    double twist;                   // rad
    double stored;                  // J
};

// A law's step, with the slider that is wanted if it has one (contact/yield.hpp).
template <class Law, class Input, class AnySlider>
inline auto step_of(const Law& law, const Input& in, AnySlider& slider) {
    if constexpr (requires { law.step(in, slider); })
        return law.step(in, slider);
    else
        return law.step(in);
}

template <class Interaction, class AnySlider>
inline Push push(const Interaction& law, const ContactConstants& c,
                 const contact::NormalState& elastic, const Motion& m, Vec3 spring,
                 double previous_radius, double dt, AnySlider& slider) {
    const double a = elastic.contact_radius;
    const double dashpot = law.damping.normal(law.normal.e_star, a, c.m_star) * m.approach_speed;
    const double repulsive = contact::repulsive_force(law.normal.e_star, c.r_star, a);
    const double cap = contact::cap_force(law.friction_cap, elastic.force, dashpot,
                                          law.normal.pull_off_force(c.r_star), repulsive);
    const contact::TangentialState slip = step_of(
        law.tangential,
        contact::TangentialInput{.spring = spring,
                                 .previous_radius = previous_radius,
                                 .contact_radius = a,
                                 .n = m.n,
                                 .slip_velocity = m.slip_velocity,
                                 .cap_force = cap,
                                 .damping_factor = law.damping.tsuji.factor,
                                 .m_star = c.m_star,
                                 .dt = dt,
                                 .extra_dashpot = law.damping.viscoelastic.tangential(a, c.m_star)},
        slider);
    return {elastic.force + dashpot, dashpot, cap, slip.force_on_j, slip.spring, slip.stored};
}

template <class Interaction, class AnySlider>
inline Turn turn(const Interaction& law, const ContactConstants& c, double contact_radius,
                 double cap_force, Vec3 friction_on_j, const Motion& m, Vec3 spring, double twist,
                 double previous_radius, double dt, AnySlider& slider) {
    const contact::RollingState roll =
        step_of(law.rolling,
                contact::RollingInput{.spring = spring,
                                      .n = m.n,
                                      .spin_i = m.spin_i,
                                      .spin_j = m.spin_j,
                                      .r_i = c.r_i,
                                      .r_j = c.r_j,
                                      .r_star = c.r_star,
                                      .inverse_inertia_i = c.inverse_inertia_i,
                                      .inverse_inertia_j = c.inverse_inertia_j,
                                      .e_star = law.normal.e_star,
                                      .previous_radius = previous_radius,
                                      .contact_radius = contact_radius,
                                      .cap_force = cap_force,
                                      .dt = dt},
                slider);
    const contact::TwistingState screwed = law.twisting.step(
        {.angle = twist,
         .previous_radius = previous_radius,
         .contact_radius = contact_radius,
         .spin = contact::dot(m.spin_j - m.spin_i, m.n),
         .cap_force = cap_force,
         .damping_factor = law.damping.tsuji.factor,
         .m_star = c.m_star,
         .dt = dt,
         .extra_dashpot = law.damping.viscoelastic.tangential(contact_radius, c.m_star)});
    const Vec3 moment = contact::cross(m.n, friction_on_j), screw = screwed.torque_on_j * m.n;
    return {roll.torque_on_i - screw - m.lever_i * moment,
            roll.torque_on_j + screw - m.lever_j * moment, roll.spring, screwed.angle,
            roll.stored + screwed.stored};
}

}  // namespace dem_min
