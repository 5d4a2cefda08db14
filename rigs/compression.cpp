// SPDX-License-Identifier: MIT
#include "rigs/compression.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigs {
namespace {

using contact::Vec3;
using dem_min::Plane;
using dem_min::Simulation;

constexpr int the_floor = 0, the_piston = 1;  // walls
constexpr std::int64_t look_interval = 20;    // steps between two looks at the piston's stress
constexpr double row_strain =
    2e-3;  // of the piston's way between two rows, over the height as filled
constexpr double unloaded = 0.01;  // of the consolidation stress: the piston carries nothing

Plane& piston(Simulation& s) { return std::get<Plane>(s.walls[the_piston]); }
double height(const Simulation& s) { return std::get<Plane>(s.walls[the_piston]).point.z; }

double piston_stress(const Simulation& s, const CompressionCell& cell) {
    return elastic_force_on_grains(s, the_piston) / (cell.width * cell.width);
}

// Volume of a sphere between two heights: pi (R^2 - t^2) summed over the height t above its centre.
double between(double z, double radius, double low, double high) {
    const auto below = [&](double t) {
        t = std::clamp(t, -radius, radius);
        return std::numbers::pi * t * (radius * radius - t * t / 3.0);
    };
    return below(high - z) - below(low - z);
}

CompressionRow row_of(const CompressionRun& run, const CompressionCell& cell) {
    const Simulation& s = run.simulation;
    const double h = height(s);
    const bool confined = s.settings.period_x > 0.0;
    return {.stage = run.stage,
            .time = s.time(),
            .strain = 1.0 - h / run.reference_height,
            .piston_stress = piston_stress(s, cell),
            .floor_stress = elastic_force_on_grains(s, the_floor) / (cell.width * cell.width),
            .packing_fraction = confined ? packing_between(s, cell.width, 0.2 * h, 0.8 * h) : 0.0,
            .coordination = coordination_between(s, 0.2 * h, 0.8 * h)};
}

// The sample as a wire would cut it: each grain to its own side, what it held on the other is torn in the next step.
void cut_free(Simulation& s, double width) {
    for (dem_min::Array* along : {&s.grains.x, &s.grains.y})
        for (double& x : *along) x -= width * std::floor(x / width);
    s.settings.period_x = s.settings.period_y = 0.0;
    s.list_is_stale = true;
}

bool has_ended(const CompressionRun& run, const CompressionSetup& setup) {
    const Simulation& s = run.simulation;
    const CompressionCell& cell = setup.cell;
    const double waited = static_cast<double>(s.steps - run.stage_since) * setup.time_step;
    switch (run.stage) {
        case Stage::compressing:
            return piston_stress(s, cell) >= cell.stress;
        case Stage::unloading:
            return piston_stress(s, cell) <= unloaded * cell.stress;
        case Stage::holding:
        case Stage::freed:
            return waited >= cell.pause;
        case Stage::crushing:
            return 1.0 - height(s) / run.reference_height >= cell.crush_strain;
        case Stage::done:
            break;
    }
    return false;
}

void begin_next(CompressionRun& run, const CompressionSetup& setup) {
    Simulation& s = run.simulation;
    run.stage = static_cast<Stage>(static_cast<int>(run.stage) + 1);
    run.stage_since = s.steps;
    double speed = 0.0;  // upwards
    if (run.stage == Stage::unloading) speed = setup.cell.speed;
    if (run.stage == Stage::crushing) speed = -setup.cell.speed;
    piston(s).velocity = {0.0, 0.0, speed};
    if (run.stage == Stage::freed) cut_free(s, setup.cell.width);
    if (run.stage == Stage::crushing) run.reference_height = height(s);
}

std::int64_t steps_of(double way, const CompressionSetup& s) {
    return static_cast<std::int64_t>(way / s.cell.speed / s.time_step);
}

std::int64_t row_interval(const CompressionSetup& s) {
    const std::int64_t looks = steps_of(row_strain * s.cell.height, s) / look_interval;
    return std::max<std::int64_t>(1, looks) * look_interval;
}

void look(CompressionRun& run, const CompressionSetup& setup) {
    const Simulation& s = run.simulation;
    if (s.steps % look_interval != 0) return;
    const bool ends = has_ended(run, setup);
    if (ends || s.steps % row_interval(setup) == 0) run.rows.push_back(row_of(run, setup.cell));
    if (ends) begin_next(run, setup);
}

}  // namespace

const char* to_string(Stage stage) {
    constexpr const char* names[] = {"compressing", "holding",  "unloading",
                                     "freed",       "crushing", "done"};
    return names[static_cast<int>(stage)];
}

double elastic_force_on_grains(const Simulation& s, int wall) {
    double sum = 0.0;
    for (const dem_min::Tile& tile : s.tiles)
        for (std::size_t group = 0; group < tile.groups.size(); ++group) {
            if (!s.at_wall(group)) continue;
            const dem_min::Contacts& c = tile.groups[group];
            for (std::size_t k = 0; k < c.count(); ++k) {
                if (c.j[k] != wall) continue;
                const auto i = static_cast<std::size_t>(c.i[k]);
                const double overlap =
                    s.grains.radius[i] -
                    distance(s.walls[static_cast<std::size_t>(wall)], s.grains.position(i))
                        .distance;
                sum += std::visit(
                    [&](const auto& law) {
                        return law.at(c.r_star[k], c.length_scale[k], overlap).force;
                    },
                    s.laws(group).normal);
            }
        }
    return sum;
}

double packing_between(const Simulation& s, double width, double low, double high) {
    double solid = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        solid += between(s.grains.z[k], s.grains.radius[k], low, high);
    return solid / (width * width * (high - low));
}

double coordination_between(const Simulation& s, double low, double high) {
    const auto inside = [&](int grain) {
        const double z = s.grains.z[static_cast<std::size_t>(grain)];
        return z >= low && z <= high;
    };
    std::size_t ends = 0, grains = 0;
    for (std::size_t k = 0; k < s.grains.count(); ++k) grains += inside(static_cast<int>(k));
    dem_min::for_each_contact(s,
                              [&](std::size_t group, const dem_min::Contacts& c, std::size_t slot) {
                                  if (!s.at_wall(group))
                                      ends += inside(c.i[slot]) + inside(c.j[slot]);
                              });
    return grains == 0 ? 0.0 : static_cast<double>(ends) / static_cast<double>(grains);
}

CompressionRun begin_compression(const CompressionSetup& setup, int threads) {
    CompressionRun run;
    Simulation& s = run.simulation;
    const CompressionCell& cell = setup.cell;
    s.settings = {.time_step = setup.time_step,
                  .skin = setup.skin,
                  .gravity = {0.0, 0.0, -setup.gravity},
                  .lost_below = -cell.height,
                  .threads = threads,
                  .period_x = cell.width,
                  .period_y = cell.width};
    s.between_grains = laws(setup.grains);
    s.at_walls = laws(setup.plates);
    s.walls = {Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}},
               Plane{{0.0, 0.0, cell.height}, {0.0, 0.0, -1.0}, {0.0, 0.0, -cell.speed}}};
    for (std::size_t k = 0; k < setup.place.size(); ++k)
        dem_min::insert(s, {setup.place[k], {}, {}, setup.radius[k], setup.density});
    run.reference_height = cell.height;
    return run;
}

void advance(CompressionRun& run, const CompressionSetup& setup, std::int64_t steps) {
    Simulation& s = run.simulation;
    const std::int64_t last = s.steps + steps;
    while (s.steps < last && !run.finished()) {
        const std::int64_t next = (s.steps / look_interval + 1) * look_interval;
        dem_min::advance(s, std::min(last, next) - s.steps);
        look(run, setup);
    }
}

std::int64_t expected_steps(const CompressionSetup& s) {
    const CompressionCell& cell = s.cell;
    const double compressed = cell.solid_volume / (cell.width * cell.width) / 0.5;
    const double way = cell.height - compressed + cell.crush_strain * compressed;
    return steps_of(way + 2.0 * cell.pause * cell.speed, s);
}

CompressionRecord record(const CompressionRun& run, const CompressionSetup& setup) {
    const CompressionCell& cell = setup.cell;
    CompressionRecord r{};
    r.rows = run.rows;
    for (const CompressionRow& row : run.rows) {
        if (row.stage == Stage::compressing) r.consolidated = row;
        if (row.stage == Stage::crushing && row.piston_stress > r.strength.stress)
            r.strength = {row.piston_stress, row.strain};
    }
    const auto inertial_number = [&](double h, double stress) {
        return stress > 0.0 ? cell.speed / h * setup.d * std::sqrt(setup.density / stress) : 0.0;
    };
    r.inertial_number =
        inertial_number((1.0 - r.consolidated.strain) * cell.height, r.consolidated.piston_stress);
    r.inertial_number_of_crush =
        inertial_number((1.0 - r.strength.strain) * run.reference_height, r.strength.stress);
    r.steps = run.simulation.steps;
    r.hash = dem_min::state_hash(run.simulation);
    return r;
}

}  // namespace rigs
