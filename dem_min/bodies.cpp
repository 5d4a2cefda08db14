// SPDX-License-Identifier: MIT
#include "dem_min/bodies.hpp"

#include "dem_min/simulation.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace dem_min {
namespace {

using contact::cross;
using contact::dot;

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

// The turn by the angle |a| about a. With u = tan(|a|/4) along a the quaternion is ((1 - u^2), 2 u)/(1 + u^2), of unit length for any
// u; the tangent is cut off after x + x^3/3 + 2 x^5/15, 1e-12 of an angle of a tenth. No sine or cosine: their last bit hangs on the
// library.
Quaternion turn_by(Vec3 a) {
    const Vec3 x = 0.25 * a;
    const double x2 = dot(x, x);
    const Vec3 u = (1.0 + x2 * (1.0 / 3.0 + x2 * (2.0 / 15.0))) * x;
    const double u2 = dot(u, u), scale = 1.0 / (1.0 + u2);
    const Vec3 v = (2.0 * scale) * u;
    return {(1.0 - u2) * scale, v.x, v.y, v.z};
}

// Products leave the unit length by round-off; one step of Newton's brings it back.
Quaternion unit(const Quaternion& q) {
    const double s = 1.5 - 0.5 * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {s * q.w, s * q.x, s * q.y, s * q.z};
}

Vec3 times(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

Vec3 vector_of(const Quaternion& q) { return {q.x, q.y, q.z}; }

// Body by body; each is alone with its members.
template <class Each>
void for_each_body(Simulation& s, Each&& each) {
    if (s.bodies.empty()) return;
    const int bodies = static_cast<int>(s.bodies.size()), team = s.team();
#pragma omp parallel for schedule(static) num_threads(team) if (team > 1)
    for (int b = 0; b < bodies; ++b) each(s.bodies[static_cast<std::size_t>(b)]);
}

// each(grain, arm): the arm from the body's centre to the member, m, in space.
template <class Each>
void for_each_member(const Simulation& s, const Body& body, Each&& each) {
    for (std::int64_t m = body.first; m < body.first + body.count; ++m) {
        const Member& member = s.members[static_cast<std::size_t>(m)];
        each(static_cast<std::size_t>(member.grain), turned(body.turn, member.place));
    }
}

void half_kick(Body& b, double half) {
    b.velocity = b.velocity + (half / b.mass) * b.force;
    b.angular_momentum = b.angular_momentum + half * b.torque;
}

void set_velocity(Particles& p, std::size_t k, Vec3 v) {
    p.vx[k] = v.x, p.vy[k] = v.y, p.vz[k] = v.z;
}

void give_velocities(Simulation& s, const Body& body) {
    Particles& p = s.grains;
    const Vec3 w = body.spin();
    for_each_member(s, body, [&](std::size_t k, Vec3 arm) {
        set_velocity(p, k, body.velocity + cross(w, arm));
        p.wx[k] = w.x, p.wy[k] = w.y, p.wz[k] = w.z;
    });
}

void place(Simulation& s, const Body& body) {
    Particles& p = s.grains;
    for_each_member(s, body, [&](std::size_t k, Vec3 arm) {
        const Vec3 x = body.centre + arm;
        p.x[k] = x.x, p.y[k] = x.y, p.z[k] = x.z;
    });
    give_velocities(s, body);
}

void refuse_unless_positive(double value, const std::string& what, const std::string& unit) {
    if (value > 0.0 && std::isfinite(value)) return;
    throw scaling::InvalidParameter(
        scaling::mistake("clump." + what, std::to_string(value) + " " + unit, "must be > 0",
                         "give what the body is made of"));
}

}  // namespace

Vec3 turned(const Quaternion& q, Vec3 a) {  // a + 2 w (v x a) + 2 v x (v x a)
    const Vec3 v = vector_of(q), t = 2.0 * cross(v, a);
    return a + q.w * t + cross(v, t);
}

Vec3 turned_back(const Quaternion& q, Vec3 a) { return turned({q.w, -q.x, -q.y, -q.z}, a); }

Quaternion turn_to(Vec3 axis) {
    const double w = std::sqrt(0.5 * std::max(0.0, 1.0 + axis.z));
    if (w <
        0.5) {  // by way of the turn about x that takes z to -z, so that nothing is divided by 0
        const Quaternion q = turn_to({axis.x, -axis.y, -axis.z});
        return Quaternion{0.0, 1.0, 0.0, 0.0} * q;
    }
    return {w, -0.5 * axis.y / w, 0.5 * axis.x / w, 0.0};
}

Quaternion free_turn(const Quaternion& start, Vec3 momentum, Vec3 inverse, double dt) {
    Quaternion q = start;
    const auto about_y = [&](double time) {
        const double rate = (inverse.y - inverse.x) * turned_back(q, momentum).y;
        if (rate != 0.0) q = q * turn_by({0.0, time * rate, 0.0});
    };
    about_y(0.5 * dt);
    q = q * turn_by({0.0, 0.0, dt * ((inverse.z - inverse.x) * turned_back(q, momentum).z)});
    about_y(0.5 * dt);
    return unit(turn_by((dt * inverse.x) * momentum) * q);
}

Vec3 Body::spin() const {
    return turned(turn, times(inverse_inertia, turned_back(turn, angular_momentum)));
}

void insert(Simulation& s, const Clump& clump, const Birth& birth) {
    refuse_unless_positive(static_cast<double>(clump.balls.size()), "balls", "");
    refuse_unless_positive(clump.mass, "mass", "kg");
    const Vec3 inertia = clump.inertia;
    refuse_unless_positive(std::min({inertia.x, inertia.y, inertia.z}), "inertia", "kg m^2");
    Body body{};
    body.centre = birth.centre, body.velocity = birth.velocity, body.turn = birth.turn;
    body.mass = clump.mass;
    body.inverse_inertia = {1.0 / inertia.x, 1.0 / inertia.y, 1.0 / inertia.z};
    body.angular_momentum = turned(birth.turn, times(inertia, turned_back(birth.turn, birth.spin)));
    body.force = clump.mass * s.settings.gravity;
    body.first = static_cast<std::int64_t>(s.members.size());
    body.count = static_cast<std::int64_t>(clump.balls.size());
    Particles& p = s.grains;
    for (const Ball& ball : clump.balls) {
        s.members.push_back({static_cast<std::int64_t>(p.count()), ball.place});
        p.add({{}, {}, {}, ball.radius, 0.0, true, birth.material}, s.births++);
        p.body.back() = static_cast<int>(s.bodies.size());
        // What resists rolling asks how soon it could stop: at its most sudden, about the easiest axis.
        p.inverse_inertia.back() = 1.0 / std::min({inertia.x, inertia.y, inertia.z});
    }
    s.bodies.push_back(body);
    place(s, body);
    s.past.kinetic_in += kinetic_energy(body);
    s.past.potential_in += potential_of_gravity(s, body);
    s.list_is_stale = true;
}

double kinetic_energy(const Body& b) {
    return 0.5 * b.mass * dot(b.velocity, b.velocity) + 0.5 * dot(b.angular_momentum, b.spin());
}

double potential_of_gravity(const Simulation& s, const Body& b) {
    return -b.mass * dot(s.settings.gravity, b.centre);
}

double mass_of(const Simulation& s, std::size_t k) {
    const Particles& p = s.grains;
    if (p.body[k] < 0) return p.mass[k];
    const Body& body = s.bodies[static_cast<std::size_t>(p.body[k])];
    const auto cube = [&](std::size_t m) { return p.radius[m] * p.radius[m] * p.radius[m]; };
    double volumes = 0.0;
    for_each_member(s, body, [&](std::size_t m, Vec3) { volumes += cube(m); });
    return body.mass * cube(k) / volumes;
}

void begin_bodies(Simulation& s) {
    const double dt = s.settings.time_step;
    for_each_body(s, [&](Body& body) {
        half_kick(body, 0.5 * dt);
        const Body before = body;
        body.centre = body.centre + dt * body.velocity;
        body.turn = free_turn(body.turn, body.angular_momentum, body.inverse_inertia, dt);
        for (std::int64_t m = body.first; m < body.first + body.count; ++m) {
            const Member& member = s.members[static_cast<std::size_t>(m)];
            const Vec3 way = turned(body.turn, member.place) - turned(before.turn, member.place);
            set_velocity(s.grains, static_cast<std::size_t>(member.grain),
                         body.velocity + (1.0 / dt) * way);
        }
    });
}

void place_members(Simulation& s) {
    for_each_body(s, [&](const Body& body) { place(s, body); });
}

void end_bodies(Simulation& s) {
    const Particles& p = s.grains;
    for_each_body(s, [&](Body& body) {
        Vec3 force, torque;
        for_each_member(s, body, [&](std::size_t k, Vec3 arm) {
            const Vec3 f{p.fx[k], p.fy[k], p.fz[k]};
            force = force + f;
            torque = torque + Vec3{p.tx[k], p.ty[k], p.tz[k]} + cross(arm, f);
        });
        body.force = force + body.mass * s.settings.gravity;
        body.torque = torque;
        half_kick(body, 0.5 * s.settings.time_step);
        give_velocities(s, body);
    });
}

std::vector<bool> lost_bodies(const Simulation& s) {
    std::vector<bool> lost;
    for (const Body& body : s.bodies) lost.push_back(body.centre.z < s.settings.lost_below);
    return lost;
}

void renumber_bodies(Simulation& s, const std::vector<int>& new_index) {
    const std::vector<Body> old = std::move(s.bodies);
    const std::vector<Member> old_members = std::move(s.members);
    s.bodies.clear(), s.members.clear();
    for (Body body : old) {
        const auto first = old_members.begin() + body.first;
        if (new_index[static_cast<std::size_t>(first->grain)] < 0) continue;
        body.first = static_cast<std::int64_t>(s.members.size());
        for (auto m = first; m != first + body.count; ++m) {
            const int grain = new_index[static_cast<std::size_t>(m->grain)];
            s.members.push_back({grain, m->place});
            s.grains.body[static_cast<std::size_t>(grain)] = static_cast<int>(s.bodies.size());
        }
        s.bodies.push_back(body);
    }
}

void refuse_sleep_of_bodies(const Simulation& s) {
    if (s.bodies.empty() || !(s.settings.sleep_speed > 0.0)) return;
    throw scaling::InvalidParameter(
        scaling::mistake("sleep_speed", std::to_string(s.settings.sleep_speed) + " m/s",
                         "must be 0 where grains are clumps", "let no region sleep"));
}

}  // namespace dem_min
