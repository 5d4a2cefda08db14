// SPDX-License-Identifier: MIT
#include "scaling/scale_study.hpp"

#include "scaling/errors.hpp"
#include "scaling/numbers.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace scaling;

namespace {

ScaleInput zirconia(const char* scheme) {
    ScaleInput in{};
    in.grain = {.diameter = 1.2e-6 * si::meters,
                .density = 5600.0 * si::kilogrammes_per_cubic_metre,
                .youngs_modulus = youngs_modulus(60e6 * si::pascals, 0.3),
                .poisson_ratio = 0.3,
                .gravity = 9.81 * si::meters_per_second_squared,
                .drop_height = 65e-3 * si::meters};
    in.apparatus_length = 6e-3 * si::meters;
    in.base_diameter = 80e-3 * si::meters;
    in.adhesion = StatedAdhesion{0.38 * si::newtons_per_meter, Of::scaled};
    in.coefficients = {{"restitution", 0.225}, {"sliding_friction", 0.8}};
    in.scheme = named_scheme(scheme);
    in.h = 200.0;
    in.duration = 12.0 * si::seconds;
    return in;
}

ScaleStudy paper_study(Invariant invariant) {
    ScaleInput in = zirconia("paper");
    in.invariant = invariant;
    return study(in);
}

const GroupChange& group(const ScaleStudy& s, const std::string& name) {
    const auto found = std::find_if(s.groups.begin(), s.groups.end(),
                                    [&](const GroupChange& g) { return g.group.name == name; });
    INFO(name);
    REQUIRE(found != s.groups.end());
    return *found;
}

const FactorRow* factor(const ScaleStudy& s, const std::string& quantity) {
    const auto found = std::find_if(s.factors.begin(), s.factors.end(),
                                    [&](const FactorRow& f) { return f.quantity == quantity; });
    return found == s.factors.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("study: every quantity that a report promises has its factor", "[study]") {
    const ScaleStudy s = study(zirconia("exact"));
    for (const char* quantity :
         {"length",           "density",       "time",          "velocity",  "acceleration",
          "gravity",          "mass",          "force",         "stress",    "strain",
          "youngs_modulus",   "shear_modulus", "poisson_ratio", "energy",    "surface_energy",
          "work_of_adhesion", "stiffness",     "damping",       "viscosity", "liquid_volume",
          "mass_rate"}) {
        INFO(quantity);
        REQUIRE(factor(s, quantity) != nullptr);
    }
    REQUIRE(factor(s, "apparatus_length") == nullptr);
    REQUIRE(factor(s, "contact_time") == nullptr);
}

TEST_CASE(
    "study: the paper's scheme shows both rulers and both clocks, and adhesion as the invariant "
    "set it",
    "[study]") {
    const ScaleStudy s = paper_study(Invariant::weight_bond);
    REQUIRE(factor(s, "apparatus_length")->factor == 1.0);
    REQUIRE(factor(s, "contact_time")->factor == Approx(200.0).epsilon(1e-12));
    REQUIRE(factor(s, "time")->factor == 1.0);
    REQUIRE(factor(s, "surface_energy")->factor == Approx(4e4).epsilon(1e-12));
    REQUIRE(factor(s, "surface_energy")->imposed);
    REQUIRE_FALSE(factor(s, "stiffness")->imposed);
    REQUIRE(s.distorted);
    REQUIRE(s.original_scale_number.value == Approx(10000.0).epsilon(1e-12));
    REQUIRE(s.scaled_scale_number.value == Approx(50.0).epsilon(1e-12));
}

TEST_CASE("study: an undistorted scheme keeps every group of the case and says so", "[study]") {
    for (const char* scheme : {"exact", "kept_gravity", "kept_gravity_kept_modulus"}) {
        const ScaleStudy s = study(zirconia(scheme));
        for (const GroupChange& g : s.groups) {
            INFO(scheme << ": " << g.group.name);
            CHECK(g.kept);
        }
        REQUIRE(s.findings.at(0).name == "broken_groups");
        REQUIRE(s.findings.at(0).judgement == Judgement::fine);
        REQUIRE(s.other_invariants.empty());
    }
}

TEST_CASE("study: the paper's scheme breaks what it breaks, by the powers of h that theory gives",
          "[study]") {
    // Grain h, everything else 1: size ratio 1/h, inertial number h; under weight_bond the stress
    // Bond number h.
    const ScaleStudy s = paper_study(Invariant::weight_bond);
    REQUIRE(group(s, "weight_bond").kept);
    REQUIRE(group(s, "stress_bond").ratio == Approx(200.0).epsilon(1e-12));
    REQUIRE(group(s, "inertial_number").ratio == Approx(200.0).epsilon(1e-12));
    REQUIRE(group(s, "size_ratio").ratio == Approx(0.005).epsilon(1e-12));
    REQUIRE(group(s, "restitution").kept);
    REQUIRE(group(s, "sliding_friction").scaled == 0.8);
    REQUIRE(s.findings.at(0).judgement == Judgement::caution);
    REQUIRE_THAT(s.findings.at(0).text, Catch::Contains("stress_bond x 200"));
}

TEST_CASE("study: the stated adhesion is shown under the other invariants too", "[study]") {
    const ScaleStudy s = paper_study(Invariant::weight_bond);
    REQUIRE(s.adhesion->original.surface_energy.value() == Approx(4.75e-6).epsilon(1e-12));
    REQUIRE(s.other_invariants.size() == 3);
    REQUIRE(s.other_invariants[0].invariant == Invariant::stress_bond);
    REQUIRE(s.other_invariants[0].original.surface_energy.value() == Approx(9.5e-4).epsilon(1e-12));
}

TEST_CASE(
    "study: a scheme that leaves adhesion open asks for the invariant, adhesion stated or not",
    "[study][domain]") {
    ScaleInput in = zirconia("paper");
    REQUIRE_THROWS_AS(study(in), InvalidParameter);
    in.adhesion.reset();
    REQUIRE_THROWS_WITH(study(in), Catch::StartsWith("invariant: got none"));
}

TEST_CASE("study: a powder without adhesion has no adhesion groups and no prediction", "[study]") {
    ScaleInput in = zirconia("exact");
    in.adhesion.reset();
    const ScaleStudy s = study(in);
    REQUIRE_FALSE(s.adhesion);
    REQUIRE(std::none_of(s.groups.begin(), s.groups.end(),
                         [](const GroupChange& g) { return g.group.name == "weight_bond"; }));
}

TEST_CASE("study: the heap on the base gives the grains, h^3 fewer of them after scaling",
          "[study]") {
    // 0.4 * pi D^3 tan(45 deg) / 24 over pi d^3 / 6 = 0.1 (D/d)^3.
    const ScaleStudy s = paper_study(Invariant::stress_bond);
    const double ratio = 80e-3 / 1.2e-6;
    REQUIRE(*s.original_cost.grains == Approx(0.1 * ratio * ratio * ratio).epsilon(1e-12));
    REQUIRE(*s.scaled_cost.grains == Approx(*s.original_cost.grains / 8e6).epsilon(1e-12));
    REQUIRE(s.originals_per_grain == Approx(8e6).epsilon(1e-12));
}

TEST_CASE(
    "study: the speed of the groups is that of the drop, else of a fall over half the apparatus",
    "[study]") {
    // v / sqrt(g D) with v^2 = 2 g H, H = 65 mm, D = 6 mm; without a drop v^2 = g D.
    ScaleInput in = zirconia("exact");
    REQUIRE(group(study(in), "froude").original == Approx(std::sqrt(130.0 / 6.0)).epsilon(1e-12));
    in.grain.drop_height.reset();
    REQUIRE(group(study(in), "froude").original == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("study: fluid and bridges bring their groups", "[study]") {
    ScaleInput in = zirconia("exact");
    in.fluid = Fluid{1.2 * si::kilogrammes_per_cubic_metre, 1.8e-5 * si::pascals * si::seconds};
    in.liquid = Liquid{0.072 * si::newtons_per_meter, 1e-21 * si::cubic_meters};
    const ScaleStudy s = study(in);
    for (const char* name :
         {"reynolds", "stokes", "galilei", "capillary", "capillary_bond", "liquid_content"}) {
        REQUIRE(group(s, name).kept);
    }
}

TEST_CASE("study: no group is listed twice", "[study]") {
    const ScaleStudy s = paper_study(Invariant::stress_bond);
    std::set<std::string> names;
    for (const GroupChange& g : s.groups) REQUIRE(names.insert(g.group.name).second);
}
