// SPDX-License-Identifier: MIT
// The rig `drum` (docs/drum.md).
#include "rigs/vessels.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigs {
namespace {

using contact::Vec3;
using dem_min::Shell;
using dem_min::Simulation;

constexpr double poured_packing = 0.6;  // what `fill_fraction` counts as a full bed
constexpr double fullest = 0.5;         // of the drum: more cannot begin loosely in it
constexpr double turns = 2.0;           // of a run without a recording; the last one is averaged
constexpr int looks_per_turn = 100;

// The surface, as a line across the drum: at a distance `level` from the axis (> 0 above it), `angle` against the horizontal.
struct Surface {
    double angle, level;  // rad, m
};

// Along the surface (uphill) and out of the bed, of a point.
struct Across {
    double along, out;
};
Across turned(double angle, double x, double y) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * x + s * y, c * y - s * x};
}

// The tops of the grains in cells one d wide along the surface and along the axis, within the middle half of the chord; the line of
// least squares through them. It begins with the direction from the axis to the centre of mass and is turned until it stays.
Surface surface_of(const Simulation& s, const Drum& drum, double d) {
    double x = 0.0, y = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        x += s.grains.mass[k] * s.grains.x[k], y += s.grains.mass[k] * s.grains.y[k];
    Surface surface{std::atan2(x, -y), 0.0};
    const double radius = 0.5 * drum.diameter;
    double half = 0.5 * radius;  // of the part that is fitted
    const auto slices = std::max(1, static_cast<int>(drum.length / d));
    for (int round = 0; round < 4; ++round) {
        const auto cells = std::max(2, static_cast<int>(2.0 * half / d));
        std::vector<double> top(static_cast<std::size_t>(cells * slices), -radius);
        for (std::size_t k = 0; k < s.grains.count(); ++k) {
            const Across at = turned(surface.angle, s.grains.x[k], s.grains.y[k]);
            const int cell = static_cast<int>(std::floor((at.along + half) / (2.0 * half) * cells));
            const int slice =
                std::clamp(static_cast<int>(s.grains.z[k] / drum.length * slices), 0, slices - 1);
            if (cell < 0 || cell >= cells) continue;
            double& highest = top[static_cast<std::size_t>(cell * slices + slice)];
            highest = std::max(highest, at.out + s.grains.radius[k]);
        }
        double n = 0.0, su = 0.0, sv = 0.0, suu = 0.0, suv = 0.0;
        for (int cell = 0; cell < cells; ++cell)
            for (int slice = 0; slice < slices; ++slice) {
                const double u = (cell + 0.5) / cells * 2.0 * half - half;
                const double v = top[static_cast<std::size_t>(cell * slices + slice)];
                if (v == -radius) continue;  // nobody there
                n += 1.0, su += u, sv += v, suu += u * u, suv += u * v;
            }
        const double spread = n * suu - su * su;
        if (!(spread > 0.0)) return surface;
        const double slope = (n * suv - su * sv) / spread;
        surface.level = (sv - slope * su) / n / std::sqrt(1.0 + slope * slope);
        surface.angle += std::atan(slope);
        const double chord2 = radius * radius - surface.level * surface.level;
        half = 0.5 * std::sqrt(std::max(d * d, chord2));
    }
    return surface;
}

std::size_t depth_cells(const Drum& drum, double d) {
    return static_cast<std::size_t>(drum.diameter / d) + 1;
}

std::string key(const char* what, std::size_t cell) { return what + std::to_string(cell); }

// Grains within one d of the middle of the chord, by depths one d apart.
void add_velocities(FlowRun& run, const Surface& surface, double d, std::size_t cells) {
    const Simulation& s = run.simulation;
    for (std::size_t k = 0; k < s.grains.count(); ++k) {
        const Across at = turned(surface.angle, s.grains.x[k], s.grains.y[k]);
        const Across v = turned(surface.angle, s.grains.vx[k], s.grains.vy[k]);
        const double depth = surface.level - at.out;
        if (std::abs(at.along) > d || depth < 0.0) continue;
        const std::size_t cell = std::min(cells - 1, static_cast<std::size_t>(depth / d));
        run.state.noted[key("velocity_", cell)] -= v.along;
        run.state.noted[key("seen_", cell)] += 1.0;
    }
}

// Straight between the cells' middles; nothing beyond them but for half a cell.
std::vector<cases::Column> at_depths(const std::vector<cases::Column>& cells,
                                     const std::vector<double>& depths) {
    const std::vector<double>&x = cells[0].values, &v = cells[1].values;
    std::vector<cases::Column> asked{{"depth", "m", depths, {}}, {"velocity", "m/s", {}, {}}};
    for (const double depth : depths) {
        const auto above =
            static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), depth) - x.begin());
        double value = std::nan("");
        if (above > 0 && above < x.size())
            value = v[above - 1] +
                    (depth - x[above - 1]) / (x[above] - x[above - 1]) * (v[above] - v[above - 1]);
        else if (!x.empty() && depth >= 0.0 && depth <= x.back() + x.front())
            value = above == 0 ? v.front() : v.back();
        asked[1].values.push_back(value);
    }
    return asked;
}

double turn_time(const Drum& drum) { return 2.0 * std::numbers::pi / drum.speed; }

}  // namespace

Drum drum_of(const cases::Experiment& e) {
    const cases::Value& given = e.conditions;
    const auto length = [&](const char* name) {
        return given.at(name).quantity<scaling::Length>().value();
    };
    // Mirrored, a drum that turns the other way is this one.
    const double speed =
        std::abs(given.at("rotation_speed").quantity<scaling::Frequency>().value());
    if (speed == 0.0)
        cases::refuse(given.at("rotation_speed"), "must not be 0", "a drum at rest shows nothing");
    const double fill = given.at("fill_fraction").number();
    if (!(fill > 0.0 && fill <= fullest))
        cases::refuse(given.at("fill_fraction"), "must be > 0 and at most 0.5 to be simulated",
                      "more cannot be poured in loosely");
    return {length("drum_diameter"), length("drum_length"), speed, fill};
}

Filling filling_of(const Drum& drum, const cases::Experiment&) {
    const double volume = std::numbers::pi / 4.0 * drum.diameter * drum.diameter * drum.length;
    return {0, poured_packing * drum.fill * volume, 0.0};
}

Vec3 up(const Drum&) { return {0.0, 1.0, 0.0}; }

dem_min::Box room(const Drum& drum) {
    const double r = 0.5 * drum.diameter;
    return {{-r, -r, 0.0}, {r, r, drum.length}};
}

bool clear_of_walls(const Drum& drum, Vec3 p, double radius) {
    return std::hypot(p.x, p.y) < 0.5 * drum.diameter - radius;
}

std::vector<dem_min::Wall> walls_of(const Drum& drum, double) {
    const double r = 0.5 * drum.diameter;
    return {dem_min::tube(r, 0.0, drum.length), dem_min::disc(r, 0.0),
            dem_min::disc(r, drum.length)};
}

double usual_interval(const Drum& drum, const FlowSetup&) {
    return turn_time(drum) / looks_per_turn;
}

double run_time(const Drum& drum) { return turns * turn_time(drum); }

double expected_duration(const Drum& drum, const FlowSetup&) { return run_time(drum); }

void let_go(const Drum& drum, Simulation& s) {
    for (dem_min::Wall& wall : s.walls) std::get<Shell>(wall).spin = drum.speed;
}

void look(const Drum& drum, FlowRun& run, const FlowSetup& setup, double t, std::size_t) {
    const Surface surface = surface_of(run.simulation, drum, setup.d);
    run.state.rows.push_back({t, surface.angle, surface.level});
    const double end = setup.times.empty() ? run_time(drum) : setup.times.back();
    if (t >= std::min(turn_time(drum), 0.5 * end))
        add_velocities(run, surface, setup.d, depth_cells(drum, setup.d));
}

std::string watch(const Drum& drum, FlowRun& run, const FlowSetup& setup) {
    const bool over = setup.times.empty() && seconds_since_release(run, setup) >= run_time(drum);
    return over ? "recorded" : "";
}

void complete(const Drum& drum, FlowRecord& r, const FlowRun& run, const FlowSetup& setup) {
    r.channels = {{"t", "s", {}, {}}, {"angle", "rad", {}, {}}};
    for (const std::vector<double>& row : run.state.rows)
        r.channels[0].values.push_back(row[0]), r.channels[1].values.push_back(row[1]);
    r.profile = {{"depth", "m", {}, {}}, {"velocity", "m/s", {}, {}}};
    for (std::size_t cell = 0; cell < depth_cells(drum, setup.d); ++cell) {
        const auto seen = run.state.noted.find(key("seen_", cell));
        if (seen == run.state.noted.end()) continue;
        r.profile[0].values.push_back((static_cast<double>(cell) + 0.5) * setup.d);
        r.profile[1].values.push_back(run.state.noted.at(key("velocity_", cell)) / seen->second);
    }
    if (!setup.depths.empty()) r.profile = at_depths(r.profile, setup.depths);
    const std::vector<double>& t = r.channels[0].values;
    double sum = 0.0, squares = 0.0, level = 0.0, n = 0.0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (t[k] < 0.5 * t.back()) continue;
        const double angle = r.channels[1].values[k];
        n += 1.0, sum += angle, squares += angle * angle, level += run.state.rows[k][2];
    }
    const double radius = 0.5 * drum.diameter;
    r.quantities.insert(r.quantities.end(),
                        {{"froude_number", drum.speed * drum.speed * radius / setup.gravity, "1"},
                         {"surface_above_axis", level / n, "m"},
                         {"dynamic_angle", sum / n, "rad"},
                         {"dynamic_angle_spread",
                          std::sqrt(std::max(0.0, squares / n - sum / n * sum / n)), "rad"}});
}

}  // namespace rigs
