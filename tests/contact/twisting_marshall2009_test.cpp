// SPDX-License-Identifier: MIT
// Expected values by hand from Marshall (2009): a disc of radius a, k_t = 8 G* a, so k_t a^2/2 = 4 G* a^3.
#include "contact/twisting_marshall2009.hpp"

#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

namespace si = boost::units::si;
using contact::TwistingInput;
using contact::TwistingMarshall2009;

namespace {

const TwistingMarshall2009 law{.g_star = 1e9, .sliding_friction = 0.5};

// At rest at a contact radius of 1 um with a spring of `angle`.
TwistingInput held(double angle) {
    return {.angle = angle,
            .previous_radius = 1e-6,
            .contact_radius = 1e-6,
            .spin = 0.0,
            .cap_force = 1.0,
            .damping_factor = 0.0,
            .m_star = 1e-9,
            .dt = 1e-7};
}

}  // namespace

TEST_CASE("twisting: a held spring answers with 4 G* a^3 theta and stores half of that times theta",
          "[contact][twisting][exact]") {
    const auto r = law.step(held(1e-3));
    REQUIRE(r.torque_on_j == Approx(-4.0 * 1e9 * 1e-18 * 1e-3).epsilon(1e-12));  // algebra
    REQUIRE(r.stored == Approx(0.5 * 4.0 * 1e9 * 1e-18 * 1e-6).epsilon(1e-12));
    REQUIRE(r.dissipated == Approx(0.0).margin(1e-12 * r.stored));
}

TEST_CASE("twisting: a spinning contact gains strain and feels Tsuji's dashpot over its disc",
          "[contact][twisting][exact]") {
    TwistingInput in = held(0.0);
    in.spin = 20.0;
    in.damping_factor = 0.5;
    const double strain = 20.0 * 1e-7, c_t = 0.5 * std::sqrt(8.0 * 1e9 * 1e-6 * 1e-9);
    const auto r = law.step(in);
    REQUIRE(r.angle == Approx(strain).epsilon(1e-12));
    REQUIRE(r.torque_on_j == Approx(-(4e-9 * strain + 0.5e-12 * c_t * 20.0)).epsilon(1e-12));
    REQUIRE(r.dissipated ==
            Approx(0.5e-12 * c_t * 20.0 * strain).epsilon(1e-9));  // the dashpot's work alone
}

TEST_CASE("twisting: it yields at 2/3 a mu N, spring and dashpot together",
          "[contact][twisting][exact]") {
    TwistingInput in = held(1.0);
    in.cap_force = 1e-4;
    const double limit = 2.0 / 3.0 * 1e-6 * 0.5 * 1e-4;
    const auto spring = law.step(in);
    REQUIRE(spring.torque_on_j == Approx(-limit).epsilon(1e-12));
    REQUIRE(spring.angle == Approx(limit / 4e-9).epsilon(1e-12));
    REQUIRE(spring.dissipated ==
            Approx(limit * (1.0 - limit / 4e-9)).epsilon(1e-12));  // torque times slipped angle
    in.angle = -1.0;
    REQUIRE(law.step(in).torque_on_j == Approx(limit).epsilon(1e-12));
    in = held(0.0);
    in.cap_force = 1e-4;
    in.spin = 1e4;
    in.damping_factor = 10.0;
    REQUIRE(law.step(in).torque_on_j == Approx(-limit).epsilon(1e-12));
}

TEST_CASE(
    "twisting: a growing contact keeps its torque and gains no energy, a shrinking one gives some "
    "up",
    "[contact][twisting][energy]") {
    TwistingInput in = held(1e-3);
    in.contact_radius = 2e-6;
    const auto grown = law.step(in);
    REQUIRE(grown.torque_on_j == Approx(-4e-9 * 1e-3).epsilon(1e-12));
    REQUIRE(grown.angle == Approx(1e-3 / 8.0).epsilon(1e-12));
    REQUIRE(grown.dissipated == Approx(0.5 * 4e-9 * 1e-6 * (1.0 - 1.0 / 8.0)).epsilon(1e-12));
    in.contact_radius = 0.5e-6;
    const auto shrunk = law.step(in);
    REQUIRE(shrunk.torque_on_j == Approx(-4e-9 / 8.0 * 1e-3).epsilon(1e-12));
    REQUIRE(shrunk.angle == Approx(1e-3).epsilon(1e-12));
    REQUIRE(shrunk.dissipated == Approx(0.5 * 4e-9 * 1e-6 * (1.0 - 1.0 / 8.0)).epsilon(1e-12));
}

TEST_CASE("twisting: without a modulus there is no resistance", "[contact][twisting][limit]") {
    const TwistingMarshall2009 none{0.0, 0.0};
    TwistingInput in = held(1e-3);
    in.spin = 50.0;
    in.damping_factor = 0.5;
    REQUIRE(none.step(in).torque_on_j == 0.0);
    REQUIRE(none.step(in).stored == 0.0);
}

TEST_CASE("twisting: bad parameters are named", "[contact][twisting][domain]") {
    const auto pa = si::pascals;
    REQUIRE_THROWS_WITH(TwistingMarshall2009::from(-1.0 * pa, 0.5),
                        Catch::Matchers::Contains("TwistingMarshall2009.g_star"));
    REQUIRE_THROWS_WITH(TwistingMarshall2009::from(1e9 * pa, -0.5),
                        Catch::Matchers::Contains("TwistingMarshall2009.sliding_friction"));
    REQUIRE(TwistingMarshall2009::from(1e9 * pa, 0.5).g_star == 1e9);
}
