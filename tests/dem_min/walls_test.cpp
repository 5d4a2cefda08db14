// SPDX-License-Identifier: MIT
#include "dem_min/walls.hpp"

#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using dem_min::distance;
using dem_min::Vec3;
using dem_min::Wall;
using dem_min::WallDistance;

namespace {

// 1e-14: one square root and a few products.
void require_way(const Wall& wall, Vec3 point, double d, Vec3 n) {
    const WallDistance way = distance(wall, point);
    REQUIRE(way.distance == Approx(d).epsilon(1e-14));
    REQUIRE(contact::norm(way.n - n) < 1e-14);
}

}  // namespace

TEST_CASE("plane: the way is the height above it", "[dem_min][walls][exact]") {
    const Wall plane = dem_min::Plane{{0.0, 0.0, 1.0}, {0.0, 0.6, 0.8}};
    require_way(plane, {5.0, 0.6, 1.8}, 1.0, {0.0, -0.6, -0.8});
    REQUIRE(distance(plane, {0.0, 0.0, 0.0}).distance < 0.0);  // behind it
}

// 3-4-5 triangles from the rim of a disc of radius 2 at z = 1.
TEST_CASE("disc: straight down above the face, to the rim beside it", "[dem_min][walls][exact]") {
    const Wall disc = dem_min::disc(2.0, 1.0);
    require_way(disc, {1.0, -1.0, 1.5}, 0.5, {0.0, 0.0, -1.0});
    require_way(disc, {0.0, 0.0, 0.25}, 0.75, {0.0, 0.0, 1.0});  // from below, on the axis
    require_way(disc, {0.0, 5.0, 5.0}, 5.0, {0.0, -0.6, -0.8});
    require_way(disc, {-5.0, 0.0, -3.0}, 5.0, {0.6, 0.0, 0.8});
}

TEST_CASE("tube: outward from inside, inward from outside, to the rim above",
          "[dem_min][walls][exact]") {
    const Wall tube = dem_min::tube(3.0, 0.0, 2.0);
    require_way(tube, {0.0, -2.0, 1.0}, 1.0, {0.0, -1.0, 0.0});
    require_way(tube, {5.0, 0.0, 1.0}, 2.0, {-1.0, 0.0, 0.0});
    require_way(tube, {0.0, 0.0, 6.0}, 5.0, {0.6, 0.0, -0.8});  // on the axis: one of all ways
    require_way(tube, {0.0, 7.0, -3.0}, 5.0, {0.0, -0.8, 0.6});
}

// Flank from (r, z) = (1, 0) to (4, 4), a 3-4-5 slope: its outward normal downhill is (0.8, -0.6).
TEST_CASE("cone: square to the flank, to the rims beyond it", "[dem_min][walls][exact]") {
    const Wall cone = dem_min::cone(1.0, 0.0, 4.0, 4.0);
    require_way(cone, {2.5 - 0.8, 0.0, 2.0 + 0.6}, 1.0, {0.8, 0.0, -0.6});  // inside
    require_way(cone, {0.0, 2.5 + 1.6, 2.0 - 1.2}, 2.0, {0.0, -0.8, 0.6});  // outside
    require_way(cone, {1.0, 0.0, -3.0}, 3.0, {0.0, 0.0, 1.0});              // below the outlet
    require_way(cone, {0.0, 4.0, 9.0}, 5.0, {0.0, 0.0, -1.0});              // above the top
}

// At rest the overlap carries the weight: 4/3 E* sqrt(R) d^(3/2) = m g.
TEST_CASE("a grain comes to rest on the face of a disc", "[dem_min][walls][pair]") {
    const samples::Powder p = samples::dry();
    samples::System system = samples::rain(p, 1, true, false);
    system.walls = {dem_min::disc(2.0 * p.diameter, 0.0)};
    system.grains[0].position = {0.3 * p.diameter, 0.0, 1.0 * p.diameter};
    system.grains[0].spin = {};
    dem_min::Simulation s = samples::simulation(system);
    for (int k = 0; k < 40000; ++k) step(s);
    const double r = 0.5 * p.diameter, weight = s.grains.mass[0] * p.gravity;
    const double overlap = std::cbrt(std::pow(0.75 * weight / p.e_star, 2) / r);
    REQUIRE(contact::norm(s.grains.velocity(0)) < 1e-9 * std::sqrt(p.gravity * p.diameter));
    REQUIRE(r - s.grains.z[0] == Approx(overlap).epsilon(1e-6));  // what still rings after 0.1 s
    REQUIRE(s.grains.x[0] == 0.3 * p.diameter);
}

TEST_CASE("a grain whose centre is beyond the rim rolls off the disc", "[dem_min][walls][pair]") {
    const samples::Powder p = samples::dry();
    samples::System system = samples::rain(p, 1, true, false);
    const double edge = 2.0 * p.diameter;
    system.walls = {dem_min::disc(edge, 0.0)};
    const bool beyond = GENERATE(false, true);
    system.grains[0].position = {edge + (beyond ? 0.05 : -0.05) * p.diameter, 0.0,
                                 0.6 * p.diameter};
    system.grains[0].spin = {};
    dem_min::Simulation s = samples::simulation(system);
    for (int k = 0; k < 40000 && s.grains.count() > 0; ++k) step(s);
    REQUIRE(s.past.grains_lost == (beyond ? 1 : 0));
    REQUIRE(wall_contact_count(s) == (beyond ? 0 : 1));
}
