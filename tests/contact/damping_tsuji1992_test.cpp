// SPDX-License-Identifier: MIT
#include "contact/damping_tsuji1992.hpp"

#include "contact/hertz.hpp"
#include "contact/mindlin.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using contact::DampingTsuji1992;
using contact::Hertz;
using std::numbers::pi;

namespace {

// Rebound speed of two Hertzian spheres: m* x'' = -F - c x', from touch to zero overlap, by the
// classical Runge-Kutta method with `steps` to the length of the elastic contact.
double rebound_speed(const Hertz& law, const DampingTsuji1992& damping, double r_star,
                     double m_star, double speed, int steps) {
    const auto acceleration = [&](double x, double v) {
        const contact::NormalState s = law.at(r_star, law.length_scale(r_star), x);
        return -(s.force + damping.normal(law.e_star, s.contact_radius, m_star) * v) / m_star;
    };
    // Hertz: contact time 2.87 (m*^2/(R* E*^2 v))^(1/5).
    const double time =
        2.87 * std::pow(m_star * m_star / (r_star * law.e_star * law.e_star * speed), 0.2);
    const double h = time / steps;
    double x = 0.0, v = speed, last_x = 0.0, last_v = speed;
    while (x >= 0.0) {
        last_x = x;
        last_v = v;
        const double a1 = acceleration(x, v), v2 = v + 0.5 * h * a1;
        const double a2 = acceleration(x + 0.5 * h * v, v2), v3 = v + 0.5 * h * a2;
        const double a3 = acceleration(x + 0.5 * h * v2, v3), v4 = v + h * a3;
        const double a4 = acceleration(x + h * v3, v4);
        x += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
        v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    return -(last_v + (v - last_v) * last_x / (last_x - x));
}

}  // namespace

// beta = 1 for e = 0, 1/sqrt(2) for e = exp(-pi), 0 for e = 1; by hand. 1e-14: algebra.
TEST_CASE("tsuji: the factor runs from 2 sqrt(5/6) without rebound to 0 without loss",
          "[contact][damping][exact]") {
    REQUIRE(DampingTsuji1992::from(0.0).factor == Approx(std::sqrt(10.0 / 3.0)).epsilon(1e-14));
    REQUIRE(DampingTsuji1992::from(std::exp(-pi)).factor ==
            Approx(std::sqrt(5.0 / 3.0)).epsilon(1e-14));
    REQUIRE(DampingTsuji1992::from(1.0).factor == 0.0);
}

// Antypov & Elliott (2011): with this factor the nonlinear oscillator maps on the linear one, so e
// is exact at every speed. 1e-4: the step, at the ends of the contact, where c has no smooth slope.
TEST_CASE("tsuji: spheres leave with the restitution asked for, at any speed",
          "[contact][damping][exact]") {
    const double restitution = GENERATE(0.3, 0.7, 0.95), speed = GENERATE(1e-3, 2.0);
    const double rebound =
        rebound_speed(Hertz{7e9}, DampingTsuji1992::from(restitution), 5e-4, 2e-7, speed, 4000);
    REQUIRE(rebound / speed == Approx(restitution).epsilon(1e-4));
}

// c = factor sqrt(S m*) with the slope S of the force that is damped. Normal: Hertz' dF/dd, by
// central difference (error 1e-9). Tangential: Mindlin's answer to a displacement, undamped.
TEST_CASE("tsuji: the dashpots take the stiffness of the springs beside them",
          "[contact][damping][exact]") {
    const DampingTsuji1992 damping{0.5};
    const Hertz hertz{7e9};
    const double r_star = 5e-4, d = 1e-7, half = 1e-4 * d, m_star = 2e-7, g_star = 2e9;
    const auto force = [&](double x) { return hertz.at(r_star, r_star, x).force; };
    const double slope = (force(d + half) - force(d - half)) / (2.0 * half);
    const double a = hertz.at(r_star, r_star, d).contact_radius;
    REQUIRE(damping.normal(7e9, a, m_star) ==
            Approx(0.5 * std::sqrt(slope * m_star)).epsilon(1e-8));

    const contact::TangentialState pushed =
        contact::Mindlin{g_star, 1.0}.step({.spring = {},
                                            .previous_radius = a,
                                            .contact_radius = a,
                                            .n = {0.0, 0.0, 1.0},
                                            .slip_velocity = {1.0, 0.0, 0.0},
                                            .cap_force = 1e9,
                                            .damping_factor = 0.0,
                                            .m_star = m_star,
                                            .dt = 1e-9});
    const double stiffness = -pushed.force_on_j.x / 1e-9;
    REQUIRE(damping.tangential(g_star, a, m_star) ==
            Approx(0.5 * std::sqrt(stiffness * m_star)).epsilon(1e-12));
}
