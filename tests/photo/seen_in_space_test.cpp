// SPDX-License-Identifier: MIT
// Heaps in space seen by a camera, projected point by point: nothing here knows the formula or the fit.
#include "photo/measure.hpp"
#include "rendered_heap.hpp"
#include "rigs/angle_of_repose.hpp"
#include "synthetic_heap.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using std::numbers::pi;
constexpr double deg = pi / 180.0;
using Vec = std::array<double, 3>;

double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A pinhole camera at `distance` from the apex of a cone (height 1), which it looks down at by `down`, its axis through the apex. Highest and lowest
// projected point of the cone's surface over each of `columns` columns; pixels from the principal point, y up.
struct Seen {
    std::vector<double> top, bottom;
};

Seen cone_seen(double angle, double down, double distance, double focal, long columns) {
    const Vec apex{0.0, 0.0, 1.0};
    const Vec forward{0.0, std::cos(down), -std::sin(down)},
        up{0.0, std::sin(down), std::cos(down)};
    const Vec camera{0.0, -distance * std::cos(down), 1.0 + distance * std::sin(down)};
    Seen seen{std::vector<double>(static_cast<std::size_t>(columns), -1e9),
              std::vector<double>(static_cast<std::size_t>(columns), 1e9)};
    for (int k = 0; k < 7200; ++k)
        for (int i = 0; i <= 600; ++i) {
            const double phi = 2.0 * pi * k / 7200.0, depth = i / 600.0,
                         r = depth / std::tan(angle);
            const Vec p{r * std::cos(phi) - camera[0], r * std::sin(phi) - camera[1],
                        apex[2] - depth - camera[2]};
            const double x = focal * p[0] / dot(p, forward),
                         y = focal * dot(p, up) / dot(p, forward);
            const long column = std::lround(x) + columns / 2;
            if (column < 0 || column >= columns) continue;
            auto& top = seen.top[static_cast<std::size_t>(column)];
            auto& bottom = seen.bottom[static_cast<std::size_t>(column)];
            top = std::max(top, y), bottom = std::min(bottom, y);
        }
    return seen;
}

}  // namespace

// 0.4 deg: the points are 1 to 2 pixels apart, so the outline is that much too low, more so at the flank's ends.
TEST_CASE(
    "photo: a cone seen from above or below, near or far, is read right once the camera's angle is "
    "stated",
    "[photo][space]") {
    const double down = GENERATE(0.0, 10.0, -8.0, 20.0) * deg, distance = GENERATE(4.0, 40.0);
    const double angle = 40.0 * deg;
    const double focal = 160.0 * distance;
    const Seen seen = cone_seen(angle, down, distance, focal, 640);
    const photo::Picture p = rendered::two_tones(640, 400, [&](double x, double y) {
        const auto column = static_cast<std::size_t>(std::clamp(std::lround(x), 0L, 639L));
        const double above = 120.0 - y;  // the apex at y = 120
        return above <= seen.top[column] && above >= seen.bottom[column];
    });
    photo::Settings s;
    s.looking_down = down, s.looking_down_stated = true;
    const photo::Measurement m = photo::measure(p, s);
    INFO(down / deg << " deg at " << distance << ": "
                    << (m.findings.empty() ? "" : m.findings.back().name));
    REQUIRE(m.heap);
    CHECK(m.heap->angle / deg == Approx(40.0).margin(0.4));
    // Without it the picture shows a flatter heap, by as much as the finding says where it matters.
    const photo::Measurement plain = photo::measure(p, {});
    REQUIRE(plain.heap);
    if (std::abs(down) > 9.0 * deg) CHECK(plain.heap->angle < m.heap->angle - 0.5 * deg);
}

// One heap of spheres: its outline from 12 sides, drawn and measured, against the estimator for simulated heaps. 0.5 deg: the map's strips are
// d/8 wide and take the highest spot, the picture's columns are finer and see between grains; a grain's roughness over 20 d leaves 0.2 deg.
TEST_CASE("photo: pictures of a simulated heap give the simulation's silhouette",
          "[photo][space]") {
    const double tangent = std::tan(33.0 * deg);
    synthetic::Shape shape = synthetic::cone(20.0, tangent);
    shape.noise = 0.05;
    const rigs::Heap heap = synthetic::heap(shape, 3);
    const auto simulated = rigs::angle_of_repose(rigs::scan(heap), rigs::Estimator::silhouette);
    REQUIRE(simulated);
    const double scale = 13.0;  // pixels per diameter
    double sum = 0.0;
    for (int view = 0; view < 12; ++view) {
        const double c = std::cos(pi * view / 12.0), s = std::sin(pi * view / 12.0);
        std::vector<double> top(4 * 640, 0.0);  // quarters of pixels
        for (std::size_t k = 0; k < heap.centre.size(); ++k) {
            const double x = 320.0 + scale * (c * heap.centre[k].x + s * heap.centre[k].y),
                         z = scale * heap.centre[k].z, r = scale * heap.radius[k];
            for (long i = std::lround(4.0 * (x - r)); i <= std::lround(4.0 * (x + r)); ++i) {
                const double dx = 0.25 * static_cast<double>(i) - x;
                if (i < 0 || i >= static_cast<long>(top.size()) || dx * dx >= r * r) continue;
                top[static_cast<std::size_t>(i)] =
                    std::max(top[static_cast<std::size_t>(i)], z + std::sqrt(r * r - dx * dx));
            }
        }
        const photo::Picture p = rendered::two_tones(640, 400, [&](double x, double y) {
            const long i = std::clamp(std::lround(4.0 * x), 0L, 4L * 640 - 1);
            return y < 320.0 && 320.0 - y <= top[static_cast<std::size_t>(i)];
        });
        photo::Settings settings;
        settings.base = {{5.0, 320.0}, {634.0, 320.0}};
        const photo::Measurement m = photo::measure(p, settings);
        INFO(view << " " << m.findings.back().name);
        REQUIRE(m.heap);
        sum += m.heap->angle;
    }
    CHECK(sum / 12.0 / deg == Approx(simulated->angle / deg).margin(0.5));
}
