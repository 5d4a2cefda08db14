// SPDX-License-Identifier: MIT
#include "cases/json_tree.hpp"
#include "cases/read_case.hpp"
#include "prove/baselines.hpp"
#include "prove/campaign.hpp"
#include "prove/record.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

using namespace prove;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t seed = 3;

fs::path empty_folder(const char* name) {
    const fs::path path = fs::temp_directory_path() / name;
    fs::remove_all(path);
    return path;
}

int first_of(Kind kind) {
    for (int number = 1;; ++number)
        if (plan(seed, number).kind == kind) return number;
}

}  // namespace

TEST_CASE("prove: 1200 cases have the shares, and every effect its turn", "[prove]") {
    std::map<Kind, int> kinds;
    std::map<std::string, int> effects, nulls;
    for (int number = 1; number <= 1200; ++number) {
        const Plan p = plan(seed, number);
        ++kinds[p.kind];
        if (p.kind == Kind::single) ++effects[p.effect];
        if (p.kind == Kind::null) ++nulls[p.subkind];
    }
    REQUIRE(kinds == std::map<Kind, int>{{Kind::null, 400},
                                         {Kind::single, 500},
                                         {Kind::look_alike, 120},
                                         {Kind::pair, 80},
                                         {Kind::outside, 60},
                                         {Kind::numerical, 40}});
    REQUIRE(effects.size() == 16);
    for (const auto& [effect, n] : effects) REQUIRE(n >= 31);
    for (const auto& [kind, n] : nulls) REQUIRE(n == 100);
}

TEST_CASE("prove: a case follows from seed and number alone", "[prove]") {
    const int number = first_of(Kind::single);
    const BlindCase a = make_case(seed, number);
    make_case(seed, number + 1, Figures::none);
    const BlindCase b = make_case(seed, number);
    REQUIRE(a.files == b.files);
    REQUIRE(a.key_text == b.key_text);
    REQUIRE(make_case(seed, number, Figures::none).files == a.files);
    REQUIRE(make_case(seed + 1, number, Figures::none).files != a.files);
}

TEST_CASE("prove: every kind is a case that the reader accepts, with its key elsewhere",
          "[prove]") {
    const fs::path home = empty_folder("similitude-prove-cases");
    for (const Kind kind :
         {Kind::null, Kind::single, Kind::look_alike, Kind::pair, Kind::outside, Kind::numerical}) {
        const int number = first_of(kind);
        const BlindCase made = make_case(seed, number);
        write(made, (home / "cases").string(), (home / "keys").string());
        REQUIRE(is_written(number, home / "cases", home / "keys"));
        const cases::Case c = cases::read_case((home / "cases" / made.key.name).string());
        int fits = 0, held_out = 0;
        for (const cases::Experiment& e : c.experiments) {
            REQUIRE(e.recording);
            ++(e.held_out ? held_out : fits);
        }
        REQUIRE(fits >= 2);
        REQUIRE(held_out >= 1);
        // Nothing concealed stands in the model, no start value is the truth.
        for (const std::string& effect : made.key.effects) REQUIRE(!c.model.includes(effect));
        for (const Stated& p : made.skeleton.parameters)
            if (p.free) REQUIRE(c.model.find(p.name)->value != p.truth);
        const Key back = read_key((home / "keys" / (made.key.name + ".json")).string());
        REQUIRE(back.effects == made.key.effects);
        REQUIRE(back.idr == Approx(made.key.idr).epsilon(1e-8).margin(1e-12));
        for (const auto& [name, content] : made.files) {
            REQUIRE(content.find(to_string(kind)) == std::string::npos);
            REQUIRE(content.find("idr") == std::string::npos);
        }
    }
    fs::remove_all(home);
}

TEST_CASE("prove: singles have the discrepancy that was asked for", "[prove]") {
    int checked = 0;
    for (int number = 1; checked < 4; ++number) {
        const Plan p = plan(seed, number);
        if (p.kind != Kind::single) continue;
        const Key k = make_case(seed, number).key;
        // The strength is solved to a tenth; noise is then printed with three digits.
        REQUIRE(k.idr == Approx(p.target).epsilon(0.15));
        REQUIRE(k.lambda == Approx(k.n_eff * k.idr * k.idr).epsilon(1e-9));
        REQUIRE(k.oracle_power >= 0.05);
        ++checked;
    }
}

// Against all terms, its own among them, a concealed effect is no distance away: the search finds the minimum that is there. It
// does not for vibrations, and not always for adhesion in a fall (docs/prove.md).
TEST_CASE("prove: the separation of an effect from itself is nothing", "[prove]") {
    int found = 0;
    for (int number = 1; number <= 60 && found < 6; ++number) {
        const Plan p = plan(seed, number);
        if (p.kind != Kind::single || p.effect == "vibration" || p.effect == "adhesion") continue;
        const BlindCase made = make_case(seed, number, Figures::none);
        INFO(made.key.rig << " " << made.key.effects.front());
        CHECK(separation(made.skeleton, made.world, {}).d < 1.0);
        ++found;
    }
    CHECK(found == 6);
}

TEST_CASE("prove: a recording that is asked for is made in the case's own world", "[prove]") {
    int number = 1;
    while (plan(seed, number).kind != Kind::single || plan(seed, number).rig != Rig::incline)
        ++number;
    const BlindCase made = make_case(seed, number, Figures::none);
    const fs::path home = empty_folder("similitude-prove-asked");
    fs::create_directories(home);
    std::ofstream(home / "wish.json") << R"({"rig": "drop", "conditions": {"height": "300 mm"},
        "channels": ["z"], "ordinate": {"from": 0, "to": 0.2, "rows": 40},
        "noise": {"z": 0.001}})";
    auto files = record(made, seed, cases::read_json((home / "wish.json").string()));
    for (const auto& [name, content] : files) std::ofstream(home / name) << content;
    const cases::Case c = cases::read_case(home.string());
    REQUIRE(c.experiments.size() == made.skeleton.stated.size() + 1);
    REQUIRE(c.experiments.back().rig == "drop");
    REQUIRE(c.experiments.back().recording->rows() == 40);
    REQUIRE(c.experiments.back().recording->values("z").front() == Approx(0.3).margin(6e-3));
    std::ofstream(home / "wish.json")
        << R"({"rig": "drop", "channels": ["force"], "ordinate": {"from": 0, "to": 1}})";
    REQUIRE_THROWS_AS(record(made, seed, cases::read_json((home / "wish.json").string())),
                      scaling::InvalidInput);
    fs::remove_all(home);
}

TEST_CASE("prove: shards share the numbers out, kinds and rigs pick", "[prove]") {
    Extent e{.seed = seed, .cases = 30};
    std::set<int> all;
    for (const char* shard : {"1/3", "2/3", "3/3"}) {
        e.shard = shard;
        for (const int n : numbers_of(e)) REQUIRE(all.insert(n).second);
    }
    REQUIRE(all.size() == 30);
    e.shard = "4/3";
    REQUIRE_THROWS_AS(numbers_of(e), scaling::InvalidInput);
    e.shard = "1/1", e.kind = Kind::outside, e.rig = "impact", e.cases = 3;
    for (const int n : numbers_of(e)) {
        REQUIRE(plan(seed, n).kind == Kind::outside);
        REQUIRE(plan(seed, n).rig == Rig::impact);
    }
}

TEST_CASE("prove: the baselines answer every kind of rig", "[prove]") {
    for (const Rig rig : {Rig::drop, Rig::incline, Rig::impact, Rig::pull_off}) {
        int number = 1;
        while (plan(seed, number).kind != Kind::null || plan(seed, number).rig != rig) ++number;
        const BlindCase made = make_case(seed, number);
        REQUIRE(!bic_verdict(made).hypotheses.empty());
        REQUIRE(!sparse_verdict(made).hypotheses.empty());
        REQUIRE(oracle_verdict(made.key).verdict == "consistent");
    }
}
