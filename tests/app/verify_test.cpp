// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

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
