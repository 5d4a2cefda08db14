// SPDX-License-Identifier: MIT
#include "rigs/flight.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rigs {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// When a plate that sinks faster than the grain would fall lets it go; `never` where it does not.
double lift_off(const DropWorld& world, double hold, double t) {
    const Vibration& plate = world.grain->vibration;
    const double peak = plate.amplitude * plate.omega * plate.omega;
    if (!(peak > hold)) return never;
    const double turn = 2.0 * std::numbers::pi, at = std::asin(hold / peak);
    const double phase = std::fmod(std::fmod(plate.omega * t + plate.phase, turn) + turn, turn);
    if (phase >= at && phase <= 0.5 * turn - at) return t;
    return t + (phase < at ? at - phase : turn + at - phase) / plate.omega;
}

}  // namespace

void stay(const DropWorld& world, DropState& s, DropRows& out) {
    const OneGrain& g = *world.grain;
    const double hold = world.holding(), held = 2.0 * g.pull_off_force() / g.mass;
    const double sunk = g.resting_overlap(g.mass * hold);
    const PlateForces forces{.along = world.along,
                             .press = hold + held,
                             .friction = g.friction,
                             .rolling_friction = g.rolling_friction,
                             .drag = &g.drag,
                             .mass = g.mass,
                             .further = {}};
    const bool moving = g.vibration.amplitude > 0.0;
    const double end =
        moving && g.work_of_adhesion == 0.0 ? lift_off(world, world.grip(s), s.t) : never;
    const auto on_it = [&](const OnPlate& p) {
        DropState r = s;
        r.t = p.t, r.x = p.s, r.vx = p.v, r.w = p.w;
        r.z = moving ? g.vibration.height(p.t) - sunk : -sunk;
        r.vz = moving ? g.vibration.velocity(p.t) : 0.0;
        return r;
    };
    OnPlate p{s.t, s.x, s.vx, s.w, false};
    std::vector<DropState>& states = out.path.states;
    carry(p, end, forces, out.rows, [&](std::size_t row, const OnPlate& at) {
        states.push_back(on_it(at));
        states.back().t = out.rows.at[row];
    });
    if (out.done()) return;
    s = on_it(p);
    s.z += sunk;
}

}  // namespace rigs
