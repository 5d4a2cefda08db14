// SPDX-License-Identifier: MIT
#include "diagnose/locate.hpp"

#include "line.hpp"

#include <catch2/catch.hpp>

#include <cmath>

// Squares 1 4 4 4 4 1 1 1: 16 of 20 lie in rows 1 to 4.
TEST_CASE("locate: the interval is the shortest that holds 80 % of the squares",
          "[diagnose][locate][exact]") {
    diagnose::Problem p = line::problem(8, 0.0, 0.0, 0.0, 1.0, 0.0, 1);
    Eigen::VectorXd white(8);
    white << 1, -2, -2, -2, -2, 1, 1, 1;
    const auto list = diagnose::located(p, white, 0.001 * white, 0.01);
    REQUIRE(list.size() == 1);
    CHECK(list[0].from == Approx(1.0 / 7.0));
    CHECK(list[0].to == Approx(4.0 / 7.0));
    CHECK(list[0].sign == -1);
    CHECK(list[0].size == Approx(0.002));
}

// z has 6 and 7 of the squares in two recordings, x 9 in one of them.
TEST_CASE(
    "locate: the channel with most of the mismatch comes first, its strongest recording ahead",
    "[diagnose][locate][exact]") {
    diagnose::Problem p = line::problem(4, 0.0, 0.0, 0.0, 1.0, 0.0, 1);
    diagnose::Problem other = line::problem(4, 0.0, 0.0, 0.0, 1.0, 0.0, 2);
    diagnose::Channel x = p.records[0].channels[0];
    x.name = "x", x.first = 4;
    p.records[0].channels.push_back(x);
    other.records[0].channels[0].first = 8;
    p.records.push_back(std::move(other.records[0]));
    p.size = 12;
    Eigen::VectorXd white(12);
    white << 1, 1, 2, 0, 2, 2, 1, 0, 1, 1, 2, 1;
    const auto list = diagnose::located(p, white, white, 0.01);
    REQUIRE(list.size() == 3);
    CHECK(list[0].channel == "z");
    CHECK(list[1].channel == "z");
    CHECK(list[2].channel == "x");
    // By the rms of 80 % of the squares: 1 + 4 + 1 of 7 in the second recording, 1 + 4 of 6 in the first.
    CHECK(list[0].size == Approx(std::sqrt(2.0)));
    CHECK(list[1].size == Approx(std::sqrt(2.5)));
}
