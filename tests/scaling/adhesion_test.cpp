// SPDX-License-Identifier: MIT
#include "scaling/adhesion.hpp"

#include "scaling/adhesion_findings.hpp"
#include "scaling/errors.hpp"
#include "scaling/numbers.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

using namespace scaling;

namespace {

const EnergyPerArea joule_per_area = 1.0 * si::newtons_per_meter;

Exponents exponents(Rational h, Rational softening = 0) { return {h, softening}; }

// The paper's powder: D50 1.2 um, 5600 kg/m^3, G 60 MPa, nu 0.3.
Grain zirconia() {
    return {.diameter = 1.2e-6 * si::meters,
            .density = 5600.0 * si::kilogrammes_per_cubic_metre,
            .youngs_modulus = youngs_modulus(60e6 * si::pascals, 0.3),
            .poisson_ratio = 0.3,
            .gravity = 9.81 * si::meters_per_second_squared,
            .drop_height = std::nullopt};
}

ScaleMap paper(double h, double softening = 1.0) {
    return ScaleMap::solve(named_scheme("paper"), h, softening);
}

AdhesionPrediction of_original(double surface_energy, Invariant invariant, double h = 200.0) {
    return predict_adhesion(zirconia(), paper(h), invariant,
                            {2.0 * surface_energy * joule_per_area, Of::original});
}

const Finding& finding(const AdhesionPrediction& p, const std::string& name) {
    const auto found = std::find_if(p.findings.begin(), p.findings.end(),
                                    [&](const Finding& f) { return f.name == name; });
    INFO(name);
    REQUIRE(found != p.findings.end());
    return *found;
}

}  // namespace

TEST_CASE("adhesion: the exponent of w under each invariant, apparatus kept and grown",
          "[adhesion][exact]") {
    // By hand with E, g, rho kept, R = h, D = 1 or h, v^2 = g D:
    //   weight: w R / R^3; stress: w R / (D R^2); cohesion: (w^5 / R^8)^(1/3);
    //   sticking: w^(5/3) R^(4/3) R^-3 / v^2.
    const auto [invariant, kept, grown, softening] =
        GENERATE(table<Invariant, Rational, Rational, Rational>({
            {Invariant::weight_bond, Rational(2), Rational(2), Rational(0)},
            {Invariant::stress_bond, Rational(1), Rational(2), Rational(0)},
            {Invariant::cohesion_number, Rational(8, 5), Rational(8, 5), Rational(2, 5)},
            {Invariant::sticking_velocity, Rational(1), Rational(8, 5), Rational(2, 5)},
        }));
    const Scheme grown_scheme = with_scaled_apparatus(named_scheme("paper"));
    INFO(to_string(invariant));
    CHECK(adhesion_exponents(paper(200.0), invariant) == exponents(kept));
    CHECK(adhesion_exponents(ScaleMap::solve(grown_scheme, 200.0), invariant) == exponents(grown));
    CHECK(adhesion_exponents(paper(200.0, 0.01), invariant) == exponents(kept, softening));
    CHECK(adhesion_exponents(ScaleMap::solve(grown_scheme, 200.0, 0.01), invariant) ==
          exponents(grown, softening));
    CHECK(modulus_exponent(invariant) == softening);
}

TEST_CASE("adhesion: keeping the invariant keeps its group, to the last rational", "[adhesion]") {
    const std::vector<Variable> variables = {{"density", "density", 1.0},
                                             {"gravity", "gravity", 1.0},
                                             {"grain_diameter", "length", 1.0},
                                             {"apparatus_length", "apparatus_length", 1.0},
                                             {"youngs_modulus", "youngs_modulus", 1.0},
                                             {"velocity", "velocity", 1.0},
                                             {"work_of_adhesion", "work_of_adhesion", 1.0}};
    for (const Invariant invariant : all_invariants()) {
        const ScaleMap map = with_adhesion(paper(200.0, 0.01), invariant);
        for (const PiGroup& g : named_groups(0.3)) {
            if (g.name == to_string(invariant)) CHECK(change_of(g, variables, map) == Exponents{});
        }
    }
}

TEST_CASE("adhesion: which real surface energy the paper's 0.19 J/m^2 at h = 200 stands for",
          "[adhesion][paper]") {
    // 0.19 / 200, / 200^(8/5), / 200^2.
    const auto [invariant, real] =
        GENERATE(table<Invariant, double>({{Invariant::stress_bond, 9.5e-4},
                                           {Invariant::cohesion_number, 3.95e-5},
                                           {Invariant::weight_bond, 4.75e-6}}));
    const AdhesionPrediction p =
        predict_adhesion(zirconia(), paper(200.0), invariant, {0.38 * joule_per_area, Of::scaled});
    REQUIRE(p.original.surface_energy.value() == Approx(real).epsilon(2e-3));  // three digits
    REQUIRE(p.scaled.surface_energy.value() == Approx(0.19).epsilon(1e-14));
    REQUIRE(finding(p, "original_surface_energy_over_lowest").judgement == Judgement::caution);
    REQUIRE(p.physically_usable);
}

TEST_CASE(
    "adhesion: the pull-off of the paper's grain in its weights, 270 with 0.19 J/m^2 per surface",
    "[adhesion][paper]") {
    // w = 0.38: twice the 135 of w = 0.19 (numbers_test).
    const AdhesionPrediction p = predict_adhesion(zirconia(), paper(200.0), Invariant::weight_bond,
                                                  {0.38 * joule_per_area, Of::scaled});
    REQUIRE(p.scaled.pull_off_in_grain_weights == Approx(270.2).epsilon(5e-4));
    REQUIRE(p.original.pull_off_in_grain_weights ==
            Approx(p.scaled.pull_off_in_grain_weights).epsilon(1e-12));
    REQUIRE(p.scaled.pull_off_force.value() ==
            Approx(1.5 * 3.14159265358979 * 0.38 * 60e-6).epsilon(1e-12));
}

TEST_CASE("adhesion: a real 30 mJ/m^2 at h = 200 under weight_bond is no usable grain",
          "[adhesion][findings]") {
    // gamma h^2 = 1200 J/m^2; a0^3 = 9 pi (2 gamma) R*^2 / (2 E*) = (0.94 R)^3 with R* = 60 um, E*
    // = 60 MPa / 0.7.
    const AdhesionPrediction p = of_original(0.03, Invariant::weight_bond);
    REQUIRE(p.scaled.surface_energy.value() == Approx(1200.0).epsilon(1e-12));
    const Finding& neck = finding(p, "zero_load_contact_radius_over_radius");
    REQUIRE(neck.value == Approx(0.94).epsilon(5e-3));  // two digits
    REQUIRE(neck.judgement == Judgement::unusable);
    REQUIRE_FALSE(p.physically_usable);
    const Finding& usable = finding(p, "physically_usable");
    REQUIRE(usable.judgement == Judgement::unusable);
    // a0/R ~ h^(1/3): 0.3 is reached at 200 (0.3/0.938)^3 = 6.5. stress_bond keeps a0/R at 0.938 /
    // 200^(1/3) = 0.16.
    REQUIRE_THAT(usable.text, Catch::Contains("use h <= 6.5"));
    REQUIRE_THAT(usable.text,
                 Catch::Contains("keep stress_bond instead (6 J/m^2 per surface, a0/R 0.16)"));
    // a0/R ~ E^(-1/3): (0.938/0.3)^3 = 31 times stiffer.
    REQUIRE_THAT(usable.text, Catch::Contains("a modulus 31 times stiffer"));
}

TEST_CASE(
    "adhesion: at h = 50 the same powder has a0/R 0.59, and the advice given at h = 200 is usable",
    "[adhesion][findings]") {
    REQUIRE(finding(of_original(0.03, Invariant::weight_bond, 50.0),
                    "zero_load_contact_radius_over_radius")
                .value == Approx(0.59).epsilon(5e-3));  // two digits
    REQUIRE(of_original(0.03, Invariant::weight_bond, 6.4).physically_usable);
    REQUIRE_FALSE(of_original(0.03, Invariant::weight_bond, 6.8).physically_usable);
    REQUIRE(of_original(0.03, Invariant::stress_bond).physically_usable);
}

TEST_CASE("adhesion: the neck, overlap and gap of the scaled grain follow JKR's closed forms",
          "[adhesion][findings]") {
    const AdhesionPrediction p = predict_adhesion(zirconia(), paper(200.0), Invariant::stress_bond,
                                                  {0.38 * joule_per_area, Of::scaled});
    const double r = 120e-6, r_star = 60e-6, e_star = 60e6 / 0.7, w = 0.38, pi = 3.14159265358979;
    const double a0 = std::cbrt(9.0 * pi * w * r_star * r_star / (2.0 * e_star));
    REQUIRE(finding(p, "zero_load_contact_radius_over_radius").value ==
            Approx(a0 / r).epsilon(1e-10));
    REQUIRE(finding(p, "tear_off_gap_over_radius").value ==
            Approx(1.60877 * std::cbrt(w * w * r_star / (e_star * e_star)) / r)
                .epsilon(1e-5));  // digits printed
    // Without load delta = a0^2 / (3 R*); a grain's weight, 1/270 of the pull-off, adds less than 1
    // %.
    REQUIRE(finding(p, "overlap_over_radius").value ==
            Approx(a0 * a0 / (3.0 * r_star) / r).epsilon(0.01));
    REQUIRE(finding(p, "pull_off_in_grain_weights").value ==
            Approx(p.scaled.pull_off_in_grain_weights));
}

TEST_CASE("adhesion: a drop of 65 mm meets at 1.13 m/s, 49 sticking speeds, and dents 3.5 % of R",
          "[adhesion][findings]") {
    Grain grain = zirconia();
    grain.drop_height = 65e-3 * si::meters;
    const AdhesionPrediction p = predict_adhesion(grain, paper(200.0), Invariant::stress_bond,
                                                  {0.19 * joule_per_area, Of::scaled});
    REQUIRE(finding(p, "impact_over_sticking_speed").value ==
            Approx(49.0).epsilon(0.01));  // two digits
    REQUIRE(finding(p, "impact_overlap_over_radius").value ==
            Approx(0.035).epsilon(0.015));  // two digits
    REQUIRE(finding(p, "impact_over_sticking_speed").judgement == Judgement::caution);
}

TEST_CASE(
    "adhesion: Tabor's number says JKR for the softened powder and DMT for its stand-in under "
    "weight_bond",
    "[adhesion][findings]") {
    // (3e-7 w^2 / ((60e6/0.7)^2 (1.65e-10)^3))^(1/3): 32 for w = 0.06, 0.094 for w = 9.5e-6.
    const auto tabor = [](const AdhesionPrediction& p) {
        return finding(p, "tabor_number_original");
    };
    const AdhesionPrediction real = of_original(0.03, Invariant::stress_bond);
    REQUIRE(tabor(real).value == Approx(32.0).epsilon(0.01));
    REQUIRE(tabor(real).judgement == Judgement::fine);
    const AdhesionPrediction stand_in = predict_adhesion(
        zirconia(), paper(200.0), Invariant::weight_bond, {0.38 * joule_per_area, Of::scaled});
    REQUIRE(tabor(stand_in).value == Approx(0.0936).epsilon(0.01));
    REQUIRE(tabor(stand_in).judgement == Judgement::caution);
    REQUIRE_THAT(tabor(stand_in).text, Catch::StartsWith("DMT is the law"));
}

TEST_CASE("adhesion: a real 30 mJ/m^2 is above the least adhesive solid's 18.5 mJ/m^2",
          "[adhesion][findings]") {
    // 3.8e-20 / (24 pi (0.165e-9)^2) = 0.01851; PTFE is measured at 0.018 to 0.019 J/m^2.
    const AdhesionPrediction p = of_original(0.03, Invariant::stress_bond);
    const Finding& f = finding(p, "original_surface_energy_over_lowest");
    REQUIRE(f.value == Approx(0.03 / 0.01851).epsilon(1e-3));  // four digits
    REQUIRE(f.judgement == Judgement::fine);
}

TEST_CASE("adhesion: an open map without an invariant is refused", "[adhesion][domain]") {
    const StatedAdhesion stated{0.06 * joule_per_area, Of::original};
    REQUIRE_THROWS_AS(predict_adhesion(zirconia(), paper(200.0), std::nullopt, stated),
                      InvalidParameter);
    REQUIRE_THROWS_WITH(predict_adhesion(zirconia(), paper(200.0), std::nullopt, stated),
                        Catch::StartsWith("invariant: got none, must be stated"));
}

TEST_CASE("adhesion: an undistorted map needs no invariant, and refuses none", "[adhesion]") {
    const ScaleMap map = ScaleMap::solve(named_scheme("kept_gravity"), 200.0);
    const StatedAdhesion stated{0.06 * joule_per_area, Of::original};
    REQUIRE(
        predict_adhesion(zirconia(), map, std::nullopt, stated).scaled.work_of_adhesion.value() ==
        Approx(2400.0).epsilon(1e-12));
    REQUIRE(predict_adhesion(zirconia(), map, Invariant::sticking_velocity, stated).exponents ==
            exponents(2));
}

TEST_CASE("adhesion: an invariant against a demanded surface energy is refused",
          "[adhesion][domain]") {
    const Scheme scheme = own_scheme(
        {"density", "gravity", "youngs_modulus", "apparatus_length", "surface_energy"}, true);
    REQUIRE_THROWS_WITH(
        with_adhesion(ScaleMap::solve(scheme, 200.0), Invariant::weight_bond),
        Catch::Contains("asks for work_of_adhesion h^2, but the kept quantities demand 1"));
}

TEST_CASE("adhesion: a parameter out of range is refused by name", "[adhesion][domain]") {
    const StatedAdhesion stated{0.06 * joule_per_area, Of::original};
    const auto refused = [&](Grain grain, const char* member) {
        REQUIRE_THROWS_WITH(predict_adhesion(grain, paper(2.0), Invariant::weight_bond, stated),
                            Catch::StartsWith(std::string(member) + ": got"));
    };
    Grain grain = zirconia();
    grain.diameter = -grain.diameter;
    refused(grain, "grain.diameter");
    grain = zirconia();
    grain.density = 0.0 * grain.density;
    refused(grain, "grain.density");
    grain = zirconia();
    grain.youngs_modulus = std::nan("") * grain.youngs_modulus;
    refused(grain, "grain.youngs_modulus");
    grain = zirconia();
    grain.gravity = 0.0 * grain.gravity;
    refused(grain, "grain.gravity");
    grain = zirconia();
    grain.poisson_ratio = 0.5;
    refused(grain, "grain.poisson_ratio");
    REQUIRE_THROWS_WITH(predict_adhesion(zirconia(), paper(2.0), Invariant::weight_bond,
                                         {-0.05 * joule_per_area, Of::original}),
                        Catch::StartsWith("work_of_adhesion: got -0.05 J/m^2, must be > 0"));
    REQUIRE_THROWS_WITH(invariant_from("stressbond"), Catch::Contains("did you mean stress_bond?"));
}
