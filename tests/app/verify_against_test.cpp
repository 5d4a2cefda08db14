// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>

using Catch::Matchers::Contains;

TEST_CASE("verify --against lammps: figures with their bars, rules that differ, a page",
          "[app][verify][lammps]") {
    const Folder folder;
    const Outcome o = similitude({"verify", "--against", "lammps", "--small", "--out",
                                  folder / "out", "--json", "-", "--report", folder / "page.html"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const auto json = o.json();
    CHECK(json.at("verdict") == "yes");
    CHECK(json.at("checks").size() > 40);
    CHECK(json.at("against").at("engine") == "lammps");
    CHECK(json.at("against").at("heaps").is_null());
    CHECK(json.at("against").at("differences").size() == 8);
    CHECK_THAT(contents(folder / "page.html"),
               Contains("Figures and their bars") && Contains("Where the rules differ"));
    // The deck stays where a reader can run it again.
    CHECK_THAT(contents(folder / "out/similitude-lammps/led/deck.in"),
               Contains("pair_style granular"));
}

TEST_CASE("verify --against: other engines and other extents are refused",
          "[app][verify][lammps]") {
    CHECK(similitude({"verify", "--against", "edem"}).code == 2);
    CHECK(similitude({"verify", "--against", "lammps", "--full"}).code == 2);
    CHECK(similitude({"verify", "--against", "lammps", "--exact"}).code == 2);
}

TEST_CASE("verify --against lammps: without the program the message names the package",
          "[app][verify][lammps]") {
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    const Outcome o = similitude({"verify", "--against", "lammps", "--small"});
    setenv("PATH", path.c_str(), 1);
    CHECK(o.code == 2);
    CHECK_THAT(o.err, Contains("apt-get install lammps"));
}
