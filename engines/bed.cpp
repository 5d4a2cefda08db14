// SPDX-License-Identifier: MIT
#include "engines/bed.hpp"

#include "dem_min/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace engines {

using contact::Vec3;

namespace {

// The nearest image. m
double shortest(double d, double period) { return d - period * std::round(d / period); }

}  // namespace

Vec3 Bed::acceleration() const { return (gravity / contact::norm(downward)) * downward; }

std::vector<Vec3> positions(const Bed& bed) {
    const dem_min::RandomStream chance{bed.seed, 0};
    std::uint64_t drawn = 0;
    const auto moved = [&](int k) {
        return (k + 0.5) * bed.lattice() + bed.jitter * (2.0 * chance.uniform(drawn++) - 1.0);
    };
    std::vector<Vec3> all;
    all.reserve(static_cast<std::size_t>(bed.grains()));
    for (int z = 0; z < bed.nz; ++z)
        for (int y = 0; y < bed.ny; ++y)
            for (int x = 0; x < bed.nx; ++x) {
                const double at_x = moved(x), at_y = moved(y), at_z = moved(z);  // in this order
                all.push_back({at_x, at_y, at_z});
            }
    return all;
}

std::string positions_data(const Bed& bed, int types) {
    std::string text = fmt::format(
        "bed of {} x {} x {} spheres\n\n{} atoms\n{} atom types\n\n0 {} xlo xhi\n"
        "0 {} ylo yhi\n0 {} zlo zhi\n\nAtoms\n\n",
        bed.nx, bed.ny, bed.nz, bed.grains(), types, bed.period_x(), bed.period_y(), bed.height());
    int id = 0;
    for (const Vec3& at : positions(bed))
        text += fmt::format("{} 1 {} {} {} {} {}\n", ++id, 2.0 * bed.radius, bed.density, at.x,
                            at.y, at.z);
    return text;
}

double overlapping_neighbours(const Bed& bed, const std::vector<Vec3>& at) {
    // Upwards through the bed: from each grain only those less than a diameter above it are tried.
    std::vector<Vec3> rising = at;
    std::sort(rising.begin(), rising.end(), [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
    const double reach = 2.0 * bed.radius;
    std::int64_t pairs = 0;
    for (std::size_t i = 0; i < rising.size(); ++i)
        for (std::size_t j = i + 1; j < rising.size() && rising[j].z - rising[i].z < reach; ++j) {
            const double dx = shortest(rising[j].x - rising[i].x, bed.period_x());
            const double dy = shortest(rising[j].y - rising[i].y, bed.period_y());
            const double dz = rising[j].z - rising[i].z;
            if (dx * dx + dy * dy + dz * dz < reach * reach) ++pairs;
        }
    return at.empty() ? 0.0 : 2.0 * static_cast<double>(pairs) / static_cast<double>(at.size());
}

}  // namespace engines
