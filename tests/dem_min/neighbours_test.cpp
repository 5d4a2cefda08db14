// SPDX-License-Identifier: MIT
#include "dem_min/neighbours.hpp"

#include "dem_min/random.hpp"
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <utility>

using dem_min::Simulation;
using dem_min::step;
using samples::Powder;
using samples::sticky;

// Against all pairs: sizes that differ by 2 to 10, several tiles, contacts in between, open and periodic boxes.
TEST_CASE("the list holds each pair that its margins can reach and that is not in contact",
          "[dem_min][neighbours]") {
    const double smallest = GENERATE(1.0, 0.5, 0.1);
    const bool periodic = GENERATE(false, true);
    const double d = 1e-4, box = 20.0 * d;
    Simulation s;
    s.settings.time_step = 1e-7;
    s.settings.skin = GENERATE(0.05, 0.4) * d;
    if (periodic) s.settings.period_x = s.settings.period_y = box;
    s.between_grains = s.at_walls = samples::laws(samples::dry());
    const dem_min::RandomStream places{11, 0}, sizes{11, 1};
    for (std::uint64_t k = 0; k < 2600; ++k) {
        const auto place = [&](std::uint64_t axis) { return box * places.uniform(3 * k + axis); };
        const double r = 0.5 * d * (smallest + (1.0 - smallest) * sizes.uniform(k));
        insert(s, {{place(0), place(1), place(2)}, {}, {}, r, 2500.0, k % 7 == 0});
    }
    find_neighbours(s);
    for (std::size_t t = 0; t < s.tiles.size(); ++t) begin_contacts(s, t);
    REQUIRE(pair_count(s) > 100);
    s.list_is_stale = true;
    find_neighbours(s);
    std::set<std::pair<int, int>> listed, expected;
    for (const dem_min::Tile& tile : s.tiles)
        for (std::size_t c = 0; c < tile.near_grains.count(); ++c)
            REQUIRE(listed.insert({tile.near_grains.i[c], tile.near_grains.j[c]}).second);
    const dem_min::Particles& p = s.grains;
    const auto nearest = [&](double way) {
        return periodic ? way - box * std::round(way / box) : way;
    };
    for (std::size_t i = 0; i < p.count(); ++i)
        for (std::size_t j = i + 1; j < p.count(); ++j) {
            const double dx = nearest(p.x[j] - p.x[i]), dy = nearest(p.y[j] - p.y[i]);
            const double apart =
                std::sqrt(dx * dx + dy * dy + (p.z[j] - p.z[i]) * (p.z[j] - p.z[i]));
            const double gap = apart - (p.radius[i] + p.radius[j]);
            const double margin =
                s.tiles[i / dem_min::tile_size].margin + s.tiles[j / dem_min::tile_size].margin;
            const bool both_fixed = p.fixed(i) && p.fixed(j);
            if (gap > 0.0 && gap <= margin && !both_fixed)
                expected.insert({static_cast<int>(i), static_cast<int>(j)});
        }
    REQUIRE(!expected.empty());
    REQUIRE(listed == expected);
}

// Two grains drawn apart slowly, the list made anew at every step by a skin of nothing: the contact
// must live beyond zero overlap, down to the tear-off gap 3/4 (pi^2 w^2 R*/E*^2)^(1/3), and not
// beyond.
TEST_CASE("a stretched adhesive pair is never lost before it tears", "[dem_min][neighbours]") {
    const Powder p = sticky();
    const double pi = 3.14159265358979, r_star = 0.25 * p.diameter;
    const double gap = 0.75 * std::cbrt(pi * pi * p.work_of_adhesion * p.work_of_adhesion * r_star /
                                        (p.e_star * p.e_star));
    samples::System system = samples::two_grains(p, 0.0, 0.0, false);
    system.skin = GENERATE(0.0, 1e-9, 1e-5);
    system.time_step = samples::recommended_step(p, 0.01);
    system.grains[0].fixed = true;
    system.grains[1].position.x -= 1e-7;  // touching
    Simulation s = samples::simulation(system);
    step(s);
    REQUIRE(pair_count(s) == 1);
    double longest = 0.0;
    const double speed = gap / 1000.0 / system.time_step;
    while (pair_count(s) == 1 && longest < 2.0 * gap) {
        longest = std::max(longest, s.grains.x[1] - s.grains.x[0] - p.diameter);
        s.grains.vx[1] = speed, s.grains.fx[1] = 0.0;  // pulled at this speed, whatever resists
        step(s);
    }
    REQUIRE(longest == Approx(gap).epsilon(2e-3));  // one way of a step is 1e-3 of it
}

// A dense grid over their bounding box would need 1e24 cells.
TEST_CASE("grains far apart cost no memory and meet nobody", "[dem_min][neighbours]") {
    samples::System system = samples::two_grains(sticky(), 0.05, 5e-6, false);
    system.grains.push_back({{1e4, 0.0, 0.0}, {}, {}, 5e-5, 2500.0, false});
    system.grains.push_back({{0.0, 1e4, 1e4}, {}, {}, 5e-5, 2500.0, false});
    Simulation s = samples::simulation(system);
    for (int k = 0; k < 100 && pair_count(s) == 0; ++k) step(s);
    REQUIRE(pair_count(s) == 1);
    REQUIRE(s.tiles[0].groups[0].i == std::vector<int>{0});
    REQUIRE(s.tiles[0].groups[0].j == std::vector<int>{1});
}

// Fast grains outrun a list in few steps: it must be made anew in time. Two grains 30 diameters
// apart meet head on at 1 m/s.
TEST_CASE("a grain that comes from far is seen when it arrives", "[dem_min][neighbours]") {
    const Powder p = samples::dry();
    Simulation s = samples::simulation(samples::two_grains(p, 1.0, 30.0 * p.diameter, false));
    bool met = false;
    for (int k = 0; k < 5000 && !met; ++k) step(s), met = pair_count(s) == 1;
    REQUIRE(met);
    REQUIRE(s.time() == Approx(30.0 * p.diameter / 1.0).margin(s.settings.time_step));
}
