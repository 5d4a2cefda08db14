// SPDX-License-Identifier: MIT
#include "scaling/numbers.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace scaling;

namespace {

const Length micron = 1e-6 * si::meters;
const Density zirconia = 5600.0 * si::kilogrammes_per_cubic_metre;
const Acceleration earth = 9.81 * si::meters_per_second_squared;
const Pressure megapascal = 1e6 * si::pascals;

}  // namespace

TEST_CASE("numbers: a scaled zirconia grain with w = 0.19 J/m^2 holds 135 of its own weights",
          "[numbers][paper]") {
    // 3/2 pi w R/2 = 5.372e-5 N over 4/3 pi R^3 rho g = 3.976e-7 N at R = 120 um.
    const Force pull_off = 1.5 * std::numbers::pi * 0.19 * 60e-6 * si::newtons;
    REQUIRE(weight_bond_number(pull_off, grain_mass(240.0 * micron, zirconia), earth) ==
            Approx(135.1).epsilon(5e-4));
}

TEST_CASE(
    "numbers: elastic moduli of an isotropic solid agree, E = 2 G (1 + nu), E* = G / (1 - nu)",
    "[numbers]") {
    // E* of two like grains: E / (2 (1 - nu^2)) = G / (1 - nu).
    const Pressure e = youngs_modulus(60.0 * megapascal, 0.3);
    REQUIRE(e.value() == Approx(156e6).epsilon(1e-12));
    REQUIRE(shear_modulus(e, 0.3).value() == Approx(60e6).epsilon(1e-12));
    REQUIRE(effective_modulus(e, 0.3).value() == Approx(60e6 / 0.7).epsilon(1e-12));
}

TEST_CASE("numbers: each against its definition with round values", "[numbers]") {
    const Velocity v = 2.0 * si::meters_per_second;
    const Length d = 1e-3 * si::meters;
    const Viscosity air = 1.8e-5 * si::pascals * si::seconds;
    const Density gas = 1.2 * si::kilogrammes_per_cubic_metre,
                  grain = 2500.0 * si::kilogrammes_per_cubic_metre;
    const auto as_defined = [](double x) { return Approx(x).epsilon(1e-12); };  // algebra
    REQUIRE(froude_number(v, earth, d) == as_defined(2.0 / std::sqrt(9.81e-3)));
    REQUIRE(reynolds_number(gas, v, d, air) == as_defined(1.2 * 2e-3 / 1.8e-5));
    REQUIRE(stokes_number(grain, v, d, air) == as_defined(2500.0 * 2e-3 / (18.0 * 1.8e-5)));
    REQUIRE(galilei_number(grain, gas, earth, d, air) ==
            as_defined(2500.0 * 1.2 * 9.81 * 1e-9 / (1.8e-5 * 1.8e-5)));
    REQUIRE(capillary_number(air, v, 0.072 * si::newtons_per_meter) == as_defined(3.6e-5 / 0.072));
    REQUIRE(stiffness_number(megapascal, grain, earth, d) == as_defined(1e6 / (2500.0 * 9.81e-3)));
    REQUIRE(cauchy_number(grain, v, megapascal) == as_defined(0.01));
    REQUIRE(elastic_adhesion_number(0.05 * si::newtons_per_meter, megapascal, d) ==
            as_defined(5e-5));
    REQUIRE(inertial_number(10.0 * si::hertz, d, grain, 1e3 * si::pascals) ==
            as_defined(1e-2 * std::sqrt(2.5)));
    REQUIRE(stress_bond_number(2e-6 * si::newtons, 100.0 * si::pascals, 1e-4 * si::meters) ==
            as_defined(2.0));
}

TEST_CASE(
    "numbers: Tabor's number grows with the root of softness, R*^(1/3) w^(2/3) E*^(-2/3) / z0",
    "[numbers]") {
    const double tabor = tabor_number(0.06 * si::newtons_per_meter, 8e7 * si::pascals, 0.3 * micron,
                                      equilibrium_separation);
    REQUIRE(tabor == Approx(std::cbrt(0.3e-6) * std::cbrt(0.0036) / std::cbrt(6.4e15) / 0.165e-9)
                         .epsilon(1e-12));
}

TEST_CASE("numbers: the cohesion number is (w^5 / (E*^2 R^8))^(1/3) / (rho g)", "[numbers]") {
    const double number =
        cohesion_number(0.06 * si::newtons_per_meter, 8e7 * si::pascals, micron, zirconia, earth);
    const double defined = std::cbrt(std::pow(0.06, 5) / (6.4e15 * 1e-48)) / (5600.0 * 9.81);
    REQUIRE(number == Approx(defined).epsilon(1e-12));
}
