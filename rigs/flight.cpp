// SPDX-License-Identifier: MIT
#include "rigs/flight.hpp"

#include "rigs/ode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigs {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr int most_changes = 8;  // of the branch of the drag curve, in one flight

// First time > 0 at which z + v t - g t^2/2 comes down to 0.
double time_down(double z, double v, double g) {
    const double square = v * v + 2.0 * g * std::max(z, 0.0);
    if (square < 0.0) return never;
    const double root = std::sqrt(square);
    if (v > 0.0) return g > 0.0 ? (v + root) / g : never;
    if (v - root < 0.0) return 2.0 * std::max(z, 0.0) / (root - v);
    return g > 0.0 ? 0.0 : never;
}

double gap_at(const Vibration& plate, const DropState& s) {
    return plate.amplitude > 0.0 ? s.z - plate.height(s.t) : s.z;
}

// Steps that no crest of the plate can outrun: the gap bends by no more than g + A omega^2.
double time_to_moving_plate(const DropWorld& world, const DropState& start, double horizon) {
    const Vibration& plate = world.grain->vibration;
    const double bend = std::abs(world.into) + plate.amplitude * plate.omega * plate.omega;
    const double least = 1e-13 * (plate.amplitude + start.z + 1e-12);
    double t = 0.0;
    if (start.z > plate.amplitude) t = time_down(start.z - plate.amplitude, start.vz, world.into);
    while (t < horizon) {
        const Vibration::Motion at = plate.at(start.t + t);
        const double gap = start.z + (start.vz - 0.5 * world.into * t) * t - at.height;
        const double rate = start.vz - world.into * t - at.velocity;
        if (gap <= least && rate < 0.0) return t;
        const double dt = time_down(std::max(gap, 0.0), rate, bend);
        // A grain that has just been let go leaves the plate with the third power of time: no step is shorter there than a
        // thousandth of a period, in which the two part by less than 1e-7 of the amplitude.
        t += rate < 0.0 ? std::max(dt, 1e-15 * (std::abs(start.t + t) + 1e-9))
                        : std::max(dt, 6e-3 / plate.omega);
    }
    return horizon;
}

bool fly_freely(const DropWorld& world, DropState& s, DropRows& out) {
    const double horizon = std::max(0.0, out.rows.at.back() - s.t);
    const bool moving = world.grain->vibration.amplitude > 0.0;
    const double down = moving ? time_to_moving_plate(world, s, 1.000001 * horizon + 1e-9)
                               : time_down(s.z, s.vz, world.into);
    while (!out.done() && out.rows.time() <= s.t + down)
        out.add(thrown(world, s, out.rows.time() - s.t));
    if (out.done() || down == never) return false;
    s = thrown(world, s, down);
    if (!moving) s.z = 0.0;
    return true;
}

struct Air {
    const DropWorld* world;
    const DropState* regime;  // bridged, impact_speed
    const bool* newton;
    Unknowns<4> operator()(double t, const Unknowns<4>& y) const {
        const OneGrain& g = *world->grain;
        const DropState s{t, y[0], y[1], y[2], y[3], 0.0, regime->impact_speed, regime->bridged};
        double ax = world->along, az = -world->into;
        if (g.drag.factor != 0.0) {
            const double rate = g.drag.resistance(s.speed(), *newton) / g.mass;
            ax -= rate * s.vx, az -= rate * s.vz;
        }
        az += world->lift(s, std::max(0.0, gap_at(g.vibration, s))) / g.mass;
        return {y[2], y[3], ax, az};
    }
};

// m/s^2, of all that pulls here, drag left out.
double pull_at(const DropWorld& world, const DropState& s) {
    const double lift = world.lift(s, std::max(0.0, gap_at(world.grain->vibration, s)));
    return std::abs(world.into - lift / world.grain->mass) + std::abs(world.along);
}

// Scales that tell how small an error no longer counts.
Unknowns<4> negligible(const DropWorld& world, const DropState& s) {
    const double length = std::abs(s.z) + 1e-3 * world.grain->radius;
    const double speed = s.speed() + std::sqrt(2.0 * pull_at(world, s) * length);
    return {1e-9 * length, 1e-10 * length, 1e-9 * speed, 1e-10 * speed};
}

double first_step(const DropWorld& world, const DropState& s) {
    const double a = pull_at(world, s) + 1e-30;
    const double rise = std::abs(s.vz) / a, fall = std::sqrt(2.0 * std::max(s.z, 0.0) / a);
    return std::max(0.4 * std::max(s.vz > 0.0 ? rise : 0.0, 0.3 * fall), 1e-12);
}

// A step that misses no crest of the plate: a twentieth of a period where the plate may be, longer while the grain is above all
// crests.
double time_to_be_watched(const DropWorld& world, const DropState& s, bool newton) {
    const OneGrain& g = *world.grain;
    const double part = 0.05 * 2.0 * std::numbers::pi / g.vibration.omega;
    if (s.z <= g.vibration.amplitude) return part;
    const double drag =
        g.drag.factor == 0.0 ? 0.0 : g.drag.resistance(s.speed(), newton) / g.mass * s.speed();
    const double most = 1.1 * pull_at(world, s) + drag;
    return std::max(part, time_down(s.z - g.vibration.amplitude, s.vz, most));
}

bool fly_by_steps(const DropWorld& world, DropState& s, DropRows& out) {
    const OneGrain& g = *world.grain;
    const bool dragged = g.drag.factor != 0.0, moving = g.vibration.amplitude > 0.0;
    bool newton = dragged && g.drag.beyond(s.speed());
    Ode<4, Air> ode({&world, &s, &newton}, s.t, {s.x, s.z, s.vx, s.vz}, negligible(world, s),
                    first_step(world, s));
    // Where weight lies between the two branches at Re = 1000, the grain would change branches for ever.
    int changes = 0;
    for (bool first = true; !out.done(); first = false) {
        if (!std::isfinite(s.z + s.vz + s.vx)) return false;
        const double horizon = std::max(out.rows.at.back() - s.t, 1e-12);
        double longest = horizon;
        if (moving) longest = std::min(longest, time_to_be_watched(world, s, newton));
        if (first) longest = std::min(longest, first_step(world, s));
        const DropState start = s;
        const OdeStep<4> step = ode.step(longest);
        const auto at = [&](double share) {
            const Unknowns<4> y = step.at(share);
            DropState r = start;
            r.t = step.t + share * step.h, r.x = y[0], r.z = y[1], r.vx = y[2], r.vz = y[3];
            return r;
        };
        double share = 1.0;
        enum class Event { none, touch, rupture, regime } event = Event::none;
        const auto watch = [&](Event kind, const auto& value) {  // value > 0 before the event
            if (value(at(share)) >= 0.0) return;
            share = crossing(
                [&](double p) {
                    return p == 0.0 ? std::max(value(at(0.0)), 1e-300) : value(at(p));
                },
                0.0, share);
            event = kind;
        };
        watch(Event::touch, [&](const DropState& r) { return gap_at(g.vibration, r); });
        if (s.bridged)
            watch(Event::rupture, [&](const DropState& r) {
                return g.attraction.rupture - gap_at(g.vibration, r);
            });
        if (dragged && changes < most_changes) {
            const double side = newton ? 1.0 : -1.0;
            watch(Event::regime,
                  [&](const DropState& r) { return side * (g.drag.reynolds(r.speed()) - 1000.0); });
        }
        const DropState end = at(share);
        while (!out.done() && out.rows.time() <= end.t)
            out.add(at((out.rows.time() - step.t) / step.h));
        s = end;
        if (event == Event::touch) {
            if (!moving) s.z = 0.0;
            return !out.done();
        }
        if (event == Event::rupture) s.bridged = false;
        if (event == Event::regime) newton = !newton, ++changes;
        if (event != Event::none) ode.restart(s.t, {s.x, s.z, s.vx, s.vz});
    }
    return false;
}

}  // namespace

DropState thrown(const DropWorld& world, DropState s, double duration) {
    const double along = world.along, into = world.into;
    s.t += duration;
    s.x += (s.vx + 0.5 * along * duration) * duration;
    s.z += (s.vz - 0.5 * into * duration) * duration;
    s.vx += along * duration, s.vz -= into * duration;
    return s;
}

bool fly(const DropWorld& world, DropState& s, DropRows& out) {
    return world.ballistic() ? fly_freely(world, s, out) : fly_by_steps(world, s, out);
}

}  // namespace rigs
