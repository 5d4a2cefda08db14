// SPDX-License-Identifier: MIT
// The whole way with heaps that the core pours: sixty grains on glued ones, so that it takes seconds.
#include "diagnose/bulk_effects.hpp"
#include "diagnose/diagnose.hpp"
#include "rigs/scanner.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <numbers>
#include <random>

namespace {

constexpr double d = 0.002, base = 0.014, noise = 5e-5;  // m

rigs::Heap poured(const rigs::PileSetup& s) {
    static std::map<std::vector<double>, rigs::Heap> known;  // by what differs here
    std::vector<double> key{s.grains.sliding_friction, s.grains.rolling_friction,
                            s.grains.work_of_adhesion, s.grains.e_star};
    key.insert(key.end(), s.feed_x.begin(), s.feed_x.end());
    key.insert(key.end(), s.radius.begin(), s.radius.end());
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    rigs::PileRun run = rigs::begin_pile(s, 1);
    while (!run.finished) rigs::advance(run, s, 100'000);
    return known[key] = rigs::record(run, s).heap;
}

cases::Value text(const std::string& key, const std::string& value) {
    return {.where = key, .kind = cases::Value::Kind::text, .written_text = value};
}

// Grains so soft (E/(rho g d) = 4e3) that steps are long: both sides have them.
cases::Case sixty(double weights, std::uint64_t seed) {
    cases::Case c;
    c.path = "sixty";
    cases::Experiment e;
    e.rig = "pile";
    e.grain.diameter.value = scaling::Length::from_value(d);
    e.grain.density.value = scaling::Density::from_value(2500.0);
    e.grain.youngs_modulus.value = scaling::Pressure::from_value(2e5);
    e.grain.poisson_ratio.value = scaling::Dimensionless(0.25);
    e.plate = {scaling::Pressure::from_value(2e5), scaling::Dimensionless(0.25)};
    e.surroundings.gravity = scaling::Acceleration::from_value(9.81);
    e.conditions.members = {{"base", text("base", "glued_grains")},
                            {"base_diameter", text("base_diameter", "14 mm")},
                            {"grains", {.where = "grains", .kind = cases::Value::Kind::number}}};
    e.conditions.members.back().second.written_number = 60.0;
    e.noise = {{"z", noise}};
    c.grain = e.grain;
    c.model.physics = {"gravity", "hertz_mindlin"};
    c.model.parameters = {{"restitution", {0.4, "1", {}}},
                          {"sliding_friction", {0.4, "1", std::pair{0.15, 0.9}}}};
    rigs::World truth = rigs::world_of(c, e);
    if (weights > 0.0) {
        const double weight = 2500.0 * std::numbers::pi / 6.0 * d * d * d * 9.81;
        truth.physics.insert("adhesion");
        truth.parameters["work_of_adhesion"] =
            weights * weight / (1.5 * std::numbers::pi * d / 4.0);
    }
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (std::uint64_t k = 0; k < 2; ++k) {
        const rigs::Heap heap =
            poured(rigs::pile_setup(diagnose::in_world(c, truth), e, 10 * seed + k));
        std::vector<double> azimuth, r;
        for (int a = 0; a < 16; ++a)
            for (int n = 0; n < 28; ++n)
                azimuth.push_back(2.0 * std::numbers::pi * a / 16), r.push_back((n + 0.5) * d / 8);
        std::vector<double> z = rigs::heights_at(heap, azimuth, r);
        for (double& v : z) v += noise * normal(random);
        e.id = "heap-" + std::to_string(k + 1);
        e.recording = cases::Recording{
            {{"azimuth", "rad", azimuth, {}}, {"r", "m", r, {}}, {"z", "m", z, {}}}};
        c.experiments.push_back(e);
    }
    return c;
}

diagnose::Verdict verdict_of(const cases::Case& c) {
    diagnose::Settings settings;
    settings.pour = [](const std::vector<rigs::PileSetup>& setups) {
        std::vector<rigs::Heap> heaps;
        for (const rigs::PileSetup& s : setups) heaps.push_back(poured(s));
        return heaps;
    };
    return diagnose::diagnose(c, settings, [](cases::Case&) {});
}

}  // namespace

TEST_CASE(
    "sixty grains poured: nothing is named where nothing is missing, and strong adhesion is seen",
    "[diagnose][piles][dem]") {
    const diagnose::Verdict none = verdict_of(sixty(0.0, 3));
    CHECK(none.answer == diagnose::Answer::consistent);
    for (const diagnose::Effect& e : none.effects) CHECK_FALSE(e.named);
    const diagnose::Verdict strong = verdict_of(sixty(30.0, 4));
    CHECK(strong.p_value < 0.01);
    REQUIRE(!strong.effects.empty());
    CHECK(strong.effects[0].name == "adhesion");
    CHECK(strong.fit->nrmse_extended < strong.fit->nrmse_base);
}
