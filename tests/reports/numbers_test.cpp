// SPDX-License-Identifier: MIT
#include "reports/numbers.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace reports;

TEST_CASE("numbers: four significant digits, an exponent only where zeros would have to be counted",
          "[reports][numbers]") {
    CHECK(number(14.142135) == "14.14");
    CHECK(number(0.0) == "0");
    CHECK(number(10000.0) == "10000");
    CHECK(number(12345.6) == "12350");
    CHECK(number(99996.0) == "1e5");
    CHECK(number(-1.25e-7) == "-1.25e-7");
    CHECK(number(8e6) == "8e6");
}

TEST_CASE("numbers: what is no number is never written as one", "[reports][numbers]") {
    CHECK(number(std::numeric_limits<double>::quiet_NaN()) == "none");
    CHECK(number(std::numeric_limits<double>::infinity()) == "none");
    CHECK(quantity(std::numeric_limits<double>::quiet_NaN(), "m") == "none");
}

TEST_CASE("numbers: quantities take the prefix that people use", "[reports][numbers]") {
    CHECK(quantity(1.2e-6, "m") == "1.2 um");
    CHECK(quantity(85.714285e6, "Pa") == "85.71 MPa");
    CHECK(quantity(0.38, "J/m^2") == "0.38 J/m^2");
    CHECK(quantity(std::acos(-1.0) / 180.0, "rad") == "1 deg");  // the e of deg is no exponent
    CHECK(quantity(270.2, "1") == "270.2");
}

TEST_CASE("numbers: a long time is told in minutes, hours, days and years", "[reports][numbers]") {
    CHECK(quantity(90.0, "s") == "90 s");
    CHECK(quantity(600.0, "s") == "10 min");
    CHECK(quantity(9000.0, "s") == "2.5 h");
    CHECK(quantity(864000.0, "s") == "10 d");
    CHECK(quantity(3.15576e9, "s") == "100 years");  // Julian years of 365.25 d
}

TEST_CASE("numbers: counts have their thousands apart", "[reports][numbers]") {
    CHECK(count(999.0) == "999");
    CHECK(count(1500.0) == "1 500");
    CHECK(count(54007.0) == "54 007");
    CHECK(count(2.4e9) == "2.4e9");
}

TEST_CASE("numbers: exponents are raised, signs joined and markup made harmless",
          "[reports][numbers]") {
    CHECK(typeset("h^2") == "h<sup>2</sup>");
    CHECK(typeset("(R* w^(-1/2))") == "(R* w<sup>-1/2</sup>)");
    CHECK(typeset("1.2e-6") == "1.2\u00d710<sup>-6</sup>");
    CHECK(typeset("3e+05 grains") == "3\u00d710<sup>5</sup> grains");
    CHECK(typeset("1e-12, 11e5") == "10<sup>-12</sup>, 11\u00d710<sup>5</sup>");
    CHECK(typeset("1.2 um") == "1.2 \u00b5m");
    CHECK(typeset(">= 5 +- 1") == "\u2265 5 \u00b1 1");
    CHECK(typeset("<b>&\"") == "&lt;b&gt;&amp;&quot;");
    CHECK(typeset("a^b, 2e, stone, 1e5x") == "a^b, 2e, stone, 1e5x");
    CHECK(typeset("F_po/(rho_f g), pi") == "F<sub>po</sub>/(\u03c1<sub>f</sub> g), \u03c0");
    CHECK(typeset("kept_gravity, spin, beta1") == "kept_gravity, spin, beta1");
    CHECK(words("youngs_modulus") == "Young's modulus");
    CHECK(words("base_diameter / grain_diameter") == "base diameter / grain diameter");
    CHECK(tidy("7.78e-07 s and 1e+06") == "7.78e-7 s and 1e6");
}
