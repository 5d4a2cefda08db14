// SPDX-License-Identifier: MIT
#include "scaling/dimension.hpp"

#include "scaling/errors.hpp"
#include "scaling/quantities.hpp"
#include "scaling/quantity_table.hpp"
#include "scaling/rational_system.hpp"

#include <catch2/catch.hpp>

using namespace scaling;

TEST_CASE("dimension: a stress is M L^-1 T^-2 and a surface energy has no length in it",
          "[dimension]") {
    REQUIRE(to_string(dimension_of<Pressure>()) == "M L^-1 T^-2");
    REQUIRE(to_string(dimension_of<EnergyPerArea>()) == "M T^-2");
    REQUIRE(to_string(dimension_of<Viscosity>()) == "M L^-1 T^-1");
    REQUIRE(to_string(dimension_of<Dimensionless>()) == "1");
}

TEST_CASE("dimension: in density, length and time a surface energy is rho L^3 T^-2",
          "[dimension]") {
    REQUIRE(in_density_length_time(dimension_of<EnergyPerArea>()) == "rho L^3 T^-2");
    REQUIRE(in_density_length_time(dimension_of<Damping>()) == "rho L^3 T^-1");
    REQUIRE(in_density_length_time(dimension_of<Energy>()) == "rho L^5 T^-2");
    REQUIRE(in_density_length_time(dimension_of<Time>()) == "T");
}

TEST_CASE("dimension: the square root of stress over density is a velocity", "[dimension]") {
    const Dimension wave =
        power(dimension_of<Pressure>() / dimension_of<Density>(), Rational(1, 2));
    REQUIRE(wave == dimension_of<Velocity>());
    REQUIRE(dimension_of<Force>() * dimension_of<Length>() == dimension_of<Energy>());
    REQUIRE(to_string(power(dimension_of<Length>(), Rational(-3, 2))) == "L^-3/2");
}

TEST_CASE(
    "dimension: the cohesion number as printed on a public page, gamma / (rho g R^3 E^2)^(1/3), "
    "has a length left",
    "[dimension]") {
    // From the factors: M T^-2 over (M L^-3 * L T^-2 * L^3 * M^2 L^-2 T^-4)^(1/3) = M L^-1/3 T^-2,
    // so L^1/3 is left.
    const Dimension base = dimension_of<Density>() * dimension_of<Acceleration>() *
                           power(dimension_of<Length>(), Rational(3)) *
                           power(dimension_of<Pressure>(), Rational(2));
    const Dimension printed = dimension_of<EnergyPerArea>() / power(base, Rational(1, 3));
    REQUIRE_FALSE(printed.dimensionless());
    REQUIRE(to_string(printed) == "L^1/3");
}

TEST_CASE("dimension: rationals are read exactly and anything else is refused by name",
          "[dimension]") {
    REQUIRE(rational_from("-3/2", "kept time") == Rational(-3, 2));
    REQUIRE(rational_from("2", "kept time") == Rational(2));
    for (const char* bad : {"", "1/0", "0.5", "1/2/3", "h", "1/", "1 "}) {
        REQUIRE_THROWS_WITH(rational_from(bad, "kept time"),
                            Catch::StartsWith("kept time: got \""));
    }
}

TEST_CASE(
    "quantities: every name is found and belongs to one side or to a product with its own "
    "dimension",
    "[quantities]") {
    for (const NamedQuantity& q : quantity_table()) {
        REQUIRE(named_quantity(q.name).name == q.name);
        REQUIRE((q.side == Side::both) == !q.product.empty());
        if (q.side != Side::both) continue;
        Dimension product;
        for (const Power& p : q.product)
            product = product * power(named_quantity(p.name).dimension, p.exponent);
        INFO(q.name);
        REQUIRE(product == q.dimension);
    }
}

TEST_CASE("quantities: a mistyped name is refused with the nearest one", "[quantities][domain]") {
    REQUIRE_THROWS_AS(named_quantity("gravty"), InvalidParameter);
    REQUIRE_THROWS_WITH(named_quantity("gravty"), Catch::Contains("did you mean gravity?"));
}

TEST_CASE("rational system: an equation is added, implied or conflicting, exactly", "[algebra]") {
    using Outcome = RationalSystem::Outcome;
    const Exponents one{Rational(1), Rational(0)}, half{Rational(1, 2), Rational(0)};
    RationalSystem system;
    REQUIRE(system.add({Rational(1), Rational(-2)}, one) == Outcome::added);  // x - 2 y = 1
    REQUIRE_FALSE(system.value_of({Rational(1), Rational(0)}));
    REQUIRE(system.add({Rational(3), Rational(-6)}, Rational(3) * one) == Outcome::implied);
    REQUIRE(system.add({Rational(1), Rational(-2)}, half) == Outcome::conflicting);
    REQUIRE(system.add({Rational(0), Rational(1)}, half) == Outcome::added);
    REQUIRE(*system.value_of({Rational(1), Rational(0)}) == Rational(2) * one);  // x = 1 + 2/2
    REQUIRE(system.rank() == 2);
}
