// SPDX-License-Identifier: MIT
// The motion of rigid bodies alone: free tops, one sphere as a body, impacts of dumbbells on a plate.
#include "dem_min/bodies.hpp"

#include "dem_min/clump.hpp"
#include "scaling/errors.hpp"
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>
#include <gsl/gsl_sf_elljac.h>

#include <cmath>
#include <numbers>

using contact::cross;
using contact::dot;
using contact::norm;
using dem_min::Birth;
using dem_min::Body;
using dem_min::Clump;
using dem_min::free_turn;
using dem_min::Quaternion;
using dem_min::Simulation;
using dem_min::turned;
using dem_min::turned_back;
using dem_min::Vec3;

namespace {

constexpr double pi = std::numbers::pi;

// `a` turned by `angle` about the unit vector `axis` (Rodrigues).
Vec3 rodrigues(Vec3 a, Vec3 axis, double angle) {
    return std::cos(angle) * a + std::sin(angle) * cross(axis, a) +
           (1.0 - std::cos(angle)) * dot(axis, a) * axis;
}

double energy(const Quaternion& q, Vec3 momentum, Vec3 inverse) {
    const Vec3 l = turned_back(q, momentum);
    return 0.5 * (inverse.x * l.x * l.x + inverse.y * l.y * l.y + inverse.z * l.z * l.z);
}

// A simulation without grains, gravity or walls.
Simulation empty(const samples::Powder& p, double step) {
    samples::System s{.between_grains = samples::laws(p),
                      .at_walls = samples::laws(p),
                      .walls = {},
                      .grains = {},
                      .gravity = 0.0,
                      .time_step = step,
                      .skin = 0.1 * p.diameter,
                      .lost_below = -1e3 * p.diameter};
    return samples::simulation(s);
}

samples::Powder smooth() {
    return {.work_of_adhesion = 0.0,
            .restitution = 1.0,
            .sliding_friction = 0.0,
            .rolling_friction = 0.0};
}

// Overlap of a Hertz impact of mass m at speed v on a plate, and how long it lasts (Johnson 1985, section 11.4).
struct Hertz {
    double overlap, duration;  // m, s
    Hertz(double m, double v, double radius, double e_star)
        : overlap(std::pow(15.0 * m * v * v / (16.0 * std::sqrt(radius) * e_star), 0.4)),
          duration(2.9432 * overlap / v) {}
};

}  // namespace

// The axis goes round L at |L|/I_1, while the body turns about its axis at L_3 (1/I_3 - 1/I_1) (Landau & Lifshitz, Mechanics,
// section 33). 3000 steps of 0.01 rad; each turn is exact to 1e-15.
TEST_CASE("a symmetric top without torque precesses as the closed form says",
          "[dem_min][bodies][exact]") {
    const double i1 = 3.0, i3 = GENERATE(0.7, 3.0, 5.5);  // long, round, flat
    const Vec3 inverse{1.0 / i1, 1.0 / i1, 1.0 / i3};
    const Quaternion start = dem_min::turn_to({0.6, -0.48, 0.64});
    const Vec3 momentum{0.3, 1.1, -0.9};
    const double dt = 0.01, rate = norm(momentum) / i1;
    const Vec3 towards = 1.0 / norm(momentum) * momentum;
    const double own = turned_back(start, momentum).z * (1.0 / i3 - 1.0 / i1);
    Quaternion q = start;
    for (int k = 0; k < 3000; ++k) q = free_turn(q, momentum, inverse, dt);
    const double t = 3000 * dt;
    for (const Vec3 point : {Vec3{0.0, 0.0, 1.0}, Vec3{1.0, 0.0, 0.0}}) {
        const Vec3 expected =
            rodrigues(turned(start, rodrigues(point, {0.0, 0.0, 1.0}, own * t)), towards, rate * t);
        REQUIRE(norm(turned(q, point) - expected) < 1e-11);
    }
}

// w_1 = A_1 cn, w_2 = A_2 sn, w_3 = A_3 dn (Landau & Lifshitz, Mechanics, section 37, for 2 E I_2 < L^2).
TEST_CASE("an asymmetric top without torque follows the elliptic functions, to second order",
          "[dem_min][bodies][order]") {
    const double i1 = 1.0, i2 = 1.7, i3 = 2.4;
    const double w1 = 0.5, w3 = 1.3;  // at t = 0, where w2 = 0
    const double e2 = i1 * w1 * w1 + i3 * w3 * w3, l2 = i1 * i1 * w1 * w1 + i3 * i3 * w3 * w3;
    const Vec3 momentum{i1 * w1, 0.0, i3 * w3};
    const double t = 6.0;
    const double tau = t * std::sqrt((i3 - i2) * (l2 - e2 * i1) / (i1 * i2 * i3));
    const double m = (i2 - i1) * (e2 * i3 - l2) / ((i3 - i2) * (l2 - e2 * i1));
    double sn = 0.0, cn = 0.0, dn = 0.0;
    gsl_sf_elljac_e(tau, m, &sn, &cn, &dn);
    const Vec3 expected{std::sqrt((e2 * i3 - l2) / (i1 * (i3 - i1))) * cn,
                        std::sqrt((e2 * i3 - l2) / (i2 * (i3 - i2))) * sn,
                        std::sqrt((l2 - e2 * i1) / (i3 * (i3 - i1))) * dn};
    // Which of the moments stands first must not matter.
    const int turn = GENERATE(0, 1, 2);
    const auto cycled = [turn](Vec3 a) {
        return turn == 0 ? a : turn == 1 ? Vec3{a.y, a.z, a.x} : Vec3{a.z, a.x, a.y};
    };
    const Vec3 inverse = cycled({1.0 / i1, 1.0 / i2, 1.0 / i3});
    const auto error = [&](int steps, double& worst) {
        Quaternion q;
        const double before = energy(q, cycled(momentum), inverse);
        for (int k = 0; k < steps; ++k) {
            q = free_turn(q, cycled(momentum), inverse, t / steps);
            worst = std::max(worst, std::abs(energy(q, cycled(momentum), inverse) / before - 1.0));
        }
        const Vec3 l = turned_back(q, cycled(momentum));
        const Vec3 w{inverse.x * l.x, inverse.y * l.y, inverse.z * l.z};
        return norm(w - cycled(expected));
    };
    double coarse_energy = 0.0, fine_energy = 0.0;
    const double coarse = error(200, coarse_energy), fine = error(400, fine_energy);
    CAPTURE(coarse, fine, coarse_energy, fine_energy);
    REQUIRE(fine < 1e-3);
    REQUIRE(std::log2(coarse / fine) == Approx(2.0).margin(0.1));
    REQUIRE(std::log2(coarse_energy / fine_energy) == Approx(2.0).margin(0.1));
}

TEST_CASE("the shortest turn to an axis takes z there", "[dem_min][bodies]") {
    for (const Vec3 axis : {Vec3{0.0, 0.0, 1.0}, Vec3{0.0, 0.0, -1.0}, Vec3{0.6, 0.0, -0.8},
                            Vec3{0.36, -0.48, 0.8}, Vec3{0.0, 1.0, 0.0}}) {
        const Quaternion q = dem_min::turn_to(axis);
        REQUIRE(norm(turned(q, {0.0, 0.0, 1.0}) - axis) < 1e-15);
        REQUIRE(norm(turned_back(q, axis) - Vec3{0.0, 0.0, 1.0}) < 1e-15);
        REQUIRE(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z == Approx(1.0).epsilon(1e-15));
    }
}

// Friction, rolling resistance, dashpots, adhesion, a plate and another sphere: what is left between body and sphere is the rounding of
// I L against L/I, multiplied by some collisions.
TEST_CASE("a clump of one sphere moves as that sphere", "[dem_min][bodies][limit]") {
    const samples::Powder p = GENERATE(samples::dry(), samples::sticky());
    const double d = p.diameter, speed = 0.05;
    Simulation spheres = empty(p, samples::recommended_step(p, speed));
    spheres.walls = {dem_min::Plane{{}, {0.0, 0.0, 1.0}}};
    spheres.settings.gravity = {0.0, 0.0, -p.gravity};
    Simulation bodies = spheres;
    const Vec3 place{0.0, 0.0, 0.6 * d}, other{0.3 * d, 0.1 * d, 1.7 * d};
    const Vec3 v{0.4 * speed, 0.0, -speed}, w{30.0, -200.0, 70.0};
    insert(spheres, {place, v, w, 0.5 * d, p.density});
    insert(spheres, {other, {}, {}, 0.5 * d, p.density});
    const Clump one = dem_min::row_of_spheres(1, 0.5 * d, 0.0, p.density);
    insert(bodies, one, {place, dem_min::turn_to({0.6, 0.0, 0.8}), v, w});
    insert(bodies, one, {other, {}, {}, {}});
    std::size_t most = 0;
    for (int k = 0; k < 2000; ++k) {
        step(spheres), step(bodies);
        most = std::max(most, pair_count(bodies) + wall_contact_count(bodies));
        REQUIRE(pair_count(spheres) == pair_count(bodies));
    }
    REQUIRE(most >= 2);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(norm(spheres.grains.position(k) - bodies.grains.position(k)) < 1e-9 * d);
        CHECK(norm(spheres.grains.velocity(k) - bodies.grains.velocity(k)) < 1e-9 * speed);
        CHECK(norm(spheres.grains.spin(k) - bodies.grains.spin(k)) < 1e-9 * speed / d);
    }
    CHECK(kinetic_energy(bodies) == Approx(kinetic_energy(spheres)).epsilon(1e-9));
}

// Lying flat it falls on both ends at once: two equal springs, each with half of the mass.
TEST_CASE("a dumbbell that falls flat on a plate bounces as its half alone would",
          "[dem_min][bodies][exact]") {
    const samples::Powder p = smooth();
    const double r = 0.5 * p.diameter, speed = 0.01;
    const Clump dumbbell = dem_min::row_of_spheres(2, r, 2.0 * r, p.density);
    const Hertz half(0.5 * dumbbell.mass, speed, r, p.e_star);
    Simulation s = empty(p, half.duration / 400.0);
    s.walls = {dem_min::Plane{{}, {0.0, 0.0, 1.0}}};
    insert(s, dumbbell,
           {{0.0, 0.0, r + 1e-9}, dem_min::turn_to({1.0, 0.0, 0.0}), {0.0, 0.0, -speed}, {}});
    double deepest = 0.0;
    int touched = 0;
    for (int k = 0; k < 600; ++k) {
        step(s);
        touched += wall_contact_count(s) == 2;
        REQUIRE(wall_contact_count(s) % 2 == 0);
        deepest = std::max(deepest, r - s.bodies[0].centre.z);
    }
    // The scheme is of second order: (pi/400)^2 of the way, some 1e-4; its clock has a step at either end.
    REQUIRE(deepest == Approx(half.overlap).epsilon(1e-3));
    REQUIRE(touched == Approx(400).margin(2.5));
    REQUIRE(s.bodies[0].velocity.z == Approx(speed).epsilon(1e-3));
    REQUIRE(norm(s.bodies[0].spin()) < 1e-9 * speed / r);
}

// On one end, hard and smooth: an impulse J at the arm a, with 1/m_eff = 1/m + (a x n)^2/I, that turns the speed of that end round.
// While it lasts the rod turns by a share (overlap/length) of its arm; 50 times stiffer grains bring that to 1e-3.
TEST_CASE("a dumbbell that falls on one end is thrown round by the impulse of rigid bodies",
          "[dem_min][bodies][exact]") {
    samples::Powder p = smooth();
    p.e_star *= 1e4;
    const double r = 0.5 * p.diameter, speed = 0.01;
    const Clump dumbbell = dem_min::row_of_spheres(2, r, 2.0 * r, p.density);
    const double slope = 0.6, flat = 0.8;  // sine and cosine of the axis over the plate
    const double arm = r * flat;           // horizontal, from centre to contact
    const double m_eff = 1.0 / (1.0 / dumbbell.mass + arm * arm / dumbbell.inertia.x);
    const Hertz impact(m_eff, speed, r, p.e_star);
    Simulation s = empty(p, impact.duration / 200.0);
    s.walls = {dem_min::Plane{{}, {0.0, 0.0, 1.0}}};
    insert(s, dumbbell,
           {{0.0, 0.0, r + slope * r + 1e-10},
            dem_min::turn_to({flat, 0.0, slope}),
            {0.0, 0.0, -speed},
            {}});
    for (int k = 0; k < 300; ++k) step(s);
    REQUIRE(wall_contact_count(s) == 0);
    const double impulse = 2.0 * m_eff * speed;
    const Body& body = s.bodies[0];
    REQUIRE(body.velocity.z == Approx(impulse / dumbbell.mass - speed).epsilon(2e-3));
    // The lower end is at -arm: a push up there turns the body about +y.
    REQUIRE(body.spin().y == Approx(impulse * arm / dumbbell.inertia.x).epsilon(2e-3));
    REQUIRE(kinetic_energy(s) == Approx(0.5 * dumbbell.mass * speed * speed).epsilon(1e-4));
}

TEST_CASE("a body without balls or mass, or among tiles that may sleep, is refused",
          "[dem_min][bodies][domain]") {
    using Catch::Contains;
    const samples::Powder p = samples::dry();
    Simulation s = empty(p, 1e-6);
    Clump clump = dem_min::row_of_spheres(2, 5e-5, 5e-5, p.density);
    CHECK_THROWS_WITH(insert(s, Clump{{}, clump.mass, clump.inertia}, {}), Contains("clump.balls"));
    CHECK_THROWS_WITH(insert(s, Clump{clump.balls, 0.0, clump.inertia}, {}),
                      Contains("clump.mass"));
    CHECK_THROWS_WITH(insert(s, Clump{clump.balls, clump.mass, {}}, {}), Contains("clump.inertia"));
    REQUIRE(s.grains.count() == 0);
    insert(s, clump, {});
    s.settings.sleep_speed = 1e-3;
    CHECK_THROWS_AS(step(s), scaling::InvalidParameter);
}
