// SPDX-License-Identifier: MIT
#include "rigs/flow.hpp"

#include "rigs/vessels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace rigs {
namespace {

using contact::Vec3;
using dem_min::Simulation;

constexpr std::int64_t watch_interval = 100;  // steps
constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

double height(const FlowSetup& setup, Vec3 place) {
    return contact::dot(std::visit([](const auto& v) { return up(v); }, setup.vessel), place);
}

// m, no grain is higher when it begins to fall.
double top_of(const FlowSetup& setup) {
    double top = 0.0;
    for (std::size_t k = 0; k < setup.place.size(); ++k)
        top = std::max(top, height(setup, setup.place[k]) + setup.radius[k]);
    return top;
}

// Grains that stand above the level go where the next step takes out what has left.
void strike_off(Simulation& s, const FlowSetup& setup) {
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        if (height(setup, s.grains.position(k)) > setup.filling.level)
            s.grains.z[k] = 2.0 * s.settings.lost_below;
    s.list_is_stale = true;
}

void release(FlowRun& run, const FlowSetup& setup) {
    const Simulation& s = run.simulation;
    double moment = 0.0;  // m
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        moment += height(setup, s.grains.position(k)) / static_cast<double>(s.grains.count());
    run.state.noted["grains"] = static_cast<double>(s.grains.count());
    run.state.noted["filled_mass"] = mass_of(s);
    run.state.noted["mean_height"] = moment;
    run.state.released = run.state.last_out = s.steps;
    run.state.still_since = -1;
    std::visit([&](const auto& v) { let_go(v, run.simulation); }, setup.vessel);
    run.simulation.list_is_stale = true;
}

// The bed before t = 0.
void watch_bed(FlowRun& run, const FlowSetup& setup) {
    FlowState& state = run.state;
    if (at_rest(run, setup)) {
        if (setup.filling.level > 0.0 && !state.levelled) {
            strike_off(run.simulation, setup);
            state.levelled = true;
            state.still_since = -1;
        } else {
            release(run, setup);
        }
    } else if (run.simulation.time() >= setup.longest) {
        state.finished = true;
        state.ending = "not_at_rest";
    }
}

// s, of a look; infinite where there is none.
double time_of_look(const FlowSetup& setup, std::size_t number) {
    if (setup.times.empty()) return static_cast<double>(number) * setup.every;
    return number < setup.times.size() ? setup.times[number]
                                       : std::numeric_limits<double>::infinity();
}

// Far away where there is none.
std::int64_t step_of_look(const FlowRun& run, const FlowSetup& setup) {
    const std::int64_t after = steps_to_look(setup, run.state.looked);
    return run.state.released < 0 || after == never ? never : run.state.released + after;
}

void look_where_due(FlowRun& run, const FlowSetup& setup) {
    while (step_of_look(run, setup) <= run.simulation.steps) {
        const std::size_t number = run.state.looked++;
        const double t = time_of_look(setup, number);
        std::visit([&](const auto& v) { look(v, run, setup, t, number); }, setup.vessel);
    }
}

// What is asked for after the run has come to rest is as it is then.
void finish(FlowRun& run, const FlowSetup& setup, std::string ending) {
    run.state.finished = true;
    run.state.ending = std::move(ending);
    for (; run.state.looked < setup.times.size(); ++run.state.looked)
        std::visit(
            [&](const auto& v) {
                look(v, run, setup, setup.times[run.state.looked], run.state.looked);
            },
            setup.vessel);
}

void watch_flow(FlowRun& run, const FlowSetup& setup) {
    std::string ending =
        std::visit([&](const auto& v) { return watch(v, run, setup); }, setup.vessel);
    if (ending.empty() && !setup.times.empty() && run.state.looked == setup.times.size())
        ending = "recorded";
    if (!ending.empty()) finish(run, setup, std::move(ending));
}

// Walls go on from where they were seen last.
void take(FlowRun& run, const FlowSight& sight) {
    Simulation seen;
    const Simulation& before = run.simulation;
    seen.settings = before.settings;
    seen.between_grains = before.between_grains, seen.at_walls = before.at_walls;
    seen.walls = before.walls;
    const auto steps = static_cast<double>(sight.step - before.steps);
    for (dem_min::Wall& wall : seen.walls)
        if (dem_min::moves(wall)) dem_min::carry_on(wall, steps * before.settings.time_step);
    for (const dem_min::Grain& grain : sight.grains) dem_min::insert(seen, grain);
    seen.steps = sight.step;
    run.simulation = std::move(seen);
}

}  // namespace

double mass_of(const Simulation& s) {
    double sum = 0.0;
    for (const double mass : s.grains.mass) sum += mass;
    return sum;
}

double seconds_since_release(const FlowRun& run, const FlowSetup& setup) {
    return static_cast<double>(run.simulation.steps - run.state.released) * setup.time_step;
}

// As of piles: mean kinetic energy of translation below 1e-6 m g d.
bool at_rest(FlowRun& run, const FlowSetup& setup) {
    const Simulation& s = run.simulation;
    const double mass = setup.density * (std::numbers::pi / 6.0) * (setup.d * setup.d * setup.d);
    const double unit = mass * setup.gravity * setup.d;
    const auto grains = static_cast<double>(std::max<std::size_t>(1, s.grains.count()));
    if (dem_min::translational_energy(s) / grains / unit >= 1e-6)
        run.state.still_since = -1;
    else if (run.state.still_since < 0)
        run.state.still_since = s.steps;
    return run.state.still_since >= 0 &&
           static_cast<double>(s.steps - run.state.still_since) * setup.time_step >=
               setup.rest_duration;
}

FlowRun begin_flow(const FlowSetup& setup, int threads) {
    FlowRun run;
    Simulation& s = run.simulation;
    const Vec3 upwards = std::visit([](const auto& v) { return up(v); }, setup.vessel);
    const double largest = *std::max_element(setup.radius.begin(), setup.radius.end());
    s.settings = {.time_step = setup.time_step,
                  .skin = setup.skin,
                  .gravity = -setup.gravity * upwards,
                  .lost_below = -largest,  // wholly under a silo's bottom
                  .threads = threads};
    s.between_grains = laws(setup.grains);
    s.at_walls = laws(setup.walls);
    const double top = top_of(setup) + setup.d;
    s.walls = std::visit([&](const auto& v) { return walls_of(v, top); }, setup.vessel);
    for (std::size_t k = 0; k < setup.place.size(); ++k)
        dem_min::insert(s, {setup.place[k], {}, {}, setup.radius[k], setup.density});
    return run;
}

void restore(FlowRun& run, const FlowSetup& setup, FlowState state) {
    if (state.released >= 0)
        std::visit([&](const auto& v) { let_go(v, run.simulation); }, setup.vessel);
    run.state = std::move(state);
}

FlowRun run_as_seen(const FlowSetup& setup, const SeenFlow& seen) {
    FlowRun run = begin_flow(setup, 1);
    for (const FlowSight& sight : seen.sights) {
        take(run, sight);
        if (!seen.released) continue;
        if (run.state.released < 0) release(run, setup);
        look_where_due(run, setup);
    }
    run.state.still_since = seen.still_since;
    if (!seen.released) {
        run.state.finished = true;
        run.state.ending = "not_at_rest";
        return run;
    }
    run.state.last_out = seen.last_out;
    run.state.noted["last_count"] = static_cast<double>(run.simulation.grains.count());
    watch_flow(run, setup);
    if (!run.state.finished)
        throw std::runtime_error("a flow that another engine ended is not over by the rig's rules");
    return run;
}

std::int64_t steps_to_look(const FlowSetup& setup, std::size_t number) {
    const double time = time_of_look(setup, number);
    return std::isfinite(time) ? std::llround(time / setup.time_step) : never;
}

void advance(FlowRun& run, const FlowSetup& setup, std::int64_t steps) {
    Simulation& s = run.simulation;
    const std::int64_t last = s.steps + steps;
    while (s.steps < last && !run.state.finished) {
        const std::int64_t next_watch = (s.steps / watch_interval + 1) * watch_interval;
        const std::int64_t next = std::min({last, next_watch, step_of_look(run, setup)});
        if (next > s.steps) dem_min::advance(s, next - s.steps);
        look_where_due(run, setup);
        if (s.steps % watch_interval != 0) continue;
        run.state.released < 0 ? watch_bed(run, setup) : watch_flow(run, setup);
    }
}

std::int64_t expected_steps(const FlowSetup& setup) {
    const double fall = 2.0 * std::sqrt(2.0 * top_of(setup) / setup.gravity);
    const double rests = setup.filling.level > 0.0 ? 2.5 : 1.5;
    const double flow =
        setup.times.empty()
            ? std::visit([&](const auto& v) { return expected_duration(v, setup); }, setup.vessel)
            : setup.times.back();
    return static_cast<std::int64_t>((fall + rests * setup.rest_duration + flow) / setup.time_step);
}

FlowRecord record(const FlowRun& run, const FlowSetup& setup) {
    const Simulation& s = run.simulation;
    FlowRecord r{};
    r.ending = run.state.ending;
    for (std::size_t k = 0; k < s.grains.count(); ++k) {
        r.grains.centre.push_back(s.grains.position(k));
        r.grains.radius.push_back(s.grains.radius[k]);
    }
    r.steps = s.steps;
    r.hash = dem_min::state_hash(s);
    if (run.state.released < 0) return r;
    const auto noted = [&](const char* name) { return run.state.noted.at(name); };
    r.quantities = {{"grains", noted("grains"), "1"},
                    {"filled_mass", noted("filled_mass"), "kg"},
                    {"time", seconds_since_release(run, setup), "s"}};
    std::visit([&](const auto& v) { complete(v, r, run, setup); }, setup.vessel);
    return r;
}

}  // namespace rigs
