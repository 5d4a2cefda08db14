// SPDX-License-Identifier: MIT
#include "contact/capillary_bridge.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace si = boost::units::si;
using contact::CapillaryBridge;
using std::numbers::pi;

namespace {

constexpr double gamma_of_water = 0.072;  // N/m

CapillaryBridge bridge(double gamma, double volume, double angle) {
    return CapillaryBridge::from(gamma * si::newtons_per_meter, volume * si::cubic_meters, angle);
}

}  // namespace

// 1e-14: algebra in the last digits.
TEST_CASE("capillary bridge: closed it pulls with 4 pi gamma R* cos(theta), whatever its volume",
          "[contact][capillary_bridge][exact]") {
    const double r = 2e-4, volume = GENERATE(1e-16, 1e-13), angle = GENERATE(0.0, 0.4);
    const CapillaryBridge law = bridge(gamma_of_water, volume, angle);
    const double at_plate = 4.0 * pi * gamma_of_water * r * std::cos(angle);
    REQUIRE(law.closed(r) == Approx(at_plate).epsilon(1e-14));
    REQUIRE(law.across(r, 0.0) == law.closed(r));
    // Two equal spheres, R* = R/2: 2 pi gamma R.
    REQUIRE(law.closed(0.5 * r) == Approx(0.5 * at_plate).epsilon(1e-14));
    REQUIRE(law.acts());
    REQUIRE(!CapillaryBridge{}.acts());
}

// Rabinovich, Esayanur & Moudgil (2005) for two equal spheres, as printed, without the term of the wetted circle:
// F = 2 pi gamma R cos(theta)/(1 + h/(2 d)), d = (h/2)(-1 + sqrt(1 + 2 V/(pi R h^2))). 1e-10: 1 + x - 1 in theirs.
TEST_CASE("capillary bridge: across a gap between equal spheres it is the published force",
          "[contact][capillary_bridge][exact]") {
    const double r = 2e-4, volume = GENERATE(1e-16, 4e-15, 1e-13), angle = GENERATE(0.0, 0.4);
    const CapillaryBridge law = bridge(gamma_of_water, volume, angle);
    for (const double share : {0.01, 0.1, 0.5, 0.99}) {
        const double h = share * std::cbrt(volume);
        const double d = 0.5 * h * (-1.0 + std::sqrt(1.0 + 2.0 * volume / (pi * r * h * h)));
        const double published =
            2.0 * pi * gamma_of_water * r * std::cos(angle) / (1.0 + h / (2.0 * d));
        REQUIRE(law.across(0.5 * r, h) == Approx(published).epsilon(1e-10));
    }
}

// Lian, Thornton & Adams (1993). 1e-14: round-off of a cube root.
TEST_CASE("capillary bridge: it ruptures at (1 + theta/2) V^(1/3)",
          "[contact][capillary_bridge][exact]") {
    const double angle = GENERATE(0.0, 0.4), volume = 3e-15;
    const CapillaryBridge law = bridge(gamma_of_water, volume, angle);
    const double gap = (1.0 + angle / 2.0) * std::cbrt(volume);
    REQUIRE(law.rupture_gap == Approx(gap).epsilon(1e-14));
    REQUIRE(law.across(1e-4, 0.999 * gap) > 0.0);
    REQUIRE(law.across(1e-4, 1.001 * gap) == 0.0);
}

// Central difference, h^2/6 of the third derivative: 1e-7 of the closed force at a step of 1e-4 of the rupture gap.
TEST_CASE("capillary bridge: the pull is the slope of the work",
          "[contact][capillary_bridge][energy]") {
    const CapillaryBridge law = bridge(gamma_of_water, 3e-15, 0.3);
    const double r_star = 1e-4, step = 1e-4 * law.rupture_gap;
    REQUIRE(law.work(r_star, 0.0) == 0.0);
    for (const double share : {0.001, 0.02, 0.3, 0.9}) {
        const double h = share * law.rupture_gap;
        const double slope =
            (law.work(r_star, h + step) - law.work(r_star, h - step)) / (2.0 * step);
        REQUIRE(slope ==
                Approx(law.across(r_star, h)).epsilon(0.0).margin(1e-7 * law.closed(r_star)));
    }
}

// By hand: much liquid, A >> h^2, a constant pull over the gap, less F h^2/(2 sqrt(A)), here 0.5 %; little, A << h^2: the
// integral of 1 - h/sqrt(h^2 + A) to infinity is sqrt(A), short of it by A/(2 h), here 0.5 %.
TEST_CASE("capillary bridge: the work of much and of little liquid",
          "[contact][capillary_bridge][limit]") {
    const double r_star = 1e-4;
    const CapillaryBridge much{1.0, 1e-14, 1e-7}, little{1.0, 3.1415926535e-20, 1e-6};
    REQUIRE(much.work(r_star, 1e-8) == Approx(much.closed(r_star) * 1e-8).epsilon(1e-2));
    REQUIRE(little.work(r_star, 1e-6) == Approx(little.closed(r_star) * 1e-8).epsilon(1e-2));
}
