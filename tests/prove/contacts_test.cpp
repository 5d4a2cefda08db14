// SPDX-License-Identifier: MIT
// The generator's plane, impact and force curve against closed forms.
#include "prove/collision.hpp"
#include "tests/prove/worlds.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace prove;
using std::numbers::pi;

TEST_CASE("prove: thrown without spin a sphere slides until 5/7 of its speed, at 2 v/(7 mu g)",
          "[prove]") {
    Setup s = bead(Rig::incline, {Channel::s, Channel::spin});
    s.speed = 0.7;
    World w;
    w.sliding_friction = 0.2;
    const double rolls = 2.0 * 0.7 / (7.0 * 0.2 * s.gravity);
    s.at = {0.5 * rolls, rolls, 3.0 * rolls};
    const std::vector<double> y = predict(w, s);
    REQUIRE(y[0] == Approx(0.7 * s.at[0] - 0.1 * s.gravity * s.at[0] * s.at[0]).epsilon(1e-12));
    REQUIRE(y[4] * s.radius() == Approx(0.5).epsilon(1e-12));
    REQUIRE(y[2] - y[1] == Approx(0.5 * 2.0 * rolls).epsilon(1e-12));
}

TEST_CASE("prove: rolling resistance slows a rolling sphere by 5/7 mu_r g until it lies",
          "[prove]") {
    Setup s = bead(Rig::incline, {Channel::s});
    s.speed = 0.3, s.spin = 0.3 / s.radius();
    World w;
    w.sliding_friction = 0.4, w.rolling_friction = 0.02;
    const double slowing = 5.0 / 7.0 * 0.02 * s.gravity, stops = 0.3 / slowing;
    s.at = {0.4 * stops, 1.5 * stops};
    const std::vector<double> y = predict(w, s);
    REQUIRE(y[0] == Approx(0.3 * s.at[0] - 0.5 * slowing * s.at[0] * s.at[0]).epsilon(1e-12));
    REQUIRE(y[1] == Approx(0.5 * 0.3 * stops).epsilon(1e-12));
}

TEST_CASE(
    "prove: downhill it rolls at 5/7 g sin, on too steep a plane it slides at g (sin - mu cos)",
    "[prove]") {
    Setup s = bead(Rig::incline, {Channel::s});
    s.at = {0.5};
    World w;
    w.sliding_friction = 0.3;
    s.angle = 0.2;
    REQUIRE(predict(w, s)[0] ==
            Approx(0.125 * 5.0 / 7.0 * s.gravity * std::sin(0.2)).epsilon(1e-12));
    s.angle = 1.2;  // tan > 7/2 mu
    REQUIRE(predict(w, s)[0] ==
            Approx(0.125 * s.gravity * (std::sin(1.2) - 0.3 * std::cos(1.2))).epsilon(1e-12));
    // Adhesion adds twice its pull-off to what friction multiplies.
    w.work_of_adhesion = 0.005;
    const double held = 2.0 * 1.5 * pi * 0.005 * s.radius() / s.mass();
    REQUIRE(predict(w, s)[0] ==
            Approx(0.125 * (s.gravity * std::sin(1.2) - 0.3 * (s.gravity * std::cos(1.2) + held)))
                .epsilon(1e-12));
}

TEST_CASE("prove: a rigid impact slides through at grazing angles and sticks at steep ones",
          "[prove]") {
    Setup s = bead(Rig::impact, {Channel::tangential_restitution, Channel::rebound_spin});
    s.speed = 2.0;
    World w;
    w.micro_slip = false;
    w.restitution = 0.8, w.sliding_friction = 0.15;
    const double limit = std::atan(3.5 * 0.15 * 1.8);  // Walton (1993)
    s.at = {0.9 * limit, 1.3};
    const std::vector<double> y = predict(w, s);
    REQUIRE(y[0] == Approx(5.0 / 7.0).epsilon(1e-12));
    REQUIRE(y[1] == Approx(1.0 - 0.15 * 1.8 / std::tan(1.3)).epsilon(1e-12));
    REQUIRE(y[3] == Approx(2.5 * 0.15 * 1.8 * 2.0 * std::cos(1.3) / s.radius()).epsilon(1e-12));
    // Micro-slip changes nothing where the contact slides throughout.
    w.micro_slip = true;
    REQUIRE(predict(w, s)[1] == Approx(y[1]).epsilon(1e-4));
    REQUIRE(std::abs(predict(w, s)[0] - y[0]) > 0.02);
}

TEST_CASE("prove: friction that falls with the slip is solved as its equation says", "[prove]") {
    Setup s = bead(Rig::impact, {Channel::tangential_restitution});
    s.speed = 3.0, s.at = {1.2};
    World w;
    w.micro_slip = false;
    w.restitution = 0.6, w.sliding_friction = 0.3, w.dynamic_friction = 0.1;
    w.friction_velocity = 1.0;
    // du/dp = -7/2 mu(u), mu = mu_d + D exp(-u/v_f): ln(mu_d e^(u/v_f) + D) falls by 7/2 mu_d p/v_f.
    const double u0 = 3.0 * std::sin(1.2), p = 1.6 * 3.0 * std::cos(1.2), d = 0.2;
    const double u1 = std::log(((0.1 * std::exp(u0) + d) * std::exp(-3.5 * 0.1 * p) - d) / 0.1);
    REQUIRE(u1 > 0.0);
    // Steps of a 120th of the impulse, second order.
    REQUIRE(predict(w, s)[0] == Approx(1.0 - 2.0 / 7.0 * (u0 - u1) / u0).epsilon(1e-5));
}

TEST_CASE("prove: restitution follows the speed as its laws say", "[prove]") {
    World w;
    w.loss_coefficient = 0.2;
    REQUIRE(restitution_at(w, 2.0, 0.0) == Approx(1.0 - 0.2 * std::pow(2.0, 0.2)).epsilon(1e-14));
    World hard;
    hard.restitution = 0.9, hard.yield_velocity = 0.5;
    REQUIRE(restitution_at(hard, 0.4, 0.0) == 0.9);
    REQUIRE(restitution_at(hard, 8.0, 0.0) ==
            Approx(0.9 * std::pow(1.0 / 16.0, 0.25)).epsilon(1e-14));
}

TEST_CASE("prove: the course of an elastic impact is deepest at (5/4)^(2/5) and lasts 3.218",
          "[prove]") {
    // Units of Hertz' problem: v^2/2 = (2/5) x^2.5; the duration is 2.9432 of the depth (Johnson 1985, 11.1).
    const std::vector<ContactNode> course = hertz_course(1.0);
    double deepest = 0.0;
    for (const ContactNode& n : course) deepest = std::max(deepest, n.overlap);
    REQUIRE(deepest == Approx(std::pow(1.25, 0.4)).epsilon(1e-4));
    REQUIRE(course.back().t == Approx(2.9432 * std::pow(1.25, 0.4)).epsilon(1e-4));
}

TEST_CASE("prove: the force curve is Hertz inwards and tears off at 3/2 pi w R*", "[prove]") {
    Setup s = bead(Rig::pull_off, {Channel::force});
    s.diameter = 20e-6;
    World w;
    w.work_of_adhesion = 0.05;
    const double fold = 1.60877 * std::cbrt(0.05 * 0.05 * s.r_star() / (s.e_star() * s.e_star()));
    s.at = evenly(-5.0 * fold, 1.2 * fold, 4001);
    s.retract.assign(s.at.size(), true);
    const std::vector<double> f = predict(w, s);
    REQUIRE(*std::min_element(f.begin(), f.end()) ==
            Approx(-1.5 * pi * 0.05 * s.r_star()).epsilon(1e-6));
    for (std::size_t k = 0; k < s.at.size(); ++k)
        if (s.at[k] > 1.0001 * fold) REQUIRE(f[k] == 0.0);
    s.retract.assign(s.at.size(), false);
    w.work_of_adhesion = 0.0;
    REQUIRE(predict(w, s)[0] ==
            Approx(4.0 / 3.0 * s.e_star() * std::sqrt(s.r_star()) * std::pow(5.0 * fold, 1.5))
                .epsilon(1e-12));
}

TEST_CASE("prove: attractions over a gap have their textbook size", "[prove]") {
    Setup s = bead(Rig::pull_off, {Channel::force});
    s.diameter = 10e-6;
    s.at = {2e-9};
    s.retract = {false};
    World tail;
    tail.hamaker_constant = 1e-19;
    REQUIRE(predict(tail, s)[0] == Approx(-1e-19 * 5e-6 / (6.0 * 4e-18)).epsilon(1e-12));
    World charged;
    charged.charge = 3e-15;
    REQUIRE(
        predict(charged, s)[0] ==
        Approx(-9e-30 / (16.0 * pi * 8.8541878128e-12 * std::pow(5e-6 + 2e-9, 2))).epsilon(1e-9));
    World wet;
    wet.surface_tension = 0.072, wet.liquid_volume = 1e-20;
    REQUIRE(predict(wet, s)[0] == 0.0);  // no bridge before the first touch
    s.at = {-1e-12};
    s.retract = {true};
    REQUIRE(predict(wet, s)[0] == Approx(-4.0 * pi * 0.072 * 5e-6).epsilon(1e-3));
}

TEST_CASE("prove: behind a spring the grain stands where spring and contact agree", "[prove]") {
    Setup s = bead(Rig::pull_off, {Channel::force});
    s.diameter = 20e-6, s.preload = 2e-6, s.cantilever_stiffness = 5.0;
    World w;
    w.work_of_adhesion = 0.05;
    s.at = {-3e-7, 2e-7, 3e-6, 2e-7};
    s.retract = {false, true, true, false};
    const std::vector<double> f = predict(w, s);
    const Jkr law{s.e_star(), s.r_star(), 0.05};
    for (const std::size_t k : {0u, 1u}) {
        // A repulsive force bends the spring away: separation = drive + F/k.
        const double separation = s.at[k] + f[k] / 5.0;
        REQUIRE(f[k] == Approx(law.force(law.radius(-separation))).epsilon(1e-8));
    }
    REQUIRE(f[2] == 0.0);
    REQUIRE(f[3] == 0.0);
}

// The force of the tail ends at its contact value A R/(6 h^2), h = 0.165 nm: up to there a spring that is drawn back finds the
// grain where it touches.
TEST_CASE("prove: behind a soft spring van der Waals' pull holds the grain where it touches",
          "[prove]") {
    Setup s = bead(Rig::pull_off, {Channel::force});
    s.diameter = 20e-6, s.preload = 2e-6, s.cantilever_stiffness = 5.0;
    World w;
    w.hamaker_constant = 1e-19;
    const double deepest = 1e-19 * s.r_star() / (6.0 * 0.165e-9 * 0.165e-9);
    // In: it jumps where the pull grows faster than the spring, A R/(3 h^3) = k.
    const double jump = std::cbrt(1e-19 * s.r_star() / (3.0 * 5.0));
    s.at = {0.98 * deepest / 5.0, 1.02 * deepest / 5.0, 0.5 * jump, 3.0 * jump};
    s.retract = {true, true, false, false};
    const std::vector<double> f = predict(w, s);
    REQUIRE(f[0] == Approx(-0.98 * deepest).epsilon(1e-9));
    REQUIRE(std::abs(f[1]) < 1e-6 * deepest);
    REQUIRE(f[2] == Approx(-5.0 * 0.5 * jump).epsilon(1e-9));
    REQUIRE(f[3] ==
            Approx(-1e-19 * s.r_star() / (6.0 * std::pow(s.at[3] + f[3] / 5.0, 2))).epsilon(1e-6));
}
