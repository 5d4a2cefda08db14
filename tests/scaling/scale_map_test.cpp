// SPDX-License-Identifier: MIT
#include "scaling/scale_map.hpp"

#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace scaling;

namespace {

using Column = std::vector<std::pair<std::string, Rational>>;

void require_exponents(const ScaleMap& map, const Column& expected) {
    for (const auto& [quantity, exponent] : expected) {
        INFO(quantity << " has " << to_string(map.exponents(quantity)) << ", expected "
                      << to_string(exponent));
        CHECK(map.exponents(quantity) == Exponents{exponent, Rational(0)});
    }
}

Exponents h_to(int numerator, int denominator = 1) {
    return {Rational(numerator, denominator), Rational(0)};
}

ScaleMap kept(const std::vector<std::string>& quantities, double h = 200.0,
              double softening = 1.0) {
    return ScaleMap::solve(own_scheme(quantities, false), h, softening);
}

}  // namespace

TEST_CASE("exact: the paper's Table 2", "[schemes][paper]") {
    // Niu et al. (2026), Table 2: length h, density 1, time h, mass h^3, nu 1, E 1, G 1, force h^2,
    // stress 1, strain 1.
    const ScaleMap map = ScaleMap::solve(named_scheme("exact"), 200.0);
    require_exponents(map, {{"length", 1},
                            {"density", 0},
                            {"time", 1},
                            {"mass", 3},
                            {"poisson_ratio", 0},
                            {"youngs_modulus", 0},
                            {"shear_modulus", 0},
                            {"force", 2},
                            {"stress", 0},
                            {"strain", 0}});
    REQUIRE(map.factor("mass") == Approx(8e6).epsilon(1e-12));
    REQUIRE_FALSE(map.distorted());
}

// Expected exponents: rho^r L^l T^t by hand with the three base factors of each scheme.
TEST_CASE("exact: what Table 2 leaves out follows from the same three factors", "[schemes]") {
    require_exponents(ScaleMap::solve(named_scheme("exact"), 200.0), {{"gravity", -1},
                                                                      {"velocity", 0},
                                                                      {"surface_energy", 1},
                                                                      {"work_of_adhesion", 1},
                                                                      {"stiffness", 1},
                                                                      {"damping", 2},
                                                                      {"viscosity", 1},
                                                                      {"hamaker_constant", 3},
                                                                      {"liquid_volume", 3},
                                                                      {"energy", 3},
                                                                      {"mass_rate", 2},
                                                                      {"number_rate", -1},
                                                                      {"spin", -1}});
}

TEST_CASE("kept gravity: time sqrt h, modulus h, surface energy h^2", "[schemes]") {
    const ScaleMap map = ScaleMap::solve(named_scheme("kept_gravity"), 200.0);
    require_exponents(map, {{"density", 0},
                            {"time", {1, 2}},
                            {"velocity", {1, 2}},
                            {"gravity", 0},
                            {"youngs_modulus", 1},
                            {"stress", 1},
                            {"force", 3},
                            {"mass", 3},
                            {"surface_energy", 2},
                            {"stiffness", 2},
                            {"damping", {5, 2}},
                            {"viscosity", {3, 2}},
                            {"hamaker_constant", 4},
                            {"mass_rate", {5, 2}}});
    REQUIRE(map.factor("time") == Approx(std::sqrt(200.0)).epsilon(1e-15));
}

TEST_CASE("kept gravity and modulus: density 1/h, surface energy h", "[schemes]") {
    require_exponents(ScaleMap::solve(named_scheme("kept_gravity_kept_modulus"), 200.0),
                      {{"density", -1},
                       {"time", {1, 2}},
                       {"velocity", {1, 2}},
                       {"force", 2},
                       {"mass", 2},
                       {"surface_energy", 1},
                       {"stiffness", 1},
                       {"damping", {3, 2}},
                       {"viscosity", {1, 2}},
                       {"hamaker_constant", 3},
                       {"mass_rate", {3, 2}}});
}

TEST_CASE("a set of the user's own: surface energy kept with density, or with gravity",
          "[schemes]") {
    require_exponents(kept({"density", "surface_energy"}), {{"time", {3, 2}},
                                                            {"velocity", {-1, 2}},
                                                            {"gravity", -2},
                                                            {"youngs_modulus", -1},
                                                            {"force", 1},
                                                            {"damping", {3, 2}},
                                                            {"mass_rate", {3, 2}}});
    require_exponents(kept({"gravity", "work_of_adhesion"}), {{"density", -2},
                                                              {"time", {1, 2}},
                                                              {"youngs_modulus", -1},
                                                              {"mass", 1},
                                                              {"viscosity", {-1, 2}},
                                                              {"mass_rate", {1, 2}}});
}

TEST_CASE("a demand may be a power of h: time=1/2 with density is kept gravity", "[schemes]") {
    const ScaleMap map = kept({"density", "time=1/2"});
    require_exponents(map, {{"gravity", 0}, {"youngs_modulus", 1}, {"surface_energy", 2}});
}

TEST_CASE(
    "coarse graining: apparatus, flow time and velocity kept, contact time h and contact force h^2",
    "[schemes][distorted]") {
    for (const char* name : {"paper", "coarse_grain"}) {
        const ScaleMap map = ScaleMap::solve(named_scheme(name), 200.0);
        require_exponents(map, {{"length", 1},
                                {"apparatus_length", 0},
                                {"density", 0},
                                {"time", 0},
                                {"contact_time", 1},
                                {"velocity", 0},
                                {"gravity", 0},
                                {"youngs_modulus", 0},
                                {"stress", 0},
                                {"pressure", 0},
                                {"force", 2},
                                {"mass", 3},
                                {"stiffness", 1},
                                {"damping", 2},
                                {"hamaker_constant", 3},
                                {"liquid_volume", 3},
                                {"mass_rate", 0},
                                {"number_rate", -3},
                                {"spin", -1}});
        REQUIRE(map.distorted());
        REQUIRE(map.apparatus_kept());
        REQUIRE(map.adhesion_is_open());
        REQUIRE(map.imposed().empty());
    }
}

TEST_CASE("paper with its apparatus grown along: flow time sqrt h against contact time h",
          "[schemes][distorted]") {
    const ScaleMap map = ScaleMap::solve(with_scaled_apparatus(named_scheme("paper")), 200.0);
    require_exponents(map, {{"apparatus_length", 1},
                            {"time", {1, 2}},
                            {"velocity", {1, 2}},
                            {"contact_time", 1},
                            {"gravity", 0},
                            {"pressure", 1},
                            {"viscosity", 1},
                            {"stress", 0}});
    REQUIRE_FALSE(map.apparatus_kept());
}

TEST_CASE(
    "over-determined: density, gravity and modulus kept is refused with the conflict and the way "
    "out",
    "[solver][domain]") {
    const std::vector<std::string> demands = {"density", "gravity", "poisson_ratio",
                                              "youngs_modulus"};
    REQUIRE_THROWS_AS(kept(demands), InvalidParameter);
    REQUIRE_THROWS_WITH(
        kept(demands),
        "kept: got length h, density 1, gravity 1 and youngs_modulus 1, the former force "
        "youngs_modulus h (leave one of them out, or ask for a distorted map (--distorted), which "
        "says "
        "which groups break and by how much)");
}

TEST_CASE("over-determined: the conflict that is named is minimal", "[solver][domain]") {
    // time and velocity alone contradict a grown apparatus; density and energy take no part.
    REQUIRE_THROWS_WITH(
        kept({"density", "energy=5", "time", "velocity"}),
        Catch::StartsWith(
            "kept: got length h, time 1 and velocity 1, the former force velocity h"));
    REQUIRE_THROWS_WITH(
        kept({"density", "apparatus_length"}),
        Catch::StartsWith("kept: got length h and apparatus_length 1, the former force "
                          "apparatus_length h"));
}

TEST_CASE("over-determined but true: a demand that follows from the others is welcome",
          "[solver]") {
    REQUIRE(kept({"density", "youngs_modulus", "velocity", "stress", "force=2"}).exponent("time") ==
            Rational(1));
}

TEST_CASE("under-determined: what is free and what would fix it is named", "[solver][domain]") {
    REQUIRE_THROWS_WITH(kept({"density"}),
                        Catch::Contains("still free: time, contact_time") &&
                            Catch::Contains("keep 1 more") && Catch::Contains("gravity") &&
                            Catch::Contains("surface_energy") && !Catch::Contains("mass,"));
    REQUIRE_THROWS_WITH(kept({"gravity"}),
                        Catch::Contains("still free: density (") && Catch::Contains("mass,"));
    REQUIRE_THROWS_WITH(kept({}),
                        Catch::Contains("nothing kept") && Catch::Contains("keep 2 more"));
    // A product of density and time alone settles neither.
    REQUIRE_THROWS_WITH(kept({"force"}), Catch::Contains("still free: density, time") &&
                                             Catch::Contains("keep 1 more"));
}

TEST_CASE("a kept apparatus without a clock for the flow is under-determined",
          "[solver][distorted][domain]") {
    const Scheme scheme = own_scheme({"density", "youngs_modulus", "apparatus_length"}, true);
    REQUIRE_THROWS_WITH(ScaleMap::solve(scheme, 2.0), Catch::Contains("still free: time ("));
}

TEST_CASE("length is the grain's and cannot be kept", "[solver][domain]") {
    REQUIRE_THROWS_WITH(kept({"length", "density"}), Catch::Contains("keep apparatus_length"));
}

TEST_CASE("h and softening must be positive and finite", "[solver][domain]") {
    for (const double bad : {0.0, -2.0, std::nan(""), HUGE_VAL}) {
        REQUIRE_THROWS_WITH(ScaleMap::solve(named_scheme("exact"), bad),
                            Catch::StartsWith("h: got"));
        REQUIRE_THROWS_WITH(ScaleMap::solve(named_scheme("exact"), 2.0, bad),
                            Catch::StartsWith("softening: got"));
    }
}

TEST_CASE("an unknown scheme is refused with the nearest one", "[schemes][domain]") {
    REQUIRE_THROWS_WITH(named_scheme("kept_gravty"), Catch::Contains("did you mean kept_gravity?"));
}

TEST_CASE(
    "a distorted map imposes what two rulers and two clocks cannot give, on that quantity alone",
    "[distorted]") {
    const Scheme scheme =
        own_scheme({"density", "gravity", "youngs_modulus", "surface_energy"}, true);
    const ScaleMap map = ScaleMap::solve(scheme, 200.0);
    require_exponents(
        map, {{"surface_energy", 0}, {"work_of_adhesion", 0}, {"stiffness", 1}, {"force", 2}});
    REQUIRE(map.imposed().size() == 2);
    REQUIRE_FALSE(map.adhesion_is_open());
}

TEST_CASE("a distorted map is not distorted where the demands do not need it", "[distorted]") {
    const ScaleMap map = ScaleMap::solve(own_scheme({"density", "gravity"}, true), 200.0);
    REQUIRE_FALSE(map.distorted());
    REQUIRE(map.exponent("youngs_modulus") == Rational(1));
}

TEST_CASE("softening: an exact map carries it through, T = h (E'/E)^-1/2 and g = (E'/E)/h",
          "[softening]") {
    // E = rho L^2 T^-2 with rho = 1, L = h, E = s.
    const ScaleMap map = ScaleMap::solve(named_scheme("exact"), 200.0, 0.01);
    REQUIRE(map.exponents("time") == Exponents{Rational(1), Rational(-1, 2)});
    REQUIRE(map.exponents("gravity") == Exponents{Rational(-1), Rational(1)});
    REQUIRE(map.exponents("surface_energy") == Exponents{Rational(1), Rational(1)});
    REQUIRE(map.factor("time") == Approx(2000.0).epsilon(1e-14));
    REQUIRE(to_string(map.exponents("time")) == "h (E'/E)^-1/2");
    REQUIRE_FALSE(map.distorted());
}

TEST_CASE(
    "softening: where gravity and density already force the modulus it is refused unless distorted",
    "[softening][domain]") {
    REQUIRE_THROWS_WITH(
        ScaleMap::solve(named_scheme("kept_gravity"), 4.0, 0.1),
        Catch::StartsWith("softening: got 0.1") && Catch::Contains("force youngs_modulus h"));
    Scheme scheme = named_scheme("kept_gravity");
    scheme.distorted = true;
    const ScaleMap map = ScaleMap::solve(scheme, 4.0, 0.1);
    REQUIRE(map.exponents("youngs_modulus") == Exponents{Rational(1), Rational(1)});
    REQUIRE(map.exponents("time") == h_to(1, 2));
    REQUIRE(map.exponents("contact_time") == Exponents{Rational(1, 2), Rational(-1, 2)});
}

TEST_CASE("softening: coarse graining keeps the flow's clock and slows the contact's",
          "[softening][distorted]") {
    const ScaleMap map = ScaleMap::solve(named_scheme("paper"), 200.0, 0.01);
    REQUIRE(map.exponents("time") == Exponents{});
    REQUIRE(map.exponents("contact_time") == Exponents{Rational(1), Rational(-1, 2)});
}

TEST_CASE("bits: exact is a power of two for every 2^k, kept gravity for every 4^k only",
          "[bits]") {
    const auto exact_bits = [](const char* scheme, double h, double softening = 1.0) {
        return ScaleMap::solve(named_scheme(scheme), h, softening).exact_in_binary();
    };
    REQUIRE(exact_bits("exact", 2.0));
    REQUIRE(exact_bits("exact", 256.0));
    REQUIRE_FALSE(exact_bits("exact", 200.0));
    REQUIRE(exact_bits("exact", 2.0, 0.25));
    REQUIRE_FALSE(exact_bits("exact", 2.0, 0.5));
    REQUIRE(exact_bits("kept_gravity", 256.0));
    REQUIRE(exact_bits("kept_gravity", 0.25));
    REQUIRE_FALSE(exact_bits("kept_gravity", 8.0));
}

TEST_CASE("bits: a power of two to a half is the power of two itself, to the last bit", "[bits]") {
    REQUIRE(power_of(4096.0, Rational(1, 2)) == 64.0);
    REQUIRE(power_of(0.25, Rational(5, 2)) == 0.03125);
    REQUIRE(power_of(200.0, Rational(0)) == 1.0);
    REQUIRE(power_of(200.0, Rational(3)) == 8e6);
}
