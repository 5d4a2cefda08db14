// SPDX-License-Identifier: MIT
#include "contact/ageing.hpp"

#include "contact/hertz.hpp"

#include <catch2/catch.hpp>

#include <numbers>

namespace si = boost::units::si;
using contact::Ageing;

// By definition; 1e-14: the logarithm of a power of ten.
TEST_CASE("ageing: adhesion grows by the rate in every decade of age beyond the onset",
          "[contact][ageing][exact]") {
    const double onset = GENERATE(1.0, 0.02);
    const Ageing law = Ageing::from(0.3, onset * si::seconds);
    REQUIRE(law.growth(0.0) == 1.0);
    REQUIRE(law.growth(9.0 * onset) == Approx(1.3).epsilon(1e-14));
    REQUIRE(law.growth(99.0 * onset) == Approx(1.6).epsilon(1e-14));
    REQUIRE(law.growth(9999.0 * onset) == Approx(2.2).epsilon(1e-14));
    REQUIRE(law.acts());
    REQUIRE(!Ageing{}.acts());
}

// 3/2 pi w R* with w of that age. 1e-14: as above.
TEST_CASE("ageing: an old contact has the pull-off force of the work of adhesion it has grown to",
          "[contact][ageing][exact]") {
    const contact::Jkr fresh{.e_star = 1e8, .w = 0.05};
    const Ageing law{.rate = 0.5, .onset = 2.0};
    const contact::Jkr old = law.aged(fresh, 18.0);
    REQUIRE(old.e_star == fresh.e_star);
    REQUIRE(old.pull_off_force(1e-4) ==
            Approx(1.5 * std::numbers::pi * 0.075 * 1e-4).epsilon(1e-14));
    REQUIRE(law.aged(contact::Hertz{1e8}, 18.0).e_star ==
            1e8);  // what does not adhere does not age
}

TEST_CASE("ageing: a rate of 0 leaves the law as it is, to the last bit",
          "[contact][ageing][limit]") {
    const contact::Jkr fresh{.e_star = 1e8, .w = 0.05};
    REQUIRE(Ageing{.rate = 0.0, .onset = 1.0}.aged(fresh, 1e6).w == fresh.w);
}
