// SPDX-License-Identifier: MIT
// Each pair of materials has its laws where its contacts are, and nowhere else.
#include "cases/read_case.hpp"
#include "dem_min/forces.hpp"
#include "rigs/pile.hpp"
#include "scaling/scale_map.hpp"
#include "scaling/schemes.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <variant>

namespace {

constexpr int grain = cases::material_of_grain, plate = cases::material_of_plate, steel = 2,
              clay = 3;

// Two kinds of grains, a funnel of steel over a flat base of the plate's, with these pairs.
cases::Case mixture(const std::string& pairs) {
    const std::string text = R"({
  "format": "similitude-case/1",
  "grain": {"diameter": "2 mm", "density": "2500 kg/m^3", "youngs_modulus": "2 MPa", "poisson_ratio": 0.2,
            "sizes": [["2 mm", 0.5], ["1.5 mm", 0.5, "clay"]]},
  "plate": {"youngs_modulus": "3 MPa", "poisson_ratio": 0.4},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "materials": {
    "steel": {"youngs_modulus": "200 MPa", "poisson_ratio": 0.28},
    "clay": {"youngs_modulus": "1 MPa", "poisson_ratio": 0.3, "density": "1500 kg/m^3"}
  },
  "model": {
    "physics": ["gravity", "hertz_mindlin", "rolling_resistance", "adhesion", "wall_adhesion"],
    "parameters": {"restitution": {"value": 0.8}, "sliding_friction": {"value": 0.4}, "rolling_friction": {"value": 0.01},
      "work_of_adhesion": {"value": "0.01 J/m^2"}, "wall_work_of_adhesion": {"value": "0.02 J/m^2"},
      "wall_restitution": {"value": 0.7}, "wall_sliding_friction": {"value": 0.3}, "wall_rolling_friction": {"value": 0.02}},
    "pairs": [)" + pairs + R"(]
  },
  "experiments": [
    {"id": "heap", "rig": "pile",
     "conditions": {"base": "flat", "base_diameter": "40 mm", "grains": 60, "funnel":
       {"outlet_diameter": "10 mm", "top_diameter": "30 mm", "height": "20 mm", "outlet_height": "30 mm", "material": "steel"}}}
  ]
})";
    std::string name =
        (std::filesystem::temp_directory_path() / "similitude-materials-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    std::ofstream(name + "/case.json") << text;
    const cases::Case c = cases::read_case(name);
    std::filesystem::remove_all(name);
    return c;
}

rigs::PileSetup setup_of(const std::string& pairs) {
    const cases::Case c = mixture(pairs);
    return rigs::pile_setup(c, c.experiments.at(0), 1);
}

// Sliding friction, rolling friction, restitution's dashpot, work of adhesion.
using Numbers = std::tuple<double, double, double, double>;
Numbers numbers(const dem_min::Laws& laws) {
    const auto* jkr = std::get_if<contact::Jkr>(&laws.normal);
    const auto* rolling = std::get_if<contact::RollingEpsd>(&laws.rolling);
    return {std::get<contact::Mindlin>(laws.tangential).sliding_friction,
            rolling == nullptr ? 0.0 : rolling->rolling_friction, laws.damping.tsuji.factor,
            jkr == nullptr ? 0.0 : jkr->w};
}

// The laws of each kind of contact, by the materials on its two sides.
struct Kind {
    int i, other;
    bool at_wall;
    auto operator<=>(const Kind&) const = default;
};
std::map<Kind, Numbers> laws_by_kind(const rigs::PileSetup& setup) {
    dem_min::Simulation s = rigs::begin_pile(setup, 1).simulation;
    for (const int material : {grain, clay})
        dem_min::insert(s, {{}, {}, {}, 1e-3, 2500.0, false, material});
    std::map<Kind, Numbers> all;
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j)
            all[{s.grains.material[i], s.grains.material[j], false}] =
                numbers(s.laws(dem_min::group_of_pair(s, i, j)));
        for (std::size_t wall = 0; wall < s.walls.size(); ++wall)
            all[{s.grains.material[i], s.wall_material[wall], true}] =
                numbers(s.laws(dem_min::group_of_wall(s, i, wall)));
    }
    return all;
}

}  // namespace

TEST_CASE("a pair's numbers move the contacts of that pair alone, from either side",
          "[rigs][pile][materials]") {
    const auto usual = laws_by_kind(setup_of(""));
    REQUIRE(usual.size() == 4 + 4);
    struct Pair {
        const char* between;
        std::vector<Kind> moved;
    };
    const Pair pair =
        GENERATE(Pair{R"(["grain", "clay"])", {{grain, clay, false}, {clay, grain, false}}},
                 Pair{R"(["clay", "grain"])", {{grain, clay, false}, {clay, grain, false}}},
                 Pair{R"(["clay", "clay"])", {{clay, clay, false}}},
                 Pair{R"(["steel", "grain"])", {{grain, steel, true}}},
                 Pair{R"(["clay", "steel"])", {{clay, steel, true}}},
                 Pair{R"(["plate", "clay"])", {{clay, plate, true}}});
    struct Law {
        const char *name, *value;
    };
    const Law law = GENERATE(Law{"sliding_friction", "0.11"}, Law{"rolling_friction", "0.22"},
                             Law{"restitution", "0.33"}, Law{"work_of_adhesion", "\"0.44 J/m^2\""});
    CAPTURE(pair.between, law.name);
    const auto changed = laws_by_kind(
        setup_of(fmt::format(R"({{"between": {}, "{}": {}}})", pair.between, law.name, law.value)));
    REQUIRE(changed.size() == usual.size());
    for (const auto& [kind, now] : changed) {
        CAPTURE(kind.i, kind.other, kind.at_wall);
        const bool must_move =
            std::find(pair.moved.begin(), pair.moved.end(), kind) != pair.moved.end();
        CHECK((now != usual.at(kind)) == must_move);
        if (must_move && std::string(law.name) == "sliding_friction")
            CHECK(std::get<0>(now) == 0.11);
        if (must_move && std::string(law.name) == "rolling_friction")
            CHECK(std::get<1>(now) == 0.22);
        if (must_move && std::string(law.name) == "work_of_adhesion")
            CHECK(std::get<3>(now) == 0.44);
    }
}

TEST_CASE("every pair has the E* of its own two materials", "[rigs][pile][materials]") {
    const rigs::PileSetup s = setup_of("");
    const auto e_star = [](double e1, double nu1, double e2, double nu2) {  // Hertz
        return 1.0 / ((1.0 - nu1 * nu1) / e1 + (1.0 - nu2 * nu2) / e2);
    };
    CHECK(s.grains.e_star == Approx(e_star(2e6, 0.2, 2e6, 0.2)).epsilon(1e-14));
    CHECK(s.walls.e_star == Approx(e_star(2e6, 0.2, 3e6, 0.4)).epsilon(1e-14));
    std::size_t seen = 0;
    for (const rigs::PairParameters& p : s.materials.pairs) {
        const auto is = [&](int a, int b, bool wall) {
            return p.grain == a && p.partner == b && p.at_wall == wall;
        };
        const double expected = is(grain, clay, false)   ? e_star(2e6, 0.2, 1e6, 0.3)
                                : is(clay, clay, false)  ? e_star(1e6, 0.3, 1e6, 0.3)
                                : is(grain, steel, true) ? e_star(2e6, 0.2, 2e8, 0.28)
                                : is(clay, steel, true)  ? e_star(1e6, 0.3, 2e8, 0.28)
                                : is(clay, plate, true)  ? e_star(1e6, 0.3, 3e6, 0.4)
                                                         : 0.0;
        CHECK(p.laws.e_star == Approx(expected).epsilon(1e-14));
        ++seen;
    }
    CHECK(seen == 5);
}

TEST_CASE("grains of the second kind have its density and size, half of all",
          "[rigs][pile][materials]") {
    rigs::PileSetup setup = setup_of("");
    rigs::PileRun run = rigs::begin_pile(setup, 1);
    while (run.fed < 60) rigs::advance(run, setup, 200);
    const dem_min::Particles& p = run.simulation.grains;
    std::size_t clay_grains = 0;
    for (std::size_t k = 0; k < p.count(); ++k) {
        const bool of_clay = p.material[k] == clay;
        clay_grains += of_clay;
        const double r = of_clay ? 0.75e-3 : 1e-3, density = of_clay ? 1500.0 : 2500.0;
        CHECK(p.radius[k] == Approx(r).epsilon(1e-14));
        CHECK(p.mass[k] ==
              Approx(density * 4.0 / 3.0 * 3.14159265358979 * r * r * r).epsilon(1e-12));
    }
    CHECK(clay_grains > 15);  // 60 draws of one half: 30 +- 4
    CHECK(clay_grains < 45);
}

TEST_CASE("a pile of two kinds is the same bits when it is scaled", "[rigs][pile][materials]") {
    const rigs::PileSetup original =
        setup_of(R"({"between": ["grain", "clay"], "work_of_adhesion": "0.05 J/m^2"})");
    const scaling::ScaleMap exact = scaling::ScaleMap::solve(scaling::named_scheme("exact"), 256.0);
    const rigs::PileSetup larger = rigs::scaled(original, exact);
    rigs::PileRun a = rigs::begin_pile(original, 1), b = rigs::begin_pile(larger, 1);
    rigs::advance(a, original, 40000), rigs::advance(b, larger, 40000);
    REQUIRE(dem_min::mean_coordination(a.simulation) > 0.5);  // or nothing is shown
    CHECK(dem_min::state_hash(a.simulation) ==
          dem_min::state_hash(b.simulation, 256.0, exact.factor("time")));
}

TEST_CASE("a pair that meets nowhere in a pile is told of", "[rigs][pile][materials]") {
    const rigs::PileSetup s = setup_of(R"({"between": ["plate", "steel"], "restitution": 0.5})");
    REQUIRE(s.notes.size() == 1);
    CHECK(s.notes[0] == "the pair plate, steel of the model meets nowhere in this pile");
    CHECK(setup_of(R"({"between": ["clay", "steel"], "restitution": 0.5})").notes.empty());
}
