// SPDX-License-Identifier: MIT
// The generator's falling grain against closed forms.
#include "tests/prove/worlds.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace prove;
using std::numbers::pi;

TEST_CASE("prove: without air a grain falls by a parabola and rises to e^2 of its height",
          "[prove]") {
    Setup s = bead(Rig::drop, {Channel::z});
    s.height = 0.5;
    const double touch = std::sqrt(2.0 * s.height / s.gravity), e = 0.7;
    World w;
    w.restitution = e;
    s.at = evenly(0.0, 0.99 * touch, 20);
    const std::vector<double> z = predict(w, s);
    for (std::size_t k = 0; k < s.at.size(); ++k)
        REQUIRE(z[k] == Approx(0.5 - 0.5 * s.gravity * s.at[k] * s.at[k]).margin(1e-12));
    // The contact takes some 15 us and as much time from the rise: 1e-4 of the height.
    s.at = {touch * (1.0 + e)};
    REQUIRE(predict(w, s)[0] == Approx(e * e * s.height).epsilon(2e-4));
}

TEST_CASE("prove: a small grain in a thick gas sinks at Stokes' speed, corrected", "[prove]") {
    Setup s = bead(Rig::drop, {Channel::z});
    s.diameter = 30e-6, s.height = 0.05;
    s.fluid_density = 1.2, s.fluid_viscosity = 1.8e-5;
    World w;
    w.drag = 1.0;
    s.at = {0.2, 0.3};
    const std::vector<double> z = predict(w, s);
    const double speed = (z[0] - z[1]) / 0.1;
    const double re = 1.2 * speed * s.diameter / 1.8e-5;
    // No buoyancy in it: the weight is carried by 3 pi eta d v (1 + 0.15 Re^0.687).
    const double stokes = s.density * s.gravity * s.diameter * s.diameter / (18.0 * 1.8e-5);
    REQUIRE(speed == Approx(stokes / (1.0 + 0.15 * std::pow(re, 0.687))).epsilon(1e-6));
}

TEST_CASE("prove: a large light ball sinks where 0.44 of the dynamic pressure carries it",
          "[prove]") {
    Setup s = bead(Rig::drop, {Channel::z});
    s.diameter = 0.1, s.density = 20.0, s.height = 100.0;
    s.fluid_density = 1.2, s.fluid_viscosity = 1.8e-5;
    World w;
    w.drag = 1.0;
    s.at = {6.0, 7.0};
    const std::vector<double> z = predict(w, s);
    const double terminal =
        std::sqrt(s.mass() * s.gravity / (0.5 * 1.2 * 0.44 * pi * s.radius() * s.radius()));
    REQUIRE(z[0] - z[1] == Approx(terminal).epsilon(1e-6));
}

TEST_CASE("prove: buoyancy takes the fluid's share of the weight; a tilted plate turns it",
          "[prove]") {
    Setup s = bead(Rig::drop, {Channel::z, Channel::x});
    s.density = 50.0, s.fluid_density = 1.2, s.height = 1.0;
    World w;
    w.buoyancy = 1.0;
    w.tilt_angle = 0.1, w.tilt_azimuth = 0.6;
    s.at = {0.3};
    const std::vector<double> y = predict(w, s);
    const double fallen = 0.5 * s.gravity * (1.0 - 1.2 / 50.0) * 0.09;
    REQUIRE(y[0] == Approx(1.0 - fallen * std::cos(0.1)).epsilon(1e-12));
    REQUIRE(y[1] == Approx(fallen * std::sin(0.1) * std::cos(0.6)).epsilon(1e-12));
}

TEST_CASE("prove: a plate that comes up at V throws a grain back at e v + (1 + e) V", "[prove]") {
    Setup s = bead(Rig::drop, {Channel::z});
    s.height = 0.2;
    World w;
    w.restitution = 0.5, w.amplitude = 1e-6, w.frequency = 20.0;
    const double touch = std::sqrt(2.0 * s.height / s.gravity);
    // Upward fastest just at the touch.
    w.phase = -2.0 * pi * w.frequency * touch;
    const double v = s.gravity * touch, lift = 2.0 * pi * w.frequency * w.amplitude;
    const double away = 0.5 * v + 1.5 * lift;
    s.at = {touch + away / s.gravity};
    REQUIRE(predict(w, s)[0] == Approx(0.5 * away * away / s.gravity).epsilon(2e-4));
    World still = w;
    still.amplitude = 0.0;
    // 1.5 V is seen: 4e-4 of the height, above the 15 us of a contact.
    s.at = {touch + 0.5 * v / s.gravity};
    REQUIRE(predict(w, s)[0] - predict(still, s)[0] ==
            Approx(0.5 * (away * away - 0.25 * v * v) / s.gravity).epsilon(0.02));
}

TEST_CASE("prove: an elastic grain with adhesion sticks below the sticking speed and not above",
          "[prove]") {
    Setup s = bead(Rig::drop, {Channel::z});
    s.diameter = 0.2e-3, s.youngs_modulus = 5e6, s.poisson_ratio = 0.48;
    World w;
    w.work_of_adhesion = 0.1;
    // 7.0922 (w^5 R^4/E*^2)^(1/3) is the work from touch to tear-off (docs/laws/jkr.md; Thornton & Ning 1998).
    const double work =
        7.0922 * std::cbrt(std::pow(0.1, 5) * std::pow(s.radius(), 4) / (s.e_star() * s.e_star()));
    const double sticking = 0.5 * (2.0 * work / s.mass()) / s.gravity;  // height of that speed
    for (const double share : {0.9, 1.1}) {
        s.height = share * sticking;
        const double touch = std::sqrt(2.0 * s.height / s.gravity);
        s.at = evenly(touch, 2.0 * touch, 50);
        const std::vector<double> z = predict(w, s);
        const double highest = *std::max_element(z.begin() + 5, z.end());
        if (share < 1.0) REQUIRE(highest < 1e-3 * s.height);
        // What is left of the energy lifts it by 0.1 of the height at tear-off.
        if (share > 1.0) REQUIRE(highest == Approx(0.1 / 1.1 * s.height).epsilon(0.05));
    }
}

TEST_CASE("prove: a bridge takes from a rebound the work of its attraction up to rupture",
          "[prove]") {
    Setup s = bead(Rig::drop, {Channel::z});
    s.diameter = 1e-3, s.height = 0.05;
    World w;
    w.restitution = 0.8, w.surface_tension = 0.02, w.liquid_volume = 1e-13;
    const double r = s.radius(), gap = std::cbrt(w.liquid_volume);
    const double c = w.liquid_volume / (pi * r);
    const double work = 4.0 * pi * 0.02 * r * (gap - std::sqrt(gap * gap + c) + std::sqrt(c));
    const double touch = std::sqrt(2.0 * s.height / s.gravity);
    s.at = evenly(touch * 1.01, touch * (1.0 + 2.0 * 0.8 * 0.97), 4000);
    const std::vector<double> z = predict(w, s);
    const double highest = *std::max_element(z.begin(), z.end());
    REQUIRE(highest == Approx(0.64 * s.height - work / (s.mass() * s.gravity)).epsilon(1e-4));
}

TEST_CASE("prove: instruments scale, shift and stretch what is true", "[prove]") {
    Setup s = bead(Rig::drop, {Channel::z});
    s.height = 1.0;
    World w;
    w.scale[0] = 1.02, w.offset[0] = 3e-3, w.time_factor = 1.1;
    s.at = {0.22};
    REQUIRE(predict(w, s)[0] ==
            Approx(1.02 * (1.0 - 0.5 * s.gravity * 0.04) + 3e-3).epsilon(1e-12));
}
