// SPDX-License-Identifier: MIT
// The published calibration of zirconia powder, Niu et al. (2026), Coatings 16, 1016. Expected
// values are the paper's printed numbers, or were computed by hand or by an independent script from
// its tables; tolerances are half of the last digit given.
#include "calibrate/replay.hpp"

#include "calibrate/observations.hpp"
#include "cases/read_case.hpp"
#include "scaling/errors.hpp"
#include "scaling/numbers.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace calibrate;
namespace si = scaling::si;

namespace {

constexpr const char* zirconia = "data/zirconia/case.json";

// Tables 4 and 11 and sections 4.3.1 to 4.3.3, by hand.
scaling::ScaleInput paper_input() {
    const auto m = si::meters;
    scaling::ScaleInput input{};
    input.grain = {1.2e-6 * m,
                   scaling::in_si<scaling::Density>(5600.0),
                   scaling::youngs_modulus(scaling::in_si<scaling::Pressure>(60e6), 0.3),
                   0.3,
                   scaling::in_si<scaling::Acceleration>(9.81),
                   65e-3 * m};
    input.apparatus_length = 6e-3 * m;
    input.base_diameter = 80e-3 * m;
    input.adhesion =
        scaling::StatedAdhesion{scaling::in_si<scaling::EnergyPerArea>(0.38), scaling::Of::scaled};
    input.scheme = scaling::named_scheme("paper");
    input.h = 200.0;
    input.invariant = scaling::Invariant::weight_bond;
    input.stated.grains = {1e6, 1e5};
    input.stated.time_step = 7.78e-7 * si::seconds;
    input.stated.simulated_time = 10.0 * si::seconds;
    input.stated.wall_time = 21600.0 * si::seconds;
    return input;
}

const Replayed& paper() {
    static const Replayed r =
        replayed(read_published(zirconia), cases::read_case(zirconia), paper_input());
    return r;
}

const EffectFit& without(const std::string& term) {
    const auto& fits = paper().audit.fits;
    const auto found = std::find_if(fits.begin(), fits.end(),
                                    [&](const EffectFit& f) { return f.left_out == term; });
    REQUIRE(found != fits.end());
    return *found;
}

double effect(const EffectFit& fit, const std::string& factor) {
    for (const Effect& e : fit.effects)
        if (e.factor == factor) return e.estimate;
    return 0.0;
}

const Observation& named(const std::string& name) {
    const auto& all = paper().observations;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Observation& o) { return o.name == name; });
    INFO(name);
    REQUIRE(found != all.end());
    return *found;
}

// published.json with `from` replaced by `to`, in a folder of its own.
std::string changed(const std::string& from, const std::string& to) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / "similitude-published";
    std::filesystem::create_directories(folder);
    std::ifstream in("data/zirconia/published.json");
    std::stringstream text;
    text << in.rdbuf();
    std::string body = text.str();
    const std::size_t at = body.find(from);
    REQUIRE(at != std::string::npos);
    body.replace(at, from.size(), to);
    std::ofstream(folder / "published.json") << body;
    return (folder / "case.json").string();
}

}  // namespace

TEST_CASE("printed: a number agrees when it rounds to the printed digits", "[calibrate][exact]") {
    const Printed effect{"4.944", 4.944};
    CHECK(effect.agrees(4.94449));
    CHECK(effect.agrees(4.9435));
    CHECK_FALSE(effect.agrees(4.9446));
    CHECK(Printed{"19.018", 19.018}.agrees(76.07 / 4.0));  // 19.0175: half goes up
    CHECK(Printed{"10000", 1e4}.agrees(10000.4));
    CHECK_FALSE(Printed{"10000", 1e4}.agrees(10001.0));
    CHECK(Printed{"7.78e-7 s", 7.78e-7}.agrees(7.7849e-7));
    CHECK_FALSE(Printed{"7.78e-7 s", 7.78e-7}.agrees(7.87e-7));
}

// The Rayleigh time is 3.9351e-6 s; 20 % of it is 7.870e-7 s, the paper prints 7.78e-7 s.
TEST_CASE("replay: every printed number but the time step comes out again", "[calibrate][replay]") {
    const Replay& r = paper().replay;
    CHECK(r.mismatches == 1);
    int table_7 = 0, errors = 0;
    for (const Recomputed& d : r.digits) {
        table_7 += d.table == "Table 7";
        errors += d.what.find("relative error, %") != std::string::npos;
        if (d.agrees) continue;
        CHECK(d.printed.text == "7.78e-7 s");
        CHECK(d.value == Approx(7.870e-7).margin(5e-11));
    }
    CHECK(table_7 == 7 * 8);
    CHECK(errors == 6 + 9);
    CHECK(r.line.slope == Approx(97.4).margin(1e-9));
    CHECK(r.line.intercept == Approx(35.172).margin(1e-9));
    CHECK(r.line.solution == Approx(0.189918).margin(5e-7));
    CHECK(r.line.at_printed == Approx(53.678).margin(5e-4));
}

TEST_CASE("replay: a changed digit is listed, and so is a changed response",
          "[calibrate][replay]") {
    const scaling::ScaleStudy study = scaling::study(paper_input());
    const Replay digit = replay(read_published(changed("\"4.944\"", "\"4.945\"")), study);
    CHECK(digit.mismatches == 2);
    // One response more by 0.1 changes sums and means of all seven factors.
    const Replay run = replay(read_published(changed("\"26.46\"", "\"26.56\"")), study);
    CHECK(run.mismatches >= 1 + 7 * 3);
}

TEST_CASE("published: what cannot be read is refused with its place", "[calibrate][domain]") {
    CHECK_THROWS_WITH(read_published("data/recordings/none/case.json"),
                      Catch::Contains("published.json") && Catch::Contains("docs/calibrate.md"));
    CHECK_THROWS_WITH(read_published(changed("[[-1,  1, -1,  1", "[[-1,  2, -1,  1")),
                      Catch::Contains("screening.runs[0]") && Catch::Contains("-1 or 1"));
    CHECK_THROWS_WITH(read_published(changed("\"97.4\"", "\"steep\"")),
                      Catch::Contains("interpolation.slope"));
    CHECK_THROWS_WITH(read_published(changed("\"runs\": [4, 5]", "\"runs\": [4, 50]")),
                      Catch::Contains("interpolation.runs[1]"));
    CHECK_THROWS_WITH(read_published(changed("\"claimed\": [\"B\"", "\"claimed\": [\"K\"")),
                      Catch::Contains("factors") && Catch::Contains("\"K\""));
    CHECK_THROWS_WITH(read_published(changed("\"letter\": \"C\"", "\"letter\": \"D\"")),
                      Catch::Contains("must be \"C\""));
    CHECK_THROWS_WITH(read_published(changed("[[\"0.9\", \"0.27\"], \"60.11\", \"12.00\"]", "[]")),
                      Catch::Contains("second_ascent.rows[5]"));
}

TEST_CASE("audit: without its failed runs the screening has rank 7 of 8", "[calibrate][audit]") {
    const Audit& a = paper().audit;
    CHECK(a.planned_orthogonal);
    CHECK(a.planned_rank == 8);
    CHECK(a.rank == 7);
    REQUIRE(a.null_vectors.size() == 1);
    CHECK(a.null_vectors[0].text == "1 - B + D - E + F + G = 0");
    CHECK(a.d_efficiency == 0.0);
    CHECK(a.estimable == std::vector<bool>{false, true, false, true, false, false, false, false});
    const auto& pairs = a.estimable_pairs;
    CHECK(std::find(pairs.begin(), pairs.end(), "B + G") != pairs.end());
    CHECK(std::find(pairs.begin(), pairs.end(), "B - E") != pairs.end());
    CHECK(a.aliases.size() == 7 * 15);
    CHECK_FALSE(a.ranking.identifiable);
}

TEST_CASE("audit: fits with the same residuals order the effects otherwise", "[calibrate][audit]") {
    CHECK(paper().audit.fits.size() == 5);
    for (const EffectFit& fit : paper().audit.fits) {
        CHECK(fit.sum_of_squares == Approx(17.12).margin(0.005));
        CHECK(fit.degrees_of_freedom == 3);
        CHECK(fit.spread == Approx(2.39).margin(0.005));
    }
    CHECK(effect(without("G"), "B") == Approx(5.88).margin(0.005));
    CHECK(effect(without("G"), "E") == Approx(0.49).margin(0.005));
    CHECK(effect(without("G"), "D") == Approx(-1.55).margin(0.005));
    CHECK(effect(without("G"), "F") == Approx(-1.72).margin(0.005));
    CHECK(effect(without("B"), "E") == Approx(-5.40).margin(0.005));
    CHECK(effect(without("B"), "G") == Approx(5.88).margin(0.005));
    CHECK(effect(without("D"), "G") == Approx(1.55).margin(0.005));
    CHECK(paper().audit.ranking.largest_t == Approx(3.02).margin(0.005));
    CHECK(paper().audit.ranking.t_needed == Approx(3.182).margin(5e-4));  // any t table, 3 dof
}

TEST_CASE("audit: what a failed run counts as decides signs", "[calibrate][audit]") {
    const Audit& a = paper().audit;
    const std::vector<double> g{-5.4, -3.7, -2.1, -0.4, 0.6}, e{5.9, 4.2, 2.6, 0.9, -0.1};
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(a.imputed[k].effects[6] == Approx(g[k]).margin(0.05));
        CHECK(a.imputed[k].effects[4] == Approx(e[k]).margin(0.05));
    }
    CHECK(a.sign_changes[4].value() == Approx(17.7).margin(0.05));
    CHECK(a.sign_changes[6].value() == Approx(16.2).margin(0.05));
    // Both failed runs lie at B = E = -1 and D = F = G = +1.
    for (const CensoredEffect& slope : a.feasibility->slopes) {
        const bool up = slope.factor == "B" || slope.factor == "E";
        const bool down = slope.factor == "D" || slope.factor == "F" || slope.factor == "G";
        if (up) CHECK(slope.estimate > 0.0);
        if (down) CHECK(slope.estimate < 0.0);
    }
    for (const ImpliedRange& r : a.implied) {
        if (r.factor == "E") CHECK(std::isinf(r.effect.high));
        if (r.factor == "G") CHECK(std::isinf(r.effect.low));
    }
}

TEST_CASE("audit: the orthogonal test fixes the surface energy and not the friction",
          "[calibrate][audit]") {
    const AnalysisOfVariance& v = paper().replay.orthogonal;
    CHECK(v.factors[0].sum_of_squares == Approx(0.66).margin(0.005));
    CHECK(v.factors[0].f == Approx(0.48).margin(0.005));
    CHECK(v.factors[1].sum_of_squares == Approx(110.2).margin(0.05));
    CHECK(v.factors[1].f == Approx(80.0).margin(0.5));
    CHECK(v.residual.sum_of_squares == Approx(2.75).margin(0.005));
    CHECK(v.spread == Approx(0.83).margin(0.005));
    const std::vector<Crossing>& c = paper().replay.crossings;
    REQUIRE(c.size() == 3);
    CHECK(c[0].second == Approx(0.1954).margin(5e-5));
    CHECK(c[1].second == Approx(0.1899).margin(5e-5));
    CHECK(c[2].second == Approx(0.1969).margin(5e-5));
    CHECK(paper().replay.pooled_solution == Approx(0.1908).margin(5e-5));
}

TEST_CASE("audit: the ascent did not go along the effects", "[calibrate][audit]") {
    const std::vector<AscentStep>& s = paper().replay.steps;
    CHECK(s[1].by_effects == Approx(0.0024).margin(5e-5));
    CHECK(s[2].by_effects == Approx(-0.055).margin(5e-4));
}

// Facts recomputed from the paper's tables, one observation each.
TEST_CASE("audit: findings carry the numbers that hand computing gives", "[calibrate][audit]") {
    CHECK(named("runs_used_again").value == 3.0);
    CHECK(named("half_width_of_95_percent").value == Approx(7.99).margin(0.005));
    CHECK(named("solutions_over_the_readings").value == Approx(0.214 - 0.152).margin(1e-3));
    CHECK(named("funnel_cone_angle").value == Approx(57.6).margin(0.05));
    CHECK(named("rank_of_the_path").value == 2.0);
    CHECK(named("stated_time_step_over_computed").value == Approx(0.9885).margin(5e-5));
    CHECK(named("stated_grain_counts_apart").value == Approx(10.0));
    CHECK(named("mass_of_the_simulated_grains").value == Approx(40.5e-3).margin(5e-5));
    CHECK(named("implied_grain_steps_per_second").value == Approx(5.95e8).margin(5e5));
    CHECK(named("rayleigh_time_over_original").value == Approx(200.0));
    CHECK(named("factor_of_surface_energy_under_exact_scaling").value == Approx(200.0));
    CHECK(named("factor_of_gravity_under_exact_scaling").value == Approx(1.0 / 200.0));
    CHECK(named("simulated_base_over_real").value == Approx(0.625));
    CHECK(named("outlet_over_scaled_grain").value == Approx(25.0));
    CHECK(named("weight_over_adhesion_scaled_over_original").value == Approx(4e4));
    CHECK(named("pull_off_in_grain_weights").value == Approx(270.0).margin(0.5));
    CHECK(named("original_surface_energies_apart").value == Approx(200.0));  // h^1 against h^2
    CHECK(named("adhesion_for_the_softened_modulus").value == Approx(0.0562).margin(5e-5));
    CHECK(named("packing_fraction_measured").value == Approx(0.366).margin(5e-4));
    CHECK(named("span_of_the_sizes").value == Approx(4.02).margin(5e-3));
    CHECK(named("confirmed_off_target_over_spread").value == Approx(0.2 / 0.83).margin(2e-3));
    CHECK(named("answer_over_high_level_of_G").value == Approx(9.5));
    CHECK(named("answer_over_high_level_of_B").value == Approx(2.0));
    CHECK(std::isnan(named("walls_without_adhesion").value));
    CHECK_THAT(named("funnel_cone_angle").text, Catch::Contains("GB/T 16913"));
}
