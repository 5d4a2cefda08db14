// SPDX-License-Identifier: MIT
#include "dem_min/neighbours.hpp"

#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <set>
#include <utility>

using dem_min::Simulation;
using dem_min::step;
using samples::Powder;
using samples::sticky;

namespace {

std::set<std::pair<int, int>> listed(const dem_min::CandidateList& list) {
    std::set<std::pair<int, int>> pairs;
    for (std::size_t c = 0; c < list.count(); ++c) pairs.insert({list.i[c], list.j[c]});
    return pairs;
}

}  // namespace

// Against all pairs, with sizes that differ by 2 and a gap that grows with R*.
TEST_CASE("the list holds exactly the pairs within reach, gap and skin", "[dem_min][neighbours]") {
    const samples::System system = samples::rain(sticky(), 100, true, true);
    const Simulation s = samples::simulation(system);
    const dem_min::Particles& p = s.grains;
    const double skin = GENERATE(0.6, 1.0, 2.0) * 1e-4;
    const auto gap = [](double r_star) { return 0.4 * r_star; };
    dem_min::Neighbours neighbours;
    dem_min::Contacts pairs, walls;
    find_neighbours(neighbours, p, s.walls, pairs, walls, skin, gap, gap, GENERATE(1, 3));
    std::set<std::pair<int, int>> expected;
    for (int i = 0; i < 100; ++i)
        for (int j = i + 1; j < 100; ++j) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
            const double sum = p.radius[a] + p.radius[b];
            const double r_star = p.radius[a] * p.radius[b] / sum;
            const double apart = contact::norm(p.position(b) - p.position(a)) - sum;
            if (apart <= gap(r_star) + skin) expected.insert({i, j});
        }
    REQUIRE(!expected.empty());
    REQUIRE(listed(neighbours.pairs) == expected);
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
    REQUIRE(s.pairs.count() == 1);
    double longest = 0.0;
    const double speed = gap / 1000.0 / system.time_step;
    while (s.pairs.count() == 1 && longest < 2.0 * gap) {
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
    for (int k = 0; k < 100 && s.pairs.count() == 0; ++k) step(s);
    REQUIRE(s.pairs.count() == 1);
    REQUIRE(s.pairs.i[0] == 0);
    REQUIRE(s.pairs.j[0] == 1);
}

// Fast grains outrun a list in few steps: it must be made anew in time. Two grains 30 diameters
// apart meet head on at 1 m/s.
TEST_CASE("a grain that comes from far is seen when it arrives", "[dem_min][neighbours]") {
    const Powder p = samples::dry();
    Simulation s = samples::simulation(samples::two_grains(p, 1.0, 30.0 * p.diameter, false));
    bool met = false;
    for (int k = 0; k < 5000 && !met; ++k) step(s), met = s.pairs.count() == 1;
    REQUIRE(met);
    REQUIRE(s.time() == Approx(30.0 * p.diameter / 1.0).margin(s.settings.time_step));
}
