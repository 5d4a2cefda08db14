// SPDX-License-Identifier: MIT
#include "contact/rolling_epsd.hpp"

#include "contact/hertz.hpp"
#include "contact/jkr.hpp"
#include "tests/contact/rolling_pair.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using contact::RollingEpsd;
using contact::RollingInput;
using contact::RollingState;
using contact::Vec3;
using rolling_pair::at_wall;
using rolling_pair::inertia;
using rolling_pair::spheres;

// Ai et al. (2011): k_r = 2.25 k_n (mu_r R*)^2; k_n is the secant F/d of Hertz. 1e-12: algebra.
TEST_CASE("epsd: the rolling stiffness is 9/4 of Hertz' secant times the arm squared",
          "[contact][rolling_epsd][exact]") {
    const contact::Hertz hertz{1e9};
    const double mu = 0.3, overlap = 5e-9;
    RollingInput in = spheres(1e-4, 3e-4);
    const contact::NormalState normal = hertz.at(in.r_star, in.r_star, overlap);
    in.contact_radius = normal.contact_radius;
    in.spring = {2e-6, 0.0, 0.0};
    const double arm = mu * in.r_star;
    const double expected = 2.25 * normal.force / overlap * arm * arm * 2e-6;
    const RollingState state = RollingEpsd::from(mu, 0.0).step(in);
    REQUIRE(state.torque_on_j.x == Approx(-expected).epsilon(1e-12));
    REQUIRE(state.torque_on_i.x == -state.torque_on_j.x);
    REQUIRE(state.stored == Approx(0.5 * expected * 2e-6).epsilon(1e-12));
}

// Under adhesion the radius at zero overlap is not zero, and neither is the stiffness.
TEST_CASE("epsd: an adhering contact resists rolling at zero overlap and beyond",
          "[contact][rolling_epsd][limit]") {
    const contact::Jkr jkr{.e_star = 1e9, .w = 0.1};
    RollingInput in = spheres(1e-4, 1e-4);
    const double scale = jkr.length_scale(in.r_star);
    const double overlap = GENERATE(0.0, -0.5) * scale * scale / in.r_star;
    in.contact_radius = jkr.at(in.r_star, scale, overlap).contact_radius;
    in.spring = {1e-6, 0.0, 0.0};
    const double torque = -RollingEpsd{0.2, 0.3}.step(in).torque_on_j.x;
    REQUIRE(std::isfinite(torque));
    REQUIRE(torque > 0.0);
}

// mu_r R* N = 0.2 5e-5 m 1e-4 N = 1e-9 N m, dashpot or not. 1e-14: algebra.
TEST_CASE("epsd: fully mobilised the torque is mu_r R* N", "[contact][rolling_epsd][exact]") {
    RollingInput in = spheres(1e-4, 1e-4);
    in.spin_j = {0.0, 5e5, 0.0};
    in.spring = {0.0, 5e-3, 0.0};
    const RollingState state = RollingEpsd{0.2, GENERATE(0.0, 0.5)}.step(in);
    REQUIRE(state.torque_on_j.y == Approx(-1e-9).epsilon(1e-14));
    REQUIRE(contact::norm(state.torque_on_j) <= 1e-9 * (1.0 + 1e-15));
}

// At the limit along y, spun along x: the spring turns a little towards x, a dashpot would add to
// it.
TEST_CASE("epsd: the dashpot is off at full mobilisation", "[contact][rolling_epsd][exact]") {
    RollingInput in = spheres(1e-4, 1e-4);
    in.spring = {0.0, 1.0, 0.0};
    in.spin_j = {1e3, 0.0, 0.0};
    const RollingState damped = RollingEpsd{0.2, 1.0}.step(in);
    const RollingState bare = RollingEpsd{0.2, 0.0}.step(in);
    REQUIRE(damped.torque_on_j == bare.torque_on_j);
}

// c = 2 eta sqrt(I_r k). A sphere on a wall has I_r = 7/5 m R^2 = 7/2 I, a pair of equal spheres
// half of it. In a step so short that the spring is nothing: 1e-9.
TEST_CASE("epsd: the dashpot is critical at eta 1 for the inertia about the contact",
          "[contact][rolling_epsd][exact]") {
    const bool wall = GENERATE(true, false);
    RollingInput in = wall ? at_wall(1e-4) : spheres(1e-4, 1e-4);
    in.spin_i = {1e-2, 0.0, 0.0};
    in.dt = 1e-20;
    const double k = 3.0 * 1e9 * 2e-6 * 0.04 * in.r_star * in.r_star;
    const double about_contact = (wall ? 1.0 : 0.5) * 3.5 * inertia(1e-4);
    const double expected = 2.0 * 0.3 * std::sqrt(about_contact * k) * 1e-2;
    REQUIRE(RollingEpsd{0.2, 0.3}.step(in).torque_on_i.x == Approx(-expected).epsilon(1e-9));
}

TEST_CASE("epsd: twisting and turning together meet no resistance",
          "[contact][rolling_epsd][limit]") {
    RollingInput in = spheres(1e-4, 3e-4);
    in.spin_i = {70.0, -30.0, 500.0};
    in.spin_j = {70.0, -30.0, -900.0};
    REQUIRE(contact::norm(RollingEpsd{0.2, 0.3}.step(in).torque_on_i) == 0.0);
}

// k_r goes as a: 1.5 times the radius at a held angle stores half as much again, half the radius
// halves it. k_r = 3 1e9 Pa 2e-6 m (0.2 5e-5 m)^2 = 6e-7 N m before. 1e-12: algebra.
TEST_CASE("epsd: what a change of radius does to a loaded spring stands in the ledger",
          "[contact][rolling_epsd][energy]") {
    const double growth = GENERATE(1.5, 0.5);
    RollingInput in = spheres(1e-4, 1e-4);
    in.previous_radius = 2e-6;
    in.contact_radius = growth * 2e-6;
    in.spring = {3e-6, -4e-6, 0.0};
    const double before = 0.5 * 6e-7 * 25e-12;
    const RollingState state = RollingEpsd{0.2, 0.3}.step(in);
    REQUIRE(state.stored == Approx(growth * before).epsilon(1e-12));
    REQUIRE(state.dissipated == Approx((1.0 - growth) * before).epsilon(1e-12));
}

TEST_CASE("epsd: no step gives energy at a constant radius", "[contact][rolling_epsd][energy]") {
    const RollingEpsd law{0.2, 0.4};
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    RollingInput in = spheres(1e-4, 2e-4);
    for (int k = 0; k < 5000; ++k) {
        in.spin_i = {2e3 * uniform(random), 2e3 * uniform(random), 2e3 * uniform(random)};
        in.cap_force = 1e-4 * std::max(0.0, uniform(random) + 0.3);
        const RollingState state = law.step(in);
        const double limit = 0.2 * in.r_star * in.cap_force;
        REQUIRE(state.dissipated >= -1e-15 * limit);
        REQUIRE(contact::norm(state.torque_on_i) <= limit * (1.0 + 1e-15));
        in.spring = state.spring;
    }
}

// Work done on the contact = change of stored energy + dissipated, but for (1/2) k |omega dt|^2 in
// each step, so the defect halves with the step. The rocking sticks and slides.
TEST_CASE("epsd: the ledger of a rocking pair closes to first order in the step",
          "[contact][rolling_epsd][energy][order]") {
    const auto defect = [](int steps) {
        const RollingEpsd law{0.2, 0.3};
        RollingInput in = spheres(1e-4, 1e-4);
        in.cap_force = 1e-6;
        in.dt = 1e-3 / steps;
        double work = 0.0, dissipated = 0.0, stored = 0.0;
        for (int k = 0; k < steps; ++k) {
            const double phase = 4.0 * std::numbers::pi * (k + 0.5) / steps;
            in.spin_i = {0.3 * std::cos(phase), 0.2 * std::sin(phase), 0.0};
            const RollingState state = law.step(in);
            work -= in.dt * contact::dot(state.torque_on_i, in.spin_i);
            dissipated += state.dissipated;
            stored = state.stored;
            in.spring = state.spring;
        }
        REQUIRE(dissipated > 0.0);
        return (work - stored - dissipated) / work;
    };
    const double coarse = defect(1000), fine = defect(2000);
    REQUIRE(std::abs(fine) < 1e-2);
    REQUIRE(coarse / fine == Approx(2.0).epsilon(0.05));
}
