// SPDX-License-Identifier: MIT
#include "contact/coulomb.hpp"

#include "contact/effective.hpp"

#include <catch2/catch.hpp>

using contact::Coulomb;
using contact::TangentialInput;
using contact::TangentialState;
using contact::Vec3;

namespace {

TangentialInput sliding(Vec3 slip_velocity, double cap_force, double m_star) {
    return {.spring = {},
            .previous_radius = 0.0,
            .contact_radius = 0.0,
            .n = {0.0, 0.0, 1.0},
            .slip_velocity = slip_velocity,
            .cap_force = cap_force,
            .damping_factor = 0.0,
            .m_star = m_star,
            .dt = 1e-6};
}

// Two solid spheres, or one against a wall of infinite mass; velocities along x, spins along y.
struct Sphere {
    double mass, radius, velocity, spin;
    double inertia() const { return 0.4 * mass * radius * radius; }
    double energy() const {
        return 0.5 * mass * velocity * velocity + 0.5 * inertia() * spin * spin;
    }
};

// v_j - v_i - (R_i omega_i + R_j omega_j) x n along x, for n along z and spins along y.
double slip(const Sphere& i, const Sphere& j) {
    return j.velocity - i.velocity - (i.radius * i.spin + j.radius * j.spin);
}

// The impulse acts on j at -R_j n, its opposite on i at R_i n.
void push(Sphere& i, Sphere& j, double impulse) {
    i.velocity -= impulse / i.mass;
    j.velocity += impulse / j.mass;
    i.spin -= impulse * i.radius / i.inertia();
    j.spin -= impulse * j.radius / j.inertia();
}

}  // namespace

// 0.5 times 40 uN against a slip along (0.6, -0.8). 1e-14: algebra.
TEST_CASE("coulomb: a sliding contact holds mu N against the slip", "[contact][coulomb][exact]") {
    const TangentialState state = Coulomb::from(0.5).step(sliding({0.3, -0.4, 0.0}, 40e-6, 1e-6));
    REQUIRE(state.force_on_j.x == Approx(-12e-6).epsilon(1e-14));
    REQUIRE(state.force_on_j.y == Approx(16e-6).epsilon(1e-14));
    REQUIRE(state.spring == Vec3{});
    REQUIRE(state.stored == 0.0);
}

// Two free solid spheres, unlike in mass and size: after one step at full grip their surfaces are
// at rest on each other. Momentum and spin are written out here, without 2/7. 1e-12: algebra.
TEST_CASE("coulomb: friction stops the slip of two solid spheres and never turns it round",
          "[contact][coulomb][exact]") {
    Sphere i{3e-6, 1e-3, 0.2, 150.0}, j{1e-6, 0.7e-3, -0.1, -40.0};
    const double before = slip(i, j);
    const TangentialInput in = sliding({before, 0.0, 0.0}, 1e3, contact::m_star(i.mass, j.mass));
    push(i, j, Coulomb{0.5}.step(in).force_on_j.x * in.dt);
    REQUIRE(slip(i, j) == Approx(0.0).margin(1e-12 * std::abs(before)));
}

TEST_CASE("coulomb: the loss is the kinetic energy that friction takes from two solid spheres",
          "[contact][coulomb][energy]") {
    const double cap_force = GENERATE(1e-4, 1e3);  // slides on; is stopped
    Sphere i{3e-6, 1e-3, 0.2, 150.0}, j{1e-6, 0.7e-3, -0.1, -40.0};
    const double before = i.energy() + j.energy();
    const TangentialInput in =
        sliding({slip(i, j), 0.0, 0.0}, cap_force, contact::m_star(i.mass, j.mass));
    const TangentialState state = Coulomb{0.5}.step(in);
    push(i, j, state.force_on_j.x * in.dt);
    REQUIRE(state.dissipated ==
            Approx(before - i.energy() - j.energy()).epsilon(1e-9).margin(1e-14 * before));
}

TEST_CASE("coulomb: without slip there is no force", "[contact][coulomb][limit]") {
    const double cap_force = GENERATE(0.0, 40e-6);
    const TangentialState state = Coulomb{0.5}.step(sliding({}, cap_force, 1e-6));
    REQUIRE(contact::norm(state.force_on_j) == 0.0);
    REQUIRE(state.dissipated == 0.0);
}
