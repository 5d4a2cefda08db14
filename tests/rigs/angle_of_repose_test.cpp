// SPDX-License-Identifier: MIT
#include "rigs/angle_of_repose.hpp"

#include "scaling/errors.hpp"
#include "synthetic_heap.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using rigs::Estimator;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double deg = pi / 180.0;

// A continuum's cone of slope `tangent`, apex at (x, 0), on a base of radius 1; no grains, hence no diameter.
rigs::HeightMap exact_cone(double tangent, double x) {
    rigs::HeightMap map{480, 100, 1.0, 0.0, {}};
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) {
            const double px = map.radius(i) * std::cos(map.azimuth(k)) - x;
            const double py = map.radius(i) * std::sin(map.azimuth(k));
            map.z.push_back(std::max(0.0, tangent * (1.0 - std::hypot(px, py))));
        }
    }
    return map;
}

// Mean angle over `heaps` cuts of the lattice.
double mean_angle(const synthetic::Shape& shape, Estimator estimator, int heaps) {
    double sum = 0.0;
    for (int seed = 1; seed <= heaps; ++seed) {
        const auto a = rigs::angle_of_repose(
            rigs::scan(synthetic::heap(shape, static_cast<std::uint64_t>(seed))), estimator);
        REQUIRE(a);
        sum += a->angle;
    }
    return sum / heaps;
}

// Only the skin of a heap is seen: three diameters along the normal let no spot look through to the base.
synthetic::Shape skin_of(synthetic::Shape shape, double tangent) {
    shape.shell = 3.0 * std::hypot(1.0, tangent);
    return shape;
}

// What the roughness of grains allows a line fit to be off, rad. Tops scatter by about 0.25 d along z; the window holds
// about 2 (R/d)^2 grains over a width of 0.6 R, whose standard deviation is 0.17 R: slopes scatter by
// 0.25 d / (0.17 R sqrt(2) R/d) = 4.2 (d/D)^2. Allowed: four times that over the square root of the number of heaps, and
// 0.1 deg for terraces of the lattice.
double roughness(double across, int heaps) {
    return 4.0 * 4.2 / (across * across) / std::sqrt(heaps) + 0.1 * deg;
}

}  // namespace

TEST_CASE("angle of repose: a continuum's cone has the one angle by all five estimators",
          "[rigs][exact]") {
    const double angle = GENERATE(15, 30, 45, 55, 65) * deg;
    const rigs::HeightMap map = exact_cone(std::tan(angle), 0.0);
    const auto at = [&](Estimator e) { return rigs::angle_of_repose(map, e).value(); };
    CHECK(at(Estimator::flank_20_80).angle == Approx(angle).epsilon(1e-10));  // algebra
    CHECK(at(Estimator::cone).angle == Approx(angle).epsilon(1e-8));          // stop rule 1e-9
    // The highest spot lies half a ring off the axis: 1/200 of the height.
    CHECK(std::tan(at(Estimator::two_h_over_d).angle) ==
          Approx(0.995 * std::tan(angle)).epsilon(1e-10));
    // Strips two rings wide see their innermost spot: off by less than a quarter of a ring's width from end to end.
    CHECK(std::tan(at(Estimator::silhouette).angle) == Approx(std::tan(angle)).epsilon(5e-3));
    // Midpoint rule on r (1 - r): relative error (1/100)^2 / 2 = 5e-5.
    CHECK(std::tan(at(Estimator::volume).angle) == Approx(std::tan(angle)).epsilon(6e-5));
    for (const Estimator e : rigs::computed_estimators) {
        CHECK(at(e).samples == 12);
        CHECK(at(e).spread < 0.1 * deg);
    }
}

TEST_CASE("angle of repose: an apex off the axis is found and does not matter to the fits",
          "[rigs][exact]") {
    const double angle = 35.0 * deg;
    const rigs::HeightMap map = exact_cone(std::tan(angle), 0.13);
    CHECK(rigs::apex(map).x == Approx(0.13).margin(0.005));  // half a ring
    CHECK(rigs::apex(map).y == Approx(0.0).margin(0.005));
    CHECK(rigs::angle_of_repose(map, Estimator::cone)->angle == Approx(angle).epsilon(1e-6));
    // The apex from spots half a ring apart is off by e < 0.005, at r > 0.2: 1 - cos(e/r) < 3.2e-4.
    CHECK(rigs::angle_of_repose(map, Estimator::flank_20_80)->angle ==
          Approx(angle).epsilon(3.2e-4));
}

// Slope m (1 + 0.2 cos 2 phi). Mean over a sector of 30 deg: cos 2 phi times sin(30 deg)/(pi/6) = 0.9549; deviation over 12
// sectors: 0.2 * 0.9549 * sqrt(6/11) m = 0.1410 m, times d(angle)/d(tan) = cos^2: 0.06106 rad at 30 deg. The arctangent's
// curvature changes that by less than (0.2 m)^2 = 1.4 %; 2 % are allowed.
TEST_CASE("angle of repose: the spread is that between the sectors", "[rigs][exact]") {
    rigs::HeightMap map{480, 100, 1.0, 0.0, {}};
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) {
            const double m = std::tan(30.0 * deg) * (1.0 + 0.2 * std::cos(2.0 * map.azimuth(k)));
            map.z.push_back(std::tan(30.0 * deg) * 1.3 - m * map.radius(i));
        }
    }
    const auto a = rigs::angle_of_repose(map, Estimator::flank_20_80);
    CHECK(a->spread == Approx(0.06106).epsilon(0.02));
}

TEST_CASE("angle of repose: the ring of grains at the rim takes no part in the fits",
          "[rigs][exact]") {
    rigs::HeightMap map{480, 100, 1.0, 0.1, {}};
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) {
            const bool gap = map.radius(i) > 0.9 && k % 3 == 0;
            map.z.push_back(gap ? 0.0 : 1.0 - 0.5 * map.radius(i));
        }
    }
    const double angle = std::atan(0.5);
    CHECK(rigs::angle_of_repose(map, Estimator::flank_20_80)->angle ==
          Approx(angle).epsilon(1e-10));
    CHECK(rigs::angle_of_repose(map, Estimator::cone)->angle == Approx(angle).epsilon(1e-8));
}

// Bare outside 0.95 and 0.8: the foot is the rim where it comes within a diameter, 0.1, of it.
TEST_CASE("foot: within a diameter of the rim it is the rim", "[rigs][exact]") {
    const double bare = GENERATE(0.95, 0.8);
    rigs::HeightMap map{480, 100, 1.0, 0.1, {}};
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) {
            map.z.push_back(map.radius(i) < bare ? 0.5 * (1.0 - map.radius(i)) : 0.0);
        }
    }
    CHECK(rigs::foot_radius(map) == Approx(bare > 0.9 ? 1.0 : 0.8).epsilon(1e-12));
}

TEST_CASE("angle of repose: grains in a cone have its slope, but for a bias of order d/D",
          "[rigs][synthetic]") {
    const int across = GENERATE(10, 20, 50);
    const double angle = GENERATE(15, 30, 45, 65) * deg, tangent = std::tan(angle);
    const int heaps = across == 50 ? 2 : 8;
    const synthetic::Shape shape = skin_of(synthetic::cone(0.5 * across, tangent), tangent);
    CAPTURE(across, angle / deg);
    CHECK(mean_angle(shape, Estimator::flank_20_80, heaps) ==
          Approx(angle).margin(roughness(across, heaps)));
    CHECK(mean_angle(shape, Estimator::cone, heaps) ==
          Approx(angle).margin(roughness(across, heaps)));
    // The outline is the highest grain of about 2 abreast near the apex and 4 near the foot, which sinks its slope by
    // 0.25 d/D; it is made of fewer grains than the flank, hence three times the scatter.
    const double outline = mean_angle(shape, Estimator::silhouette, heaps);
    CHECK(outline < angle + 3.0 * roughness(across, heaps));
    CHECK(outline > angle - 0.25 / across - 3.0 * roughness(across, heaps));
}

// Tops lie 0.21 d (hollow of the base) + 0.7 d (lowest layer) + 0.5 d above the cone at most, on the mean lower by up to one
// lattice layer, 0.82 d: the mean shift is 0.59 d to 1.41 d, and tan = 3 V/(pi R^3) gains 6 (shift/d) (d/D).
TEST_CASE("volume: a heap of grains holds more than its cone by half a diameter or so everywhere",
          "[rigs][synthetic]") {
    const int across = GENERATE(10, 20, 50);
    const double angle = GENERATE(15, 45, 65) * deg, tangent = std::tan(angle);
    const synthetic::Shape shape = skin_of(synthetic::cone(0.5 * across, tangent), tangent);
    const double gain = std::tan(mean_angle(shape, Estimator::volume, 2)) - tangent;
    CHECK(gain > 6.0 * 0.59 / across);
    CHECK(gain < 6.0 * 1.41 / across);
}

// The highest top is 1.41 d above the cone at most. The lattice has one point in 0.71 d^3, a cone of depth y from its apex
// holds pi y^3/(3 tan^2): one point is expected within y = (0.68 tan^2)^(1/3) d, and within 2 y all but exp(-8) of the cuts have
// one. tan = 2 H/D follows.
TEST_CASE("2h/D: the highest grain stands for the apex", "[rigs][synthetic]") {
    const int across = GENERATE(10, 20, 50);
    const double angle = GENERATE(15, 45, 65) * deg, tangent = std::tan(angle);
    const synthetic::Shape shape = skin_of(synthetic::cone(0.5 * across, tangent), tangent);
    const double gain = std::tan(mean_angle(shape, Estimator::two_h_over_d, 2)) - tangent;
    CHECK(gain < 2.0 * 1.41 / across);
    CHECK(gain > 2.0 * (1.41 - 2.0 * std::cbrt(0.68 * tangent * tangent)) / across);
}

TEST_CASE("angle of repose: fine grains give the cone's angle by every estimator",
          "[rigs][synthetic]") {
    const double tangent = std::tan(40.0 * deg);
    const rigs::HeightMap map =
        rigs::scan(synthetic::heap(skin_of(synthetic::cone(100.0, tangent), tangent), 3));
    const auto at = [&](Estimator e) { return rigs::angle_of_repose(map, e)->angle / deg; };
    CHECK(at(Estimator::flank_20_80) == Approx(40.0).margin(0.1));
    CHECK(at(Estimator::cone) == Approx(40.0).margin(0.1));
    CHECK(at(Estimator::silhouette) == Approx(40.0).margin(0.1 + 0.25 / 200.0 / deg));
    // d(angle) = cos^2 d(tan) = 0.587 * 6 * 1.41/200 and 0.587 * 2 * 1.41/200 at the most.
    CHECK(at(Estimator::volume) == Approx(40.0).margin(0.587 * 6.0 * 1.41 / 200.0 / deg));
    CHECK(at(Estimator::two_h_over_d) == Approx(40.0).margin(0.587 * 2.0 * 1.41 / 200.0 / deg));
}

TEST_CASE(
    "flank and cone: a cut apex, a flat apron, rough and shifted heaps keep the flank's angle",
    "[rigs][synthetic]") {
    const double angle = GENERATE(25, 40, 55) * deg, m = std::tan(angle), r = 25.0;
    const int kind = GENERATE(0, 1, 2, 3);
    synthetic::Shape shape = skin_of(synthetic::cone(r, m), m);
    if (kind == 0) {  // a fifth of the height is missing
        shape.lift = [=](double x, double y) {
            return m * (r - std::max(0.2 * r, std::hypot(x, y)));
        };
    } else if (kind == 1) {  // grains that ran out lie flat on the outer 15 %
        shape.lift = [=](double x, double y) {
            return m * std::max(0.0, 0.85 * r - std::hypot(x, y));
        };
    } else if (kind == 2) {
        shape.noise = 0.15;
    } else {
        shape.lift = [=](double x, double y) { return m * (r - std::hypot(x - 0.1 * r, y)); };
    }
    CAPTURE(kind, angle / deg);
    CHECK(mean_angle(shape, Estimator::flank_20_80, 2) == Approx(angle).margin(roughness(50, 2)));
    CHECK(mean_angle(shape, Estimator::cone, 2) == Approx(angle).margin(roughness(50, 2)));
}

TEST_CASE("angle of repose: a heap 256 times as large has the same angle, bit for bit",
          "[rigs][similarity]") {
    rigs::Heap heap = synthetic::heap(synthetic::cone(8.0, 0.7), 5);
    const rigs::HeightMap small = rigs::scan(heap);
    for (auto& c : heap.centre) c = 256.0 * c;
    for (double& r : heap.radius) r *= 256.0;
    heap.base_radius *= 256.0;
    const rigs::HeightMap large = rigs::scan(heap);
    for (const Estimator e : rigs::computed_estimators) {
        CHECK(rigs::angle_of_repose(small, e)->angle == rigs::angle_of_repose(large, e)->angle);
        CHECK(rigs::angle_of_repose(small, e)->spread == rigs::angle_of_repose(large, e)->spread);
    }
}

TEST_CASE("angle of repose: no grains, no angle", "[rigs][limit]") {
    const rigs::HeightMap map = rigs::scan({{}, {}, 0.01});
    for (const Estimator e : rigs::computed_estimators) {
        CHECK_FALSE(rigs::angle_of_repose(map, e));
    }
    CHECK(rigs::foot_radius(map) == 0.0);
    CHECK(rigs::apex(map).x == 0.0);
}

TEST_CASE("angle of repose: a level has no flank, and one grain is no heap to fit",
          "[rigs][limit]") {
    rigs::HeightMap level{48, 24, 1.0, 0.05, std::vector<double>(48 * 24, 0.3)};
    CHECK_FALSE(rigs::angle_of_repose(level, Estimator::flank_20_80));
    CHECK_FALSE(rigs::angle_of_repose(level, Estimator::silhouette));
    CHECK_FALSE(rigs::angle_of_repose(level, Estimator::cone));
    const rigs::HeightMap one = rigs::scan({{{0.5, 0.0, 0.5}}, {0.5}, 1.0});
    for (const Estimator e : rigs::computed_estimators) {
        const auto a = rigs::angle_of_repose(one, e);
        if (a) CHECK((std::isfinite(a->angle) && std::isfinite(a->spread)));
    }
}

TEST_CASE("angle of repose: every estimator has its name, and the protractor only its name",
          "[rigs][domain]") {
    for (const Estimator e : rigs::computed_estimators) {
        CHECK(rigs::estimator_named(rigs::to_string(e)) == e);
    }
    CHECK(rigs::estimator_named("protractor") == Estimator::protractor);
    CHECK_FALSE(rigs::estimator_named("eye"));
    CHECK_THROWS_AS(rigs::angle_of_repose(exact_cone(0.5, 0.0), Estimator::protractor),
                    scaling::InvalidParameter);
}
