// SPDX-License-Identifier: MIT
#include "reports/scaling_map_json.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace {

struct File {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("similitude-scaling-map-" + std::to_string(getpid()) + ".json");
    explicit File(const std::string& text) { std::ofstream(path) << text; }
    ~File() { std::filesystem::remove(path); }
};

// Numbers by hand; 0.1 and 1/3 have no short binary form.
verify::ScalingMap sample() {
    verify::MapCell cell{.study = "coarse_graining",
                         .rule = "stress_bond",
                         .bond = 10.0,
                         .factor = 1.5,
                         .reference = {48.0, 1e5, 10.0, 29889, 6, 6, 5},
                         .scaled = {32.0, 1e5 / 1.5, 10.0 / 1.5, 8856, 6, 5, 4},
                         .quantities = {},
                         .verdict = verify::MapVerdict::not_decided,
                         .why = "angle_flank_20_80 is not decided"};
    cell.quantities.push_back({.name = "angle_flank_20_80",
                               .unit = "deg",
                               .reference = {51.1, 1.0 / 3.0, 5},
                               .scaled = {53.2, 0.1, 4},
                               .difference = 2.1,
                               .interval = {1.1, 3.1},
                               .margin = 2.5,
                               .verdict = verify::MapVerdict::not_decided,
                               .seeds_needed = 21});
    cell.quantities.push_back(cell.quantities.front());
    cell.quantities.back().seeds_needed.reset();
    return {.extent = "full",
            .reference_grains = 29889,
            .first_seed = 1,
            .cells = {cell},
            .heaps = {{.name = "one-seed1",
                       .seed = 123456001,
                       .setup = "0123456789abcdef",
                       .git = "abc",
                       .at_rest = true,
                       .formed = false,
                       .missed = {"base_covered"},
                       .values = {51.5, std::nullopt},
                       .grains_on_base = 20000,
                       .grain_steps = 1.5e9,
                       .seconds = 70.0}},
            .heaps_planned = 2,
            .heaps_stale = 1,
            .grain_steps_planned = 3e9};
}

}  // namespace

TEST_CASE("scaling map: what is written is read again, to the last bit", "[reports][scaling_map]") {
    const std::string text = reports::text_of(reports::to_json(sample(), {}));
    const verify::ScalingMap read = reports::read_scaling_map(File(text).path.string());
    CHECK(reports::text_of(reports::to_json(read, {})) == text);
    REQUIRE(read.cells.size() == 1);
    const verify::MapCell& c = read.cells.front();
    CHECK(c.scaled.elasticity == 1e5 / 1.5);
    CHECK(c.scaled.formed == 4);
    CHECK(c.verdict == verify::MapVerdict::not_decided);
    REQUIRE(c.quantities.size() == 2);
    CHECK(c.quantities[0].reference.standard_deviation == 1.0 / 3.0);
    CHECK(c.quantities[0].interval.high == 3.1);
    CHECK(c.quantities[0].seeds_needed == 21);
    CHECK_FALSE(c.quantities[1].seeds_needed);
    REQUIRE(read.heaps.size() == 1);
    CHECK(read.heaps[0].seed == 123456001);
    CHECK(read.heaps[0].values[0] == 51.5);
    CHECK_FALSE(read.heaps[0].values[1]);
}

TEST_CASE("scaling map: another format and an unknown verdict are refused by name",
          "[reports][scaling_map][input]") {
    using Catch::Matchers::Contains;
    CHECK_THROWS_WITH(
        reports::read_scaling_map(File(R"({"format": "similitude-case/1"})").path.string()),
        Contains("format") && Contains("similitude-scaling-map/1"));
    std::string text = reports::text_of(reports::to_json(sample(), {}));
    text.replace(text.find("not_decided"), 11, "perhaps");
    CHECK_THROWS_WITH(reports::read_scaling_map(File(text).path.string()),
                      Contains("verdict") && Contains("perhaps"));
}

TEST_CASE("scaling map: the small map in data/ is whole, and its means are those of its heaps",
          "[reports][scaling_map][data]") {
    const verify::ScalingMap map = reports::read_scaling_map("data/scaling-map/small.json");
    CHECK(map.extent == "small");
    CHECK(map.heaps.size() == map.heaps_planned);
    const verify::MapCell* cell = nullptr;
    for (const verify::MapCell& c : map.cells)
        if (c.study == "coarse_graining" && c.rule == "none" && c.bond == 10.0 && c.factor == 2.0)
            cell = &c;
    REQUIRE(cell != nullptr);
    double sum = 0.0, count = 0.0;
    for (const verify::MapHeap& h : map.heaps)
        if (h.name.find("bond10-e10000-base20-h2-none-seed") == 0)
            sum += h.values.at(3).value(), count += 1.0;  // coordination
    REQUIRE(count == 8.0);
    for (const verify::MapQuantity& q : cell->quantities)
        if (q.name == "coordination") CHECK(q.scaled.mean == Approx(sum / count).epsilon(1e-12));
}
