// SPDX-License-Identifier: MIT
#include "prove/ground.hpp"

#include "prove/collision.hpp"
#include "prove/motions.hpp"
#include "prove/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prove {
namespace {

constexpr double outside_length = 0.1;  // m, of the effects that depend on the way

struct Mode {
    enum class Kind { slide, roll, rest } kind;
    double slip_sign = 0.0, roll_sign = 0.0;
    bool spin_held = false;  // rolling resistance holds a grain that slides without turning
};

struct Motion {
    const World& w;
    const Setup& s;
    const Load& load;
    double middle;  // of the recording: where gravity steps

    double along(double t, double x) const {
        double pull = load.along;
        if (w.kind == Outside::gravity_step && t > middle) pull *= 1.0 + w.outside;
        if (w.kind == Outside::spring_to_middle) pull -= s.gravity * w.outside * x / outside_length;
        return pull;
    }
    double friction(double x, double slip) const {
        double mu = friction_at(w, slip);
        if (w.kind == Outside::growing_friction)
            mu *= std::max(0.0, 1.0 + w.outside * x / outside_length);
        return mu;
    }
    double hold(double t) const {
        return load.hold * (w.kind == Outside::gravity_step && t > middle ? 1.0 + w.outside : 1.0);
    }
    bool constant() const {
        return w.drag == 0.0 && w.friction_velocity <= 0.0 && w.kind == Outside::none;
    }
    // y = x, v, spin
    void rates(const Mode& mode, double t, const double* y, double* rate) const {
        const double r = s.radius(), n = hold(t), drag = drag_deceleration(w, s, y[1]);
        rate[0] = y[1];
        if (mode.kind == Mode::Kind::rest) {
            rate[1] = rate[2] = 0.0;
        } else if (mode.kind == Mode::Kind::roll) {
            rate[1] = 5.0 / 7.0 * (along(t, y[0]) - drag - mode.roll_sign * w.rolling_friction * n);
            rate[2] = rate[1] / r;
        } else {
            const double f = mode.slip_sign * friction(y[0], y[1] - r * y[2]) * n;
            rate[1] = along(t, y[0]) - f - drag;
            rate[2] =
                mode.spin_held ? 0.0 : 2.5 / r * (f - mode.roll_sign * w.rolling_friction * n);
        }
    }
    double slip(const double* y) const { return y[1] - s.radius() * y[2]; }

    Mode rolling(double t, const double* y) const {
        const double n = hold(t), pull = along(t, y[0]) - drag_deceleration(w, s, y[1]);
        const double scale = std::abs(s.gravity) * 1e-9;
        Mode mode{Mode::Kind::roll};
        const double speed_floor = 1e-12;
        if (std::abs(y[1]) > speed_floor) {
            mode.roll_sign = std::copysign(1.0, y[1]);
        } else if (std::abs(pull) <= w.rolling_friction * n + scale) {
            // At rest, unless it slides away under the force.
            if (std::abs(pull) <= friction(y[0], 0.0) * n + scale) return {Mode::Kind::rest};
        } else {
            mode.roll_sign = std::copysign(1.0, pull);
        }
        double rate[3];
        rates(mode, t, y, rate);
        const double needed = pull - rate[1];  // friction per mass, against the slip
        if (std::abs(needed) > friction(y[0], 0.0) * n + scale) {
            mode = sliding(t, y, std::copysign(1.0, needed));
        }
        return mode;
    }
    Mode sliding(double t, const double* y, double sign) const {
        Mode mode{Mode::Kind::slide, sign};
        if (w.rolling_friction <= 0.0) return mode;
        if (y[2] != 0.0) {
            mode.roll_sign = std::copysign(1.0, y[2]);
        } else if (friction(y[0], slip(y)) <= w.rolling_friction) {
            mode.spin_held = true;
        } else {
            mode.roll_sign = sign;  // friction turns it this way
        }
        (void)t;
        return mode;
    }
    Mode choose(double t, double* y) const {
        const double u = slip(y), floor = 1e-10 * (std::abs(y[1]) + std::abs(s.radius() * y[2]));
        if (std::abs(u) <= std::max(floor, 1e-13)) {
            y[2] = y[1] / s.radius();
            return rolling(t, y);
        }
        return sliding(t, y, std::copysign(1.0, u));
    }
    // What ends the mode: a quantity that passes zero.
    double event(const Mode& mode, const double* y, int which) const {
        if (mode.kind == Mode::Kind::slide)
            return which == 0 ? slip(y) * mode.slip_sign
                              : (mode.roll_sign == 0.0 ? 1.0 : y[2] * mode.roll_sign);
        if (mode.kind == Mode::Kind::roll)
            return which == 0 && mode.roll_sign != 0.0 ? y[1] * mode.roll_sign : 1.0;
        return 1.0;
    }
};

Point point(double t, const double* y, const double* rate) {
    return {t, 0.0, 0.0, 0.0, y[0], y[1], rate[1], y[2], rate[2]};
}

void settle(const Mode& mode, int which, double radius, double* y) {
    if (mode.kind == Mode::Kind::slide && which == 0) y[2] = y[1] / radius;
    if (mode.kind == Mode::Kind::slide && which == 1) y[2] = 0.0;
    if (mode.kind == Mode::Kind::roll) y[1] = y[2] = 0.0;
}

// One mode with constant accelerations, to its end; returns the time reached.
double by_quadratic(const Motion& m, const Mode& mode, double t, double t_end, double* y) {
    double rate[3];
    m.rates(mode, t, y, rate);
    const double r = m.s.radius();
    double end = t_end;
    int which = -1;
    const auto consider = [&](double value, double change, int event) {
        if (value * change >= 0.0) return;
        const double when = t - value / change;
        if (when < end) end = when, which = event;
    };
    if (mode.kind == Mode::Kind::slide) {
        consider(m.slip(y), rate[1] - r * rate[2], 0);
        if (m.w.rolling_friction > 0.0) consider(y[2], rate[2], 1);
    } else if (mode.kind == Mode::Kind::roll) {
        consider(y[1], rate[1], 0);
    }
    const double h = end - t;
    y[0] += h * (y[1] + 0.5 * h * rate[1]);
    y[1] += h * rate[1];
    y[2] += h * rate[2];
    if (which >= 0) settle(mode, which, r, y);
    return end;
}

// The same by the integrator, with points of the path on the way.
double by_steps(const Motion& m, const Mode& mode, double t, double t_end, double* y, Path& path) {
    const double r = m.s.radius(), v0 = std::abs(y[1]) + r * std::abs(y[2]) + 1e-3;
    Stepper stepper(
        [&](double at, const double* state, double* rate) { m.rates(mode, at, state, rate); },
        {1e-10, 1e-10 * v0, 1e-10 * v0 / r}, 1e-10);
    double h = first_step(m.w, m.s, y[1], 0.02 * (t_end - t)), rate[3];
    const double widest = 0.1 * (t_end - t);
    while (t < t_end) {
        const double t0 = t, y0[3] = {y[0], y[1], y[2]};
        double rate0[3];
        m.rates(mode, t0, y0, rate0);
        h = std::min(h, widest);
        stepper.advance(t, t_end, h, y);
        m.rates(mode, t, y, rate);
        for (int which = 0; which < 2; ++which) {
            if (m.event(mode, y, which) >= 0.0) continue;
            const auto between = [&](double at, double* state) {
                const Quintic x = quintic(at, t0, y0[0], y0[1], rate0[1], t, y[0], y[1], rate[1]);
                const double part = (at - t0) / (t - t0), step = t - t0;
                state[0] = x.value;
                state[1] = x.slope;
                state[2] = y0[2] + step * part * (rate0[2] + 0.5 * part * (rate[2] - rate0[2])) +
                           part * (y[2] - y0[2] - 0.5 * step * (rate0[2] + rate[2]));
            };
            const double end = root(
                [&](double at) {
                    double state[3];
                    between(at, state);
                    return m.event(mode, state, which);
                },
                t0, t);
            double state[3];
            between(end, state);
            settle(mode, which, r, state);
            std::copy(state, state + 3, y);
            return std::max(end, t0 + 1e-12 * (t - t0));
        }
        path.add(point(t, y, rate));
    }
    return t;
}

}  // namespace

Load load_on_plane(const World& w, const Setup& s, double angle, bool wet) {
    const double weight = s.gravity * (1.0 - w.buoyancy * s.fluid_density / s.density);
    const double pull_off = 1.5 * std::numbers::pi * w.work_of_adhesion * s.r_star();
    const double pressed =
        weight * std::cos(angle) + (attraction(w, s, 0.0, wet) + 2.0 * pull_off) / s.mass();
    return {weight * std::sin(angle), std::max(0.0, pressed)};
}

void move_on_ground(const World& w, const Setup& s, const Load& load, double t_end, Path& path) {
    const Motion m{w, s, load, 0.5 * t_end};
    double t = path.back().t;
    double y[3] = {path.back().x, path.back().vx, path.back().spin}, rate[3];
    for (int k = 0; k < 400 && t < t_end; ++k) {
        const Mode mode = m.choose(t, y);
        m.rates(mode, t, y, rate);
        path.add(point(t, y, rate));
        t = m.constant() || mode.kind == Mode::Kind::rest ? by_quadratic(m, mode, t, t_end, y)
                                                          : by_steps(m, mode, t, t_end, y, path);
        m.rates(mode, t, y, rate);
        path.add(point(t, y, rate));
    }
}

std::vector<double> incline(const World& w, const Setup& s) {
    Path path;
    path.add({0.0, 0.0, 0.0, 0.0, 0.0, s.speed, 0.0, s.spin, 0.0});
    const double t_end = std::max(s.at.back(), s.at.front()) / w.time_factor + 1e-9;
    move_on_ground(w, s, load_on_plane(w, s, s.angle + w.tilt_angle, true), t_end, path);
    const std::size_t rows = s.at.size();
    std::vector<double> all(s.size());
    for (std::size_t k = 0; k < rows; ++k) {
        const Point p = path.at(s.at[k] / w.time_factor);
        for (std::size_t c = 0; c < s.recorded.size(); ++c)
            all[c * rows + k] = s.recorded[c] == Channel::s ? p.x : p.spin;
    }
    return all;
}

}  // namespace prove
