// SPDX-License-Identifier: MIT
#include "photo/base_line.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace {

// A heap of 40 deg over x = 150 to 450 on ground that rises by `slope`, 600 columns; `step`: how much lower the ground lies on the right.
std::vector<photo::Pixel> outline(double slope, double step, double noise = 0.1) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0.0, noise);
    std::vector<photo::Pixel> edge;
    for (int x = 0; x < 600; ++x) {
        const double ground = 300.0 - slope * (x - 300.0) + (x > 300 ? step : 0.0);
        edge.push_back(
            {static_cast<double>(x),
             ground - std::max(0.0, 0.84 * (150.0 - std::abs(x - 300.0))) + normal(random)});
    }
    return edge;
}

}  // namespace

TEST_CASE("base line: the ground on both sides, not the heap on it", "[photo][base_line]") {
    const double slope = GENERATE(-0.15, 0.0, 0.08);
    const auto found = photo::find_base_line(outline(slope, 0.0), 600);
    REQUIRE(found);
    CHECK(found->line.slope == Approx(-slope).margin(4.0 * found->slope_error));
    CHECK(found->slope_error < 3e-4);  // 0.1 pixels over 600: 1.7e-4
    CHECK(found->line.y(300.0) == Approx(300.0).margin(0.1));
}

TEST_CASE("base line: a shadow that hangs under it does not turn it", "[photo][base_line]") {
    auto edge = outline(0.0, 0.0);
    for (auto& p : edge)
        if (p.x > 460.0 && p.x < 560.0) p.y += 8.0;
    const auto found = photo::find_base_line(edge, 600);
    REQUIRE(found);
    CHECK(std::abs(found->line.slope) < 1e-3);
}

// The line through both pieces, 2.5 pixels apart over some 450, is wrong by 0.0055; nothing says which piece is right, so the error has to.
TEST_CASE("base line: ground at two levels is told by a larger error", "[photo][base_line]") {
    const auto found = photo::find_base_line(outline(0.0, 2.5), 600);
    REQUIRE(found);
    CHECK(found->slope_error > 0.5 * std::abs(found->line.slope));
    CHECK(std::abs(found->line.slope) > 3e-3);
}

TEST_CASE("base line: none where no ground is seen", "[photo][base_line]") {
    std::vector<photo::Pixel> edge;
    for (int x = 0; x < 600; ++x)
        edge.push_back({static_cast<double>(x), 100.0 + 0.84 * std::abs(x - 300.0)});
    CHECK(!photo::find_base_line(edge, 600));
    CHECK(!photo::find_base_line({}, 600));
}
