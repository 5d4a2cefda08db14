// SPDX-License-Identifier: MIT
#include "verify/exact_answers.hpp"

#include "verify/two_sphere_ode.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <string>

TEST_CASE("every exact answer comes out of the core", "[verify][exact]") {
    std::set<std::string> names;
    for (const verify::Check& check : verify::exact_answers()) {
        CAPTURE(check.name, check.expected, check.got, check.tolerance, check.reason);
        CHECK(check.passed);
        CHECK(names.insert(check.name).second);  // a name says which check failed
        CHECK(!check.reason.empty());
        CHECK(!check.source.empty());
        CHECK(!check.unit.empty());
    }
    REQUIRE(names.size() > 40);
}

TEST_CASE("a check passes inside its tolerance alone, and never on what is not a number",
          "[verify]") {
    REQUIRE(verify::check_relative({}, -200.0, -201.0, 0.006).passed);
    REQUIRE_FALSE(verify::check_relative({}, -200.0, -201.0, 0.004).passed);
    REQUIRE(verify::check_absolute({}, 0.0, -0.5, 0.5).passed);
    REQUIRE_FALSE(verify::check_absolute({}, 0.0, -0.5, 0.49).passed);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    REQUIRE_FALSE(verify::check_relative({}, 1.0, nan, 1.0).passed);
    REQUIRE_FALSE(verify::check_absolute({}, 1.0, nan, 1.0).passed);
}

// The integration that the core is held against is itself held against what needs no integration.
// 1e-9: relative error asked of GSL, summed over some hundred steps.
TEST_CASE("GSL's impact without a dashpot keeps the energy of the pair", "[verify][exact]") {
    const double v = 0.4, w = GENERATE(0.0, 2.0);
    const verify::TwoSpheres p{
        .e_star = 1e8, .r_star = 5e-4, .m_star = 5e-6, .work_of_adhesion = w, .restitution = 1.0};
    const double lost = w > 0.0 ? 2.0 * verify::sticking_work(p) / p.m_star : 0.0;
    REQUIRE(verify::integrate_impact(p, v).rebound_speed ==
            Approx(std::sqrt(v * v - lost)).epsilon(1e-9));
}

// Antypov & Elliott (2011): a Hertzian pair with Tsuji's dashpot has one restitution at any speed.
TEST_CASE("GSL's impact with Tsuji's dashpot has the restitution asked for", "[verify][exact]") {
    const double v = GENERATE(0.01, 3.0), e = GENERATE(0.2, 0.8);
    const verify::TwoSpheres p{
        .e_star = 1e8, .r_star = 5e-4, .m_star = 5e-6, .work_of_adhesion = 0.0, .restitution = e};
    // 1e-6: the dashpot starts as d^(1/4), which no method of high order likes.
    REQUIRE(verify::integrate_impact(p, v).rebound_speed == Approx(e * v).epsilon(1e-6));
}
