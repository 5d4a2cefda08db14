// SPDX-License-Identifier: MIT
#include "scaling/errors.hpp"
#include "verify/scaling_map_heaps.hpp"
#include "verify/scaling_map_judge.hpp"
#include "verify/scaling_map_runs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
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
    std::filesystem::path file;
    explicit Scratch(const std::string& name)
        : file(std::filesystem::temp_directory_path() /
               ("similitude-map-" + name + std::to_string(getpid()) + ".csv")) {}
    ~Scratch() { std::filesystem::remove(file); }
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
    CHECK(verify::map_cell(pair, p, p, {}, {}).verdict == MapVerdict::not_poured);
    CHECK(verify::map_cell(pair, p, p, stand, {}).verdict == MapVerdict::not_poured);
    const verify::MapCell few = verify::map_cell(pair, p, p, stand, {heap(true, 40.0)});
    CHECK(few.verdict == MapVerdict::not_decided);
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

TEST_CASE(
    "scaling map: two shards, one after the other, give the map of one run to the last bit, and a "
    "part is judged as a part",
    "[verify][scaling_map][slow]") {
    const verify::MapPlan plan = verify::map_plan(verify::MapExtent::tiny);
    const Scratch whole("whole"), shared("shared");
    REQUIRE(verify::pour_map(plan, 1, {.threads = 2, .heaps = whole.file, .git = "abc"}) ==
            verify::MapEnd::complete);
    const auto pour = [&](int shard) {
        return verify::pour_map(plan, 1, {.heaps = shared.file, .shard = shard, .shards = 2});
    };
    REQUIRE(pour(2) == verify::MapEnd::complete);
    CHECK(verify::gather_map(plan, 1, shared.file).heaps.size() == 2);
    std::ofstream(shared.file, std::ios::app) << "bond10-cut off in the mid";
    REQUIRE(pour(1) == verify::MapEnd::complete);
    const verify::ScalingMap a = verify::gather_map(plan, 1, whole.file),
                             b = verify::gather_map(plan, 1, shared.file);
    REQUIRE(a.heaps.size() == 4);
    REQUIRE(b.heaps.size() == 4);
    for (std::size_t k = 0; k < a.heaps.size(); ++k) {
        CHECK(a.heaps[k].seed == b.heaps[k].seed);
        CHECK(a.heaps[k].setup == b.heaps[k].setup);
        CHECK(a.heaps[k].git == "abc");
        CHECK(a.heaps[k].grain_steps == b.heaps[k].grain_steps);
        CHECK(a.heaps[k].missed == b.heaps[k].missed);
        CHECK(a.heaps[k].values == b.heaps[k].values);
    }
    // Nothing is left to pour: a budget of nothing does not matter, and with no heaps it leaves all of them out.
    CHECK(verify::pour_map(plan, 1, {.heaps = whole.file, .budget = 1e-9}) ==
          verify::MapEnd::complete);
    const Scratch empty("empty");
    CHECK(verify::pour_map(plan, 1, {.heaps = empty.file, .budget = 1e-9}) ==
          verify::MapEnd::out_of_budget);
    const verify::ScalingMap none = verify::gather_map(plan, 1, empty.file);
    CHECK(none.heaps.empty());
    CHECK(none.cells.front().verdict == MapVerdict::not_poured);
}

namespace {

verify::MapHeap remembered_heap() {
    verify::MapHeap h{};
    h.name = "one-seed7", h.seed = 7, h.setup = "0123456789abcdef", h.git = "abc-dirty";
    h.at_rest = true;
    h.missed = {"base_covered", "falls_outwards"};
    h.values.assign(verify::map_margins().size(), 1.0 / 3.0);
    h.values[0].reset();
    h.values[1] = -1e-300;
    h.grains_on_base = 123.0, h.grain_steps = 4e10 + 1.0, h.seconds = 0.1;
    return h;
}

}  // namespace

TEST_CASE("scaling map: a remembered heap is read again to the last bit, from files put together",
          "[verify][scaling_map]") {
    const Scratch scratch("heaps"), other("more");
    verify::MapHeap h = remembered_heap();
    verify::append_heap(scratch.file, h);
    h.setup = "another", h.missed.clear(), h.at_rest = false;
    verify::append_heap(other.file, h);
    std::ofstream(scratch.file, std::ios::app) << std::ifstream(other.file).rdbuf();
    const verify::MapHeaps read = verify::read_heaps(scratch.file);
    REQUIRE(read.size() == 2);
    const verify::MapHeap &a = read.at({"one-seed7", "0123456789abcdef"}),
                          &b = read.at({"one-seed7", "another"});
    CHECK(a.values == h.values);
    CHECK(a.grain_steps == h.grain_steps);
    CHECK(a.seconds == h.seconds);
    CHECK(a.git == "abc-dirty");
    CHECK(a.missed == remembered_heap().missed);
    CHECK((a.at_rest && !a.formed));
    CHECK_FALSE((b.at_rest || b.formed));
}

TEST_CASE("scaling map: a heap of another setup is not used, and told", "[verify][scaling_map]") {
    const verify::MapPlan plan = verify::map_plan(verify::MapExtent::tiny);
    const Scratch scratch("stale");
    verify::MapHeap h = remembered_heap();
    h.name = verify::map_job(plan.piles[0], verify::map_turns(plan, 1)[0].seed).name;
    verify::append_heap(scratch.file, h);
    const verify::ScalingMap map = verify::gather_map(plan, 1, scratch.file);
    CHECK(map.heaps.empty());
    CHECK(map.heaps_stale == 1);
}

TEST_CASE("scaling map: a line that is no heap is refused by its number",
          "[verify][scaling_map][input]") {
    using Catch::Matchers::Contains;
    const Scratch scratch("bad");
    verify::append_heap(scratch.file, remembered_heap());
    std::ofstream(scratch.file, std::ios::app) << "one-seed8,8\n";
    CHECK_THROWS_WITH(verify::read_heaps(scratch.file),
                      Contains("line 3") && Contains("one-seed8"));
    std::ofstream(scratch.file) << "heap,angle\n";
    CHECK_THROWS_WITH(verify::read_heaps(scratch.file), Contains("line 1") && Contains("header"));
}

// A change of laws, core or plan that makes them stale must be seen: pour them anew, or take them out of data/.
TEST_CASE("scaling map: the heaps in data/ are of this plan and these laws",
          "[verify][scaling_map][data]") {
    const verify::MapHeaps heaps = verify::read_heaps("data/scaling-map/heaps.csv");
    std::set<std::string> found;  // a pile may be in both
    for (const auto extent : {verify::MapExtent::small, verify::MapExtent::full}) {
        const verify::MapPlan plan = verify::map_plan(extent);
        for (const verify::MapTurn& t : verify::map_turns(plan, 1)) {
            const auto& name = plan.piles[t.pile].name;
            const auto heap = heaps.lower_bound({name + "-seed" + std::to_string(t.seed), ""});
            if (heap == heaps.end() || heap->second.seed != t.seed) continue;
            found.insert(heap->second.name);
            if (t.seed % 1000 ==
                1)  // the first of each pile; the others have its setup but for chance
                CHECK(heap->second.setup ==
                      verify::fingerprint(verify::map_job(plan.piles[t.pile], t.seed)));
        }
    }
    CHECK(found.size() == heaps.size());
    CHECK_FALSE(heaps.empty());
}
