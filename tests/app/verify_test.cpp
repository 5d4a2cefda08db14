// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

TEST_CASE(
    "verify: every exact answer carries what was expected, what came, the tolerance and its reason",
    "[app][verify]") {
    const Outcome o = similitude({"verify", "--exact", "--json", "-"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const auto checks = o.json().at("checks");
    REQUIRE(checks.size() > 10);
    for (const auto& check : checks) {
        INFO(check.at("name"));
        CHECK(check.at("expected").is_number());
        CHECK(check.at("got").is_number());
        CHECK(check.at("tolerance").is_number());
        CHECK_FALSE(check.at("reason").get<std::string>().empty());
        CHECK(check.at("passed").get<bool>());
    }
}

TEST_CASE("verify: --small, --full and --exact exclude each other", "[app][verify]") {
    CHECK(similitude({"verify", "--small", "--full"}).code == 2);
    CHECK(similitude({"verify", "--exact", "--full"}).code == 2);
}

TEST_CASE("verify: --sleep compares heaps that may sleep with heaps that stay awake",
          "[app][verify][sleep]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 60"));
    const Outcome o = similitude({"verify", path, "--sleep", "--seeds", "3", "--out", f / "out",
                                  "--json", "-", "--report", f / "page.html"});
    INFO(o.err);
    // What three seeds of so small a heap say is chance.
    CHECK((o.code == 0 || o.code == 3 || o.code == 4));
    const auto json = o.json();
    REQUIRE(json.at("comparisons").size() == 1);
    const auto& comparison = json.at("comparisons").at(0);
    CHECK(comparison.at("reference").at("label") == "awake");
    CHECK(comparison.at("reference").at("samples").size() == 3);
    CHECK(comparison.at("scaled").at("samples").size() == 3);
    CHECK(comparison.at("quantities").size() == 3);
    for (const auto& sample : comparison.at("reference").at("samples"))
        CHECK(sample.at("slept") == 0.0);
    for (const auto& sample : comparison.at("scaled").at("samples")) {
        CHECK(sample.at("slept").get<double>() > 0.0);  // all of it sleeps while rest is waited for
        CHECK(sample.at("slept").get<double>() < 1.0);
    }
    CHECK(json.at("sleep").at("grains") == 60);
    CHECK(contents(f / "page.html").find("may sleep") != std::string::npos);
}

TEST_CASE("verify: --sleep needs a pile with a count of grains", "[app][verify][sleep][input]") {
    const Folder f;
    const std::string path =
        f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": \"until_it_spills\""));
    const Outcome o = similitude({"verify", path, "--sleep", "--out", f / "out"});
    CHECK(o.code == 2);
    CHECK(o.err.find("must be a pile of this case") != std::string::npos);
    CHECK(similitude({"verify", path, "--sleep", "--experiment", "pil", "--out", f / "out"}).code ==
          2);
    CHECK(similitude({"verify", path, "--seeds", "3"}).code == 2);
}

TEST_CASE("verify: heaps are run by another engine only where it can take their rules",
          "[app][verify][lammps][input]") {
    const Folder f;
    const std::string zirconia = "data/zirconia/case.json";
    const Outcome o =
        similitude({"verify", zirconia, "--small", "--engine", "lammps", "--out", f / "out"});
    CHECK(o.code == 2);  // without lmp installed, that
    CHECK(o.err.find("lammps") != std::string::npos);
    CHECK(similitude({"verify", zirconia, "--ranks", "2", "--out", f / "out"}).code == 2);
    const Outcome single = similitude({"verify", zirconia, "--engine", "yade", "--out", f / "out"});
    CHECK(single.code == 2);
    CHECK(single.err.find("must be dem_min or lammps") != std::string::npos);
    const Outcome nearest = similitude(
        {"verify", zirconia, "--engine", "lammps", "--contact", "nearest", "--out", f / "out"});
    CHECK(nearest.code == 2);
    CHECK(nearest.err.find("must be own or lammps") != std::string::npos);
    CHECK(similitude({"verify", "--exact", "--engine", "lammps"}).code == 2);
    CHECK(similitude({"verify", "--against", "lammps", "--contact", "lammps"}).code == 2);
}

TEST_CASE("verify compression: a signal or a second call goes on from what is remembered",
          "[app][verify][compression]") {
    const Folder f;
    const auto study = [&](bool resume) {
        std::vector<std::string> words = {"verify", "compression", "--small", "--seeds", "2",
                                          "--out",  f / "out",     "--json",  "-",       "--quiet"};
        if (resume) words.push_back("--resume");
        return similitude(words);
    };
    const Outcome first = study(false);
    INFO(first.err);
    CHECK((first.code == 0 || first.code == 3 || first.code == 4));  // chance
    const auto json = first.json();
    CHECK(json.at("format") == "similitude-compression/1");
    CHECK(json.at("bits").at("equal") == true);
    REQUIRE(json.at("rules").size() == 4);
    CHECK(json.at("tool").at("seeds").size() == 14);
    const Outcome second = study(true);
    CHECK(second.json().at("rules") == json.at("rules"));
    CHECK(similitude({"verify", "compression", "--seeds", "1"}).code == 2);
}

TEST_CASE(
    "verify scaling-map: a tiny map is poured, taken up again, here and elsewhere, and never "
    "forgotten unasked",
    "[app][verify][scaling_map]") {
    const Folder f;
    const Outcome o = similitude({"verify", "scaling-map", "--tiny", "--heaps", f / "heaps.csv",
                                  "--json", f / "map.json", "--report", f / "map.html"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    CHECK(contents(f / "map.html").find("h, grain over reference grain") != std::string::npos);
    const std::string map = contents(f / "map.json");
    CHECK(map.find("similitude-scaling-map/1") != std::string::npos);
    const Outcome again =
        similitude({"verify", "scaling-map", "--tiny", "--heaps", f / "heaps.csv"});
    CHECK(again.code == 2);
    CHECK(again.err.find("--resume") != std::string::npos);
    const Outcome resumed = similitude({"verify", "scaling-map", "--tiny", "--resume", "--budget",
                                        "1 us", "--heaps", f / "heaps.csv", "--json", "-"});
    CHECK(resumed.code == 0);
    CHECK(resumed.json().at("heaps").size() == 4);
    CHECK(resumed.json().at("cells").at(0).at("reference").at("heaps") == 2);
    // Half of it, and the rest elsewhere.
    const auto poured = [&](const std::string& heaps, const char* shard) {
        const Outcome part = similitude({"verify", "scaling-map", "--tiny", "--resume", "--shard",
                                         shard, "--heaps", heaps, "--json", "-"});
        REQUIRE(part.code == 0);
        auto json = part.json();
        json.erase("tool");
        for (auto& heap : json.at("heaps")) heap.erase("seconds");
        return json;
    };
    CHECK(poured(f / "part.csv", "2/2").at("heaps").size() == 2);
    std::filesystem::copy(f / "part.csv", f / "elsewhere.csv");
    CHECK(poured(f / "elsewhere.csv", "1/1") == poured(f / "heaps.csv", "1/1"));
}

TEST_CASE("verify scaling-map: a budget that is spent leaves heaps out and says so",
          "[app][verify][scaling_map]") {
    const Folder f;
    const Outcome o = similitude({"verify", "scaling-map", "--tiny", "--budget", "1 us", "--heaps",
                                  f / "heaps.csv", "--json", "-"});
    CHECK(o.code == 4);
    CHECK(o.json().at("heaps").empty());
    CHECK(o.json().at("heaps_planned") == 4);
    CHECK(o.json().at("cells").at(0).at("verdict") == "not_poured");
}

TEST_CASE("verify scaling-map: shards and budgets that are none are refused",
          "[app][verify][scaling_map][input]") {
    for (const char* shard : {"3/2", "0/2", "1", "1/2x"}) {
        const Outcome o = similitude({"verify", "scaling-map", "--tiny", "--shard", shard});
        CHECK(o.code == 2);
        CHECK(o.err.find("--shard") != std::string::npos);
    }
    CHECK(similitude({"verify", "scaling-map", "--tiny", "--budget", "12"}).code == 2);
}
