// SPDX-License-Identifier: MIT
// Walls of triangles against what does not know them: figures by hand, a search over all triangles with another formula,
// and the primitives of walls.hpp.
#include "dem_min/mesh.hpp"

#include "dem_min/random.hpp"
#include "scaling/errors.hpp"
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

using contact::cross;
using contact::dot;
using contact::norm;
using dem_min::Surface;
using dem_min::Vec3;
using dem_min::Wall;
using dem_min::WallDistance;

namespace {

constexpr double pi = std::numbers::pi;

// x and y in steps over a grid, z = f(x, y); each cell is cut along one of its diagonals, in turn.
Surface sheet(int cells, const std::function<Vec3(double, double)>& place) {
    Surface s;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) s.vertices.push_back(place(i, j));
    const int row = cells + 1;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const int a = j * row + i, b = a + 1, c = a + row, d = c + 1;
            const bool turned = (i + j) % 2 == 1;
            s.triangles.push_back({a, b, turned ? c : d});
            s.triangles.push_back({turned ? d : a, c, turned ? b : d});
        }
    return s;
}

// The surface between two rings of `sides` points at (r0, z0) and (r1, z1) about z; at r = 0 a ring is a point.
Surface ring(int sides, double r0, double z0, double r1, double z1) {
    Surface s;
    for (int k = 0; k < sides; ++k) {
        const double c = std::cos(2.0 * pi * k / sides), sn = std::sin(2.0 * pi * k / sides);
        s.vertices.push_back({r0 * c, r0 * sn, z0});
        s.vertices.push_back({r1 * c, r1 * sn, z1});
    }
    if (r0 == 0.0) s.vertices.push_back({0.0, 0.0, z0});
    for (int k = 0; k < sides; ++k) {
        const int a = 2 * k, b = 2 * ((k + 1) % sides);
        if (r0 == 0.0) {
            s.triangles.push_back({2 * sides, a + 1, b + 1});
        } else {
            s.triangles.push_back({a, b, a + 1});
            s.triangles.push_back({b, b + 1, a + 1});
        }
    }
    return s;
}

// [0, 1]^3; the triangles of a face turn about in no agreed way.
Surface cube() {
    Surface s;
    for (int k = 0; k < 8; ++k)
        s.vertices.push_back({double(k & 1), double(k >> 1 & 1), double(k >> 2)});
    s.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 6, 5}, {5, 6, 7}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 5, 7}};
    return s;
}

Surface scaled(Surface s, double factor) {
    for (Vec3& v : s.vertices) v = factor * v;
    return s;
}

// Another way to the distance of a triangle: the foot on the plane from the normal equations, else the nearest of three segments.
double distance_by_hand(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
    const Vec3 u = b - a, v = c - a, w = p - a;
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
    const double s = (vv * dot(u, w) - uv * dot(v, w)) / determinant;
    const double t = (uu * dot(v, w) - uv * dot(u, w)) / determinant;
    if (s >= 0.0 && t >= 0.0 && s + t <= 1.0) return norm(w - s * u - t * v);
    const auto segment = [&](Vec3 from, Vec3 to) {
        const Vec3 e = to - from;
        return norm(p - from - std::clamp(dot(p - from, e) / dot(e, e), 0.0, 1.0) * e);
    };
    return std::min({segment(a, b), segment(b, c), segment(c, a)});
}

double distance_by_hand(const Surface& s, Vec3 p) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [i, j, k] : s.triangles) {
        const auto at = [&](int v) { return s.vertices[static_cast<std::size_t>(v)]; };
        least = std::min(least, distance_by_hand(at(i), at(j), at(k), p));
    }
    return least;
}

// Distances of the walls that answer, rising.
std::vector<double> answers(const std::vector<Wall>& walls, Vec3 p) {
    std::vector<double> result;
    for (const Wall& wall : walls) {
        const WallDistance way = distance(wall, p);
        REQUIRE(norm(way.n) == Approx(1.0).epsilon(1e-14));
        if (std::isfinite(way.distance)) result.push_back(way.distance);
    }
    std::sort(result.begin(), result.end());
    return result;
}

// What a grain feels that touches the nearest of them with an overlap of up to a fifth of its radius. The far side of a body is
// felt too, but it is farther off.
std::vector<double> felt(const std::vector<Wall>& walls, Vec3 p) {
    std::vector<double> result = answers(walls, p);
    while (!result.empty() && result.back() > 1.25 * result.front()) result.pop_back();
    return result;
}

Vec3 drawn(std::uint64_t stream, std::uint64_t k, double low, double high) {
    const dem_min::RandomStream numbers{stream, 0};
    const auto one = [&](std::uint64_t n) {
        return low + (high - low) * numbers.uniform(3 * k + n);
    };
    return {one(0), one(1), one(2)};
}

}  // namespace

TEST_CASE("cube: six walls, one per face", "[dem_min][mesh][exact]") {
    const std::vector<Wall> walls = dem_min::mesh_walls(cube());
    REQUIRE(walls.size() == 6);
    // Inside, all six are felt: 0.25, 0.75, 0.375, 0.625, 0.5, 0.5.
    CHECK(answers(walls, {0.25, 0.375, 0.5}) ==
          std::vector<double>{0.25, 0.375, 0.5, 0.5, 0.625, 0.75});
    const auto one = [&](Vec3 p, double d, Vec3 n) {  // 1e-15: one square root
        const std::vector<double> found = felt(walls, p);
        REQUIRE(found.size() == 1);
        CHECK(found[0] == Approx(d).epsilon(1e-15));
        for (const Wall& wall : walls)
            if (const WallDistance way = distance(wall, p); way.distance == found[0])
                CHECK(norm(way.n - n) < 1e-15);
    };
    one({0.5, 0.25, 1.5}, 0.5, {0.0, 0.0, -1.0});                     // over a face
    one({0.96875, 0.25, 1.125}, 0.125, {0.0, 0.0, -1.0});             // over a face, near its edge
    one({0.96875, 0.96875, 1.125}, 0.125, {0.0, 0.0, -1.0});          // near its corner
    one({1.0, 0.25, 1.125}, 0.125, {0.0, 0.0, -1.0});                 // straight over the edge
    one({1.0, 1.0, 1.125}, 0.125, {0.0, 0.0, -1.0});                  // straight over the corner
    one({1.75, 0.5, 2.0}, 1.25, {-0.6, 0.0, -0.8});                   // off an edge, 3-4-5
    one({-3.0, -4.0, 0.5}, 5.0, {0.6, 0.8, 0.0});                     // off another
    one({3.0, 3.0, 2.0}, 3.0, {-2.0 / 3.0, -2.0 / 3.0, -1.0 / 3.0});  // off a corner, 1-2-2
}

// From outside a convex body the nearest point is one, so one wall must answer, wherever: a grain is pushed once.
// The coarse grid holds points straight over edges and corners, where everything ties.
TEST_CASE("outside a convex body one wall answers, with the distance of the body",
          "[dem_min][mesh][exact]") {
    Surface body = cube();
    const bool sheared = GENERATE(false, true);
    if (sheared)  // edges of no round number, angles between faces of 60 to 120 degrees
        for (Vec3& v : body.vertices) v = {v.x + 0.3 * v.y, v.y + 0.2 * v.z, v.z + 0.1 * v.x};
    const std::vector<Wall> walls = dem_min::mesh_walls(body);
    REQUIRE(walls.size() == 6);
    const auto outside = [&](Vec3 p) {  // of the cube that was sheared: 6x6 solve by hand, Cramer
        if (!sheared) return p.x < 0 || p.x > 1 || p.y < 0 || p.y > 1 || p.z < 0 || p.z > 1;
        const double D = 1.0 + 0.3 * 0.2 * 0.1;
        const double x = (p.x - 0.3 * p.y + 0.3 * 0.2 * p.z) / D;
        const double z = p.z - 0.1 * x, y = p.y - 0.2 * z;
        return x < 0 || x > 1 || y < 0 || y > 1 || z < 0 || z > 1;
    };
    std::vector<Vec3> points;
    for (int i = -4; i <= 12; ++i)
        for (int j = -4; j <= 12; ++j)
            for (int k = -4; k <= 12; ++k) points.push_back({i / 8.0, j / 8.0, k / 8.0});
    for (std::uint64_t k = 0; k < 20000; ++k) points.push_back(drawn(1, k, -0.3, 1.6));
    int asked = 0;
    for (const Vec3& p : points) {
        if (!outside(p)) continue;
        ++asked;
        const std::vector<double> found = felt(walls, p);
        REQUIRE(found.size() == 1);
        REQUIRE(found[0] == Approx(distance_by_hand(body, p)).epsilon(1e-12).margin(1e-15));
    }
    REQUIRE(asked > 15000);
}

// Round-off: points nearest to an edge or corner to within the last bits, where the sides of a test disagree.
TEST_CASE("at the border of what an edge and a face hold, somebody answers once",
          "[dem_min][mesh][exact]") {
    Surface body = cube();
    for (Vec3& v : body.vertices) v = {v.x + 0.3 * v.y, v.y + 0.2 * v.z, v.z + 0.1 * v.x};
    const std::vector<Wall> walls = dem_min::mesh_walls(body);
    for (std::uint64_t k = 0; k < 20000; ++k) {
        // A point of a face's edge, or its end, and from there along the face's outward normal: both answer for it in turn.
        const Vec3 a = body.vertices[5], b = body.vertices[7], c = body.vertices[4];
        Vec3 n = cross(b - a, c - a);  // of the face z = 1
        n = (1.0 / norm(n)) * n;
        if (n.z < 0.0) n = -n;
        const Vec3 u = drawn(2, k, 0.0, 1.0);
        const double along = k % 3 == 0 ? 0.0 : u.x;
        Vec3 p = a + along * (b - a) + (0.01 + u.y) * n;
        const double bit = std::numeric_limits<double>::epsilon();
        p.x *= 1.0 + (static_cast<double>(k % 5) - 2.0) * bit;
        REQUIRE(felt(walls, p).size() == 1);
    }
}

TEST_CASE("a rough sheet: the tree finds what a search over all triangles finds",
          "[dem_min][mesh][exact]") {
    const dem_min::RandomStream heights{3, 0};
    const double roughness = GENERATE(0.15, 1.5);  // one patch; many
    std::uint64_t next = 0;
    const Surface s = sheet(12, [&](double x, double y) {
        return Vec3{x, y, roughness * heights.uniform(next++)};
    });
    const std::vector<Wall> walls = dem_min::mesh_walls(s);
    if (roughness < 1.0) REQUIRE(walls.size() == 1);
    if (roughness > 1.0) REQUIRE(walls.size() > 20);
    for (std::uint64_t k = 0; k < 3000; ++k) {
        const Vec3 p = drawn(4, k, -2.0, 14.0);
        const double expected = distance_by_hand(s, p);
        double clear = std::numeric_limits<double>::infinity();
        for (const Wall& wall : walls) {
            clear = std::min(clear, clearance(wall, p));
            REQUIRE(clearance(wall, p) <= distance(wall, p).distance);
        }
        // 1e-12: the solve by hand loses some digits on thin triangles
        REQUIRE(clear == Approx(expected).epsilon(1e-12).margin(1e-13));
        const std::vector<double> found = answers(walls, p);
        REQUIRE(!found.empty());
        REQUIRE(found[0] == clear);  // whoever is nearest answers
        for (const double d : found) REQUIRE((d == found[0] || d > found[0] * (1.0 + 1e-13)));
    }
}

// A surface of N flats inside a round one of radius R is never farther from it than the sagitta R (1 - cos(pi/N)), hence no
// distance differs by more.
TEST_CASE("cone, tube and disc of triangles are those of walls.hpp, but for the sagitta",
          "[dem_min][mesh][exact]") {
    const int sides = GENERATE(24, 96);
    const double r = 3.0, sagitta = r * (1.0 - std::cos(pi / sides));
    const int shape = GENERATE(0, 1, 2);
    const Surface s = shape == 0   ? ring(sides, 1.0, 0.0, r, 4.0)
                      : shape == 1 ? ring(sides, r, 0.0, r, 2.0)
                                   : ring(sides, 0.0, 1.0, r, 1.0);
    const Wall round = shape == 0   ? dem_min::cone(1.0, 0.0, r, 4.0)
                       : shape == 1 ? dem_min::tube(r, 0.0, 2.0)
                                    : dem_min::disc(r, 1.0);
    const std::vector<Wall> walls = dem_min::mesh_walls(s);
    REQUIRE(walls.size() == 1);
    double worst = 0.0, tilt = 0.0;
    for (std::uint64_t k = 0; k < 4000; ++k) {
        const Vec3 p = drawn(5, k, -5.0, 5.0);
        const WallDistance flat = distance(walls[0], p), exact = distance(round, p);
        worst = std::max(worst, std::abs(flat.distance - exact.distance));
        // Inside a tube or cone the ways to both sides may be alike: only where one is clearly nearest is n compared.
        const double from_axis = std::hypot(p.x, p.y);
        if (from_axis > 1.5 && from_axis < 4.5 && exact.distance > 0.2)
            tilt = std::max(tilt, norm(flat.n - exact.n));
    }
    CHECK(worst <= sagitta * (1.0 + 1e-9));
    CHECK(worst > 0.3 * sagitta);  // the bound is no idle one
    // A flat leans by at most pi/N from the round; at the rim, over a gap of 0.2, by 2 sagittas / 0.2 more.
    CHECK(tilt <= pi / sides + 10.0 * sagitta);
}

// 35 degrees is where a bend becomes an edge: 12 sides bend by 30, 10 by 36.
TEST_CASE("a tube of twelve sides is one wall, of ten sides ten", "[dem_min][mesh]") {
    REQUIRE(dem_min::mesh_walls(ring(12, 1.0, 0.0, 1.0, 1.0)).size() == 1);
    REQUIRE(dem_min::mesh_walls(ring(10, 1.0, 0.0, 1.0, 1.0)).size() == 10);
    Surface folded;  // a fold of 180 degrees is an edge, though both triangles lie in one plane
    folded.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
    folded.triangles = {{0, 1, 2}, {0, 1, 3}};
    REQUIRE(dem_min::mesh_walls(folded).size() == 2);
}

// Two squares that meet at a right angle along x = z = 0. The upright one has a vertex more on the common edge, and a triangle
// of no area closes the gap, as files have it.
TEST_CASE("a triangle without area joins what it lies in, and the ridge stays one edge",
          "[dem_min][mesh]") {
    Surface s;
    s.vertices = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, -1}, {0, 1, -1}, {0, 0.5, 0}};
    s.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 1, 6}, {0, 6, 4}, {6, 5, 4}, {6, 1, 5}};
    if (GENERATE(false, true)) {  // or two vertices there, all but one, and a sliver on each side
        s.vertices.push_back({0, 0.5 + 1e-8, 0});
        s.triangles = {{0, 6, 2}, {6, 7, 2}, {7, 1, 2}, {1, 3, 2},
                       {0, 6, 4}, {6, 5, 4}, {6, 7, 5}, {7, 1, 5}};
    }
    const std::vector<Wall> walls = dem_min::mesh_walls(s);
    REQUIRE(walls.size() == 2);
    for (std::uint64_t k = 0; k < 2000; ++k) {
        const Vec3 p = drawn(6, k, -0.9, 0.9) + Vec3{0.0, 0.95, 0.0};
        if (p.x > 0.0 && p.z < 0.0) continue;  // in the corner two answer
        const std::vector<double> found = felt(walls, p);
        REQUIRE(found.size() == 1);
        const double y = p.y - std::clamp(p.y, 0.0, 1.0);
        const double to_plate = norm({p.x - std::clamp(p.x, 0.0, 1.0), y, p.z}),
                     to_upright = norm({p.x, y, p.z - std::clamp(p.z, -1.0, 0.0)});
        // 1e-8: how far the two vertices are apart
        REQUIRE(found[0] == Approx(std::min(to_plate, to_upright)).epsilon(1e-12).margin(1e-8));
    }
    s.triangles.push_back({2, 3, 1});  // given twice, it still pushes once
    REQUIRE(answers(dem_min::mesh_walls(s), {0.75, 0.75, 0.5}) == std::vector<double>{0.5});
}

TEST_CASE("the same mesh times a power of two gives the same digits", "[dem_min][mesh][golden]") {
    const double factor = GENERATE(std::ldexp(1.0, -20), 256.0);
    const dem_min::RandomStream heights{7, 0};
    std::uint64_t next = 0;
    const Surface s = sheet(10, [&](double x, double y) {
        return Vec3{x, y, 1.1 * heights.uniform(next++)};
    });
    const std::vector<Wall> original = dem_min::mesh_walls(s),
                            larger = dem_min::mesh_walls(scaled(s, factor));
    REQUIRE(original.size() == larger.size());
    for (std::uint64_t k = 0; k < 1000; ++k) {
        const Vec3 p = drawn(8, k, -1.0, 11.0);
        for (std::size_t w = 0; w < original.size(); ++w) {
            const WallDistance a = distance(original[w], p), b = distance(larger[w], factor * p);
            REQUIRE(factor * a.distance == b.distance);
            REQUIRE(a.n == b.n);
            const auto patch = dem_min::scaled(std::get<dem_min::MeshPatch>(original[w]), factor);
            if (k < 10) REQUIRE(distance(patch, factor * p).distance == b.distance);
            if (k < 10) REQUIRE(bounds(patch).high == bounds(larger[w]).high);
        }
    }
}

TEST_CASE("boxes hold their walls", "[dem_min][mesh][walls]") {
    const dem_min::Box face = bounds(dem_min::mesh_walls(cube())[1]);  // z = 1
    CHECK((face.low == Vec3{0, 0, 1} && face.high == Vec3{1, 1, 1}));
    const dem_min::Box shell = bounds(dem_min::cone(1.0, 5.0, 4.0, 3.0));
    CHECK((shell.low == Vec3{-4, -4, 3} && shell.high == Vec3{4, 4, 5}));
    CHECK(std::isinf(bounds(Wall{dem_min::Plane{{}, {0, 0, 1}}}).high.z));
}

TEST_CASE("a mesh that is none is refused", "[dem_min][mesh][domain]") {
    Surface s = cube();
    s.vertices[3].y = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(dem_min::mesh_walls(s), scaling::InvalidParameter);
    s = cube();
    s.triangles[2][1] = 8;
    CHECK_THROWS_AS(dem_min::mesh_walls(s), scaling::InvalidParameter);
    s.triangles = {{1, 1, 2}};
    CHECK_THROWS_AS(dem_min::mesh_walls(s), scaling::InvalidParameter);
}
