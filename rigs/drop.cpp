// SPDX-License-Identifier: MIT
#include "rigs/drop.hpp"

#include "contact/jkr.hpp"
#include "dem_min/simulation.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigs {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct State {
    double t, x, z;       // s, m, m; z of the lowest point
    double vx, vz, spin;  // m/s, m/s, rad/s
};

State flown(State s, double duration, double g) {
    s.t += duration;
    s.x += s.vx * duration;
    s.z += (s.vz - 0.5 * g * duration) * duration;
    s.vz -= g * duration;
    return s;
}

// How long a free grain takes to the plate; `never` if it does not come down.
double time_to_plate(const State& s, double g) {
    if (g > 0.0) return (s.vz + std::sqrt(s.vz * s.vz + 2.0 * g * std::max(s.z, 0.0))) / g;
    return s.vz < 0.0 ? s.z / -s.vz : never;
}

// Takes down the grain's place at the times asked for, as the motion passes them.
struct Recorder {
    const std::vector<double>& times;
    DropRecord& record;

    bool done() const { return record.t.size() == times.size(); }
    double next() const { return done() ? never : times[record.t.size()]; }
    void add(double x, double z) {
        const double t = next();
        record.t.push_back(t), record.x.push_back(x), record.z.push_back(z);
    }
    void fly(const State& from, double duration, double g) {
        while (!done() && next() <= from.t + duration) {
            const State s = flown(from, next() - from.t, g);
            add(s.x, s.z);
        }
    }
    void move(const State& from, const State& to) {  // within one step: straight
        while (!done() && next() <= to.t) {
            const double share = (next() - from.t) / (to.t - from.t);
            add(from.x + share * (to.x - from.x), from.z + share * (to.z - from.z));
        }
    }
};

double mass(const DropSetup& s) {
    return s.density * 4.0 / 3.0 * std::numbers::pi * s.radius * s.radius * s.radius;
}

// A step of the contact that begins at `speed`: a share of the Hertz impact, 2.87 (m^2/(R E*^2 v))^(1/5) (Johnson 1985,
// eq. 11.24), and of the way through the adhesive gap. A slow touch lasts as if it came at sqrt(g times the resting overlap).
double step_of_contact(const DropSetup& s, double speed) {
    const double m = mass(s), r = s.radius, e = s.plate.e_star;
    const double sunk = std::pow(3.0 * m * s.gravity / (4.0 * e * std::sqrt(r)), 2.0 / 3.0);
    double effective = std::max(speed, std::sqrt(s.gravity * sunk)), gap = never;
    if (s.plate.work_of_adhesion > 0.0) {
        const contact::Jkr law{e, s.plate.work_of_adhesion};
        const double scale = law.length_scale(r);
        gap = -law.tear_off_overlap(r, scale);
        effective = std::max(effective, std::sqrt(2.0 * law.energy(r, scale, -gap) / m));
    }
    const double impact =
        2.87 * std::pow(m * m / (r * e * e * effective), 0.2) / s.steps_per_impact;
    return std::min(impact, 10.0 / s.steps_per_impact * gap / effective);
}

dem_min::Simulation contact_simulation(const DropSetup& setup, const State& s, double time_step) {
    dem_min::Simulation sim;
    sim.settings = {.time_step = time_step,
                    .skin = setup.radius,
                    .gravity = {0.0, 0.0, -setup.gravity},
                    .lost_below = -setup.radius};
    sim.between_grains = sim.at_walls = laws(setup.plate);
    sim.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    // x runs from the touch on, so that the core's margin of neighbours does not depend on where it happens.
    dem_min::insert(sim, {{0.0, 0.0, s.z + setup.radius},
                          {s.vx, 0.0, s.vz},
                          {0.0, s.spin, 0.0},
                          setup.radius,
                          setup.density});
    return sim;
}

// Nothing changes any more: neither normal motion nor slip that friction would end, nor rolling that would be braked. Speeds
// are measured by a millionth of sqrt(2 g R).
bool calm(const DropSetup& setup, const State& s) {
    const double slip = setup.plate.sliding_friction > 0.0 ? s.vx - setup.radius * s.spin : 0.0;
    const double braked = setup.plate.rolling_friction > 0.0 ? s.vx : 0.0;
    const double allowed = 1e-12 * 2.0 * setup.gravity * setup.radius;
    return s.vz * s.vz + slip * slip + braked * braked <= allowed;
}

enum class Ended { parted, settled, recorded };

Ended touch(const DropSetup& setup, State& s, Recorder& recorder) {
    const double time_step = step_of_contact(setup, std::abs(s.vz));
    dem_min::Simulation sim = contact_simulation(setup, s, time_step);
    const State start = s;
    const double patience =
        setup.steps_per_impact;  // steps: a turning point is calm, too, but not for so long
    double calm_steps = 0.0;
    bool touched = false;
    while (!recorder.done()) {
        dem_min::step(sim);
        ++recorder.record.steps;
        const State before = s;
        s = {start.t + sim.time(), start.x + sim.grains.x[0], sim.grains.z[0] - setup.radius,
             sim.grains.vx[0],     sim.grains.vz[0],          sim.grains.wy[0]};
        recorder.move(before, s);
        const bool touches = dem_min::wall_contact_count(sim) > 0;
        if (!touches && (touched || s.vz > 0.0)) return Ended::parted;
        touched = touches;
        calm_steps = touches && calm(setup, s) ? calm_steps + 1.0 : 0.0;
        if (calm_steps >= patience) return Ended::settled;
    }
    return Ended::recorded;
}

State released(const DropConditions& c) {
    return {c.release_time, 0.0, c.height, c.horizontal_speed, -c.speed, c.spin};
}

void run(const DropSetup& setup, Recorder& recorder) {
    const double g = setup.gravity;
    State s = released(setup.conditions);
    while (!recorder.done() && recorder.next() < s.t) recorder.add(0.0, setup.conditions.height);
    while (!recorder.done()) {
        const double down = time_to_plate(s, g);
        if (down == never) return recorder.fly(s, never, g);
        // The first step of the contact begins half a step above the plate.
        const double speed = std::sqrt(s.vz * s.vz + 2.0 * g * std::max(s.z, 0.0));
        const double flight = std::max(0.0, down - 0.5 * step_of_contact(setup, speed));
        recorder.fly(s, flight, g);
        s = flown(s, flight, g);
        if (recorder.done()) return;
        ++recorder.record.impacts;
        if (touch(setup, s, recorder) != Ended::settled) continue;
        recorder.record.settled = true;
        recorder.record.settled_at = s.t;
        const double rolls_on = setup.plate.rolling_friction > 0.0 ? 0.0 : s.vx;
        while (!recorder.done()) recorder.add(s.x + rolls_on * (recorder.next() - s.t), s.z);
    }
}

}  // namespace

DropConditions drop_conditions(const cases::Experiment& experiment) {
    using scaling::Velocity;
    const cases::Value& given = experiment.conditions;
    const auto or_nothing = [&]<class Q>(const char* key, Q nothing) {
        return given.quantity_or<Q>(key, nothing).value();
    };
    return {.height = given.at("height").quantity<scaling::Length>().value(),
            .speed = or_nothing("speed", Velocity{}),
            .horizontal_speed = or_nothing("horizontal_speed", Velocity{}),
            .spin = or_nothing("spin", scaling::Frequency{}),
            .release_time = or_nothing("release_time", scaling::Time{})};
}

DropSetup drop_setup(const cases::Case& c, const cases::Experiment& experiment) {
    refuse_other_physics(
        c, "drop", {"gravity", "hertz_mindlin", "hertz_coulomb", "adhesion", "rolling_resistance"});
    const cases::Model& model = c.model;
    const auto if_included = [&](const char* effect, const char* parameter) {
        return model.includes(effect) ? model.value_or(parameter, 0.0) : 0.0;
    };
    DropSetup s{};
    s.conditions = drop_conditions(experiment);
    s.radius = 0.5 * experiment.grain.diameter.value.value();
    s.density = experiment.grain.density.value.value();
    s.gravity = model.includes("gravity") ? experiment.surroundings.gravity.value() : 0.0;
    s.plate = elastic_parameters(grain_material(experiment), plate_material(experiment));
    s.plate.work_of_adhesion = if_included("adhesion", "work_of_adhesion");
    s.plate.sliding_friction = model.value_or("sliding_friction", 0.0);
    s.plate.rolling_friction = if_included("rolling_resistance", "rolling_friction");
    s.plate.restitution = model.value_or("restitution", 1.0);
    s.plate.rigid_tangential = model.includes("hertz_coulomb");
    return s;
}

DropRecord run_drop(const DropSetup& setup, const std::vector<double>& times) {
    if (!std::is_sorted(times.begin(), times.end()))
        throw scaling::InvalidParameter(scaling::mistake("run_drop.times",
                                                         "a time before the one in front of it",
                                                         "must not fall", "sort them"));
    DropRecord record;
    Recorder recorder{times, record};
    run(setup, recorder);
    return record;
}

DropRecord run_drop(const DropSetup& setup, int count) {
    const State start = released(setup.conditions);
    const double fall = time_to_plate(start, setup.gravity);
    if (!(fall < never))
        throw scaling::InvalidParameter(
            scaling::mistake("run_drop.times", "none", "must be given for a grain that never falls",
                             "gravity is 0 and it does not move towards the plate"));
    // A grain at the plate settles within some sqrt(R/g); hence the second term.
    const double longest =
        start.t +
        20.0 * (fall + (setup.gravity > 0.0 ? std::sqrt(setup.radius / setup.gravity) : fall));
    const DropRecord scout = run_drop(setup, std::vector<double>{longest});
    const double end = scout.settled ? scout.settled_at : longest;
    std::vector<double> times;
    for (int k = 0; k < count; ++k) times.push_back(end * k / std::max(1, count - 1));
    return run_drop(setup, times);
}

}  // namespace rigs
