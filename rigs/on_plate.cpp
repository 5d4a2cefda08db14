// SPDX-License-Identifier: MIT
#include "rigs/on_plate.hpp"

#include "rigs/ode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigs {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr int most_changes = 8;  // of the branch of the drag curve, in one stretch
constexpr int most_events =
    100;  // between which time stands still: slip and spin that take turns in coming to nothing

double sign(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

// What the grain does, until an event: slides with this sign, rolls, or rests. `turn` is the sign of the spin that rolling
// resistance works against; `locked`: resistance is the stronger, the grain slides without turning.
struct Mode {
    enum class Kind { slide, roll, rest } kind;
    double slip = 0.0, turn = 0.0;
    bool locked = false;
};

struct Rates {
    double a, b;  // v', w'
};

double pull(const PlateForces& f, const OnPlate& x) {
    double force = f.further ? f.further(x) : 0.0;
    if (f.drag != nullptr && f.drag->factor != 0.0)
        force -= f.drag->resistance(std::abs(x.v), x.newton) * x.v;
    return f.along + force / f.mass;
}

Rates rates(const PlateForces& f, const Mode& mode, const OnPlate& x) {
    const double p = pull(f, x), press = std::max(0.0, f.press);
    if (mode.kind == Mode::Kind::rest) return {0.0, 0.0};
    const double resistance = f.rolling_friction * press * mode.turn;
    if (mode.kind == Mode::Kind::roll) {
        const double a = (p - resistance) / 1.4;
        return {a, a};
    }
    const double held = f.friction.at(std::abs(x.v - x.w)) * press * mode.slip;
    return {p - held, mode.locked ? 0.0 : 2.5 * (held - resistance)};
}

Mode sliding(const PlateForces& f, const OnPlate& x, double slip) {
    const bool resists = f.rolling_friction > 0.0;
    if (!resists || x.w != 0.0) return {Mode::Kind::slide, slip, resists ? sign(x.w) : 0.0};
    const bool turns = f.friction.at(std::abs(x.v - x.w)) > f.rolling_friction;
    return {Mode::Kind::slide, slip, slip, !turns};
}

// By how much friction falls short of what rolling asks for, m/s^2; > 0: it slips.
double shortfall(const PlateForces& f, const Mode& roll, const OnPlate& x) {
    return std::abs(rates(f, roll, x).a - pull(f, x)) - f.friction.at(0.0) * std::max(0.0, f.press);
}

Mode mode_of(const PlateForces& f, const OnPlate& x) {
    const double slip = x.v - x.w;
    if (slip != 0.0) return sliding(f, x, sign(slip));
    const double p = pull(f, x), press = std::max(0.0, f.press);
    const double mu = f.friction.at(0.0) * press, mu_r = f.rolling_friction * press;
    if (x.v == 0.0 && std::abs(p) <= mu && std::abs(p) <= mu_r) return {Mode::Kind::rest};
    const double turn = f.rolling_friction > 0.0 ? sign(x.v != 0.0 ? x.v : p) : 0.0;
    const Mode roll{Mode::Kind::roll, 0.0, turn};
    const bool held_still = x.v == 0.0 && f.rolling_friction > 0.0 && std::abs(p) <= mu_r;
    if (!held_still && shortfall(f, roll, x) <= 0.0) return roll;
    const double needed = held_still ? -p : rates(f, roll, x).a - p;
    return sliding(f, x, -sign(needed));
}

// What ends a mode: the slip, the spin or the speed comes to zero. The value has the sign +1 at first.
double until_slip_ends(const Mode& m, const OnPlate& x) { return m.slip * (x.v - x.w); }

// Speeds that weight changes within a nanosecond are none: slip and spin would else take turns in coming to nothing for ever.
void settle(const Mode& mode, const PlateForces& f, OnPlate& x, bool slip_ended) {
    if (mode.kind == Mode::Kind::slide && slip_ended)
        x.w = x.v;
    else if (mode.kind == Mode::Kind::slide)
        x.w = 0.0;
    else
        x.v = x.w = 0.0;
    if (std::abs(x.v) + std::abs(x.w) < 1e-9 * std::max(0.0, f.press)) x.v = x.w = 0.0;
}

OnPlate moved(const OnPlate& x, const Rates& r, double dt) {
    OnPlate y = x;
    y.t += dt, y.s += (x.v + 0.5 * r.a * dt) * dt, y.v += r.a * dt, y.w += r.b * dt;
    return y;
}

double zero_after(double value, double rate) { return value * rate < 0.0 ? -value / rate : never; }

using Record = std::function<void(std::size_t, const OnPlate&)>;

// One mode at constant rates, to its end or `until`.
void carry_evenly(OnPlate& x, double until, const PlateForces& f, Rows& rows,
                  const Record& record) {
    const Mode mode = mode_of(f, x);
    const Rates r = rates(f, mode, x);
    const bool resists = f.rolling_friction > 0.0 && !mode.locked;
    double slip_ends = never, turn_ends = never;
    if (mode.kind == Mode::Kind::slide) {
        slip_ends = zero_after(x.v - x.w, r.a - r.b);
        if (resists) turn_ends = zero_after(x.w, r.b);
    } else if (resists) {
        turn_ends = zero_after(x.v, r.a);
    }
    const double duration = std::min({slip_ends, turn_ends, until - x.t});
    for (; !rows.done() && rows.time() <= x.t + duration; ++rows.next)
        record(rows.next, moved(x, r, rows.time() - x.t));
    if (duration == never) {
        x.t = never;
        return;
    }
    const bool event = duration == slip_ends || duration == turn_ends;
    x = moved(x, r, duration);
    if (event)
        settle(mode, f, x, slip_ends <= turn_ends);
    else
        x.t = until;
}

struct Plane {
    const PlateForces* forces;
    const Mode* mode;
    const bool* newton;
    Unknowns<3> operator()(double t, const Unknowns<3>& y) const {
        const OnPlate x{t, y[0], y[1], y[2], *newton};
        const Rates r = rates(*forces, *mode, x);
        return {y[1], r.a, r.b};
    }
};

// One mode at rates that change, to its end or `until`; returns the mode that must follow, where that is known.
void carry_by_steps(OnPlate& x, double until, const PlateForces& f, Rows& rows,
                    const Record& record) {
    const bool dragged = f.drag != nullptr && f.drag->factor != 0.0;
    Mode mode = mode_of(f, x);
    const double scale =
        std::abs(x.v) + std::abs(x.w) + std::sqrt(std::abs(f.along) + f.press) * 1e-3;
    const Rates first = rates(f, mode, x);
    const double guess = 0.05 * scale / (std::abs(first.a) + std::abs(first.b) + 1e-30);
    Ode<3, Plane> ode({&f, &mode, &x.newton}, x.t, {x.s, x.v, x.w},
                      {1e-12 * scale, 1e-11 * scale, 1e-11 * scale}, std::min(guess, 1e3));
    int changes = 0, events = 0;
    double last = x.t;
    while (x.t < until && !rows.done() && std::isfinite(x.s + x.v + x.w)) {
        if (mode.kind == Mode::Kind::rest) {
            x.t = std::min(until, std::max(rows.time(), x.t));
            for (; !rows.done() && rows.time() <= x.t; ++rows.next) record(rows.next, x);
            if (mode_of(f, x).kind != Mode::Kind::rest) return;
            continue;
        }
        const double horizon = std::min(until, rows.at.back());
        if (!(horizon > x.t)) return;
        const OdeStep<3> step = ode.step(horizon - x.t);
        const auto at = [&](double share) {
            const Unknowns<3> y = step.at(share);
            return OnPlate{step.t + share * step.h, y[0], y[1], y[2], x.newton};
        };
        double share = 1.0;
        int event = 0;
        const auto watch = [&](int number, const auto& value) {  // value > 0 before the event
            if (value(at(share)) >= 0.0) return;
            const auto f0 = [&](double s) {
                return s == 0.0 ? std::max(value(at(0.0)), 1e-300) : value(at(s));
            };
            share = crossing(f0, 0.0, share), event = number;
        };
        if (mode.kind == Mode::Kind::slide) {
            watch(1, [&](const OnPlate& y) { return until_slip_ends(mode, y); });
            if (f.rolling_friction > 0.0 && !mode.locked)
                watch(2, [&](const OnPlate& y) { return mode.turn * y.w; });
        } else {
            if (mode.turn != 0.0) watch(2, [&](const OnPlate& y) { return mode.turn * y.v; });
            watch(3, [&](const OnPlate& y) { return -shortfall(f, mode, y); });
        }
        if (dragged && changes < most_changes) {
            const double side = x.newton ? 1.0 : -1.0;
            watch(4, [&](const OnPlate& y) {
                return side * (f.drag->reynolds(std::abs(y.v)) - 1000.0);
            });
        }
        const OnPlate end = at(share);
        for (; !rows.done() && rows.time() <= end.t; ++rows.next)
            record(rows.next, at((rows.time() - step.t) / step.h));
        const bool newton = x.newton;
        x = end;
        x.newton = event == 4 ? !newton : newton;
        if (event == 4) ++changes;
        if (event == 0) continue;
        events = x.t - last < 1e-9 * horizon ? events + 1 : 0, last = x.t;
        if (events > most_events) {
            x.v = x.w = 0.0;
            return;
        }
        if (event == 1 || event == 2) settle(mode, f, x, event == 1);
        mode = event == 3 ? sliding(f, x, -sign(rates(f, mode, x).a - pull(f, x))) : mode_of(f, x);
        ode.restart(x.t, {x.s, x.v, x.w});
    }
}

}  // namespace

double Rows::time() const { return done() ? never : at[next]; }

void carry(OnPlate& x, double until, const PlateForces& f, Rows& rows, const Record& record) {
    const bool dragged = f.drag != nullptr && f.drag->factor != 0.0;
    const bool even = !dragged && !f.further && !f.friction.depends();
    if (dragged) x.newton = f.drag->beyond(std::abs(x.v));
    int turns = 0;
    while (x.t < until && !rows.done() && std::isfinite(x.s + x.v + x.w)) {
        if (++turns > 10 * most_events) {  // it rests, but for round-off
            x.v = x.w = 0.0;
            for (; !rows.done() && rows.time() <= until; ++rows.next) record(rows.next, x);
            x.t = until;
            return;
        }
        if (even)
            carry_evenly(x, until, f, rows, record);
        else
            carry_by_steps(x, until, f, rows, record);
    }
}

void carry(OnPlate& x, double duration, const PlateForces& f) {
    const std::vector<double> end{x.t + duration};
    Rows rows{end};
    carry(x, end.front(), f, rows, [](std::size_t, const OnPlate&) {});
}

}  // namespace rigs
