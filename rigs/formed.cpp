// SPDX-License-Identifier: MIT
#include "rigs/formed.hpp"

#include "rigs/angle_of_repose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigs {
namespace {

double share_covered(const HeightMap& map) {
    double covered = 0.0, all = 0.0;
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) {
            all += map.area(i);
            covered += map.z[k * map.rings + i] > 0.0 ? map.area(i) : 0.0;
        }
    }
    return covered / all;
}

// Largest z(r2) - z(r1) with r2 > r1, m.
double largest_rise(const RadialProfile& profile) {
    double lowest = profile.z.front(), rise = 0.0;
    for (const double z : profile.z) {
        lowest = std::min(lowest, z);
        rise = std::max(rise, z - lowest);
    }
    return rise;
}

// Mean height of the rings between two shares of the base's radius, m.
double mean_height(const HeightMap& map, const RadialProfile& profile, double from, double to) {
    double area = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < map.rings; ++i) {
        if (profile.r[i] < from * map.base_radius || profile.r[i] > to * map.base_radius) continue;
        area += map.area(i);
        sum += map.area(i) * profile.z[i];
    }
    return sum / area;
}

}  // namespace

Formed formed(const HeightMap& map, const HeapHistory& history) {
    const bool any = map.grain_diameter > 0.0 && height(map) > 0.0;
    // Without grains the lengths, all zero, are left as they are.
    const double d = any ? map.grain_diameter : map.base_radius;
    const RadialProfile profile = radial_profile(map);
    const double covered = share_covered(map), rise = largest_rise(profile) / d;
    const double fall =
        (mean_height(map, profile, 0.0, 0.25) - mean_height(map, profile, 0.75, 1.0)) / d;
    const double gap = (map.base_radius - foot_radius(map)) / d;
    const Point top = apex(map);
    const double off = std::hypot(top.x, top.y) / d;
    const double farthest = std::max(1.0, 0.1 * map.base_radius / d);
    Formed verdict{any, {}};
    verdict.criteria = {
        {"base_covered", covered, ">= 0.8", any && covered >= 0.8},
        {"falls_outwards", rise, "<= 1", any && rise <= 1.0},
        {"stands_above_rim", fall, ">= 1", any && fall >= 1.0},
        {"reaches_rim", gap, "<= 1, or grains spilled", any && (gap <= 1.0 || history.spilled > 0)},
        {"at_rest", history.kinetic_energy, "< 1e-6", history.kinetic_energy < 1e-6},
        {"apex_near_axis", off, fmt::format("<= {:.3g}", farthest), any && off <= farthest}};
    for (const Criterion& c : verdict.criteria) verdict.formed = verdict.formed && c.pass;
    return verdict;
}

}  // namespace rigs
