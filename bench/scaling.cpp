// SPDX-License-Identifier: MIT
#include "bench/scaling.hpp"

#include "bench/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bench {

using engines::Bed;

namespace {

struct Size {
    int nx, ny, nz;
};
// Cubes up to 50 layers, then wider ones.
constexpr Size sizes[] = {{10, 10, 10}, {20, 20, 25}, {40, 50, 50}, {125, 160, 50}};

// Contacts per grain, each counted once; those with the base count twice as much as they should,
// which is one layer of 10 to 50.
double contacts_of(const dem_min::Simulation& s) { return 0.5 * dem_min::mean_coordination(s); }

ScalingPoint point_of(const Bed& bed, int threads, double grain_steps, int repeats,
                      const Progress& progress) {
    dem_min::Simulation s = simulation_of(bed, threads);
    const int steps = std::max(5, static_cast<int>(grain_steps / bed.grains()));
    const double parts = repeats + 1.0;
    timed_steps(s, steps, [&](double share) { progress(share / parts); });
    std::vector<double> costs;
    for (int k = 0; k < repeats; ++k)
        costs.push_back(
            timed_steps(s, steps, [&](double share) { progress((1.0 + k + share) / parts); }) /
            steps / bed.grains());
    dem_min::check_finite(s);
    ScalingPoint p{bed.grains(),
                   threads,
                   spread_of(costs),
                   contacts_of(s),
                   memory_use(s),
                   static_cast<double>(bytes_moved(s)),
                   0.0};
    s = {};  // its memory is given back before the triad takes as much
    const auto& m = p.memory;
    p.triad = triad_bandwidth(
        static_cast<double>(m.bytes_grains + m.bytes_contacts + m.bytes_lists), threads);
    return p;
}

}  // namespace

// a0^3 = 9 pi w R*^2/(2 E*), overlap a0^2/(3 R*) there: contact/jkr.hpp at zero force.
Bed settled_bed(int nx, int ny, int nz) {
    Bed bed;
    bed.nx = nx;
    bed.ny = ny;
    bed.nz = nz;
    const double r_star = 0.5 * bed.radius;
    const double e_star = 0.5 * bed.youngs_modulus / (1.0 - bed.poisson_ratio * bed.poisson_ratio);
    const double w = 2.0 * bed.surface_energy;
    const double a0 = std::cbrt(4.5 * std::numbers::pi * w * r_star * r_star / e_star);
    const double overlap = a0 * a0 / (3.0 * r_star);
    bed.spacing = 2.0 - overlap / bed.radius;
    bed.jitter = 0.05 * overlap;
    return bed;
}

ScalingStudy scaling_study(int largest, double grain_steps, int repeats,
                           const std::vector<int>& threads, const Told& tell) {
    std::vector<Bed> beds;
    for (const Size& z : sizes)
        if (z.nx * z.ny * z.nz <= largest) beds.push_back(settled_bed(z.nx, z.ny, z.nz));
    ScalingStudy study;
    const double all = static_cast<double>(beds.size() * threads.size());
    for (const Bed& bed : beds)
        for (const int team : threads) {
            const double before = static_cast<double>(study.points.size()) / all;
            const std::string what = fmt::format("{} grains, threads: {}", bed.grains(), team);
            study.points.push_back(point_of(bed, team, grain_steps, repeats, [&](double share) {
                tell(before + share / all, what);
            }));
        }
    return study;
}

}  // namespace bench
