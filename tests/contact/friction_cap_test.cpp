// SPDX-License-Identifier: MIT
#include "contact/friction_cap.hpp"

#include "contact/hertz.hpp"
#include "contact/jkr.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using contact::cap_force;
using contact::FrictionCap;

// Pressed with 5 N, dashpot -1 N, pull-off 2 N, repulsive part 7 N: sums in whole numbers, exact.
TEST_CASE("each cap adds what its codes add", "[contact][friction_cap][exact]") {
    REQUIRE(cap_force(FrictionCap::elastic_plus_two_pull_off, 5.0, -1.0, 2.0, 7.0) == 9.0);
    REQUIRE(cap_force(FrictionCap::total_plus_two_pull_off, 5.0, -1.0, 2.0, 7.0) == 8.0);
    REQUIRE(cap_force(FrictionCap::repulsive_part, 5.0, -1.0, 2.0, 7.0) == 7.0);
    REQUIRE(cap_force(FrictionCap::elastic, 5.0, -1.0, 2.0, 7.0) == 5.0);
}

TEST_CASE("without adhesion and dashpot all caps are the normal force",
          "[contact][friction_cap][limit]") {
    const contact::Hertz law{2e9};
    const contact::NormalState state = law.at(3e-4, law.length_scale(3e-4), 1e-7);
    const double repulsive = contact::repulsive_force(2e9, 3e-4, state.contact_radius);
    for (const FrictionCap cap :
         {FrictionCap::elastic_plus_two_pull_off, FrictionCap::total_plus_two_pull_off,
          FrictionCap::repulsive_part, FrictionCap::elastic})
        REQUIRE(cap_force(cap, state.force, 0.0, 0.0, repulsive) ==
                Approx(state.force).epsilon(1e-14));
}

TEST_CASE("a pulling dashpot never makes friction negative", "[contact][friction_cap][domain]") {
    REQUIRE(cap_force(FrictionCap::total_plus_two_pull_off, 1.0, -9.0, 2.0, 1.0) == 0.0);
    REQUIRE(cap_force(FrictionCap::elastic_plus_two_pull_off, -1.0, 0.0, 0.0, 1.0) == 0.0);
    REQUIRE(cap_force(FrictionCap::repulsive_part, 1.0, 0.0, 0.0, -1.0) == 0.0);
    REQUIRE(cap_force(FrictionCap::elastic, -1.0, 0.0, 2.0, 1.0) == 0.0);
}

// At the deepest tension F_e = -F_po, so mu (F_e + 2 F_po) still holds the grain with mu F_po.
TEST_CASE("an adhering grain about to be pulled off is still held sideways by one pull-off force",
          "[contact][friction_cap][exact]") {
    REQUIRE(cap_force(FrictionCap::elastic_plus_two_pull_off, -2.0, 0.0, 2.0, 0.5) == 2.0);
}

// Johnson, Kendall & Roberts (1971): the Hertz load of equal contact radius is
// F + 2 F_po + 2 sqrt(F_po (F + F_po)). 1e-12: algebra; near the fold another branch holds.
TEST_CASE("the repulsive part of JKR is the apparent Hertz load of the paper",
          "[contact][friction_cap][exact]") {
    const contact::Jkr law{.e_star = 2e9, .w = 0.1};
    const double r_star = 3e-4, scale = law.length_scale(r_star);
    const double overlap = GENERATE(-0.4, 0.0, 1.0, 20.0) * scale * scale / r_star;
    const contact::NormalState state = law.at(r_star, scale, overlap);
    const double pull_off = law.pull_off_force(r_star), force = state.force;
    const double expected = force + 2.0 * pull_off + 2.0 * std::sqrt(pull_off * (force + pull_off));
    REQUIRE(contact::repulsive_force(2e9, r_star, state.contact_radius) ==
            Approx(expected).epsilon(1e-12));
}
