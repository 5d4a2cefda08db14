// SPDX-License-Identifier: MIT
#include "contact/damping.hpp"
#include "contact/mindlin.hpp"
#include "contact/twisting_marshall2009.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using contact::Damping;
using contact::DampingTsuji1992;
using contact::DampingViscoelastic;

// 3e9/(m s) * 2 um * 4e-9 kg = 2.4e-5 kg/s, by hand; a quarter of it is 6e-6. 1e-14: algebra.
TEST_CASE("viscoelastic: the dashpot is eta a m*, the tangential one a share of it",
          "[contact][damping][exact]") {
    const DampingViscoelastic law{.eta = 3e9, .tangential_ratio = 0.25};
    REQUIRE(law.normal(2e-6, 4e-9) == Approx(2.4e-5).epsilon(1e-14));
    REQUIRE(law.tangential(2e-6, 4e-9) == Approx(6e-6).epsilon(1e-14));
}

// c = eta a m* at a contact held at radius a: m* x'' = -k x - c x' loses the share exp(-c T/m*) of
// its energy in a period T, hence exp(-eta a T): the mass drops out. Integrated by leapfrog in 1e5
// steps, the velocity centred; 1e-6: second order in the step, (2 pi/1e5)^2, times the damping.
TEST_CASE("viscoelastic: the decay of a vibration knows no mass", "[contact][damping][exact]") {
    const DampingViscoelastic law{.eta = 2e7, .tangential_ratio = 0.0};
    const double m_star = GENERATE(1e-9, 3e-6), a = 1e-6, omega = 100.0;  // kg, m, rad/s
    const double c = law.normal(a, m_star), decay = 0.5 * 2e7 * 1e-6;     // 1/s, of the amplitude
    const double turning = std::sqrt(omega * omega - decay * decay);
    const double period = 2.0 * std::acos(-1.0) / turning, dt = period / 1e5;
    double x = 0.0, v = 1.0;
    for (int k = 0; k < 100000; ++k) {
        x += 0.5 * dt * v;
        const double kick = -(omega * omega * x + c / m_star * v) * dt;
        v += kick / (1.0 + 0.5 * dt * c / m_star);  // the dashpot at the mean velocity of the step
        x += 0.5 * dt * v;
    }
    REQUIRE(v == Approx(std::exp(-decay * period)).epsilon(1e-6));
}

TEST_CASE("damping: what is not wanted changes no bit of the other", "[contact][damping][limit]") {
    const double e_star = 3.1e9, a = 1.3e-6, m_star = 4.4e-9;
    const DampingTsuji1992 tsuji{0.7};
    const DampingViscoelastic viscoelastic{2e7, 0.5};
    REQUIRE(Damping{tsuji}.normal(e_star, a, m_star) == tsuji.normal(e_star, a, m_star));
    REQUIRE(Damping{viscoelastic}.normal(e_star, a, m_star) == viscoelastic.normal(a, m_star));
    REQUIRE(Damping{}.normal(e_star, a, m_star) == 0.0);
}

// A fresh spring of Mindlin: F = -(k v dt + (c_Tsuji + c) v), so that the extra dashpot shows as the
// difference of two forces; likewise the torque of the disc, c a^2/2 omega. 1e-9: cancellation.
TEST_CASE("damping: the extra dashpot pulls with c v at the contact and with c a^2/2 omega about n",
          "[contact][damping][exact]") {
    contact::TangentialInput in{.spring = {},
                                .previous_radius = 1e-6,
                                .contact_radius = 1e-6,
                                .n = {0.0, 0.0, 1.0},
                                .slip_velocity = {0.25, 0.0, 0.0},
                                .cap_force = 1e9,
                                .damping_factor = 0.3,
                                .m_star = 4e-9,
                                .dt = 1e-9};
    const contact::Mindlin mindlin{2e9, 1.0};
    const double without = mindlin.step(in).force_on_j.x;
    in.extra_dashpot = 6e-3;
    REQUIRE(mindlin.step(in).force_on_j.x - without == Approx(-6e-3 * 0.25).epsilon(1e-9));

    contact::TwistingInput twist{.angle = 0.0,
                                 .previous_radius = 1e-6,
                                 .contact_radius = 1e-6,
                                 .spin = 8.0,
                                 .cap_force = 1e9,
                                 .damping_factor = 0.3,
                                 .m_star = 4e-9,
                                 .dt = 1e-9};
    const contact::TwistingMarshall2009 marshall{2e9, 1.0};
    const double free = marshall.step(twist).torque_on_j;
    twist.extra_dashpot = 6e-3;
    REQUIRE(marshall.step(twist).torque_on_j - free == Approx(-6e-3 * 0.5e-12 * 8.0).epsilon(1e-9));
}
