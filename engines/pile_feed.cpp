// SPDX-License-Identifier: MIT
#include "engines/pile_feed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace engines {
namespace {

using dem_min::Grain;
using rigs::PileSetup;

// How far a grain that appeared at `since` has fallen at `t`.
double fallen(const PileSetup& s, double since, double t) {
    return 0.5 * s.gravity * (t - since) * (t - since);
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
                   z[oldest] - fallen(s, s.feed_time[oldest], s.feed_time[k]) < z[k] - 4.0 * s.d &&
                   oldest < k)
                ++oldest;
            for (bool moved = true; moved;) {
                moved = false;
                for (std::size_t j = oldest; j < k; ++j) {
                    const double reach = 1.001 * (s.radius[j] + s.radius[k]);
                    const double dx = s.feed_x[j] - s.feed_x[k], dy = s.feed_y[j] - s.feed_y[k];
                    const double level = reach * reach - dx * dx - dy * dy;
                    if (level <= 0.0) continue;
                    const auto gap = [&](double t) {  // how far j is above k
                        return z[j] - fallen(s, s.feed_time[j], t) - z[k] +
                               fallen(s, s.feed_time[k], t);
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
    for (std::size_t k = batch.first; k <= batch.last; ++k)
        grains.push_back({{s.feed_x[k], s.feed_y[k], z[k] - fallen(s, s.feed_time[k], read) + lift},
                          {0.0, 0.0, -s.gravity * (read - s.feed_time[k])},
                          {},
                          s.radius[k],
                          loose_density(s)});
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
    const double wide =
        0.5 * std::max(s.conditions.base_diameter, s.conditions.feed_diameter) + 10.0 * s.d;
    return {{-wide, -wide, s.lost_below}, {wide, wide, s.conditions.drop_height + 40.0 * s.d}};
}

double loose_density(const PileSetup& s) {
    return s.materials.density.empty() ? s.density : s.materials.density.front();
}

double energy_unit(const PileSetup& s) {
    const double mass = s.density * (std::numbers::pi / 6.0) * (s.d * s.d * s.d);
    return mass * s.gravity * s.d;
}

std::int64_t whole_checks(const PileSetup& s, double duration) {
    return static_cast<std::int64_t>(std::ceil(duration / s.time_step / rest_check_interval) *
                                     rest_check_interval);
}

void refuse_rig_of_our_own(const PileSetup& s, const DeckOptions& o, const std::string& engine) {
    const rigs::PileConditions& c = s.conditions;
    if (s.grains.rigid_tangential) refuse(o, engine, "has no rigid friction (hertz_coulomb)", ours);
    if (s.grains.friction_cap != contact::FrictionCap::elastic_plus_two_pull_off)
        refuse(o, engine, "is told of no friction_cap", ours);
    if (s.grains.bridge.acts()) refuse(o, engine, "is told of no capillary_bridge", ours);
    if (s.grains.ageing.acts()) refuse(o, engine, "has no ageing of adhesion", ours);
    if (!s.materials.pairs.empty()) refuse(o, engine, "is told of one material only", ours);
    if (c.funnel || !c.meshes.empty()) refuse(o, engine, "is told of no funnel and no mesh", ours);
    if (s.sleep_speed > 0.0) refuse(o, engine, "does not sleep", "leave --sleep out");
}

}  // namespace engines
