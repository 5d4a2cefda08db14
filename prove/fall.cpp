// SPDX-License-Identifier: MIT
// The rig `drop`: flights, impacts, and what follows the last of them.
#include "prove/collision.hpp"
#include "prove/ground.hpp"
#include "prove/motions.hpp"
#include "prove/path.hpp"
#include "prove/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace prove {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double closest = 0.165e-9;  // m, gap at which the attraction of surfaces ends

// Work of the attraction A R/(6 h^2), held at its value of the closest gap below that: A R/(3 h0).
double surface_well(const World& w, const Setup& s) {
    return w.hamaker_constant * s.r_star() / (3.0 * closest);
}

struct Fall {
    const World& w;
    const Setup& s;
    double t_end;      // of the true clock
    double middle;     // of the recording
    bool wet = false;  // a bridge hangs between grain and plate
    double upright = std::cos(w.tilt_angle);
    double leaning = std::sin(w.tilt_angle) * std::cos(w.tilt_azimuth);
    double t = 0.0, y[5] = {};  // z, vz, x, vx, spin
    Path path{};
    std::optional<std::pair<double, std::vector<ContactNode>>> course{};  // of the last e

    double plate(double at) const {
        if (w.amplitude == 0.0) return 0.0;
        return w.amplitude * std::sin(2.0 * pi * w.frequency * at + w.phase);
    }
    double plate_speed(double at) const {
        if (w.amplitude == 0.0) return 0.0;
        return w.amplitude * 2.0 * pi * w.frequency *
               std::cos(2.0 * pi * w.frequency * at + w.phase);
    }
    double weight(double at) const {
        const double g = s.gravity * (1.0 - w.buoyancy * s.fluid_density / s.density);
        return w.kind == Outside::gravity_step && at > middle ? g * (1.0 + w.outside) : g;
    }
    bool constant() const {
        return w.drag == 0.0 && w.charge == 0.0 && !wet && w.kind == Outside::none;
    }
    void rates(double at, const double* state, double* rate) const {
        const double g = weight(at);
        const double speed =
            w.drag > 0.0 ? std::sqrt(state[1] * state[1] + state[3] * state[3]) : 0.0;
        const double drag = speed > 0.0 ? drag_deceleration(w, s, speed) / speed : 0.0;
        rate[0] = state[1];
        rate[1] =
            -g * upright - drag * state[1] - attraction(w, s, state[0] - plate(at), wet) / s.mass();
        rate[2] = state[3];
        rate[3] = g * leaning - drag * state[3];
        if (w.kind == Outside::spring_to_middle) rate[3] -= s.gravity * w.outside * state[2] / 0.1;
        rate[4] = 0.0;
    }
    void mark() {
        double rate[5];
        rates(t, y, rate);
        path.add({t, y[0], y[1], rate[1], y[2], y[3], rate[3], y[4], 0.0});
    }
    double first_try() const;
    bool along_parabola(double& h);
    void back_to_gap(double gap, double t0, const double* a);
    bool fly();     // to the next touch; false where t_end came first
    bool bounce();  // false where the grain stays
    void lie();     // from here to t_end
    void stay_on_plate();
};

// Of a - b, the state on the straight or curved way between two points.
void between(double at, double t0, const double* a, const double* ra, double t1, const double* b,
             const double* rb, double* state) {
    const Quintic z = quintic(at, t0, a[0], a[1], ra[1], t1, b[0], b[1], rb[1]);
    const Quintic x = quintic(at, t0, a[2], a[3], ra[3], t1, b[2], b[3], rb[3]);
    state[0] = z.value, state[1] = z.slope, state[2] = x.value, state[3] = x.slope;
    state[4] = a[4];
}

// The step to try first: a tenth of the hop; for a parabola over a plate at rest all of it.
double Fall::first_try() const {
    double rate[5];
    rates(t, y, rate);
    const double hop = std::max(2.0 * std::abs(y[1] - plate_speed(t)) / std::abs(rate[1]), 1e-9);
    if (!constant()) return first_step(w, s, std::hypot(y[1], y[3]), 0.1 * hop);
    if (w.amplitude > 0.0)
        return std::min(0.05 / w.frequency, std::max(0.1 * hop, 1e-3 / w.frequency));
    const double gap = std::max(y[0] - plate(t), 0.0), fall = -rate[1];
    return std::max((y[1] + std::sqrt(y[1] * y[1] + 2.0 * fall * gap)) / fall, 1e-12);
}

// Under constant forces; true where it lands on a plate at rest.
bool Fall::along_parabola(double& h) {
    double rate[5];
    rates(t, y, rate);
    const bool whole = h < t_end - t;
    const double step = whole ? h : t_end - t;
    for (int k = 0; k < 4; k += 2) {
        y[k] += step * (y[k + 1] + 0.5 * step * rate[k + 1]);
        y[k + 1] += step * rate[k + 1];
    }
    t = whole ? t + step : t_end;
    h = std::min(0.05 / std::max(w.frequency, 1e-9), 2.0 * h);
    if (whole && w.amplitude == 0.0) y[0] = 0.0;
    return whole && w.amplitude == 0.0;
}

// Back to where the gap was `gap`, within the step that began at t0 with state a. Just after a rebound the gap is zero at t0
// as well: it is looked for behind that.
void Fall::back_to_gap(double gap, double t0, const double* a) {
    double ra[5], rb[5], state[5];
    rates(t0, a, ra);
    rates(t, y, rb);
    const double end = root(
        [&](double at) {
            between(at, t0, a, ra, t, y, rb, state);
            return state[0] - plate(at) - gap;
        },
        t0 + 1e-6 * (t - t0), t);
    between(end, t0, a, ra, t, y, rb, state);
    std::copy(state, state + 5, y);
    y[0] = plate(end) + gap;
    t = end;
}

bool Fall::fly() {
    mark();
    double h = first_try();
    const double v0 = std::abs(y[1]) + std::sqrt(2.0 * s.gravity * std::max(y[0], 0.0)) + 1e-4;
    Stepper stepper(
        [this](double at, const double* state, double* rate) { rates(at, state, rate); },
        {1e-8 * v0, 1e-8 * v0, 1e-8 * v0, 1e-8 * v0, 1e-6}, 1e-8);
    const double widest = w.amplitude > 0.0 ? 0.05 / w.frequency : 0.2 * t_end;
    while (t < t_end) {
        const double t0 = t, before[5] = {y[0], y[1], y[2], y[3], y[4]};
        bool touches = false;
        if (constant()) {
            touches = along_parabola(h);
        } else {
            h = std::min(h, widest);
            stepper.advance(t, t_end, h, y);
        }
        if (!touches && y[0] < plate(t)) {
            back_to_gap(0.0, t0, before);
            touches = true;
        } else if (wet && y[0] - plate(t) > rupture_gap(w)) {
            back_to_gap(rupture_gap(w), t0, before);
            wet = false;
            return fly();  // other rates from here on
        }
        mark();
        if (touches) return true;
    }
    return false;
}

bool Fall::bounce() {
    wet = w.surface_tension > 0.0;
    const double floor = plate(t), floor_speed = plate_speed(t);
    double v = floor_speed - y[1];
    if (v <= 0.0) return true;  // grazing: flies on
    const double well = 2.0 * surface_well(w, s) / s.mass();
    v = std::sqrt(v * v + well);
    const double e = restitution_at(w, v, std::atan2(std::abs(y[3]), v));
    // Weight, bridge and charge take no part in the microseconds of a contact.
    NormalContact contact;
    if (w.work_of_adhesion <= 0.0) {
        if (!course || course->first != e) course.emplace(e, hertz_course(e));
        contact = scaled_course(s, course->second, v, e);
    } else {
        contact = adhesive_contact(w, s, v, e);
    }
    const Slip out = after_contact(w, s, contact, {y[3], y[4]});
    const double x0 = y[2], mean = 0.5 * (y[3] + out.velocity);
    for (std::size_t k = 1; k + 1 < contact.nodes.size(); k += 8) {
        const ContactNode& n = contact.nodes[k];
        const double accel = n.radius > 0.0 ? n.cap / s.mass() : 0.0;
        path.add({t + n.t, floor + floor_speed * n.t - n.overlap, floor_speed - n.rate,
                  w.work_of_adhesion > 0.0 ? 0.0 : accel, x0 + mean * n.t, mean, 0.0, y[4], 0.0});
    }
    t += contact.duration;
    y[0] = floor + floor_speed * contact.duration;
    y[2] = x0 + mean * contact.duration;
    y[3] = out.velocity, y[4] = out.spin;
    const double away = contact.rebound * contact.rebound - well;
    if (contact.stuck || away <= 0.0) return false;
    y[1] = floor_speed + std::sqrt(away);
    if (w.work_of_adhesion > 0.0 && !contact.nodes.empty())
        y[0] -= std::min(0.0, contact.nodes.back().overlap);
    return true;
}

void Fall::lie() {
    y[0] = plate(t), y[1] = plate_speed(t);
    Load load = load_on_plane(w, s, 0.0, wet);
    load.along = weight(t) * std::sin(w.tilt_angle) * std::cos(w.tilt_azimuth);
    path.add({t, 0.0, 0.0, 0.0, y[2], y[3], 0.0, y[4], 0.0});
    move_on_ground(w, s, load, t_end, path);
    t = t_end;
}

// With a moving plate: held until the plate falls away faster than the grain can follow.
void Fall::stay_on_plate() {
    const double omega = 2.0 * pi * w.frequency;
    const double g = weight(t) + attraction(w, s, 0.0, wet) / s.mass();
    const double step = 0.02 / w.frequency;
    const auto lets_go = [&](double at) {
        return -w.amplitude * omega * omega * std::sin(omega * at + w.phase) + g;
    };
    // Along the plate it slides and rolls under its mean load meanwhile.
    Path along;
    along.add({t, 0.0, 0.0, 0.0, y[2], y[3], 0.0, y[4], 0.0});
    Load load = load_on_plane(w, s, 0.0, wet);
    load.along = weight(t) * leaning;
    move_on_ground(w, s, load, t_end, along);
    while (t < t_end && lets_go(t) >= 0.0) {
        const Point p = along.at(t);
        y[2] = p.x, y[3] = p.vx, y[4] = p.spin;
        path.add({t, plate(t), plate_speed(t), lets_go(t) - g, p.x, p.vx, load.along * 5.0 / 7.0,
                  p.spin, 0.0});
        const double next = std::min(t + step, t_end);
        t = lets_go(next) < 0.0 ? root(lets_go, t, next) + 1e-9 / w.frequency : next;
    }
    const Point p = along.at(t);
    y[0] = plate(t), y[1] = plate_speed(t), y[2] = p.x, y[3] = p.vx, y[4] = p.spin;
    path.add({t, y[0], y[1], 0.0, y[2], y[3], 0.0, y[4], 0.0});
}

Path trajectory(const World& w, const Setup& s) {
    const double last = s.at.back() / w.time_factor;
    Fall f{.w = w, .s = s, .t_end = last + 1e-9, .middle = 0.5 * last};
    f.t = s.release_time;
    f.y[0] = s.height, f.y[1] = -s.speed, f.y[3] = s.horizontal_speed, f.y[4] = s.spin;
    f.path.add({f.t - 1e-9, s.height, 0.0, 0.0, 0.0, 0.0, 0.0, s.spin, 0.0});
    // Bounces below 1/50 000 of the height are rest: no instrument here sees them.
    const double tiny = 2e-5 * s.height;
    for (int k = 0; k < 2000 && f.t < f.t_end; ++k) {
        if (!f.fly()) break;
        const bool away = f.bounce();
        const double hop = f.y[1] - f.plate_speed(f.t);
        const double down = f.weight(f.t) + attraction(w, s, 0.0, f.wet) / s.mass();
        const bool low = !away || hop * hop < 2.0 * down * tiny;
        if (!low) continue;
        if (w.amplitude == 0.0) {
            f.lie();
        } else {
            f.stay_on_plate();
        }
    }
    return std::move(f.path);
}

}  // namespace

std::vector<double> drop(const World& w, const Setup& s) {
    const Path path = trajectory(w, s);
    const std::size_t rows = s.at.size();
    std::vector<double> all(s.size());
    for (std::size_t k = 0; k < rows; ++k) {
        const Point p = path.at(s.at[k] / w.time_factor);
        for (std::size_t c = 0; c < s.recorded.size(); ++c)
            all[c * rows + k] = s.recorded[c] == Channel::z ? p.z : p.x;
    }
    return all;
}

}  // namespace prove
