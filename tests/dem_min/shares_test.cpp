// SPDX-License-Identifier: MIT
#include "dem_min/shares.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <thread>
#include <vector>

namespace {

TEST_CASE(
    "shares: each thread walks its own run, every other one downwards, and then helps the fullest",
    "[dem_min]") {
    dem_min::Shares shares({0, 3, 6, 11});
    REQUIRE(shares.take(0) == 0);
    REQUIRE(shares.take(1) == 5);
    REQUIRE(shares.take(0) == 1);
    REQUIRE(shares.take(0) == 2);
    REQUIRE(shares.take(2) == 6);
    REQUIRE(shares.take(0) == 10);  // the far end of the longest run, whose owner walks up
    REQUIRE(shares.take(2) == 7);
    REQUIRE(shares.take(2) == 8);
    REQUIRE(shares.take(0) == 3);  // 3, 4 are left of the second run, whose owner walks down
    REQUIRE(shares.take(1) == 4);
    REQUIRE(shares.take(1) == 9);
    for (int thread = 0; thread < 3; ++thread) REQUIRE(shares.take(thread) == -1);
}

TEST_CASE("shares: threads that race get each tile once", "[dem_min]") {
    constexpr int tiles = 20000;
    dem_min::Shares shares({0, 100, 100, tiles});  // most of it in one run, one run empty
    std::vector<std::vector<int>> got(3);
    {
        std::vector<std::jthread> threads;
        for (int k = 0; k < 3; ++k)
            threads.emplace_back([&, k] {
                for (int t = shares.take(k); t >= 0; t = shares.take(k))
                    got[static_cast<std::size_t>(k)].push_back(t);
            });
    }
    std::vector<int> all;
    for (const std::vector<int>& part : got) all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end());
    REQUIRE(all.size() == tiles);
    for (int t = 0; t < tiles; ++t) REQUIRE(all[static_cast<std::size_t>(t)] == t);
}

}  // namespace
