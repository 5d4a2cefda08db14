// SPDX-License-Identifier: MIT
#include "verify/lammps_two_grains.hpp"

#include "contact/effective.hpp"
#include "dem_min/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verify {
namespace {

using contact::Vec3;
using engines::PairStates;
using engines::TwoGrains;

// Three directions at right angles, none along an axis, so that no component is zero by accident.
constexpr Vec3 normal{1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
constexpr Vec3 along{2.0 / 3.0, 1.0 / 3.0, -2.0 / 3.0};
constexpr Vec3 across{2.0 / 3.0, -2.0 / 3.0, 1.0 / 3.0};

dem_min::Simulation simulation_of(const TwoGrains& t, double density_factor) {
    dem_min::Simulation s;
    s.settings = {.time_step = t.time_step, .skin = t.skin, .gravity = {}, .lost_below = -1e3};
    s.between_grains = s.at_walls = engines::laws(t.contact);
    for (dem_min::Grain g : t.grains) {
        g.density *= density_factor;
        dem_min::insert(s, g);
    }
    return s;
}

std::array<engines::GrainState, 2> state_of(const dem_min::Simulation& s) {
    std::array<engines::GrainState, 2> pair{};
    const dem_min::Particles& p = s.grains;
    for (std::size_t k = 0; k < 2; ++k)
        pair[k] = {p.position(k),
                   p.velocity(k),
                   p.spin(k),
                   {p.fx[k], p.fy[k], p.fz[k]},
                   {p.tx[k], p.ty[k], p.tz[k]}};
    return pair;
}

double mass_of(const dem_min::Grain& g) {
    return 4.0 / 3.0 * std::numbers::pi * g.radius * g.radius * g.radius * g.density;
}

// What is not a number is as far apart as can be.
void raise(double& to, Vec3 x, Vec3 y) {
    const double distance = contact::norm(x - y);
    if (!(distance <= to)) to = std::isnan(distance) ? HUGE_VAL : distance;
}

}  // namespace

// So heavy that no force moves them: LAMMPS' `fix move` moves grains likewise whatever the forces.
PairStates led_by_core(const TwoGrains& t) {
    dem_min::Simulation s = simulation_of(t, 1e40);
    PairStates states{state_of(s)};
    for (int k = 0; k < t.steps + t.steps_apart; ++k) {
        if (k == t.steps)
            for (std::size_t g = 0; g < 2; ++g) {
                s.grains.vx[g] = -t.grains[g].velocity.x;
                s.grains.vy[g] = -t.grains[g].velocity.y;
                s.grains.vz[g] = -t.grains[g].velocity.z;
            }
        dem_min::step(s);
        states.push_back(state_of(s));
    }
    return states;
}

PairStates thrown_by_core(const TwoGrains& t, bool wall) {
    dem_min::Simulation s = simulation_of(t, 1.0);
    if (wall) s.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    PairStates states{state_of(s)};
    for (int k = 0; k < t.steps; ++k) {
        dem_min::step(s);
        states.push_back(state_of(s));
    }
    return states;
}

TwoGrains led_pair(double skin) {
    TwoGrains t{};
    const double radius = 120e-6, r_star = 0.5 * radius, density = 5600.0;
    t.contact = {.youngs_modulus = 156e6, .poisson_ratio = 0.3, .surface_energy = 0.19};
    const contact::Jkr jkr{t.contact.e_star(), t.contact.work_of_adhesion()};
    const double scale = jkr.length_scale(r_star);  // L; d = L^2/R* (s^4 - 2 s)
    const double length = scale * scale / r_star, way = length / 400.0, gap = 20.5 * way;
    t.time_step = 1e-6;
    t.skin = skin;
    const Vec3 half = 0.5 * (2.0 * radius + gap) * normal;
    const Vec3 velocity = 0.5 * way / t.time_step * normal;
    t.grains = {dem_min::Grain{-half, velocity, {}, radius, density},
                dem_min::Grain{half, -velocity, {}, radius, density}};
    // Equilibrium: s^3 = 3, D = 3^(1/3). Torn off at D = -0.57.
    t.steps = 20 + static_cast<int>(4.0 * std::cbrt(3.0) * 400.0);
    t.steps_apart = t.steps + 300;
    return t;
}

TwoGrains passing_pair(const Pass& c) {
    TwoGrains t = led_pair(120e-6);
    const double radius = t.grains[0].radius, half_way = 0.215 * radius;
    t.contact.sliding_friction = c.sliding_friction;
    t.contact.rolling_friction = c.rolling_friction;
    t.contact.rolling_stiffness = c.rolling_friction > 0.0 ? 500.0 : 0.0;  // N/m
    t.contact.rolling_damping = 1e-5;                                      // kg/s
    t.steps = t.steps_apart = 3000;
    const Vec3 half = 0.5 * (1.99 * radius * normal - half_way * along);
    const Vec3 velocity = half_way / (t.steps * t.time_step) * along;
    const Vec3 spin =
        c.spin * contact::norm(velocity) / radius * (0.5 * normal + along - 0.7 * across);
    t.grains[0].position = -half, t.grains[0].velocity = -velocity;
    t.grains[1].position = half, t.grains[1].velocity = velocity;
    t.grains[0].spin = spin, t.grains[1].spin = 0.4 * spin;
    return t;
}

// Without adhesion two spheres of reduced mass m* reach d = (15 m* v^2/(16 E* sqrt R*))^(2/5) and part
// after 2.94 d/v (Johnson 1985, section 11.4). With it, v is eight times the sticking speed.
TwoGrains thrown_pair(const Throw& c) {
    TwoGrains t{};
    const double radius = 120e-6, density = 5600.0, youngs_modulus = 2e11;
    const dem_min::Grain like{{}, {}, {}, radius, density};
    const double r_star = c.wall ? radius : 0.5 * radius;
    const double m_star = c.wall ? mass_of(like) : 0.5 * mass_of(like);
    t.contact = {.youngs_modulus = youngs_modulus,
                 .poisson_ratio = c.poisson_ratio,
                 .tangential_ratio = c.tangential_ratio,
                 .sliding_friction = c.sliding_friction};
    const double e_star = t.contact.e_star(), depth = c.depth * radius;
    const double speed =
        std::sqrt(16.0 * e_star * std::sqrt(r_star) * std::pow(depth, 2.5) / (15.0 * m_star));
    const double a = std::sqrt(r_star * depth);
    const double work = 0.5 * m_star * speed * speed / 64.0;
    t.contact.surface_energy =
        c.adhesion * 0.5 *
        std::pow(std::pow(work / 7.0922, 3.0) * e_star * e_star / std::pow(r_star, 4.0), 0.2);
    t.contact.eta = c.damping * std::sqrt(2.0 * e_star / (a * m_star));
    t.contact.rolling_stiffness = c.rolling_friction > 0.0 ? 8.0 * t.contact.g_star() * a : 0.0;
    t.contact.rolling_damping = 0.3 * std::sqrt(t.contact.rolling_stiffness * m_star);
    t.contact.rolling_friction = c.rolling_friction;
    t.contact.twisting = c.twisting;
    t.contact.stiffness_as_number = c.stiffness_as_number;
    t.time_step = 2.94 * depth / speed / 1000.0;
    t.skin = radius;
    t.steps = 6000;

    const double angle = c.angle_deg * std::numbers::pi / 180.0, gap = 10.5 * speed * t.time_step;
    const Vec3 spin =
        speed / radius * (c.spin * (0.5 * normal + along - 0.7 * across) + c.screw * normal);
    if (c.wall) {
        const Vec3 in{0.6 * std::sin(angle) * speed, 0.8 * std::sin(angle) * speed,
                      -std::cos(angle) * speed};
        t.grains = {dem_min::Grain{{0.0, 0.0, radius + gap}, in, spin, radius, density},
                    dem_min::Grain{{10.0 * radius, 0.0, 3.0 * radius}, {}, {}, radius, density}};
        return t;
    }
    const Vec3 half = 0.5 * (2.0 * radius + gap) * normal;
    const Vec3 closing = 0.5 * speed * (std::cos(angle) * normal - std::sin(angle) * along);
    t.grains = {dem_min::Grain{-half, closing, spin, radius, density},
                dem_min::Grain{half, -closing, 0.4 * spin, radius, density}};
    return t;
}

Apart apart(const PairStates& a, const PairStates& b, const TwoGrains& t) {
    if (a.size() != b.size()) return {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
    Apart most{};
    double peak_force = 0.0, peak_torque = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
        for (std::size_t g = 0; g < 2; ++g) {
            raise(peak_force, b[k][g].force, {});
            raise(peak_torque, b[k][g].torque, {});
            raise(most.force, a[k][g].force, b[k][g].force);
            raise(most.torque, a[k][g].torque, b[k][g].torque);
            raise(most.velocity, a[k][g].velocity, b[k][g].velocity);
            raise(most.spin, a[k][g].spin, b[k][g].spin);
        }
    const double speed = contact::norm(t.grains[1].velocity - t.grains[0].velocity);
    return {most.force / peak_force, peak_torque > 0.0 ? most.torque / peak_torque : most.torque,
            most.velocity / speed, most.spin * t.grains[0].radius / speed};
}

}  // namespace verify
