// SPDX-License-Identifier: MIT
#include "contact/rolling_sds.hpp"

#include "tests/contact/rolling_pair.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace si = boost::units::si;
using contact::RollingInput;
using contact::RollingSds;
using contact::RollingState;
using contact::Vec3;
using rolling_pair::spheres;

namespace {

// 1 kN/m, 1e-4 kg/s, 0.2.
RollingSds law() {
    return RollingSds::from(1e3 * si::newtons_per_meter, 1e-4 * si::newtons_per_meter * si::seconds,
                            0.2);
}

}  // namespace

// R* = 5e-5 m, 100 rad/s about y for 1e-7 s: v_r = 5e-3 m/s, xi = 5e-10 m, f = 0.5e-6 + 0.5e-6 N;
// torque 5e-11 N m against the spin. 1e-12: algebra.
TEST_CASE("sds: the torque is R* times spring and dashpot of the rolling displacement",
          "[contact][rolling_sds][exact]") {
    RollingInput in = spheres(1e-4, 1e-4);
    in.spin_i = {0.0, 60.0, 0.0};
    in.spin_j = {0.0, -40.0, 0.0};
    const RollingState state = law().step(in);
    REQUIRE(state.torque_on_i.y == Approx(-5e-11).epsilon(1e-12));
    REQUIRE(state.torque_on_j.y == Approx(5e-11).epsilon(1e-12));
    REQUIRE(contact::norm(state.spring) == Approx(5e-10).epsilon(1e-12));
    REQUIRE(state.stored == Approx(0.5 * 1e3 * 25e-20).epsilon(1e-12));
    REQUIRE(state.dissipated == Approx(1e-4 * 25e-6 * 1e-7).epsilon(1e-12));
}

// LAMMPS manual, rolling sds: |f| = mu_r N, spring set back to (mu_r N - gamma v_r)/k. N = 10 uN
// gives f = 2 uN; v_r = 5e-3 m/s, gamma v_r = 0.5 uN, hence 1.5e-9 m. 1e-12: algebra.
TEST_CASE("sds: a sliding contact holds mu_r N R* and sets its spring back as LAMMPS does",
          "[contact][rolling_sds][exact]") {
    RollingInput in = spheres(1e-4, 1e-4);
    in.cap_force = 1e-5;
    in.spin_i = {0.0, 100.0, 0.0};
    in.spring = {1e-8, 0.0, 0.0};  // along v_r = R* omega x n
    const RollingState state = law().step(in);
    REQUIRE(state.torque_on_i.y == Approx(-2e-6 * 5e-5).epsilon(1e-12));
    REQUIRE(state.spring.x == Approx(1.5e-9).epsilon(1e-12));
}

TEST_CASE("sds: twisting and turning together meet no resistance",
          "[contact][rolling_sds][limit]") {
    RollingInput in = spheres(1e-4, 3e-4);
    in.spin_i = {70.0, -30.0, 500.0};
    in.spin_j = {70.0, -30.0, -900.0};
    REQUIRE(contact::norm(law().step(in).torque_on_i) == 0.0);
}

// Work done on the contact = change of stored energy + dissipated, but for (1/2) k |v_r dt|^2 in
// each step, so the defect halves with the step. The rocking sticks and slides.
TEST_CASE("sds: the ledger of a rocking pair closes to first order in the step",
          "[contact][rolling_sds][energy][order]") {
    const auto defect = [](int steps) {
        RollingInput in = spheres(1e-4, 1e-4);
        in.cap_force = 5e-6;
        in.dt = 1e-4 / steps;
        double work = 0.0, dissipated = 0.0, stored = 0.0;
        for (int k = 0; k < steps; ++k) {
            const double phase = 4.0 * std::numbers::pi * (k + 0.5) / steps;
            in.spin_i = {5.0 * std::cos(phase), 4.0 * std::sin(phase), 0.0};
            const RollingState state = law().step(in);
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
