// SPDX-License-Identifier: MIT
#include "scaling/errors.hpp"
#include "verify/scaling_map_judge.hpp"
#include "verify/scaling_map_runs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

using verify::MapVerdict;

namespace {

constexpr verify::MapMargin margin{"angle_flank_20_80", "deg", 2.5, false, ""};

const verify::MapPile& pile_named(const verify::MapPlan& plan, const std::string& name) {
    for (const verify::MapPile& p : plan.piles)
        if (p.name == name) return p;
    FAIL("no pile " << name);
    return plan.piles.front();
}

double pull_off_in_weights(const rigs::PileSetup& s) {
    const double pi = std::numbers::pi;
    return 1.5 * pi * s.grains.work_of_adhesion * 0.25 * s.d /
           (s.density * s.gravity * pi / 6.0 * s.d * s.d * s.d);
}

verify::MapHeap heap(bool formed, double angle) {
    verify::MapHeap h{};
    h.at_rest = true;
    h.formed = formed;
    if (!formed) h.missed = {"stands_above_rim"};
    h.values.assign(verify::map_margins().size(), 0.1);
    h.values[0] = angle;
    return h;
}

const verify::MapQuantity& quantity(const verify::MapCell& c, const std::string& name) {
    for (const verify::MapQuantity& q : c.quantities)
        if (q.name == name) return q;
    FAIL("no quantity " << name);
    return c.quantities.front();
}

struct Scratch {
    std::filesystem::path path;
    explicit Scratch(const std::string& name)
        : path(std::filesystem::temp_directory_path() /
               ("similitude-map-" + name + std::to_string(getpid()))) {}
    ~Scratch() { std::filesystem::remove_all(path); }
};

}  // namespace

// Four values a side with sample deviation 1: s = sqrt(1/4 + 1/4), nu = 6, t_{0.95, 6} = 1.943 (Student's table), half width
// 1.374.
TEST_CASE("scaling map: a cell holds inside the margin, breaks wholly outside, and else is open",
          "[verify][scaling_map]") {
    const double u = std::sqrt(0.75);  // deviation of {-u, -u, u, u}: sqrt(4 u^2/3) = 1
    const auto around = [&](double mean) {
        return std::vector<double>{mean - u, mean - u, mean + u, mean + u};
    };
    CHECK(verify::judged(margin, around(30.0), around(31.1)).verdict == MapVerdict::holds);
    CHECK(verify::judged(margin, around(30.0), around(31.2)).verdict == MapVerdict::not_decided);
    CHECK(verify::judged(margin, around(30.0), around(33.8)).verdict == MapVerdict::not_decided);
    CHECK(verify::judged(margin, around(30.0), around(33.9)).verdict == MapVerdict::breaks);
    CHECK(verify::judged(margin, around(33.9), around(30.0)).verdict == MapVerdict::breaks);
    const verify::MapQuantity q = verify::judged(margin, around(30.0), around(31.2));
    CHECK(q.interval.low == Approx(1.2 - 1.374).margin(1e-3));
    CHECK(q.interval.high == Approx(1.2 + 1.374).margin(1e-3));
}

// The table of docs/equivalence.md: 8 seeds a side at sigma = 0.5 margin and no difference. In the normal limit beyond the margin
// n = 2 (2 x 1.645 x 1.25/(5 - 2.5))^2 = 5.4.
TEST_CASE("scaling map: seeds needed are those of 95 % power", "[verify][scaling_map]") {
    const double u = 1.25 * std::sqrt(0.75);
    const std::vector<double> zero{-u, -u, u, u}, five{5 - u, 5 - u, 5 + u, 5 + u};
    CHECK(verify::judged(margin, zero, zero).seeds_needed == 8);
    CHECK(verify::judged(margin, zero, five).seeds_needed == 6);
    const std::vector<double> on_it{2.5 - u, 2.5 - u, 2.5 + u, 2.5 + u};
    CHECK_FALSE(verify::judged(margin, zero, on_it).seeds_needed);
}

TEST_CASE("scaling map: one value a side decides nothing", "[verify][scaling_map]") {
    const verify::MapQuantity q = verify::judged(margin, {30.0}, {30.0});
    CHECK(q.verdict == MapVerdict::not_decided);
    CHECK(std::isinf(q.interval.high));
}

TEST_CASE("scaling map: heaps on one side alone break a cell; on neither side angles are left out",
          "[verify][scaling_map]") {
    const verify::MapPlan plan = verify::map_plan(verify::MapExtent::tiny);
    const verify::MapPair& pair = plan.pairs.front();
    const auto& p = plan.piles[pair.reference];
    const std::vector<verify::MapHeap> stand(4, heap(true, 40.0)), lie(4, heap(false, 5.0));
    CHECK(verify::map_cell(pair, p, p, stand, stand).verdict == MapVerdict::holds);
    const verify::MapCell one = verify::map_cell(pair, p, p, stand, lie);
    CHECK(one.verdict == MapVerdict::breaks);
    CHECK(one.why.find("4 of 4") != std::string::npos);
    CHECK(one.scaled.formed == 0);
    const verify::MapCell none = verify::map_cell(pair, p, p, lie, lie);
    CHECK(none.verdict == MapVerdict::holds);
    CHECK(std::none_of(none.quantities.begin(), none.quantities.end(),
                       [](const auto& q) { return q.name == "angle_flank_20_80"; }));
    CHECK(verify::map_cell(pair, p, p, {}, {}).verdict == MapVerdict::not_decided);
}

TEST_CASE("scaling map: an uncovered base counts where both are 20 d and wider",
          "[verify][scaling_map]") {
    const verify::MapPlan plan = verify::map_plan(verify::MapExtent::full);
    const verify::MapPair& pair = plan.pairs.front();
    const auto& wide = pile_named(plan, "bond10-e100000-base24");
    const auto& narrow = pile_named(plan, "bond10-e100000-base16");
    std::vector<verify::MapHeap> covered(4, heap(true, 40.0)), bare(4, heap(false, 40.0));
    for (verify::MapHeap& h : bare) h.missed = {"base_covered"};
    CHECK(verify::map_cell(pair, wide, wide, covered, bare).verdict == MapVerdict::breaks);
    CHECK(verify::map_cell(pair, wide, narrow, covered, bare).verdict == MapVerdict::holds);
    CHECK(verify::map_cell(pair, narrow, wide, covered, bare).scaled.formed == 4);
}

// Exponents of docs/scaling.md, apparatus kept: F_po/(m g) goes as w/d^2.
TEST_CASE(
    "scaling map: piles keep base, mass rate and modulus while grains grow, and w follows "
    "the rule",
    "[verify][scaling_map]") {
    const verify::MapPlan plan = verify::map_plan(verify::MapExtent::full);
    const rigs::PileSetup r = verify::map_job(pile_named(plan, "bond10-e100000-base48"), 1).setup;
    CHECK(pull_off_in_weights(r) == Approx(10.0).epsilon(1e-12));
    const double e = 2.0 * (1.0 - 0.0625) * r.grains.e_star;
    CHECK(e / (r.density * r.gravity * r.d) == Approx(1e5).epsilon(1e-12));
    const std::vector<std::pair<std::string, double>> rules = {
        {"stress_bond", 1.0}, {"weight_bond", 2.0}, {"cohesion_number", 1.6}, {"none", 0.0}};
    for (const auto& [rule, exponent] : rules) {
        const rigs::PileSetup s =
            verify::map_job(pile_named(plan, "bond10-e100000-base48-h2-" + rule), 1).setup;
        INFO(rule);
        CHECK(s.d == 2.0 * r.d);
        CHECK(s.grains.e_star == r.grains.e_star);
        CHECK(s.conditions.base_diameter == r.conditions.base_diameter);
        CHECK(s.conditions.drop_height == r.conditions.drop_height);
        CHECK(8.0 * s.conditions.feed_rate == Approx(r.conditions.feed_rate).epsilon(1e-12));
        CHECK(8.0 * s.conditions.grains == Approx(r.conditions.grains).epsilon(1e-3));
        CHECK(s.conditions.grains >= 1000);
        CHECK(pull_off_in_weights(s) ==
              Approx(10.0 * std::pow(2.0, exponent - 2.0)).epsilon(1e-12));
    }
}

TEST_CASE("scaling map: no two piles share a seed, and the order holds every heap once",
          "[verify][scaling_map]") {
    const verify::MapPlan plan = verify::map_plan(verify::MapExtent::full);
    std::set<std::uint64_t> seeds;
    std::size_t planned = 0;
    for (const verify::MapPile& p : plan.piles) planned += static_cast<std::size_t>(p.seeds);
    for (const verify::MapTurn& t : verify::map_turns(plan, 1)) seeds.insert(t.seed);
    CHECK(verify::map_turns(plan, 1).size() == planned);
    CHECK(seeds.size() == planned);
}

// With w ~ E^(2/5) the sticking speed stays and pull-off falls by 0.1^0.4; with w ~ E radius and gap stay and pull-off falls by
// 0.1; with w kept pull-off stays and a0 ~ E^(-1/3), gap ~ E^(-2/3), v ~ E^(-1/3) rise (facts of JKR, docs/scaling.md).
TEST_CASE("scaling map: a single impact keeps what its rule keeps and loses the rest",
          "[verify][scaling_map]") {
    const std::vector<verify::MapCell> cells = verify::single_impacts(10.0, 1e7, {10.0});
    REQUIRE(cells.size() == 3);
    const auto ratio = [](const verify::MapCell& c, const char* name) {
        const verify::MapQuantity& q = quantity(c, name);
        return q.scaled.mean / q.reference.mean;
    };
    const double tenth = 0.1;
    // 1e-6: the work of tear-off comes from GSL's quadrature.
    CHECK(ratio(cells[0], "pull_off_force") == Approx(1.0).epsilon(1e-12));
    CHECK(ratio(cells[0], "sticking_speed") == Approx(std::pow(tenth, -1.0 / 3.0)).epsilon(1e-6));
    CHECK(ratio(cells[0], "contact_radius") == Approx(std::pow(tenth, -1.0 / 3.0)).epsilon(1e-12));
    CHECK(ratio(cells[0], "tear_off_gap") == Approx(std::pow(tenth, -2.0 / 3.0)).epsilon(1e-12));
    CHECK(ratio(cells[1], "sticking_speed") == Approx(1.0).epsilon(1e-6));
    CHECK(ratio(cells[1], "pull_off_force") == Approx(std::pow(tenth, 0.4)).epsilon(1e-12));
    CHECK(ratio(cells[2], "tear_off_gap") == Approx(1.0).epsilon(1e-12));
    CHECK(ratio(cells[2], "contact_radius") == Approx(1.0).epsilon(1e-12));
    CHECK(ratio(cells[2], "pull_off_force") == Approx(0.1).epsilon(1e-12));
    for (const verify::MapCell& c : cells) CHECK(c.verdict == MapVerdict::breaks);
    CHECK(quantity(cells[1], "sticking_speed").verdict == MapVerdict::holds);
    // They part, slower than the dashpot's 0.5, since adhesion takes its share.
    const double e = quantity(cells[1], "restitution").reference.mean;
    CHECK(e > 0.1);
    CHECK(e < 0.5);
    CHECK(quantity(cells[1], "pull_off_force").verdict == MapVerdict::breaks);
}

TEST_CASE("scaling map: two shards, one after the other, give the map of one run to the last bit",
          "[verify][scaling_map][slow]") {
    const verify::MapPlan plan = verify::map_plan(verify::MapExtent::tiny);
    const Scratch whole("whole"), shared("shared");
    REQUIRE(verify::pour_map(plan, 1, {.threads = 2, .folder = whole.path}) ==
            verify::MapEnd::complete);
    for (const int shard : {2, 1})
        REQUIRE(verify::pour_map(plan, 1, {.folder = shared.path, .shard = shard, .shards = 2}) ==
                verify::MapEnd::complete);
    const verify::ScalingMap a = verify::gather_map(plan, 1, whole.path),
                             b = verify::gather_map(plan, 1, shared.path);
    REQUIRE(a.heaps.size() == 4);
    REQUIRE(b.heaps.size() == 4);
    for (std::size_t k = 0; k < a.heaps.size(); ++k) {
        CHECK(a.heaps[k].seed == b.heaps[k].seed);
        CHECK(a.heaps[k].grain_steps == b.heaps[k].grain_steps);
        CHECK(a.heaps[k].values == b.heaps[k].values);
    }
    // Nothing is left to pour: a budget of nothing does not matter, and with no heaps it leaves all of them out.
    CHECK(verify::pour_map(plan, 1, {.folder = whole.path, .budget = 1e-9}) ==
          verify::MapEnd::complete);
    const Scratch empty("empty");
    CHECK(verify::pour_map(plan, 1, {.folder = empty.path, .budget = 1e-9}) ==
          verify::MapEnd::out_of_budget);
    CHECK(verify::gather_map(plan, 1, empty.path).heaps.empty());
}
