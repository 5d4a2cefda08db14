// SPDX-License-Identifier: MIT
#include "dem_min/random.hpp"
#include "dem_min/timestep.hpp"
#include "rigs/compression.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigs {
namespace {

using contact::Vec3;

constexpr std::uint64_t sizes_stream = 31, places_stream = 32;
constexpr double spread = 0.2;  // of diameters, to either side: one size would order at the plates
constexpr double fullest = 0.33;  // random sequential addition jams at 0.38 (Torquato et al. 2006)
constexpr std::uint64_t most_tries = 20'000'000;

// Mean of (d/d0)^3 over the even spread: 1 + spread^2.
std::size_t grains_for(double solid_volume, double d) {
    const double one = std::numbers::pi / 6.0 * d * d * d * (1.0 + spread * spread);
    return static_cast<std::size_t>(std::lround(solid_volume / one));
}

// Where the box repeats itself in x and y.
double square_of_way(Vec3 a, Vec3 b, double width) {
    const auto shorter = [&](double way) { return way - width * std::round(way / width); };
    const double dx = shorter(a.x - b.x), dy = shorter(a.y - b.y), dz = a.z - b.z;
    return dx * dx + dy * dy + dz * dz;
}

void choose_steps(CompressionSetup& s) {
    const double nu = 0.3;  // as in rigs/pile_setup.cpp: E* alone is known
    const double fall = std::sqrt(2.0 * s.gravity * s.cell.height);
    s.time_step =
        dem_min::step_limits({.radius = *std::min_element(s.radius.begin(), s.radius.end()),
                              .density = s.density,
                              .youngs_modulus = 2.0 * (1.0 - nu * nu) * s.grains.e_star,
                              .poisson_ratio = nu,
                              .work_of_adhesion = s.grains.work_of_adhesion,
                              .fastest_impact = std::max(fall, s.cell.speed)})
            .shortest();
    s.skin = 0.2 * s.d;
}

}  // namespace

void fill_cell(CompressionSetup& s, std::uint64_t seed) {
    const CompressionCell& cell = s.cell;
    const double filled = cell.solid_volume / (cell.width * cell.width * cell.height);
    if (!(filled > 0.0 && filled <= fullest))
        throw scaling::InvalidParameter(scaling::mistake(
            "solid_volume", fmt::format("{:.3g} of the cell", filled), "must be 0 to 0.33 of it",
            "a fuller cell cannot be filled at random: make it higher, the piston comes down"));
    const dem_min::RandomStream sizes{seed, sizes_stream}, places{seed, places_stream};
    const std::size_t count = grains_for(cell.solid_volume, s.d);
    s.radius.clear(), s.place.clear();
    double volume = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        s.radius.push_back(0.5 * s.d * (1.0 + spread * (2.0 * sizes.uniform(k) - 1.0)));
        volume += 4.0 / 3.0 * std::numbers::pi * std::pow(s.radius.back(), 3.0);
    }
    for (double& radius : s.radius) radius *= std::cbrt(cell.solid_volume / volume);
    std::uint64_t drawn = 0;
    while (s.place.size() < count && drawn < most_tries) {
        const double radius = s.radius[s.place.size()];
        const Vec3 at{cell.width * places.uniform(3 * drawn),
                      cell.width * places.uniform(3 * drawn + 1),
                      radius + (cell.height - 2.0 * radius) * places.uniform(3 * drawn + 2)};
        ++drawn;
        bool free = true;
        for (std::size_t k = 0; k < s.place.size() && free; ++k) {
            const double reach = radius + s.radius[k];
            free = square_of_way(at, s.place[k], cell.width) > reach * reach;
        }
        if (free) s.place.push_back(at);
    }
    if (s.place.size() < count)
        throw scaling::InvalidParameter(scaling::mistake(
            "width", fmt::format("{:.3g} m", cell.width), "must leave room for the grains",
            "make the cell some grains wide, or higher"));
    choose_steps(s);
}

CompressionSetup scaled(const CompressionSetup& original, const scaling::ScaleMap& map) {
    CompressionSetup s = original;
    const double length = map.factor("length"), time = map.factor("time"),
                 stress = map.factor("stress");
    const auto times = [](double factor, auto&... values) { ((values *= factor), ...); };
    times(length, s.cell.width, s.cell.height, s.d, s.skin);
    times(length * length * length, s.cell.solid_volume);
    times(length / time, s.cell.speed);
    times(time, s.cell.pause, s.time_step);
    times(stress, s.cell.stress, s.grains.e_star, s.grains.g_star, s.plates.e_star,
          s.plates.g_star);
    times(map.factor("density"), s.density);
    times(map.factor("gravity"), s.gravity);
    scale_attraction(s.grains, map), scale_attraction(s.plates, map);
    for (std::size_t k = 0; k < s.radius.size(); ++k)
        times(length, s.radius[k], s.place[k].x, s.place[k].y, s.place[k].z);
    return s;
}

}  // namespace rigs
