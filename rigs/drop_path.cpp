// SPDX-License-Identifier: MIT
#include "rigs/drop_path.hpp"

#include "rigs/flight.hpp"
#include "rigs/one_contact.hpp"
#include "rigs/stepped_drop.hpp"

#include <algorithm>
#include <cmath>

namespace rigs {
namespace {

// Whether the grain rises no higher than weight presses it in when it lies: no bounce any more, but a swing about rest. 6 nm and
// 0.3 mm/s for a glass bead of 4 mm.
bool is_at_rest(const OneGrain& g, double rebound, double grip) {
    return rebound * rebound <= 2.0 * grip * g.resting_overlap(g.mass * grip);
}

// Whether the user's step is so far below the contact time that its run is the closed one: velocity Verlet, more than `fine`
// steps to the Hertz contact 2.87 (m^2/(R E*^2 v))^(1/5) of the fastest fall. There the stepped rebound of a 4 mm glass bead
// is within 1e-3 of the closed one (at 390 steps 1e-4 to 8e-4 for e = 0.5 to 0.85; at 50 steps 9e-3). Symplectic Euler is of
// first order, never as fine.
bool is_resolved(const DropWorld& world, const DropConditions& c) {
    constexpr double fine = 400.0;
    if (world.numerics->integrator == "euler") return false;
    const OneGrain& g = *world.grain;
    const double fall = std::abs(g.gravity) * std::max(0.0, c.height);
    const double v =
        std::sqrt(c.speed * c.speed + 2.0 * fall) + g.vibration.amplitude * g.vibration.omega;
    if (!(v > 0.0)) return false;
    const double contact =
        2.87 * std::pow(g.mass * g.mass / (g.radius * g.e_star * g.e_star * v), 0.2);
    return fine * world.numerics->time_step->value() < contact;
}

enum class After { flies, stays };

After bounce(const DropWorld& world, OneContact& contact, DropState& s, DropRows& out) {
    const OneGrain& g = *world.grain;
    const bool moving = g.vibration.amplitude > 0.0;
    const double plate_speed = g.vibration.velocity(s.t);
    const double normal = std::max(0.0, plate_speed - s.vz);
    ++out.path.impacts;
    s.impact_speed = normal, s.bridged = g.attraction.bridge > 0.0;
    const Rebound r = contact.touch({normal, s.vx, s.w});
    const DropState start = s;
    const auto within = [&](double since) {
        DropState p = start;
        const double share = r.duration > 0.0 ? since / r.duration : 1.0;
        p.t += since, p.z += plate_speed * since + contact.height(since);
        p.vx += share * (r.v - start.vx), p.w += share * (r.w - start.w);
        p.x += 0.5 * (start.vx + p.vx) * since;
        p.vz = plate_speed - normal + share * (r.normal + normal);
        return p;
    };
    while (!out.done() && out.rows.time() < start.t + r.duration)
        out.add(within(out.rows.time() - start.t));
    s.t += r.duration, s.x += 0.5 * (start.vx + r.v) * r.duration;
    s.z += plate_speed * r.duration + r.gap;
    s.vx = r.v, s.w = r.w, s.vz = plate_speed + r.normal;
    if (moving) s.z = g.vibration.height(s.t) + r.gap;
    const double grip = world.grip(s);
    const bool held = grip > 0.0 && is_at_rest(g, r.normal, grip);
    return r.stays || held ? After::stays : After::flies;
}

}  // namespace

DropWorld::DropWorld(const OneGrain& g, const MissingForce* force, const cases::Numerics* how)
    : grain(&g),
      missing(force),
      numerics(how),
      into(g.gravity * std::cos(g.tilt_angle)),
      along(g.gravity * std::sin(g.tilt_angle) * std::cos(g.tilt_azimuth)) {}

bool DropWorld::ballistic() const {
    return grain->drag.factor == 0.0 && grain->attraction.none() && missing == nullptr;
}

double DropWorld::lift(const DropState& s, double gap) const {
    double force = grain->attraction.none() ? 0.0 : -grain->attraction.across(gap, s.bridged);
    if (missing != nullptr) {
        const std::string& name = missing->variable;
        const double at = name == "t"       ? s.t
                          : name == "z"     ? s.z
                          : name == "speed" ? s.speed()
                                            : s.impact_speed;
        force += straight_between(missing->knots, missing->newtons, at);
    }
    return force;
}

double DropWorld::holding() const { return into + grain->attraction.in_contact() / grain->mass; }

double DropWorld::grip(const DropState& s) const {
    DropState touching = s;
    touching.bridged = grain->attraction.bridge > 0.0;
    return into - lift(touching, 0.0) / grain->mass;
}

DropPath follow_drop(const DropWorld& world, const DropConditions& c,
                     const std::vector<double>& times) {
    DropPath path;
    path.states.reserve(times.size());
    if (times.empty()) return path;
    DropRows out{{times}, path};
    DropState s{0.0, 0.0, c.height, c.horizontal_speed, -c.speed, world.grain->radius * c.spin};
    DropState held = s;
    held.vx = held.vz = held.w = 0.0;
    while (!out.done() && out.rows.time() < c.release_time) held.t = out.rows.time(), out.add(held);
    s.t = c.release_time;
    if (world.numerics != nullptr && world.numerics->time_step && !is_resolved(world, c)) {
        step_drop(world, s, out);
        return path;
    }
    OneContact contact(*world.grain);
    int idle = 0;  // liftings that were none: the plate and what holds the grain are in balance
    while (!out.done() && idle < 1000) {
        if (!fly(world, s, out)) break;
        if (bounce(world, contact, s, out) != After::stays) continue;
        if (!path.settled) path.settled = true, path.settled_at = s.t;
        const double before = s.t;
        stay(world, s, out);
        if (out.done()) break;
        path.settled = false;
        idle = s.t == before ? idle + 1 : 0;
        if (s.t == before)
            s.vz += 1e-9 * world.grain->vibration.amplitude * world.grain->vibration.omega;
    }
    return path;
}

}  // namespace rigs
