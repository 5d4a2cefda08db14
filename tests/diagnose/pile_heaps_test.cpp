// SPDX-License-Identifier: MIT
// Where the first heaps of an apparatus lie, whatever the number of effects that may have been left out.
#include "diagnose/pile_heaps.hpp"

#include "tests/diagnose/pile_case.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

namespace {

// Widest gap that values leave between -1 and 1.
double widest_gap(std::vector<double> x) {
    x.insert(x.end(), {-1.0, 1.0});
    std::sort(x.begin(), x.end());
    double widest = 0.0;
    for (std::size_t k = 1; k < x.size(); ++k) widest = std::max(widest, x[k] - x[k - 1]);
    return widest;
}

}  // namespace

// Fourteen points a seventh of the range apart; those of a sequence of low discrepancy leave gaps up to three times as wide.
TEST_CASE("the first heaps reach all strengths of each effect and all of a free parameter",
          "[diagnose][piles]") {
    constexpr double allowed = 3.0 * 2.0 / 14.0;
    const std::string base = GENERATE("glued_grains", "flat");
    const int known = GENERATE(0, 1, 2);  // effects that the model has already
    const pile_case::Heaps heaps{"heaps", 0.002, 5e6, "24 mm", 20.0, 1e-4, 0.5, {0.1, 0.9}};
    cases::Case c = pile_case::without_recordings(heaps);
    if (known > 0)
        c.model.physics.push_back("polydispersity"),
            c.model.parameters["size_spread"] = {0.1, "1", {}};
    if (known > 1)
        c.model.physics.push_back("rolling_resistance"),
            c.model.parameters["rolling_friction"] = {0.1, "1", {}};
    cases::Experiment e = pile_case::experiment(heaps);
    e.id = "heap";
    e.conditions.members[0].second.written_text = base;
    diagnose::Settings settings;
    settings.pour = [](const std::vector<rigs::PileSetup>& setups) {
        return std::vector<rigs::Heap>(setups.size());
    };
    const diagnose::Pourer pourer(c, settings);
    diagnose::Apparatus a{.experiment = e, .stated = rigs::pile_setup(c, e, 1)};
    a.axes = diagnose::free_axes(c, e);
    REQUIRE(a.axes.size() == 1);
    for (const diagnose::BulkEffect& effect : diagnose::bulk_effects(c, e))
        a.axes.insert(a.axes.end(), effect.axes.begin(), effect.axes.end());
    pourer.pour_first(a);
    REQUIRE(a.worlds.size() == a.heaps.size());
    std::map<std::string, std::vector<double>> strengths, frictions;  // by effect, each alone
    for (const rigs::World& w : a.worlds) {
        std::vector<const diagnose::Axis*> there;
        for (const diagnose::Axis& axis : a.axes)
            if (!axis.effect.empty() && w.physics.contains(axis.effect)) there.push_back(&axis);
        if (there.size() > 1) continue;
        const std::string name = there.empty() ? "" : there[0]->effect;
        frictions[name].push_back(coordinate(a.axes[0], w));
        if (!there.empty()) strengths[name].push_back(coordinate(*there[0], w));
    }
    REQUIRE(strengths.size() + 1 == a.axes.size());
    for (const auto& [name, values] : strengths) {
        INFO(name);
        // Strengths of tilt and walls need not reach the ends of what their coordinate can be.
        CHECK(widest_gap(values) < (name.starts_with("wall_") ? 2.0 : 1.0) * allowed);
    }
    for (const auto& [name, values] : frictions) {
        INFO(name);
        CHECK(widest_gap(values) < allowed);
    }
}
