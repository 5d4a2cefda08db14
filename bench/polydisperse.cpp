// SPDX-License-Identifier: MIT
#include "bench/scaling.hpp"

#include <algorithm>
#include <cmath>

namespace bench {

using contact::Vec3;
using engines::Bed;

namespace {

constexpr int across = 10;  // small grains per edge of a cell; a large one is as wide as a cell

// The sites of the small lattice that a large grain in the middle of its cell leaves free, counted
// from the cell's corner. m
std::vector<Vec3> free_sites(const Bed& bed) {
    const double d = bed.lattice(), middle = 0.5 * across * d;
    const double clear = (across + 1) * 0.5 * d;  // R_large + R_small at the lattice's looseness
    std::vector<Vec3> sites;
    for (int z = 0; z < across; ++z)
        for (int y = 0; y < across; ++y)
            for (int x = 0; x < across; ++x) {
                const Vec3 at{(x + 0.5) * d, (y + 0.5) * d, (z + 0.5) * d};
                if (contact::norm(at - Vec3{middle, middle, middle}) >= clear) sites.push_back(at);
            }
    return sites;
}

// cells x cells wide, two cells high; the bed's own grid says how far the periods reach.
dem_min::Simulation mixed_bed(Bed bed, int cells, int threads) {
    bed.nx = bed.ny = across * cells;
    bed.nz = 0;  // no grains of the bed itself
    dem_min::Simulation s = simulation_of(bed, threads);
    const double edge = across * bed.lattice();
    const std::vector<Vec3> sites = free_sites(bed);
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x) {
                const Vec3 corner{x * edge, y * edge, z * edge};
                const Vec3 middle = corner + 0.5 * Vec3{edge, edge, edge};
                dem_min::insert(s, {middle, {}, {}, across * bed.radius, bed.density, false});
                for (const Vec3& site : sites)
                    dem_min::insert(s, {corner + site, {}, {}, bed.radius, bed.density, false});
            }
    return s;
}

PolydisperseSide side_of(dem_min::Simulation& s, int warm_up, int steps, int repeats,
                         const Progress& progress) {
    const double parts = repeats + static_cast<double>(warm_up) / steps;
    const double first = static_cast<double>(warm_up) / steps;
    timed_steps(s, warm_up, [&](double share) { progress(first * share / parts); });
    std::vector<double> seconds;  // per step
    for (int k = 0; k < repeats; ++k)
        seconds.push_back(
            timed_steps(s, steps, [&](double share) { progress((first + k + share) / parts); }) /
            steps);
    dem_min::check_finite(s);
    const double grains = static_cast<double>(s.grains.count());
    const double contacts = 0.5 * dem_min::mean_coordination(s) * grains;
    const Spread step = spread_of(seconds);
    const auto shared = [&](double among) {
        return Spread{step.median / among, step.low / among, step.high / among};
    };
    return {static_cast<int>(grains), contacts / grains, shared(contacts), shared(grains)};
}

}  // namespace

PolydisperseStudy polydisperse_study(int cells, int warm_up, int steps, int repeats, int threads,
                                     const Told& tell) {
    PolydisperseStudy study;
    study.threads = threads;
    Bed bed;
    dem_min::Simulation mixed = mixed_bed(bed, cells, threads);
    // As many grains of one size, as near as a lattice of twice as many layers as columns comes.
    bed.nx = bed.ny = std::max(
        3,
        static_cast<int>(std::lround(std::cbrt(static_cast<double>(mixed.grains.count()) / 2.0))));
    bed.nz = static_cast<int>(mixed.grains.count()) / (bed.nx * bed.ny);
    dem_min::Simulation equal = simulation_of(bed, threads);
    study.equal = side_of(equal, warm_up, steps, repeats,
                          [&](double share) { tell(0.5 * share, "grains of one size"); });
    study.mixed = side_of(mixed, warm_up, steps, repeats,
                          [&](double share) { tell(0.5 + 0.5 * share, "sizes 1 to 10"); });
    return study;
}

}  // namespace bench
