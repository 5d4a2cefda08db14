// SPDX-License-Identifier: MIT
#include "engines/pile_feed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace engines {
namespace {

using dem_min::Grain;
using rigs::PileSetup;

struct Fallen {
    double way, speed;  // m, m/s
};

// What grain k has come since it appeared, by `t`, in the room. In a fluid by Runge-Kutta of fourth order; a fall of some d lasts no
// longer than the grain's own time of drag, or ends at its terminal velocity.
Fallen fall(const PileSetup& s, std::size_t k, double t) {
    const double time = t - s.feed_time[k];
    if (!s.fluid.acts()) return {0.5 * s.gravity * time * time, s.gravity * time};
    const double d = 2.0 * s.radius[k];
    const double volume = std::numbers::pi / 6.0 * d * d * d, mass = loose_density(s) * volume;
    const auto acceleration = [&](double v) {
        const double weight = (mass - s.fluid.lifting_density * volume) * s.gravity;
        return (weight - s.fluid.drag.at(d, std::abs(v)).value * v) / mass;
    };
    constexpr int steps = 40;
    const double h = time / steps;
    Fallen now{};
    for (int step = 0; step < steps; ++step) {
        const double a1 = acceleration(now.speed), a2 = acceleration(now.speed + 0.5 * h * a1),
                     a3 = acceleration(now.speed + 0.5 * h * a2),
                     a4 = acceleration(now.speed + h * a3);
        now.way += h * now.speed + h * h / 6.0 * (a1 + a2 + a3);
        now.speed += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    return now;
}

}  // namespace

std::vector<FeedBatch> feed_batches(const PileSetup& s) {
    const double longest = std::sqrt(s.d / s.gravity);  // falls d/2
    std::vector<FeedBatch> batches;
    for (std::size_t k = 0; k < s.feed_time.size(); ++k) {
        const auto due = static_cast<std::int64_t>(std::ceil(s.feed_time[k] / s.time_step));
        if (batches.empty() || s.feed_time[k] > s.feed_time[batches.back().first] + longest)
            batches.push_back({k, k, due});
        batches.back().last = k;
        batches.back().step = due;
    }
    return batches;
}

std::vector<double> feed_heights(const PileSetup& s, const std::vector<FeedBatch>& batches) {
    const std::size_t count = s.feed_time.size();
    std::vector<double> z(count);
    std::size_t oldest = 0;
    for (const FeedBatch& batch : batches) {
        const double read = static_cast<double>(batch.step) * s.time_step;
        for (std::size_t k = batch.first; k <= batch.last; ++k) {
            z[k] = s.conditions.drop_height + s.radius[k];
            // What fell for so long is below by more than two grains and the lift of the highest.
            while (s.feed_time[oldest] < s.feed_time[k] &&
                   z[oldest] - fall(s, oldest, s.feed_time[k]).way < z[k] - 4.0 * s.d && oldest < k)
                ++oldest;
            for (bool moved = true; moved;) {
                moved = false;
                for (std::size_t j = oldest; j < k; ++j) {
                    const double reach = 1.001 * (s.radius[j] + s.radius[k]);
                    const double dx = s.feed_x[j] - s.feed_x[k], dy = s.feed_y[j] - s.feed_y[k];
                    const double level = reach * reach - dx * dx - dy * dy;
                    if (level <= 0.0) continue;
                    const auto gap = [&](double t) {  // how far j is above k
                        return z[j] - fall(s, j, t).way - z[k] + fall(s, k, t).way;
                    };
                    const double now = gap(s.feed_time[k]), then = gap(read);
                    const double apart = std::sqrt(level);
                    if (std::min(now, then) >= apart || std::max(now, then) <= -apart) continue;
                    z[k] += (std::max(now, then) + apart) * 1.001;
                    moved = true;
                }
            }
        }
    }
    return z;
}

std::vector<Grain> batch_grains(const PileSetup& s, const FeedBatch& batch,
                                const std::vector<double>& z, double lift) {
    const double read = static_cast<double>(batch.step) * s.time_step;
    std::vector<Grain> grains;
    rigs::Stand tilted = s.stand;
    tilted.shaking = {};
    for (std::size_t k = batch.first; k <= batch.last; ++k) {
        const Fallen now = fall(s, k, read);
        const dem_min::Vec3 place{s.feed_x[k], s.feed_y[k], z[k] - now.way + lift};
        dem_min::Vec3 velocity = rigs::on_base(tilted, {0.0, 0.0, -now.speed}, read);
        if (s.stand.shaking.acts()) velocity.z -= s.stand.shaking.velocity(read);
        grains.push_back(
            {rigs::on_base(s.stand, place, read), velocity, {}, s.radius[k], loose_density(s)});
    }
    return grains;
}

std::vector<Grain> glued_grains(const PileSetup& s) {
    std::vector<Grain> grains;
    const rigs::PileRun start = rigs::begin_pile(s, 1);
    const dem_min::Particles& p = start.simulation.grains;
    for (std::size_t k = 0; k < p.count(); ++k)
        grains.push_back({p.position(k), {}, {}, p.radius[k], s.density, true});
    return grains;
}

Box pile_box(const PileSetup& s) {
    const double top = s.conditions.drop_height + 40.0 * s.d;
    const double wide = 0.5 * std::max(s.conditions.base_diameter, s.conditions.feed_diameter) +
                        10.0 * s.d + top * std::abs(std::sin(s.stand.tilt_angle));
    return {{-wide, -wide, s.lost_below}, {wide, wide, top}};
}

void refuse_surroundings(const PileSetup& s, const DeckOptions& o, const std::string& engine) {
    const std::string lammps = "take lammps, which is told of it, or dem_min";
    if (s.fluid.acts()) refuse(o, engine, "is told of no fluid (air_drag, buoyancy)", lammps);
    if (s.stand.tilt_angle != 0.0) refuse(o, engine, "is told of no tilt", lammps);
    if (s.stand.shaking.acts()) refuse(o, engine, "is told of no vibration", lammps);
}

double loose_density(const PileSetup& s) {
    return s.materials.density.empty() ? s.density : s.materials.density.front();
}

double energy_unit(const PileSetup& s) {
    const double mass = s.density * (std::numbers::pi / 6.0) * (s.d * s.d * s.d);
    return mass * s.gravity * s.d;
}

std::int64_t whole_checks(double time_step, double duration) {
    const auto steps = static_cast<std::int64_t>(
        std::ceil(duration / time_step / rest_check_interval) * rest_check_interval);
    const bool short_of_it = static_cast<double>(steps) * time_step < duration;  // by rounding
    return short_of_it ? steps + rest_check_interval : steps;
}

std::int64_t whole_checks(const PileSetup& s, double duration) {
    return whole_checks(s.time_step, duration);
}

void refuse_contacts_of_our_own(const rigs::ContactParameters& grains, const DeckOptions& o,
                                const std::string& engine) {
    if (grains.rigid_tangential) refuse(o, engine, "has no rigid friction (hertz_coulomb)", ours);
    if (grains.friction_cap != contact::FrictionCap::elastic_plus_two_pull_off)
        refuse(o, engine, "is told of no friction_cap", ours);
    if (grains.bridge.acts()) refuse(o, engine, "is told of no capillary_bridge", ours);
    if (grains.ageing.acts()) refuse(o, engine, "has no ageing of adhesion", ours);
}

void refuse_rig_of_our_own(const PileSetup& s, const DeckOptions& o, const std::string& engine) {
    const rigs::PileConditions& c = s.conditions;
    refuse_contacts_of_our_own(s.grains, o, engine);
    if (!s.materials.pairs.empty()) refuse(o, engine, "is told of one material only", ours);
    if (c.funnel || !c.meshes.empty()) refuse(o, engine, "is told of no funnel and no mesh", ours);
    if (!s.feed_axis.empty()) refuse(o, engine, "is told of no clumps (shape)", ours);
    if (s.sleep_speed > 0.0) refuse(o, engine, "does not sleep", "leave --sleep out");
}

}  // namespace engines
