// SPDX-License-Identifier: MIT
#include "contact/vec3.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using contact::Vec3;

// Whole numbers by hand: exact.
TEST_CASE("vectors add, subtract and stretch component by component", "[contact][exact]") {
    const Vec3 a{1.0, 2.0, 3.0}, b{10.0, 40.0, 90.0};
    REQUIRE(a + b == Vec3{11.0, 42.0, 93.0});
    REQUIRE(b - a == Vec3{9.0, 38.0, 87.0});
    REQUIRE(-a == Vec3{-1.0, -2.0, -3.0});
    REQUIRE(2.0 * a == Vec3{2.0, 4.0, 6.0});
    REQUIRE(contact::dot(a, b) == 360.0);
    REQUIRE(contact::norm({2.0, 3.0, 6.0}) == 7.0);
}

TEST_CASE("the cross product is right-handed", "[contact][exact]") {
    REQUIRE(contact::cross({1.0, 2.0, 3.0}, {4.0, 5.0, 7.0}) == Vec3{-1.0, 5.0, -3.0});
}

TEST_CASE("the tangential part has lost its part along n and nothing else", "[contact][exact]") {
    REQUIRE(contact::tangential_part({3.0, -4.0, 5.0}, {0.0, 0.0, 1.0}) == Vec3{3.0, -4.0, 0.0});
}

// A vector of length 5 that leans out of the plane of x and y by an angle: along x, length 5. The
// series behind it ends before 35/128 sin^8.
TEST_CASE("a spring turned into a plane keeps its length", "[contact][exact]") {
    const double angle = GENERATE(0.0, 1e-6, 0.01, 0.1, 0.3);
    const Vec3 turned = contact::turned_into_plane(
        {5.0 * std::cos(angle), 0.0, 5.0 * std::sin(angle)}, {0.0, 0.0, 1.0});
    REQUIRE(turned.x == Approx(5.0).epsilon(1e-15 + 0.35 * std::pow(std::sin(angle), 8)));
    REQUIRE(turned.z == 0.0);
    REQUIRE(contact::turned_into_plane({0.0, 0.0, 4.0}, {0.0, 0.0, 1.0}) == Vec3{});
    REQUIRE(contact::turned_into_plane({}, {0.0, 0.0, 1.0}) == Vec3{});
}
