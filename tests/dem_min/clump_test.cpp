// SPDX-License-Identifier: MIT
// Mass, volume and moments of rows of spheres.
#include "dem_min/clump.hpp"

#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using dem_min::Clump;
using dem_min::elongated_grain;
using dem_min::row_of_spheres;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double r = 3e-4, density = 2500.0;  // m, kg/m^3

double sphere(double radius) { return density * 4.0 / 3.0 * pi * std::pow(radius, 3); }  // kg

bool inside(const Clump& c, double x, double y, double z) {
    for (const dem_min::Ball& b : c.balls) {
        const double dz = z - b.place.z;
        if (x * x + y * y + dz * dz <= b.radius * b.radius) return true;
    }
    return false;
}

// The same body counted out on a cubic lattice, `fine` points to a radius: no share, no border, no formula.
Clump counted(const Clump& c, int fine) {
    const double step = r / fine, half = dem_min::half_length(c);
    const int wide = fine, high = static_cast<int>(half / step) + 1;
    Clump sum{c.balls, 0.0, {}};
    for (int a = -wide; a < wide; ++a)
        for (int b = -wide; b < wide; ++b)
            for (int k = -high; k < high; ++k) {
                const double x = (a + 0.5) * step, y = (b + 0.5) * step, z = (k + 0.5) * step;
                if (!inside(c, x, y, z)) continue;
                const double m = density * step * step * step;
                sum.mass += m;
                sum.inertia =
                    sum.inertia + m * dem_min::Vec3{y * y + z * z, x * x + z * z, x * x + y * y};
            }
    return sum;
}

}  // namespace

TEST_CASE("a row of one sphere is the sphere, 2/5 m R^2 about every axis", "[dem_min][clump]") {
    const Clump one = row_of_spheres(1, r, 0.0, density);
    REQUIRE(one.mass == Approx(sphere(r)).epsilon(1e-14));
    for (const double moment : {one.inertia.x, one.inertia.y, one.inertia.z})
        REQUIRE(moment == Approx(0.4 * sphere(r) * r * r).epsilon(1e-14));
}

// Two spheres that touch: Steiner's theorem with an arm of R each.
TEST_CASE("a dumbbell of two touching spheres has 4/5 m R^2 along and 14/5 m R^2 across",
          "[dem_min][clump]") {
    const Clump two = row_of_spheres(2, r, 2.0 * r, density);
    const double unit = sphere(r) * r * r;
    REQUIRE(two.mass == Approx(2.0 * sphere(r)).epsilon(1e-14));
    REQUIRE(two.inertia.z == Approx(0.8 * unit).epsilon(1e-13));
    REQUIRE(two.inertia.x == Approx(2.8 * unit).epsilon(1e-13));
    REQUIRE(two.inertia.y == two.inertia.x);
}

// The lens that two spheres share, s apart: pi/12 (4 R + s)(2 R - s)^2, two caps of height R - s/2.
TEST_CASE("what two overlapping spheres share counts once", "[dem_min][clump]") {
    const double s = GENERATE(0.2, 1.0, 1.9) * r;
    const double lens = density * pi / 12.0 * (4.0 * r + s) * (2.0 * r - s) * (2.0 * r - s);
    REQUIRE(row_of_spheres(2, r, s, density).mass == Approx(2.0 * sphere(r) - lens).epsilon(1e-13));
}

// A lattice of 40 points to a radius counts a volume to some 1e-3 (a share of about 1/40 of the surface layer, of either sign).
TEST_CASE("mass and moments of a row are those of its points", "[dem_min][clump]") {
    const int balls = GENERATE(2, 3, 5);
    const Clump row = row_of_spheres(balls, r, GENERATE(0.6, 1.0, 1.7) * r, density);
    const Clump lattice = counted(row, 40);
    REQUIRE(row.mass == Approx(lattice.mass).epsilon(2e-3));
    REQUIRE(row.inertia.x == Approx(lattice.inertia.x).epsilon(2e-3));
    REQUIRE(row.inertia.z == Approx(lattice.inertia.z).epsilon(2e-3));
}

// Cylinder of length h with a hemisphere at each end. With m_c and m_s their masses: I_3 = m_c R^2/2 + 2/5 m_s R^2,
// I_1 = m_c (R^2/4 + h^2/12) + m_s (2/5 R^2 + h^2/4 + 3/8 h R). Waves of the row: (s/R)^2/12 of the section at most, here 3e-5.
TEST_CASE("many spheres close together are a rod with round ends", "[dem_min][clump][limit]") {
    const double h = 2.0 * r;
    const Clump row = row_of_spheres(101, r, h / 100.0, density);
    const double m_c = density * pi * r * r * h, m_s = sphere(r);
    REQUIRE(row.mass == Approx(m_c + m_s).epsilon(3e-5));
    REQUIRE(row.inertia.z == Approx(0.5 * m_c * r * r + 0.4 * m_s * r * r).epsilon(6e-5));
    REQUIRE(row.inertia.x == Approx(m_c * (r * r / 4.0 + h * h / 12.0) +
                                    m_s * (0.4 * r * r + h * h / 4.0 + 0.375 * h * r))
                                 .epsilon(6e-5));
}

TEST_CASE(
    "an elongated grain has the mass of the sphere, is as long as it should be and has no gaps",
    "[dem_min][clump]") {
    const double d = 2.0 * r, a = GENERATE(1.0, 1.05, 1.5, 2.0, 2.2, 3.0, 5.0);
    const Clump grain = elongated_grain(d, a, density);
    const double radius = grain.balls.front().radius;
    CAPTURE(a, grain.balls.size());
    REQUIRE(grain.mass == Approx(sphere(r)).epsilon(1e-15));
    const Clump built = row_of_spheres(
        static_cast<int>(grain.balls.size()), radius,
        grain.balls.size() > 1 ? grain.balls[1].place.z - grain.balls[0].place.z : 0.0, density);
    REQUIRE(built.mass == Approx(grain.mass).epsilon(1e-14));
    REQUIRE(built.inertia.x == Approx(grain.inertia.x).epsilon(1e-14));
    REQUIRE(built.inertia.z == Approx(grain.inertia.z).epsilon(1e-14));
    REQUIRE(dem_min::half_length(grain) == Approx(a * radius).epsilon(1e-14));
    for (std::size_t k = 1; k < grain.balls.size(); ++k)
        REQUIRE(grain.balls[k].place.z - grain.balls[k - 1].place.z <= radius * (1.0 + 1e-14));
    REQUIRE(grain.balls.size() == (a == 1.0   ? 1u
                                   : a <= 1.5 ? 2u
                                   : a == 2.0 ? 3u
                                   : a == 2.2 ? 4u
                                   : a == 3.0 ? 5u
                                              : 9u));
}

TEST_CASE("a grain twice as large is the same clump to the last bit",
          "[dem_min][clump][similarity]") {
    const Clump small = elongated_grain(2.0 * r, 1.7, density),
                large = elongated_grain(4.0 * r, 1.7, density);
    REQUIRE(large.mass == 8.0 * small.mass);
    REQUIRE(large.inertia == 32.0 * small.inertia);
    for (std::size_t k = 0; k < small.balls.size(); ++k) {
        REQUIRE(large.balls[k].place == 2.0 * small.balls[k].place);
        REQUIRE(large.balls[k].radius == 2.0 * small.balls[k].radius);
    }
}

TEST_CASE("a clump that cannot be is refused by name", "[dem_min][clump][domain]") {
    using Catch::Contains;
    CHECK_THROWS_WITH(row_of_spheres(0, r, r, density), Contains("clump.balls"));
    CHECK_THROWS_WITH(row_of_spheres(2, -r, r, density), Contains("clump.radius"));
    CHECK_THROWS_WITH(row_of_spheres(2, r, -r, density), Contains("clump.spacing"));
    CHECK_THROWS_WITH(row_of_spheres(2, r, r, 0.0), Contains("clump.density"));
    CHECK_THROWS_WITH(elongated_grain(2.0 * r, 0.9, density), Contains("clump.aspect_ratio"));
    CHECK_THROWS_AS(elongated_grain(0.0, 2.0, density), scaling::InvalidParameter);
}
