// SPDX-License-Identifier: MIT
// What a contact law offers, and the signs that all of them share.
//
// Signs: the unit normal n points from grain i to grain j. Overlap, compression and approach speed
// are positive. Forces and torques named `..._on_j` act on j; Newton's third law gives those on i.
// `slip_velocity` is the velocity of j's surface relative to i's at the contact, in the plane
// normal to n:
//   v_j - v_i - (l_i omega_i + l_j omega_j) x n, tangential part; l: distance from the centre to
//   the contact.
// A law is physics only: it knows one contact, no list, no thread, no grain in motion. All members
// are inline, free of branches that a vector loop could not turn into a select, and scale-free: no
// tolerance carries a unit, no power has a fractional exponent, so that a system scaled by powers
// of two keeps its bits.
#pragma once

#include "contact/vec3.hpp"

#include <concepts>

namespace contact {

// Elastic normal response at one overlap.
struct NormalState {
    double force;           // N, on j along n; > 0 in compression
    double contact_radius;  // m
};

template <class Law>
concept NormalLaw = requires(const Law law, double r_star, double length_scale, double overlap) {
    // Pa
    { law.e_star } -> std::convertible_to<double>;
    // m, once per contact
    { law.length_scale(r_star) } -> std::convertible_to<double>;
    // For overlap >= tear_off_overlap.
    { law.at(r_star, length_scale, overlap) } -> std::same_as<NormalState>;
    // J, zero at overlap 0
    { law.energy(r_star, length_scale, overlap) } -> std::convertible_to<double>;
    // N, >= 0
    { law.pull_off_force(r_star) } -> std::convertible_to<double>;
    // m, <= 0: an existing contact lives while overlap >= this; a new one is born at overlap >= 0.
    { law.tear_off_overlap(r_star, length_scale) } -> std::convertible_to<double>;
};

struct TangentialInput {
    Vec3 spring;             // m, as the last step left it
    double previous_radius;  // m, contact radius of the last step
    double contact_radius;   // m
    Vec3 n;
    Vec3 slip_velocity;          // m/s
    double cap_force;            // N, >= 0: what friction multiplies (contact/friction_cap.hpp)
    double damping_factor;       // 2 sqrt(5/6) beta, from DampingTsuji1992
    double m_star;               // kg
    double dt;                   // s
    double extra_dashpot = 0.0;  // kg/s beside Tsuji's, from DampingViscoelastic
};

struct TangentialState {
    Vec3 force_on_j;  // N
    Vec3 spring;      // m
    double stored;    // J in the spring
    // J in this step by dashpot, sliding and change of stiffness; < 0 only by the last
    double dissipated;
};

template <class Law>
concept TangentialLaw = requires(const Law law, const TangentialInput& in) {
    { law.step(in) } -> std::same_as<TangentialState>;
};

struct RollingInput {
    Vec3 spring;  // rad or m, as the law says
    Vec3 n;
    Vec3 spin_i, spin_j;                          // rad/s
    double r_i, r_j, r_star;                      // m; at a wall r_j is infinite and r_star = r_i
    double inverse_inertia_i, inverse_inertia_j;  // 1/(kg m^2); 0 for walls and fixed grains
    double e_star;                                // Pa
    double previous_radius;                       // m, contact radius of the last step
    double contact_radius;                        // m
    double cap_force;                             // N, >= 0
    double dt;                                    // s
};

struct RollingState {
    Vec3 torque_on_i, torque_on_j;  // N m
    Vec3 spring;
    double stored;  // J
    // J in this step by dashpot, slider and change of stiffness; < 0 only by the last
    double dissipated;
};

template <class Law>
concept RollingLaw = requires(const Law law, const RollingInput& in) {
    { law.step(in) } -> std::same_as<RollingState>;
};

}  // namespace contact
