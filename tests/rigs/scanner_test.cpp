// SPDX-License-Identifier: MIT
#include "rigs/scanner.hpp"

#include "rigs/height_map.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

// scan() finds heights grain by grain on its own grid; heights_at() spot by spot.
TEST_CASE("heights at the spots of a height map are those of the map", "[rigs][scanner]") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> even(-1.0, 1.0);
    rigs::Heap heap{.centre = {}, .radius = {}, .base_radius = 0.01};
    for (int k = 0; k < 200; ++k) {
        heap.centre.push_back(
            {0.011 * even(random), 0.011 * even(random), 0.004 + 0.003 * even(random)});
        heap.radius.push_back(0.001 * (1.0 + 0.5 * even(random)));
    }
    const rigs::HeightMap map = rigs::scan(heap);
    std::vector<double> azimuth, r;
    for (std::size_t k = 0; k < map.azimuths; ++k)
        for (std::size_t i = 0; i < map.rings; ++i)
            azimuth.push_back(map.azimuth(k)), r.push_back(map.radius(i));
    const std::vector<double> z = rigs::heights_at(heap, azimuth, r);
    double worst = 0.0;
    for (std::size_t k = 0; k < z.size(); ++k) worst = std::max(worst, std::abs(z[k] - map.z[k]));
    CHECK(worst < 1e-9);  // at the edge of a grain a height moves by the root of a rounding error
}

TEST_CASE("a spot at -r is the one across the axis, and none is above bare base",
          "[rigs][scanner]") {
    const rigs::Heap heap{.centre = {{0.003, 0.0, 0.001}}, .radius = {0.001}, .base_radius = 0.01};
    const auto z = rigs::heights_at(heap, {0.0, std::numbers::pi, 0.0}, {0.003, -0.003, -0.003});
    CHECK(z[0] == Approx(0.002));
    CHECK(z[1] == Approx(0.002));
    CHECK(z[2] == 0.0);
    CHECK(rigs::heights_at({.centre = {}, .radius = {}, .base_radius = 1.0}, {0.0}, {0.5})[0] ==
          0.0);
}
