// SPDX-License-Identifier: MIT
// The rig `column` (docs/column.md).
#include "rigs/angle_of_repose.hpp"
#include "rigs/height_map.hpp"
#include "rigs/vessels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigs {
namespace {

using contact::Vec3;
using dem_min::Shell;
using dem_min::Simulation;

constexpr std::size_t the_wall = 1;
constexpr double packing_to_spare = 0.66;  // denser than a bed that is poured
constexpr double away = 1e6;               // column heights: where a wall is that has vanished

double highest(const Simulation& s) {
    double top = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        top = std::max(top, s.grains.z[k] + s.grains.radius[k]);
    return top;
}

Heap heap_of(const Simulation& s, double d) {
    Heap heap{};
    for (std::size_t k = 0; k < s.grains.count(); ++k) {
        heap.centre.push_back(s.grains.position(k));
        heap.radius.push_back(s.grains.radius[k]);
        heap.base_radius = std::max(
            heap.base_radius, std::hypot(s.grains.x[k], s.grains.y[k]) + s.grains.radius[k] + d);
    }
    return heap;
}

// Straight between the spots, level inside of the first, 0 beyond the last.
double height_at(const RadialProfile& p, double r) {
    if (r <= p.r.front()) return p.z.front();
    if (r >= p.r.back()) return 0.0;
    const auto above =
        static_cast<std::size_t>(std::upper_bound(p.r.begin(), p.r.end(), r) - p.r.begin());
    const double share = (r - p.r[above - 1]) / (p.r[above] - p.r[above - 1]);
    return p.z[above - 1] + share * (p.z[above] - p.z[above - 1]);
}

// Every half diameter out to where the last grain ends.
std::vector<double> usual_spots(const Heap& heap, double d) {
    std::vector<double> r;
    for (double at = 0.25 * d; at < heap.base_radius - d; at += 0.5 * d) r.push_back(at);
    return r;
}

}  // namespace

Column column_of(const cases::Experiment& e) {
    const cases::Value& given = e.conditions;
    const bool instant =
        !given.has("lift_speed") || given.at("lift_speed").written_text == "instant";
    return {given.at("column_radius").quantity<scaling::Length>().value(),
            given.at("column_height").quantity<scaling::Length>().value(),
            instant ? 0.0 : given.at("lift_speed").quantity<scaling::Velocity>().value()};
}

Filling filling_of(const Column& c, const cases::Experiment&) {
    return {0, packing_to_spare * std::numbers::pi * c.radius * c.radius * c.height, c.height};
}

Vec3 up(const Column&) { return {0.0, 0.0, 1.0}; }

dem_min::Box room(const Column& c) {
    return {{-c.radius, -c.radius, 0.0},
            {c.radius, c.radius, std::numeric_limits<double>::infinity()}};
}

bool clear_of_walls(const Column& c, Vec3 p, double radius) {
    return std::hypot(p.x, p.y) < c.radius - radius;
}

std::vector<dem_min::Wall> walls_of(const Column& c, double top) {
    return {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, dem_min::tube(c.radius, 0.0, top)};
}

double usual_interval(const Column& c, const FlowSetup& s) {
    const double fall = 0.5 * std::sqrt(c.height / s.gravity);
    return c.lift_speed > 0.0 ? std::max(fall, 0.1 * c.height / c.lift_speed) : fall;
}

double expected_duration(const Column& c, const FlowSetup& s) {
    const double lift = c.lift_speed > 0.0 ? c.height / c.lift_speed : 0.0;
    return lift + 5.0 * std::sqrt(c.height / s.gravity) + 1.5 * s.rest_duration;
}

void let_go(const Column& c, Simulation& s) {
    auto& wall = std::get<Shell>(s.walls[the_wall]);
    if (c.lift_speed > 0.0)
        wall.rise = c.lift_speed;
    else
        wall.z0 += away * c.height, wall.z1 += away * c.height;
}

void look(const Column&, FlowRun& run, const FlowSetup& setup, double t, std::size_t number) {
    const Heap heap = heap_of(run.simulation, setup.d);
    const RadialProfile profile = radial_profile(scan(heap));
    const std::vector<double> spots =
        setup.spots.empty() ? usual_spots(heap, setup.d) : setup.spots[number];
    for (const double r : spots) run.state.rows.push_back({t, r, height_at(profile, r)});
}

// Over when all is at rest and the wall is above it.
std::string watch(const Column&, FlowRun& run, const FlowSetup& setup) {
    auto& wall = std::get<Shell>(run.simulation.walls[the_wall]);
    if (wall.rise > 0.0) {
        if (wall.z0 < highest(run.simulation) + setup.d) return {};
        wall.rise = 0.0;
    }
    if (at_rest(run, setup)) {
        if (setup.times.empty()) look(Column{}, run, setup, seconds_since_release(run, setup), 0);
        return "at_rest";
    }
    return seconds_since_release(run, setup) >= setup.longest ? "not_at_rest" : "";
}

void complete(const Column& c, FlowRecord& r, const FlowRun& run, const FlowSetup& setup) {
    r.channels = {{"t", "s", {}, {}}, {"r", "m", {}, {}}, {"z", "m", {}, {}}};
    for (const std::vector<double>& row : run.state.rows)
        for (std::size_t k = 0; k < 3; ++k) r.channels[k].values.push_back(row[k]);
    const HeightMap map = scan(heap_of(run.simulation, setup.d));
    const double foot = foot_radius(map);
    r.quantities.insert(r.quantities.end(), {{"aspect_ratio", c.height / c.radius, "1"},
                                             {"foot_radius", foot, "m"},
                                             {"runout", (foot - c.radius) / c.radius, "1"},
                                             {"height", rigs::height(map), "m"}});
    for (const Estimator estimator : computed_estimators)
        if (const auto angle = angle_of_repose(map, estimator))
            r.quantities.push_back({to_string(estimator), angle->angle, "rad"});
}

}  // namespace rigs
