// SPDX-License-Identifier: MIT
#include "contact/drag_schiller1935.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using contact::DragSchiller1935;

namespace {

constexpr double pi = std::numbers::pi;
constexpr DragSchiller1935 air{1.0, 1.204, 1.81e-5};

// Cd = F/(pi/8 rho d^2 u^2)
double coefficient(const DragSchiller1935& law, double diameter, double speed) {
    return 8.0 * law.at(diameter, speed).value / (pi * law.density * diameter * diameter * speed);
}

double speed_at(double reynolds, double diameter) {
    return reynolds * air.viscosity / (air.density * diameter);
}

}  // namespace

// 1e-14: y = 0.687 log2 x is below 70 and rounded twice, 2^y is as far off as y; and the library's own last bit.
TEST_CASE("drag: the power of Re is the library's", "[contact][drag][exact]") {
    for (double x = 0x1p-100; x < 0x1p100; x *= 1.37)
        REQUIRE(contact::power_0687(x) == Approx(std::pow(x, 0.687)).epsilon(1e-14));
    for (const double edge : {1.0, std::sqrt(0.5), std::nextafter(std::sqrt(0.5), 0.0)})
        REQUIRE(contact::power_0687(edge) == Approx(std::pow(edge, 0.687)).epsilon(1e-15));
}

// By hand from the curve: 24 * 1.15; 24/100 (1 + 0.15 * 10^1.374), 10^1.374 = 23.6592; Newton's 0.44.
TEST_CASE("drag: Cd at Re = 1, 100 and 5000", "[contact][drag][exact]") {
    const double d = GENERATE(5e-5, 4e-3);
    CHECK(coefficient(air, d, speed_at(1.0, d)) == Approx(27.6).epsilon(1e-12));
    CHECK(coefficient(air, d, speed_at(100.0, d)) == Approx(1.09173).epsilon(1e-5));
    CHECK(coefficient(air, d, speed_at(5000.0, d)) == Approx(0.44).epsilon(1e-12));
}

TEST_CASE("drag: the curve ends at Re = 1000, where Cd jumps by less than half a per cent",
          "[contact][drag][exact]") {
    const double d = 1e-3;
    const double below = coefficient(air, d, speed_at(999.999, d)),
                 above = coefficient(air, d, speed_at(1000.001, d));
    CHECK(above == Approx(0.44).epsilon(1e-12));
    CHECK(below != above);
    CHECK(below == Approx(above).epsilon(0.005));
}

// The term beside Stokes' is 0.15 Re^0.687: below 1e-12 of it at Re = 1e-18, and nothing in a fluid without density.
TEST_CASE("drag: slow grains have Stokes' 3 pi eta d u", "[contact][drag][limit]") {
    const double d = 1e-4, stokes = 3.0 * pi * air.viscosity * d;
    CHECK(air.at(d, speed_at(1e-18, d)).value == Approx(stokes).epsilon(1e-12));
    CHECK(air.at(d, 0.0).value == Approx(stokes).epsilon(1e-15));
    CHECK(DragSchiller1935{2.0, 0.0, air.viscosity}.at(d, 7.0).value ==
          Approx(2.0 * stokes).epsilon(1e-15));
    CHECK(DragSchiller1935{2.0, 0.0, air.viscosity}.at(d, 7.0).growth == Approx(0.0).margin(1e-20));
}

TEST_CASE("drag: without viscosity it is Newton's at every speed", "[contact][drag][limit]") {
    const DragSchiller1935 law{1.0, 1000.0, 0.0};
    CHECK(coefficient(law, 1e-3, 1e-6) == Approx(0.44).epsilon(1e-12));
    CHECK(law.at(1e-3, 0.0).value == 0.0);
}

// Central difference over 1e-4 of u: off by its square times a number of order 1.
TEST_CASE("drag: growth is |u| dr/d|u|", "[contact][drag][exact]") {
    const double d = 1e-3, u = speed_at(GENERATE(0.01, 1.0, 300.0, 4000.0), d), h = 1e-4;
    const double slope =
        (air.at(d, u * (1.0 + h)).value - air.at(d, u * (1.0 - h)).value) / (2.0 * h);
    CHECK(air.at(d, u).growth == Approx(slope).epsilon(1e-7));
}
