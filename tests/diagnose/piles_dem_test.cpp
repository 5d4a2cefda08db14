// SPDX-License-Identifier: MIT
// The whole way with heaps that the core pours: sixty grains on glued ones, so that it takes seconds.
#include "diagnose/bulk_effects.hpp"
#include "diagnose/diagnose.hpp"
#include "tests/diagnose/pile_case.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <numbers>
#include <random>

namespace {

constexpr double d = 0.002, noise = 5e-5;  // m

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

// Grains so soft (E/(rho g d) = 4e3) that steps are long: both sides have them.
cases::Case sixty(double weights, std::uint64_t seed) {
    const pile_case::Heaps sixty{"sixty", d, 2e5, "14 mm", 60.0, noise, 0.4, {0.15, 0.9}};
    cases::Case c = pile_case::without_recordings(sixty);
    cases::Experiment e = pile_case::experiment(sixty);
    rigs::World truth = rigs::world_of(c, e);
    if (weights > 0.0) {
        const double weight = 2500.0 * std::numbers::pi / 6.0 * d * d * d * 9.81;
        truth.physics.insert("adhesion");
        truth.parameters["work_of_adhesion"] =
            weights * weight / (1.5 * std::numbers::pi * d / 4.0);
    }
    std::mt19937_64 random(seed);
    for (std::uint64_t k = 0; k < 2; ++k) {
        const rigs::Heap heap =
            poured(rigs::pile_setup(diagnose::in_world(c, truth), e, 10 * seed + k));
        e.id = "heap-" + std::to_string(k + 1);
        e.recording = pile_case::scan(heap, 16, 28, d / 8, noise, random);
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
