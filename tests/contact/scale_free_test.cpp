// SPDX-License-Identifier: MIT
#include "contact/scale_free.hpp"

#include <catch2/catch.hpp>

#include <cmath>

TEST_CASE("the cube root of a perfect cube is the number itself", "[contact][exact]") {
    const double x = GENERATE(1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 1000.0);
    REQUIRE(contact::cube_root(x * x * x) == Approx(x).epsilon(1e-15));
}

// Three octaves hold every mantissa and every remainder of the exponent. Three units in the last
// place of the root are nine in its cube.
TEST_CASE("the cube root cubed gives the number back", "[contact][exact]") {
    for (double x = 1.0; x < 8.0; x *= 1.0037) {
        const double y = contact::cube_root(x);
        REQUIRE(y * y * y == Approx(x).epsilon(9 * 2.2e-16));
    }
}

TEST_CASE("eight times the number, twice the cube root, to the last bit", "[contact][similarity]") {
    const double x = GENERATE(1.0, 2.7, 5.1, 7.999, 3.3e-21, 8.8e17);
    for (int k = -60; k <= 60; ++k)
        REQUIRE(contact::cube_root(std::ldexp(x, 3 * k)) == std::ldexp(contact::cube_root(x), k));
}
