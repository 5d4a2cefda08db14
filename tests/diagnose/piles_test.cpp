// SPDX-License-Identifier: MIT
// The whole judge on heaps that are not poured but made up: cones whose slope follows the friction, and whose foot and roughness
// follow the adhesion, so that every answer is known beforehand.
#include "diagnose/diagnose.hpp"
#include "tests/diagnose/pile_case.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using diagnose::Answer;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double d = 0.002, base = 0.024;  // m
constexpr double noise = 1e-4;             // m

// Grains all over a cone; `bond` in grain weights makes the flank concave and the surface rough. Scatter of seeds: of the slope and
// of every grain.
rigs::Heap cone(double friction, double bond, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> even;
    rigs::Heap h{.centre = {}, .radius = {}, .base_radius = base / 2.0};
    const double slope = 0.25 + 0.4 * friction + 0.01 * normal(random), strength = std::log1p(bond);
    const double R = base / 2.0;
    for (int k = 0; k < 500; ++k) {
        const double r = R * std::sqrt(even(random)), azimuth = 2.0 * pi * even(random);
        const double z = slope * (R - r) + 0.15 * strength * R * std::pow(1.0 - r / R, 2) +
                         (2e-4 + 1e-4 * strength) * normal(random);
        h.centre.push_back({r * std::cos(azimuth), r * std::sin(azimuth), z});
        h.radius.push_back(d / 2.0);
    }
    return h;
}

rigs::Heap of(const rigs::PileSetup& s) {
    const double weight = s.density * pi / 6.0 * d * d * d * s.gravity;
    std::uint64_t seed = 0;  // what the setup drew from its own
    for (const double x : s.feed_x)
        seed = seed * 31 + static_cast<std::uint64_t>(1e9 * std::abs(x));
    return cone(s.grains.sliding_friction, 1.5 * pi * s.grains.work_of_adhesion * d / 4.0 / weight,
                seed);
}

cases::Recording recording(const rigs::Heap& heap, unsigned seed) {
    std::mt19937_64 random(seed);
    return pile_case::scan(heap, 12, 40, base / 80.0, noise, random);
}

cases::Case piles(double friction, double bond, unsigned seed) {
    const pile_case::Heaps cones{"cones", d, 5e6, "24 mm", 20.0, noise, 0.5, {0.1, 0.9}};
    cases::Case c = pile_case::without_recordings(cones);
    cases::Experiment e = pile_case::experiment(cones);
    for (unsigned k = 0; k < 2; ++k) {
        e.id = "heap-" + std::to_string(k + 1);
        e.recording = recording(cone(friction, bond, 1000 * seed + k), 77 * seed + k);
        c.experiments.push_back(e);
    }
    return c;
}

diagnose::Verdict verdict_of(const cases::Case& c) {
    diagnose::Settings settings;
    settings.pour = [](const std::vector<rigs::PileSetup>& setups) {
        std::vector<rigs::Heap> heaps;
        for (const rigs::PileSetup& s : setups) heaps.push_back(of(s));
        return heaps;
    };
    return diagnose::diagnose(c, settings, [](cases::Case&) {});
}

}  // namespace

TEST_CASE("heaps as the model makes them are consistent, whatever their friction",
          "[diagnose][piles]") {
    const diagnose::Verdict v = verdict_of(piles(0.6, 0.0, 1));
    CHECK(v.answer == Answer::consistent);
    REQUIRE(!v.refitted.empty());
    CHECK(v.refitted[0].name == "sliding_friction");
    CHECK(v.refitted[0].low < 0.6);
    CHECK(v.refitted[0].high > 0.6);
}

TEST_CASE("an adhesion that was left out is named and its strength found", "[diagnose][piles]") {
    const double bond = 8.0;
    const diagnose::Verdict v = verdict_of(piles(0.4, bond, 2));
    REQUIRE(v.answer == Answer::explained);
    REQUIRE(v.effects.size() == 1);
    CHECK(v.effects[0].name == "adhesion");
    const double weight = 2500.0 * pi / 6.0 * d * d * d * 9.81;
    const double w = bond * weight / (1.5 * pi * d / 4.0);
    REQUIRE(v.effects[0].parameters.size() == 1);
    CHECK(v.effects[0].parameters[0].value == Approx(w).epsilon(0.5));
    REQUIRE(!v.located.empty());
    CHECK(v.located[0].experiment.starts_with("heap-"));
    CHECK(v.fit->nrmse_extended < v.fit->nrmse_base);
}

TEST_CASE("a scanner that reads too high or low is found, and no physics in its place",
          "[diagnose][piles]") {
    const double offset =
        GENERATE(0.0015, -0.0028);  // the second leaves nothing but the top above the base
    cases::Case c = piles(0.4, 0.0, 5);
    for (cases::Experiment& e : c.experiments)
        for (cases::Column& column : e.recording->columns)
            if (column.name == "z")
                for (double& z : column.values) z += offset;
    const diagnose::Verdict v = verdict_of(c);
    REQUIRE(v.answer == Answer::explained);
    REQUIRE(v.effects.size() == 1);
    CHECK(v.effects[0].name == "measurement_offset");
    const diagnose::Estimate& e = v.effects[0].parameters[0];  // 90 %: 3.29 deviations wide
    CHECK(std::abs(e.value - offset) < 3.0 * (e.high - e.low) / 3.29);
}

TEST_CASE("the same seed and heaps give the same verdict", "[diagnose][piles]") {
    const cases::Case c = piles(0.4, 2.0, 3);
    const diagnose::Verdict a = verdict_of(c), b = verdict_of(c);
    CHECK(a.p_value == b.p_value);
    REQUIRE(a.hypotheses.size() == b.hypotheses.size());
    for (std::size_t k = 0; k < a.hypotheses.size(); ++k)
        CHECK(a.hypotheses[k].probability == b.hypotheses[k].probability);
}

TEST_CASE("an angle of repose alone names nothing and asks for the profile", "[diagnose][piles]") {
    cases::Case c = piles(0.4, 0.0, 4);
    for (cases::Experiment& e : c.experiments)
        e.recording = {{{"angle_of_repose", "rad", {0.87, 0.96, 0.98, 0.9, 0.91, 0.93, 0.95}, {}},
                        {"estimator", "", {}, std::vector<std::string>(7, "cone")}}};
    const diagnose::Verdict v = verdict_of(c);
    CHECK(v.answer == Answer::undecided);
    CHECK(v.effects.empty());
    REQUIRE(v.next_experiment.has_value());
    CHECK(v.next_experiment->rig == "pile");
    CHECK(v.next_experiment->channels == std::vector<std::string>{"azimuth", "z"});
    CHECK(v.next_experiment->conditions.at("base_diameter") == "24 mm");
    CHECK(v.next_experiment->rows == 12 * 8);  // six grains across the radius, eight spots at least
    REQUIRE(v.warnings.size() == 2);
    // Mean of the seven twice: 0.9286 rad, 53.20 deg.
    CHECK(v.warnings[0].find("14 angles say: their mean is 53.2 deg") != std::string::npos);
    CHECK(v.warnings[1].find("sliding friction") != std::string::npos);
    double none = 0.0, all = 0.0;
    for (const diagnose::Hypothesis& h : v.hypotheses) {
        all += h.probability;
        if (h.effects.empty()) none = h.probability;
    }
    CHECK(all == Approx(1.0));
    CHECK(none == Approx(0.35 / 0.95));  // docs/diagnose.md, pairs apart
}

namespace {

// Pulled apart under a controlled separation, down to the fold where two JKR grains let go (Johnson, Kendall & Roberts 1971), and on.
cases::Experiment force_curve(double work, unsigned seed) {
    cases::Experiment e = pile_case::experiment({"cones", d, 5e6, "24 mm", 20.0, noise, 0.5, {}});
    const double e_star = 0.5 * 5e6 / (1.0 - 0.25 * 0.25), r_star = d / 4.0;
    const double po = 1.5 * pi * work * r_star, err = 0.03 * po;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const auto overlap = [&](double a) {
        return a * a / r_star - std::sqrt(2.0 * pi * a * work / e_star);
    };
    // d(overlap)/da = 0
    const double fold = std::cbrt(pi * work * r_star * r_star / (8.0 * e_star));
    std::vector<double> separation, force;
    for (int k = 0; k < 60; ++k) {
        const double a = fold * (4.0 - 2.95 * k / 59.0);
        separation.push_back(-overlap(a));
        force.push_back(4.0 * e_star * a * a * a / (3.0 * r_star) -
                        std::sqrt(8.0 * pi * a * a * a * work * e_star) + err * normal(random));
    }
    for (int k = 1; k <= 20; ++k) {
        separation.push_back(-overlap(fold) * (1.0 + 0.1 * k));
        force.push_back(err * normal(random));
    }
    e.id = "curve", e.rig = "pull_off";
    e.conditions.members = {{"counterpart", pile_case::text("counterpart", "grain")},
                            {"preload", pile_case::text("preload", "3 mN")}};
    e.noise = {{"force", err}};
    cases::Column branch{"branch", "", {}, {}};
    branch.words.assign(separation.size(), "retract");
    e.recording = cases::Recording{
        {{"separation", "m", separation, {}}, {"force", "N", force, {}}, std::move(branch)}};
    return e;
}

}  // namespace

TEST_CASE("an adhesion named in a force curve foretells a heap that was held out",
          "[diagnose][piles]") {
    const double bond = 8.0, weight = 2500.0 * pi / 6.0 * d * d * d * 9.81;
    cases::Case c = piles(0.4, bond, 6);
    c.model.parameters["sliding_friction"].range.reset();
    for (cases::Experiment& e : c.experiments) e.held_out = true;
    c.experiments.push_back(force_curve(bond * weight / (1.5 * pi * d / 4.0), 9));
    const diagnose::Verdict v = verdict_of(c);
    REQUIRE(v.answer == Answer::explained);
    CHECK(v.effects.at(0).name == "adhesion");
    REQUIRE(v.held_out);
    // What is left is the scatter of one heap, and that of the mean of eight.
    CHECK(v.held_out->nrmse_extended < 1.3 * v.held_out->noise_floor);
    CHECK(v.held_out->nrmse_base > 1.8 * v.held_out->nrmse_extended);
}
