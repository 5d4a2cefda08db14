// SPDX-License-Identifier: MIT
#include "contact/mindlin.hpp"

#include "contact/effective.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

namespace si = boost::units::si;
using contact::Mindlin;
using contact::TangentialInput;
using contact::TangentialState;
using contact::Vec3;

namespace {

constexpr double unlimited = 1e9;  // N, a cap that is never reached

// A contact of radius 2 um between grains of 1 ug, at rest; the tests change what they are about.
TangentialInput at_rest() {
    return {.spring = {},
            .previous_radius = 2e-6,
            .contact_radius = 2e-6,
            .n = {0.0, 0.0, 1.0},
            .slip_velocity = {},
            .cap_force = unlimited,
            .damping_factor = 0.0,
            .m_star = 1e-9,
            .dt = 1e-7};
}

TangentialInput after(TangentialInput in, const TangentialState& state) {
    in.spring = state.spring;
    in.previous_radius = in.contact_radius;
    return in;
}

}  // namespace

// k_t = 8 G* a = 8 1e9 Pa 2e-6 m = 16 kN/m; 5 nm, in ten steps at 5 mm/s: 80 uN. 1e-13: ten sums.
TEST_CASE("mindlin: a stuck contact answers a displacement with 8 G* a",
          "[contact][mindlin][exact]") {
    const Mindlin law = Mindlin::from(1e9 * si::pascals, 0.5);
    TangentialInput in = at_rest();
    in.slip_velocity = {3e-3, 4e-3, 0.0};
    TangentialState state{};
    for (int k = 0; k < 10; ++k) {
        state = law.step(in);
        in = after(in, state);
    }
    REQUIRE(state.force_on_j.x == Approx(-48e-6).epsilon(1e-13));
    REQUIRE(state.force_on_j.y == Approx(-64e-6).epsilon(1e-13));
    REQUIRE(state.stored == Approx(0.5 * 80e-6 * 5e-9).epsilon(1e-13));
}

// contact/yield.hpp: what is true of a contact that sticks does not take the slider's root; one that slides is told.
TEST_CASE(
    "mindlin: a stuck slider changes nothing while the contact sticks, and tells where it does not",
    "[contact][mindlin]") {
    const Mindlin law = Mindlin::from(1e9 * si::pascals, 0.5);
    TangentialInput in = at_rest();
    in.damping_factor = 0.3;
    in.slip_velocity = {3e-3, 4e-3, 0.0};
    in.cap_force = 17e-6;  // N; the limit is half of it, the first step's spring pulls with 8 uN
    contact::StuckSlider stuck;
    TangentialState state = law.step(in, stuck);
    const double whole = contact::norm(state.force_on_j);  // N, with the dashpot
    REQUIRE(stuck.slid == 1.0);
    REQUIRE(whole > 0.5 * in.cap_force);
    REQUIRE(contact::norm(law.step(in).force_on_j) == Approx(0.5 * in.cap_force).epsilon(1e-14));
    in.cap_force = 2.0001 * whole;
    contact::StuckSlider still_stuck;
    state = law.step(in, still_stuck);
    REQUIRE(still_stuck.slid == 0.0);
    REQUIRE(state.force_on_j == law.step(in).force_on_j);
    REQUIRE(state.spring == law.step(in).spring);
}

// Mindlin (1949): tangential over normal stiffness is 2 (1 - nu)/(2 - nu) for like spheres.
TEST_CASE("mindlin: k_t/k_n is 2 (1 - nu)/(2 - nu)", "[contact][mindlin][exact]") {
    const double nu = GENERATE(0.0, 0.3, 0.5);
    const contact::Material m{2e9 * si::pascals, nu, 1e3 * si::kilograms_per_cubic_meter};
    const Mindlin law = Mindlin::from(contact::g_star(m, m), 0.5);
    TangentialInput in = at_rest();
    in.slip_velocity = {1e-2, 0.0, 0.0};
    const double tangential = -law.step(in).force_on_j.x / (1e-2 * in.dt);
    const double normal = 2.0 * contact::e_star(m, m).value() * in.contact_radius;  // Hertz, dF/dd
    REQUIRE(tangential / normal == Approx(2.0 * (1.0 - nu) / (2.0 - nu)).epsilon(1e-13));
}

// mu N = 0.5 40 uN. 1e-14: algebra.
TEST_CASE("mindlin: a contact that slides holds mu N against the slip, whatever its dashpot",
          "[contact][mindlin][exact]") {
    const Mindlin law{1e9, 0.5};
    TangentialInput in = at_rest();
    in.damping_factor = GENERATE(0.0, 1.0, 50.0);
    in.cap_force = 40e-6;
    in.slip_velocity = {0.3, -0.4, 0.0};
    TangentialState state{};
    for (int k = 0; k < 3; ++k) {
        state = law.step(in);
        in = after(in, state);
    }
    REQUIRE(state.force_on_j.x == Approx(-12e-6).epsilon(1e-14));
    REQUIRE(state.force_on_j.y == Approx(16e-6).epsilon(1e-14));
    REQUIRE(contact::norm(16e3 * state.spring) == Approx(20e-6).epsilon(1e-14));
}

// mu N |v_t| dt, once the spring no longer changes.
TEST_CASE("mindlin: steady sliding costs friction times path", "[contact][mindlin][energy]") {
    const Mindlin law{1e9, 0.5};
    TangentialInput in = at_rest();
    in.cap_force = 40e-6;
    in.damping_factor = 1.0;
    in.slip_velocity = {0.3, -0.4, 0.0};
    in = after(in, law.step(in));
    REQUIRE(law.step(in).dissipated == Approx(20e-6 * 0.5 * in.dt).epsilon(1e-12));
}

// c_t = factor sqrt(8 G* a m*) = 0.5 sqrt(16e3 1e-9) = 2 mN s/m; in a step so short that the spring
// is nothing: 1e-9.
TEST_CASE("mindlin: the dashpot of a stuck contact adds c_t v_t", "[contact][mindlin][exact]") {
    const Mindlin law{1e9, 0.5};
    TangentialInput in = at_rest();
    in.damping_factor = 0.5;
    in.slip_velocity = {0.02, 0.0, 0.0};
    in.dt = 1e-20;
    REQUIRE(law.step(in).force_on_j.x == Approx(-40e-6).epsilon(1e-9));
    REQUIRE(law.step(in).dissipated == Approx(40e-6 * 0.02 * in.dt).epsilon(1e-9));
}

// Half the radius, half the spring, a quarter of the force, an eighth of the energy; by hand.
TEST_CASE("mindlin: a shrinking contact lets go of its spring in proportion to its radius",
          "[contact][mindlin][exact]") {
    const Mindlin law{1e9, 0.5};
    TangentialInput in = at_rest();
    in.spring = {4e-9, 0.0, 0.0};
    in.contact_radius = 1e-6;
    const TangentialState state = law.step(in);
    REQUIRE(state.spring.x == Approx(2e-9).epsilon(1e-15));
    REQUIRE(state.force_on_j.x == Approx(-16e-6).epsilon(1e-14));
    REQUIRE(state.stored == Approx(0.125 * 0.5 * 16e3 * 16e-18).epsilon(1e-14));
    REQUIRE(state.dissipated == Approx(0.875 * 0.5 * 16e3 * 16e-18).epsilon(1e-14));
}

// Twice the radius, same spring: stored energy doubles, and the ledger hears of it.
TEST_CASE("mindlin: what a growing contact adds to a loaded spring stands in the ledger",
          "[contact][mindlin][energy]") {
    const Mindlin law{1e9, 0.5};
    TangentialInput in = at_rest();
    in.spring = {4e-9, 0.0, 0.0};
    in.contact_radius = 4e-6;
    const TangentialState state = law.step(in);
    REQUIRE(state.spring.x == 4e-9);
    REQUIRE(state.dissipated == Approx(-0.5 * 16e3 * 16e-18).epsilon(1e-14));
}

// The spring follows the turning pair: same length, in the new plane.
TEST_CASE("mindlin: friction stays in the contact plane as the pair turns",
          "[contact][mindlin][exact]") {
    const Mindlin law{1e9, 0.5};
    TangentialInput in = at_rest();
    in.spring = {3e-9, 4e-9, 0.0};
    in.n = {0.01, 0.0, std::sqrt(1.0 - 1e-4)};
    const TangentialState state = law.step(in);
    REQUIRE(contact::dot(state.force_on_j, in.n) == Approx(0.0).margin(1e-15 * 80e-6));
    REQUIRE(contact::norm(state.spring) == Approx(5e-9).epsilon(1e-15));
}

// The dashpot alone would exceed the limit by far. The force is mu N, the spring is drawn along the
// slip and holds less than the work done.
TEST_CASE("mindlin: at a grazing impact the dashpot does not wind up the spring",
          "[contact][mindlin][energy]") {
    const Mindlin law{1e9, 0.5};
    TangentialInput in = at_rest();
    in.damping_factor = 1.8;
    in.cap_force = 1e-9;
    in.slip_velocity = {3.0, 0.0, 0.0};
    const TangentialState state = law.step(in);
    REQUIRE(state.force_on_j.x == Approx(-0.5e-9).epsilon(1e-14));
    REQUIRE(state.spring.x > 0.0);
    REQUIRE(state.stored <= 0.5e-9 * 3.0 * in.dt);
}

// What is guaranteed, whatever slip and cap do. Round-off: 1e-15 of 50 uN over 10 nm.
TEST_CASE("mindlin: at a constant or shrinking radius no step gives energy",
          "[contact][mindlin][energy]") {
    const Mindlin law{1e9, 0.5};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    TangentialInput in = at_rest();
    in.damping_factor = 0.7;
    for (int k = 0; k < 5000; ++k) {
        in.slip_velocity = {0.05 * uniform(random), 0.05 * uniform(random), 0.0};
        in.cap_force = 100e-6 * std::max(0.0, uniform(random) + 0.3);
        in.contact_radius *= 1.0 - 1e-4 * std::max(0.0, uniform(random));
        const TangentialState state = law.step(in);
        REQUIRE(state.dissipated >= -1e-15 * 50e-6 * 1e-8);
        REQUIRE(contact::norm(state.force_on_j) <= 0.5 * in.cap_force * (1.0 + 1e-15));
        in = after(in, state);
    }
}

// At a constant radius work done on the contact = change of stored energy + dissipated, but for
// (1/2) k |v dt|^2 in each step, so the defect halves with the step. The loop sticks and slides.
TEST_CASE("mindlin: the ledger of a loop closes to first order in the step",
          "[contact][mindlin][energy][order]") {
    const auto defect = [](int steps) {
        const Mindlin law{1e9, 0.5};
        TangentialInput in = at_rest();
        in.cap_force = 60e-6;
        in.damping_factor = 0.3;
        in.dt = 1e-4 / steps;
        double work = 0.0, dissipated = 0.0, stored = 0.0;
        for (int k = 0; k < steps; ++k) {
            const double phase = 2.0 * std::numbers::pi * (k + 0.5) / steps;
            in.slip_velocity = {4e-4 * std::cos(phase), 4e-4 * std::cos(2.0 * phase), 0.0};
            const TangentialState state = law.step(in);
            work -= in.dt * contact::dot(state.force_on_j, in.slip_velocity);
            dissipated += state.dissipated;
            stored = state.stored;
            in = after(in, state);
        }
        REQUIRE(work > 0.0);
        return (work - stored - dissipated) / work;
    };
    const double coarse = defect(1000), fine = defect(2000);
    REQUIRE(std::abs(fine) < 2e-3);
    REQUIRE(coarse / fine == Approx(2.0).epsilon(0.05));
}
