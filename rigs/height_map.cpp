// SPDX-License-Identifier: MIT
#include "rigs/height_map.hpp"

#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace rigs {
namespace {

using contact::Vec3;
using scaling::InvalidParameter;
using scaling::mistake;
using std::numbers::pi;

constexpr std::size_t sectors = 12;

void require(const Heap& heap) {
    if (!(heap.base_radius > 0.0) || !std::isfinite(heap.base_radius)) {
        throw InvalidParameter(mistake("heap.base_radius", std::to_string(heap.base_radius) + " m",
                                       "must be > 0", "half of the base's diameter"));
    }
    if (heap.centre.size() != heap.radius.size()) {
        throw InvalidParameter(mistake("heap.radius", std::to_string(heap.radius.size()) + " radii",
                                       "must be as many as centres", "one radius per grain"));
    }
    for (std::size_t g = 0; g < heap.centre.size(); ++g) {
        const Vec3 c = heap.centre[g];
        if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) {
            throw InvalidParameter(mistake("heap.centre[" + std::to_string(g) + "]", "no number",
                                           "must be finite", "drop lost grains from the heap"));
        }
        if (!(heap.radius[g] > 0.0) || !std::isfinite(heap.radius[g])) {
            throw InvalidParameter(mistake("heap.radius[" + std::to_string(g) + "]",
                                           std::to_string(heap.radius[g]) + " m", "must be > 0",
                                           "half of the grain's diameter"));
        }
    }
}

// Calls visit(spot, ring, half) for every spot of the grid that a vertical line through the grain meets; half: half of the
// line's length inside the sphere, m.
template <class Visit>
void for_each_spot_under(Vec3 centre, double radius, const HeightMap& map, Visit visit) {
    const double dr = map.base_radius / static_cast<double>(map.rings);
    const double turn = 2.0 * pi / static_cast<double>(map.azimuths);
    const double rho = std::hypot(centre.x, centre.y), towards = std::atan2(centre.y, centre.x);
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor((rho - radius) / dr)));
    for (std::size_t i = first; i < map.rings; ++i) {
        const double r = map.radius(i);
        if (r - rho > radius) break;
        // Cosine of the azimuth, counted from the centre's, at which the ring leaves the sphere's shadow.
        const double c = (r * r + rho * rho - radius * radius) / (2.0 * r * rho);
        if (!(c < 1.0)) continue;
        const double reach = c <= -1.0 || rho == 0.0 ? pi : std::acos(c);
        const auto from = static_cast<long>(std::ceil((towards - reach) / turn - 0.5));
        const auto most = from + static_cast<long>(map.azimuths) - 1;
        const auto to =
            std::min(most, static_cast<long>(std::floor((towards + reach) / turn - 0.5)));
        for (long k = from; k <= to; ++k) {
            const double angle = (static_cast<double>(k) + 0.5) * turn - towards;
            const double off2 = r * r + rho * rho - 2.0 * r * rho * std::cos(angle);
            const double half2 = radius * radius - off2;
            if (half2 <= 0.0) continue;
            const auto n = static_cast<long>(map.azimuths);
            const auto column = static_cast<std::size_t>(((k % n) + n) % n);
            visit(column * map.rings + i, i, std::sqrt(half2));
        }
    }
}

// The mean profile shrunken by a ball of radius d: highest z at which the centre of that ball stays under the profile,
// which is 0 beyond the rim. Shape [rings]; not above 0 where the ball does not fit.
std::vector<double> shrunken(const RadialProfile& profile, double base_radius, double d) {
    std::vector<double> top(profile.r.size());
    for (std::size_t i = 0; i < top.size(); ++i) {
        const double r = profile.r[i];
        top[i] = r + d < base_radius ? profile.z[i] : 0.0;
        for (std::size_t j = 0; j < top.size(); ++j) {
            const double off = profile.r[j] - r;
            if (std::abs(off) < d)
                top[i] = std::min(top[i], profile.z[j] - std::sqrt(d * d - off * off));
        }
    }
    return top;
}

}  // namespace

double HeightMap::azimuth(std::size_t k) const {
    return 2.0 * pi * (static_cast<double>(k) + 0.5) / static_cast<double>(azimuths);
}

double HeightMap::radius(std::size_t i) const {
    return (static_cast<double>(i) + 0.5) * base_radius / static_cast<double>(rings);
}

double HeightMap::area(std::size_t i) const {
    const double dr = base_radius / static_cast<double>(rings);
    return 2.0 * pi * radius(i) * dr / static_cast<double>(azimuths);
}

HeightMap scan(const Heap& heap) {
    require(heap);
    double sum = 0.0;
    for (const double r : heap.radius) sum += 2.0 * r;
    const double d = heap.radius.empty()
                         ? 0.0
                         : sum / static_cast<double>(heap.radius.size()) / heap.sphere_size;
    // An empty base gets the coarsest grid.
    const double wanted = d > 0.0 ? std::ceil(8.0 * heap.base_radius / d) : 0.0;
    const auto rings = static_cast<std::size_t>(std::clamp(wanted, 24.0, 400.0));
    const std::size_t azimuths =
        sectors *
        static_cast<std::size_t>(std::ceil(2.0 * pi * static_cast<double>(rings) / sectors));
    HeightMap map{azimuths, rings, heap.base_radius, d, std::vector<double>(azimuths * rings, 0.0)};
    for (std::size_t g = 0; g < heap.centre.size(); ++g) {
        const double z = heap.centre[g].z;
        for_each_spot_under(heap.centre[g], heap.radius[g], map,
                            [&](std::size_t spot, std::size_t, double half) {
                                map.z[spot] = std::max(map.z[spot], z + half);
                            });
    }
    return map;
}

double height(const HeightMap& map) {
    return map.z.empty() ? 0.0 : *std::max_element(map.z.begin(), map.z.end());
}

double volume(const HeightMap& map) {
    double sum = 0.0;
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) sum += map.z[k * map.rings + i] * map.area(i);
    }
    return sum;
}

RadialProfile radial_profile(const HeightMap& map) {
    RadialProfile profile;
    const std::size_t per_sector = map.azimuths / sectors;
    for (std::size_t i = 0; i < map.rings; ++i) {
        double mean = 0.0, squares = 0.0;
        std::vector<double> sector(sectors, 0.0);
        for (std::size_t k = 0; k < per_sector * sectors; ++k) {
            sector[k / per_sector] += map.z[k * map.rings + i] / static_cast<double>(per_sector);
        }
        for (const double z : sector) mean += z / static_cast<double>(sectors);
        for (const double z : sector) squares += (z - mean) * (z - mean);
        profile.r.push_back(map.radius(i));
        profile.z.push_back(mean);
        profile.spread.push_back(std::sqrt(squares / static_cast<double>(sectors - 1)));
    }
    return profile;
}

std::optional<PackingFraction> packing_fraction(const Heap& heap, const HeightMap& map) {
    const double d = map.grain_diameter;
    if (!(d > 0.0)) return std::nullopt;
    const std::vector<double> top = shrunken(radial_profile(map), map.base_radius, d);
    double space = 0.0, solid = 0.0;
    for (std::size_t i = 0; i < map.rings; ++i) {
        space += std::max(0.0, top[i] - d) * map.area(i) * static_cast<double>(map.azimuths);
    }
    if (space < 10.0 * d * d * d) return std::nullopt;
    for (std::size_t g = 0; g < heap.centre.size(); ++g) {
        const double z = heap.centre[g].z;
        for_each_spot_under(
            heap.centre[g], heap.radius[g], map, [&](std::size_t, std::size_t ring, double half) {
                const double length = std::min(z + half, top[ring]) - std::max(z - half, d);
                solid += std::max(0.0, length) * map.area(ring);
            });
    }
    return PackingFraction{heap.filled() * solid / space, space};
}

}  // namespace rigs
