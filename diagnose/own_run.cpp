// SPDX-License-Identifier: MIT
#include "diagnose/own_run.hpp"

#include "cases/units.hpp"
#include "diagnose/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace diagnose {
namespace {

constexpr double negligible = 0.1;  // of the noise

struct Point {
    double at, off;
};

// Straight between points that rise in `at`, constant beyond them.
double between(const std::vector<Point>& points, double at) {
    const auto right = std::lower_bound(points.begin(), points.end(), at,
                                        [](const Point& p, double x) { return p.at < x; });
    if (right == points.begin()) return points.front().off;
    if (right == points.end()) return points.back().off;
    const Point &a = right[-1], &b = right[0];
    return b.at > a.at ? a.off + (b.off - a.off) * (at - a.at) / (b.at - a.at) : b.off;
}

// Of one branch (all rows where there are none), by rising ordinate.
std::vector<Point> points_of(const rigs::Ordinates& o, const std::vector<double>& run,
                             const std::vector<double>& ours, bool retract) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < o.at.size(); ++k)
        if ((o.retract.empty() || o.retract[k] == retract) && std::isfinite(run[k] - ours[k]))
            points.push_back({o.at[k], run[k] - ours[k]});
    std::stable_sort(points.begin(), points.end(),
                     [](const Point& a, const Point& b) { return a.at < b.at; });
    return points;
}

double noise_of(const Channel& c) {
    if (c.stated_noise > 0.0) return c.stated_noise;
    double low = 1e300, high = -1e300;
    for (const double v : c.recorded)
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    return high > low ? 0.02 * (high - low) : 0.0;
}

double rms(const std::vector<double>& v) {
    double sum = 0.0;
    for (const double x : v) sum += x * x;
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, v.size())));
}

}  // namespace

void compare_own_runs(Problem& p) {
    const Hypothesised base = p.hypothesis({});
    const Eigen::VectorXd stated = start_of(base.unknowns);
    for (Record& r : p.records) {
        const cases::Experiment& e = *r.experiment;
        if (!e.simulated || r.covariance.size() > 0) continue;
        const rigs::Ordinates rows = rigs::simulated_ordinates(e);
        const rigs::Curves ours = r.model->predict(world_at(p, base, stated, r), rows);
        for (Channel& c : r.channels) {
            const auto found = ours.find(c.name);
            if (found == ours.end() || !e.simulated->has(c.name)) continue;
            const std::vector<double>& run = e.simulated->values(c.name);
            const std::vector<Point> there = points_of(rows, run, found->second, false),
                                     back = points_of(rows, run, found->second, true);
            std::vector<double> off(c.recorded.size(), 0.0);
            for (std::size_t k = 0; k < off.size(); ++k) {
                const bool retract = !r.ordinates.retract.empty() && r.ordinates.retract[k];
                const std::vector<Point>& points = retract ? back : there;
                if (!points.empty()) off[k] = between(points, r.ordinates.at[k]);
            }
            c.own_run_rms = rms(off);
            if (*c.own_run_rms > negligible * noise_of(c)) c.own_run_off = std::move(off);
        }
    }
}

std::vector<std::string> words_of_own_runs(const Problem& p) {
    std::vector<std::string> list;
    for (const Record& r : p.records)
        for (const Channel& c : r.channels) {
            if (!c.own_run_rms) continue;
            list.push_back(fmt::format(
                "Your own run of {} and this tool's differ by {} rms in {}{}.", r.experiment->id,
                cases::format_si(*c.own_run_rms, unit_of_channel(c.name)), c.name,
                c.own_run_off.empty()
                    ? ", which these recordings cannot show"
                    : ": the difference counts as part of your simulation, and goes with a "
                      "numerical artefact"));
        }
    return list;
}

}  // namespace diagnose
