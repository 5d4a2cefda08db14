// SPDX-License-Identifier: MIT
#include "rigs/measure.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using contact::Vec3;

namespace {

void put(rigs::Frame& f, Vec3 x, double radius, bool fixed = false) {
    f.id.push_back(static_cast<std::int64_t>(f.count()) + 1);
    f.position.push_back(x), f.velocity.push_back({}), f.spin.push_back({});
    f.radius.push_back(radius), f.mass.push_back(std::nan("")), f.fixed.push_back(fixed ? 1 : 0);
}

// n^3 grains of diameter d, d apart, the first centre at d/2.
rigs::Frame cube(int n, double d) {
    rigs::Frame f;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k)
                put(f, {(i + 0.5) * d, (j + 0.5) * d, (k + 0.5) * d}, 0.5 * d);
    return f;
}

}  // namespace

// A cube of n^3 has 3 n^2 (n - 1) pairs of neighbours along its edges, and n^2 grains on the floor.
TEST_CASE("measure: contacts of a simple cubic block are counted exactly",
          "[rigs][measure][exact]") {
    const int n = GENERATE(1, 2, 7);
    const rigs::Frame f = cube(n, 1e-3);
    const auto on_floor = rigs::contacts_of(f, true, 1e-9);
    CHECK(on_floor.pairs == static_cast<std::size_t>(3 * n * n * (n - 1)));
    CHECK(on_floor.at_base == static_cast<std::size_t>(n * n));
    CHECK(on_floor.coordination ==
          Approx((6.0 * n * n * (n - 1) + n * n) / (n * n * n)).epsilon(1e-15));
    CHECK(rigs::contacts_of(f, false, 1e-9).at_base == 0);
    CHECK(rigs::contacts_of(cube(n, 1.001e-3), false, 1e-9).pairs == on_floor.pairs);
}

TEST_CASE("measure: grains of very different size touch across cells, by sign and gap",
          "[rigs][measure]") {
    rigs::Frame f;
    put(f, {0.0, 0.0, 1.0}, 1.0);
    put(f, {1.25, 0.0, 1.0}, 0.26);  // overlaps by 0.01; R* = 0.26/1.26
    put(f, {0.0, 0.0, 2.11}, 0.1);   // 0.01 apart
    put(f, {0.0, -1.2, 1.0}, 0.2, true);
    put(f, {0.0, -1.6, 1.0}, 0.2, true);  // two fixed ones
    const auto c = rigs::contacts_of(f, false, 1e-12);
    CHECK(c.pairs == 2);
    CHECK(c.coordination == Approx(3.0 / 3.0).epsilon(1e-15));
    CHECK(c.largest_overlap == Approx(0.01 * 1.26 / 0.26).epsilon(1e-12));
    CHECK(rigs::contacts_of(f, false, 0.02).pairs == 3);
}

// Cells are a way to find pairs, never a say in which there are: all pairs are tried here.
TEST_CASE("measure: contacts of scattered grains of many sizes are those that all pairs give",
          "[rigs][measure]") {
    std::mt19937 random(20261126);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    rigs::Frame f;
    for (int k = 0; k < 1000; ++k)
        put(f, {uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(0.0, 2.0)}, uniform(0.02, 0.12),
            k % 7 == 0);
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < f.count(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            pairs += !(f.fixed[i] && f.fixed[j]) &&
                     contact::norm(f.position[i] - f.position[j]) <= f.radius[i] + f.radius[j];
    REQUIRE(pairs > 500);  // or nothing is shown
    CHECK(rigs::contacts_of(f, false, 0.0).pairs == pairs);
}

TEST_CASE("measure: what has fallen off, and what is fixed, is no part of the heap",
          "[rigs][measure]") {
    rigs::Frame f;
    const Vec3 base{1.0, 2.0, 3.0};
    put(f, base + Vec3{0.0, 0.0, 0.1}, 0.1);
    put(f, base + Vec3{5.09, 0.0, 0.1}, 0.1);   // over the rim, still within a radius of it
    put(f, base + Vec3{5.11, 0.0, 0.1}, 0.1);   // beyond
    put(f, base + Vec3{0.0, 0.0, -0.11}, 0.1);  // its top under the base's
    put(f, base + Vec3{0.0, 0.0, -0.1}, 0.1, true);
    const rigs::Measured m = rigs::measure(f, {.base_diameter = 10.0, .base = base});
    CHECK(m.loose == 2);
    CHECK(m.beyond_rim == 1);
    CHECK(m.below_base == 1);
    CHECK(m.fixed == 1);
    REQUIRE(m.heap);
    CHECK_FALSE(m.heap->formed.formed);
    CHECK_FALSE(rigs::measure(f, {}).heap);
    CHECK(rigs::measure(f, {}).loose == 4);
}

// v^2/2 over g d: 0.5 * 1 / (10 * 0.2) = 0.25.
TEST_CASE("measure: rest is judged by velocities, and left open without them", "[rigs][measure]") {
    rigs::Frame f;
    put(f, {0.0, 0.0, 0.1}, 0.1);
    f.velocity[0] = {0.0, 0.6, 0.8};
    rigs::MeasureSettings s{.base_diameter = 1.0, .gravity = 10.0};
    const auto rest = [&]() -> const rigs::Criterion* {
        static rigs::Measured m;
        m = rigs::measure(f, s);
        for (const rigs::Criterion& c : m.heap->formed.criteria)
            if (c.name == "at_rest") return &c;
        return nullptr;
    };
    REQUIRE(rest());
    CHECK(rest()->value == Approx(0.25).epsilon(1e-12));
    s.moving_known = false;
    CHECK(rest() == nullptr);
}
