// SPDX-License-Identifier: MIT
#include "contact/hertz.hpp"

#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace si = boost::units::si;
using contact::Hertz;

// By hand: a^2 = R* d = 4e-4 m 1e-6 m, a = 2e-5 m; F = 4/3 3e9 Pa 2e-5 m 1e-6 m = 0.08 N;
// U = 8/15 3e9 Pa 2e-5 m 1e-12 m^2 = 3.2e-8 J. 1e-14: algebra.
TEST_CASE("hertz: 0.08 N at one micron of overlap", "[contact][hertz][exact]") {
    const Hertz law = Hertz::from(3e9 * si::pascals);
    const double scale = law.length_scale(4e-4);
    REQUIRE(law.at(4e-4, scale, 1e-6).force == Approx(0.08).epsilon(1e-14));
    REQUIRE(law.at(4e-4, scale, 1e-6).contact_radius == Approx(2e-5).epsilon(1e-14));
    REQUIRE(law.energy(4e-4, scale, 1e-6) == Approx(3.2e-8).epsilon(1e-14));
}

// Johnson (1985), section 4.2: peak pressure p0 = 2 E* a/(pi R*), load 2/3 p0 pi a^2.
TEST_CASE("hertz: the force is the integral of its elliptic pressure", "[contact][hertz][exact]") {
    const double r_star = 5e-5, overlap = GENERATE(1e-9, 1e-7, 1e-6), e_star = 4e8;
    const Hertz law{e_star};
    const contact::NormalState state = law.at(r_star, law.length_scale(r_star), overlap);
    const double a = state.contact_radius;
    const double peak = 2.0 * e_star * a / (std::numbers::pi * r_star);
    REQUIRE(state.force == Approx(2.0 / 3.0 * peak * std::numbers::pi * a * a).epsilon(1e-14));
}

// Central difference over 1e-4 of the overlap: its error is (1e-4)^2 (3/2)(1/2)/6, below 2e-9.
TEST_CASE("hertz: force is the slope of the energy", "[contact][hertz][energy]") {
    const double r_star = 5e-5, overlap = GENERATE(1e-9, 1e-7, 1e-6);
    const Hertz law{4e8};
    const double scale = law.length_scale(r_star), half = 1e-4 * overlap;
    const double slope =
        (law.energy(r_star, scale, overlap + half) - law.energy(r_star, scale, overlap - half)) /
        (2.0 * half);
    REQUIRE(slope == Approx(law.at(r_star, scale, overlap).force).epsilon(1e-8));
}

TEST_CASE("hertz: spheres that do not touch do not pull", "[contact][hertz][limit]") {
    const double overlap = GENERATE(0.0, -1e-30, -1e-6);
    const Hertz law{4e8};
    const contact::NormalState state = law.at(5e-5, law.length_scale(5e-5), overlap);
    REQUIRE(state.force == 0.0);
    REQUIRE(state.contact_radius == 0.0);
    REQUIRE(law.energy(5e-5, law.length_scale(5e-5), overlap) == 0.0);
    REQUIRE(law.pull_off_force(5e-5) == 0.0);
    REQUIRE(law.tear_off_overlap(5e-5, law.length_scale(5e-5)) == 0.0);
}
