// SPDX-License-Identifier: MIT
#include "engines/lammps_feed.hpp"

#include <algorithm>
#include <cmath>

namespace engines {

using rigs::PileSetup;

double fallen(const PileSetup& s, double since, double t) {
    return 0.5 * s.gravity * (t - since) * (t - since);
}

// Between two grains in flight the distance grows in a straight line.
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

}  // namespace engines
