// SPDX-License-Identifier: MIT
#include "rigs/height_map.hpp"

#include "scaling/errors.hpp"
#include "synthetic_heap.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

constexpr double pi = std::numbers::pi;

// Highest point of any grain above (x, y) by definition, all grains asked.
double highest(const rigs::Heap& heap, double x, double y) {
    double z = 0.0;
    for (std::size_t g = 0; g < heap.centre.size(); ++g) {
        const double dx = x - heap.centre[g].x, dy = y - heap.centre[g].y;
        const double half2 = heap.radius[g] * heap.radius[g] - dx * dx - dy * dy;
        if (half2 > 0.0) z = std::max(z, heap.centre[g].z + std::sqrt(half2));
    }
    return z;
}

}  // namespace

TEST_CASE("height map: every spot shows the highest sphere above it", "[rigs][exact]") {
    rigs::Heap heap = synthetic::heap(synthetic::cone(4.0, 0.8), 2);
    heap.centre.push_back(
        {0.0, 0.0, 5.0});  // one on the axis, one astride the rim, one of another size
    heap.centre.push_back({-3.9, 0.0, 3.0});
    heap.centre.push_back({-1.0, 1.0, 4.0});
    heap.radius.insert(heap.radius.end(), {0.5, 0.5, 1.2});
    const rigs::HeightMap map = rigs::scan(heap);
    REQUIRE(map.azimuths % 12 == 0);
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) {
            const double r = map.radius(i), a = map.azimuth(k);
            const double z = highest(heap, r * std::cos(a), r * std::sin(a));
            // Rounding of the squared half chord, 1e-15, under the root: 1e-7 where a line just grazes a sphere.
            REQUIRE(map.z[k * map.rings + i] == Approx(z).margin(1e-6));
        }
    }
}

// One sphere resting on the base: volume under its top is that of a half sphere and the cylinder below it.
TEST_CASE("height map: volume and height of one sphere", "[rigs][exact]") {
    const rigs::HeightMap map = rigs::scan({{{0.3, -0.2, 0.5}}, {0.5}, 2.0});
    CHECK(rigs::height(map) <= 1.0);
    CHECK(rigs::height(map) >
          1.0 - 0.125 * 0.125);  // spots d/8 apart: within d/8 of the pole, 1 - x^2
    const double volume = 2.0 / 3.0 * pi * 0.125 + 0.5 * pi * 0.25;
    CHECK(rigs::volume(map) ==
          Approx(volume).epsilon(0.03));  // some 50 spots cover it, the rim half
}

TEST_CASE("radial profile: a cone's mean heights, with no spread", "[rigs][exact]") {
    rigs::HeightMap map{120, 50, 1.0, 0.0, {}};
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) map.z.push_back(0.6 * (1.0 - map.radius(i)));
    }
    const rigs::RadialProfile p = rigs::radial_profile(map);
    for (std::size_t i = 0; i < map.rings; ++i) {
        CHECK(p.z[i] == Approx(0.6 * (1.0 - p.r[i])).epsilon(1e-12));
        CHECK(p.spread[i] < 1e-12);
    }
}

// A half space z = 1 + x/2: the mean over a ring is 1, and a sector's mean r/2 cos(phi) sin(15 deg)/(pi/12) has a deviation of
// r/2 0.98862 sqrt(6/11) over 12 sectors.
TEST_CASE("radial profile: a tilted level shows as spread, not as slope", "[rigs][exact]") {
    rigs::HeightMap map{480, 50, 1.0, 0.0, {}};
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) {
            map.z.push_back(1.0 + 0.5 * map.radius(i) * std::cos(map.azimuth(k)));
        }
    }
    const rigs::RadialProfile p = rigs::radial_profile(map);
    for (std::size_t i = 0; i < map.rings; ++i) {
        CHECK(p.z[i] == Approx(1.0).epsilon(1e-12));
        // 40 spots a sector stand for its integral to (1.5 deg)^2/24 = 3e-5.
        CHECK(p.spread[i] == Approx(0.5 * p.r[i] * 0.98862 * std::sqrt(6.0 / 11.0)).epsilon(1e-4));
    }
}

// Lattices cut at random: pi/6 and pi/(3 sqrt 2) by their unit cells. A heap 20 d wide has a region of about 300 d^3; a
// region's share of a lattice is off by about the cube root of its volume in grains' cross-sections, 1 % of one cut; over
// ten cuts 0.5 % is allowed.
TEST_CASE("packing fraction: a simple and a face-centred cubic heap have their lattice's",
          "[rigs][exact]") {
    const bool simple = GENERATE(true, false);
    const double tangent = GENERATE(0.5, 1.0, 1.6);
    const double expected = simple ? pi / 6.0 : pi / (3.0 * std::numbers::sqrt2);
    synthetic::Shape shape = synthetic::cone(12.0, tangent);
    shape.simple_cubic = simple;
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const rigs::Heap heap = synthetic::heap(shape, seed);
        const auto phi = rigs::packing_fraction(heap, rigs::scan(heap));
        REQUIRE(phi);
        CHECK(phi->volume > 10.0);
        CHECK(phi->value == Approx(expected).epsilon(0.02));
        sum += 0.1 * phi->value;
    }
    CHECK(sum == Approx(expected).epsilon(0.005));
}

// A level block of radius 9 d: a cylinder of radius 8 d, from 1 d over the base to 1 d under the mean surface, or under the
// lowest ring within reach of the ball; rings' means scatter by some 0.2 d, so 0.3 d are allowed.
TEST_CASE("packing fraction: the region keeps one diameter off base, rim and surface",
          "[rigs][exact]") {
    const rigs::Heap block = synthetic::heap({9.0, [](double, double) { return 6.0; }}, 3);
    const rigs::HeightMap map = rigs::scan(block);
    const double mean = rigs::volume(map) / (pi * 81.0);
    const auto phi = rigs::packing_fraction(block, map);
    REQUIRE(phi);
    CHECK(phi->volume < pi * 64.0 * (mean - 2.0 + 0.3));
    CHECK(phi->volume > pi * 64.0 * (mean - 2.0 - 0.3));
}

TEST_CASE("packing fraction: a heap too small to have an inside has none", "[rigs][limit]") {
    const rigs::Heap layer = synthetic::heap({8.0, [](double, double) { return 0.5; }}, 1);
    CHECK_FALSE(rigs::packing_fraction(layer, rigs::scan(layer)));
    const rigs::Heap none{{}, {}, 1.0};
    CHECK_FALSE(rigs::packing_fraction(none, rigs::scan(none)));
}

TEST_CASE("height map: a heap that makes no sense is refused and named", "[rigs][domain]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(rigs::scan({{}, {}, 0.0}), Catch::Contains("base_radius"));
    CHECK_THROWS_WITH(rigs::scan({{{0.0, 0.0, 0.0}}, {}, 1.0}), Catch::Contains("heap.radius"));
    CHECK_THROWS_WITH(rigs::scan({{{0.0, nan, 0.0}}, {0.5}, 1.0}), Catch::Contains("centre[0]"));
    CHECK_THROWS_WITH(rigs::scan({{{0.0, 0.0, 0.0}}, {-0.5}, 1.0}), Catch::Contains("radius[0]"));
    CHECK_THROWS_AS(rigs::scan({{{0.0, 0.0, 0.0}}, {nan}, 1.0}), scaling::InvalidParameter);
}
