// SPDX-License-Identifier: MIT
#include "bench/ours.hpp"

#include "contact/effective.hpp"

#include <algorithm>
#include <chrono>

namespace bench {

using contact::Vec3;
using engines::Bed;

namespace {

namespace si = scaling::si;

contact::Material material_of(const Bed& bed) {
    return {bed.youngs_modulus * si::pascals, bed.poisson_ratio,
            bed.density * si::kilograms_per_cubic_meter};
}

void set_laws(dem_min::Simulation& s, const Bed& bed) {
    const contact::Material m = material_of(bed);
    const double e_star = contact::e_star(m, m).value(), g_star = contact::g_star(m, m).value();
    s.between_grains = {
        contact::Jkr{e_star, 2.0 * bed.surface_energy},
        contact::Mindlin{g_star, bed.sliding_friction},
        contact::RollingSds{bed.rolling_stiffness, bed.rolling_damping, bed.rolling_friction},
        contact::DampingTsuji1992::from(bed.restitution)};
    s.at_walls = {contact::Hertz{e_star}, contact::Mindlin{g_star, bed.wall_friction},
                  contact::NoRolling{}, contact::DampingTsuji1992::from(bed.wall_restitution)};
}

double seconds_for(dem_min::Simulation& s, int steps) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    dem_min::advance(s, steps);
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

dem_min::Simulation simulation_of(const Bed& bed, int threads) {
    dem_min::Simulation s;
    s.settings.time_step = bed.time_step;
    s.settings.skin = bed.margin;
    s.settings.gravity = bed.acceleration();
    s.settings.lost_below = -bed.height();
    s.settings.threads = threads;
    s.settings.period_x = bed.period_x();
    s.settings.period_y = bed.period_y();
    set_laws(s, bed);
    s.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    for (const Vec3& at : engines::positions(bed))
        dem_min::insert(s, {at, {}, {}, bed.radius, bed.density, false});
    return s;
}

double timed_steps(dem_min::Simulation& s, int steps, const Progress& progress) {
    constexpr int portion = 100;  // steps: a fraction of a second, and its ends cost nothing
    double seconds = 0.0;
    for (int done = 0; done < steps;) {
        const int now = std::min(portion, steps - done);
        seconds += seconds_for(s, now);
        done += now;
        if (progress) progress(static_cast<double>(done) / steps);
    }
    return seconds;
}

engines::BedFigures run_ours(const Bed& bed, int threads, const Progress& progress) {
    dem_min::Simulation s = simulation_of(bed, threads);
    const double all = bed.warm_up + bed.steps;
    const auto part = [&](double before, double share) {
        if (progress) progress((before + share) / all);
    };
    timed_steps(s, bed.warm_up, [&](double done) { part(0.0, done * bed.warm_up); });
    engines::BedFigures f;
    f.seconds =
        timed_steps(s, bed.steps, [&](double done) { part(bed.warm_up, done * bed.steps); });
    dem_min::check_finite(s);
    f.grains = static_cast<std::int64_t>(s.grains.count());
    f.kinetic_energy = dem_min::kinetic_energy(s);
    std::vector<Vec3> places;
    for (std::size_t k = 0; k < s.grains.count(); ++k) places.push_back(s.grains.position(k));
    f.neighbours = engines::overlapping_neighbours(bed, places);
    return f;
}

}  // namespace bench
