// SPDX-License-Identifier: MIT
// EDEM's Standard and RVD, which share a symbol and differ by a lever and a velocity.
#include "contact/no_rolling.hpp"
#include "contact/rolling_edem_standard.hpp"
#include "contact/rolling_rvd.hpp"
#include "tests/contact/rolling_pair.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using contact::RollingEdemStandard;
using contact::RollingInput;
using contact::RollingRvd;
using contact::RollingState;
using contact::Vec3;
using rolling_pair::at_wall;
using rolling_pair::spheres;

// mu_r N R_i = 0.2 1e-6 N 1e-4 m, and 2e-4 m for j; own spin. 1e-14: algebra.
TEST_CASE("standard: each grain is braked by mu_r N times its own radius",
          "[contact][rolling_edem_standard][exact]") {
    RollingInput in = spheres(1e-4, 2e-4);
    in.cap_force = 1e-6;
    in.spin_i = {0.0, 900.0, 1200.0};
    in.spin_j = {-500.0, 0.0, 0.0};
    const RollingState state = RollingEdemStandard::from(0.2).step(in);
    REQUIRE(state.torque_on_i.y == Approx(-0.6 * 2e-11).epsilon(1e-14));
    REQUIRE(state.torque_on_i.z == Approx(-0.8 * 2e-11).epsilon(1e-14));
    REQUIRE(state.torque_on_j.x == Approx(4e-11).epsilon(1e-14));
}

// mu_r N R* = 0.2 1e-6 N 7.5e-5 m against omega_j - omega_i = (-300, 400), twisting left out.
TEST_CASE("rvd: mu_r N R* against the relative rolling spin", "[contact][rolling_rvd][exact]") {
    RollingInput in = spheres(1e-4, 3e-4);
    in.cap_force = 1e-6;
    in.spin_i = {500.0, 0.0, 60.0};
    in.spin_j = {200.0, 400.0, -900.0};
    const RollingState state = RollingRvd::from(0.2).step(in);
    REQUIRE(state.torque_on_j.x == Approx(0.6 * 1.5e-11).epsilon(1e-14));
    REQUIRE(state.torque_on_j.y == Approx(-0.8 * 1.5e-11).epsilon(1e-14));
    REQUIRE(state.torque_on_j.z == 0.0);
    REQUIRE(state.torque_on_i == -state.torque_on_j);
}

// R = 2 R*: the same mu_r is twice the torque.
TEST_CASE("equal spheres rolling on each other feel twice the torque under Standard than under RVD",
          "[contact][rolling_edem_standard][rolling_rvd][exact]") {
    RollingInput in = spheres(1e-4, 1e-4);
    in.cap_force = 1e-6;
    in.spin_i = {300.0, 0.0, 0.0};
    in.spin_j = {-300.0, 0.0, 0.0};
    const RollingState standard = RollingEdemStandard{0.2}.step(in), rvd = RollingRvd{0.2}.step(in);
    REQUIRE(standard.torque_on_i.x == Approx(2.0 * rvd.torque_on_i.x).epsilon(1e-14));
    REQUIRE(standard.torque_on_j.x == Approx(2.0 * rvd.torque_on_j.x).epsilon(1e-14));
    REQUIRE(rvd.torque_on_i.x < 0.0);
}

TEST_CASE("at a wall Standard and RVD brake the grain alike",
          "[contact][rolling_edem_standard][rolling_rvd][exact]") {
    RollingInput in = at_wall(1e-4);
    in.cap_force = 1e-6;
    in.spin_i = {0.0, 300.0, 0.0};
    const RollingState standard = RollingEdemStandard{0.2}.step(in), rvd = RollingRvd{0.2}.step(in);
    REQUIRE(standard.torque_on_i.y == Approx(-2e-11).epsilon(1e-14));
    REQUIRE(rvd.torque_on_i.y == Approx(-2e-11).epsilon(1e-14));
    REQUIRE(contact::norm(standard.torque_on_j) == 0.0);
    REQUIRE(std::isfinite(standard.dissipated));
}

// Objectivity: the pair turns as one rigid body.
TEST_CASE("a rigidly turning pair is braked by Standard and not by RVD",
          "[contact][rolling_edem_standard][rolling_rvd][limit]") {
    RollingInput in = spheres(1e-4, 3e-4);
    in.spin_i = in.spin_j = {40.0, -70.0, 20.0};
    REQUIRE(contact::norm(RollingRvd{0.2}.step(in).torque_on_i) == 0.0);
    REQUIRE(contact::norm(RollingEdemStandard{0.2}.step(in).torque_on_i) > 0.0);
}

// Under a load that would turn it round in one step, the braked spin ends at zero, to 1e-13 of it.
TEST_CASE("no constant torque turns a spin round within a step",
          "[contact][rolling_edem_standard][rolling_rvd][exact]") {
    RollingInput in = GENERATE(spheres(1e-4, 3e-4), at_wall(1e-4));
    in.cap_force = 1e3;
    in.spin_i = {40.0, -70.0, 20.0};
    in.spin_j = in.inverse_inertia_j > 0.0 ? Vec3{-10.0, 5.0, 90.0} : Vec3{};
    const RollingState own = RollingEdemStandard{0.2}.step(in), pair = RollingRvd{0.2}.step(in);
    const auto after = [&](Vec3 spin, Vec3 torque, double inverse_inertia) {
        return spin + in.dt * inverse_inertia * torque;
    };
    const double margin = 1e-13 * 100.0;
    REQUIRE(contact::norm(after(in.spin_i, own.torque_on_i, in.inverse_inertia_i)) ==
            Approx(0.0).margin(margin));
    REQUIRE((in.inverse_inertia_j == 0.0 ||
             contact::norm(after(in.spin_j, own.torque_on_j, in.inverse_inertia_j)) < margin));
    const Vec3 relative = after(in.spin_j, pair.torque_on_j, in.inverse_inertia_j) -
                          after(in.spin_i, pair.torque_on_i, in.inverse_inertia_i);
    REQUIRE(contact::norm(contact::tangential_part(relative, in.n)) == Approx(0.0).margin(margin));
}

TEST_CASE("the loss of a constant torque is the energy that it takes from the spins",
          "[contact][rolling_edem_standard][rolling_rvd][energy]") {
    RollingInput in = GENERATE(spheres(1e-4, 3e-4), at_wall(1e-4));
    in.cap_force = GENERATE(1e-6, 1e3);  // brakes; stops
    in.spin_i = {40.0, -70.0, 20.0};
    in.spin_j = in.inverse_inertia_j > 0.0 ? Vec3{-10.0, 5.0, 90.0} : Vec3{};
    const double before = rolling_pair::spin_energy(in, {}, {});
    for (const RollingState& state :
         {RollingEdemStandard{0.2}.step(in), RollingRvd{0.2}.step(in)}) {
        const double after = rolling_pair::spin_energy(in, state.torque_on_i, state.torque_on_j);
        REQUIRE(state.dissipated > 0.0);
        REQUIRE(state.dissipated == Approx(before - after).epsilon(1e-9).margin(1e-14 * before));
    }
}

TEST_CASE("without spin or without load there is no torque, and nothing is not a number",
          "[contact][rolling_edem_standard][rolling_rvd][limit]") {
    RollingInput in = GENERATE(spheres(1e-4, 3e-4), at_wall(1e-4));
    in.cap_force = GENERATE(0.0, 1.0);
    in.spin_i = in.cap_force > 0.0 ? Vec3{} : Vec3{3.0, 0.0, 0.0};
    for (const RollingState& state :
         {RollingEdemStandard{0.2}.step(in), RollingRvd{0.2}.step(in)}) {
        REQUIRE(contact::norm(state.torque_on_i) == 0.0);
        REQUIRE(contact::norm(state.torque_on_j) == 0.0);
        REQUIRE(state.dissipated == 0.0);
    }
}

TEST_CASE("no rolling law, no torque", "[contact][no_rolling][exact]") {
    RollingInput in = spheres(1e-4, 3e-4);
    in.spin_i = {40.0, -70.0, 20.0};
    const RollingState state = contact::NoRolling{}.step(in);
    REQUIRE(contact::norm(state.torque_on_i) == 0.0);
    REQUIRE(contact::norm(state.torque_on_j) == 0.0);
    REQUIRE(state.stored + state.dissipated == 0.0);
}
