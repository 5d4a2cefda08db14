// SPDX-License-Identifier: MIT
#include "prove/collision.hpp"

#include "prove/path.hpp"
#include "prove/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prove {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int course_steps = 240;

struct State {
    double x, v;
};

State hertz_rates(const State& y, double f) {
    if (y.x <= 0.0) return {y.v, 0.0};
    const double root_x = std::sqrt(y.x);
    return {y.v, -y.x * root_x - f * std::sqrt(1.5) * std::sqrt(root_x) * y.v};
}

State runge_kutta(const State& y, double h, double f) {
    const State a = hertz_rates(y, f);
    const State b = hertz_rates({y.x + 0.5 * h * a.x, y.v + 0.5 * h * a.v}, f);
    const State c = hertz_rates({y.x + 0.5 * h * b.x, y.v + 0.5 * h * b.v}, f);
    const State d = hertz_rates({y.x + h * c.x, y.v + h * c.v}, f);
    return {y.x + h / 6.0 * (a.x + 2.0 * b.x + 2.0 * c.x + d.x),
            y.v + h / 6.0 * (a.v + 2.0 * b.v + 2.0 * c.v + d.v)};
}

// In units of L/v, from touch to zero overlap.
double hertz_duration_for(double f) {
    // A weak rebound takes long to leave: steps grow with the duration.
    const double h = 0.04 * (1.0 + 0.6 * f);
    State y{0.0, 1.0};
    double t = 0.0;
    for (int k = 0; k < 4000; ++k, t += h) {
        const State next = runge_kutta(y, h, f);
        if (next.x <= 0.0 && y.v < 0.0)
            return t + root([&](double part) { return runge_kutta(y, part, f).x; }, 1e-3 * h, h);
        y = next;
    }
    return t;
}

double clipped(double value, double limit) { return std::clamp(value, -limit, limit); }

// Impulse of the force that friction multiplies, N s. Without adhesion it is what turns v into -e v: the dashpot's own impulse,
// over x^0.25 x', comes to nothing.
double cap_impulse(const World& w, const Setup& s, const NormalContact& c) {
    if (w.work_of_adhesion <= 0.0) return s.mass() * (c.nodes.front().rate + c.rebound);
    double sum = 0.0;
    for (std::size_t k = 1; k < c.nodes.size(); ++k)
        sum += 0.5 * (c.nodes[k].cap + c.nodes[k - 1].cap) * (c.nodes[k].t - c.nodes[k - 1].t);
    return sum;
}

// Rigid friction over the impulse p per mass: du/dp = -7/2 mu sign(u) + 5/2 mu_r sign(spin), exact between events where mu is
// constant, by midpoints where it depends on the slip.
Slip rigid(const World& w, const Setup& s, double impulse, Slip y) {
    const double r = s.radius(), total = impulse / s.mass();
    const int parts = w.friction_velocity > 0.0 || w.rolling_friction > 0.0 ? 120 : 1;
    double done = 0.0;
    bool sticks = false;
    while (done < total * (1.0 - 1e-12)) {
        double h = std::min(total / parts, total - done);
        const double u = y.velocity - r * y.spin;
        const double roll = y.spin == 0.0 ? 0.0 : std::copysign(w.rolling_friction, y.spin);
        if (sticks || u == 0.0) {
            const double change = -5.0 / 7.0 * roll * h;
            if (std::abs(change) >= std::abs(y.velocity)) return {0.0, 0.0};
            y = {y.velocity + change, (y.velocity + change) / r};
            sticks = true;
        } else {
            const double sign = std::copysign(1.0, u);
            const auto rate = [&](double slip) {
                return -3.5 * friction_at(w, slip) * sign + 2.5 * roll;
            };
            const double mid = u + 0.5 * h * rate(u);
            const double mean = mid * u > 0.0 ? rate(mid) : rate(0.5 * u);
            double mu = friction_at(w, mid * u > 0.0 ? mid : 0.5 * u);
            if (u * (u + h * mean) <= 0.0) {
                h = -u / mean;
                sticks = true;
            }
            y.velocity -= mu * sign * h;
            double spin = y.spin + 2.5 / r * (mu * sign - roll) * h;
            if (sticks) spin = y.velocity / r;
            y.spin = spin;
        }
        done += h;
    }
    return y;
}

// Spring, slider and dashpot over the nodes of the contact, midpoint rule.
Slip with_micro_slip(const World& w, const Setup& s, const NormalContact& c, Slip y) {
    const double m = s.mass(), r = s.radius();
    const double stiffness = 8.0 * s.g_star() * w.stiffness_ratio;
    double spring = 0.0;
    for (std::size_t k = 1; k < c.nodes.size(); ++k) {
        const ContactNode &a = c.nodes[k - 1], &b = c.nodes[k];
        const double h = b.t - a.t;
        double radius = 0.5 * (a.radius + b.radius), cap = 0.5 * (a.cap + b.cap);
        if (w.work_of_adhesion <= 0.0) {
            // Hertz at the middle of the step, by the cubic through both ends.
            const double d =
                std::max(0.0, 0.5 * (a.overlap + b.overlap) + 0.125 * h * (a.rate - b.rate));
            radius = std::sqrt(s.r_star() * d);
            cap = 4.0 / 3.0 * s.e_star() * radius * d;
        }
        const double u = y.velocity - r * y.spin;
        const double mu = friction_at(w, u), limit = mu * cap;
        const double k_t = stiffness * radius, c_t = c.damping_factor * std::sqrt(k_t * m);
        const double shrunk = a.radius > 0.0 ? std::min(1.0, radius / a.radius) : 1.0;
        const auto force = [&](double slip) {
            const double trial =
                k_t > 0.0 ? clipped(spring * shrunk + 0.5 * h * slip, limit / k_t) : 0.0;
            return clipped(k_t * trial + c_t * slip, limit);
        };
        // Half a step ahead, then the force there.
        const double ahead = u - 0.5 * h * 3.5 / m * force(u);
        const double f = force(ahead);
        const double roll =
            y.spin == 0.0 ? 0.0 : std::copysign(2.5 * w.rolling_friction * cap / (m * r), y.spin);
        y.velocity -= f * h / m;
        double spin = y.spin + 2.5 * f * h / (m * r) - roll * h;
        if (roll != 0.0 && spin * y.spin < 0.0 && std::abs(2.5 * f / (m * r)) < std::abs(roll))
            spin = 0.0;
        y.spin = spin;
        const double u1 = y.velocity - r * y.spin;
        const double end = b.radius > 0.0 ? mu * b.cap / (stiffness * b.radius) : 0.0;
        const double shrunk_all = a.radius > 0.0 ? std::min(1.0, b.radius / a.radius) : 1.0;
        spring = clipped(spring * shrunk_all + 0.5 * h * (u + u1), end);
    }
    return y;
}

ContactNode node_at(const Jkr& law, double t, double overlap, double rate) {
    const double a = law.radius(std::max(overlap, law.fold()));
    return {t, overlap, rate, a, std::max(0.0, law.force(a) + 2.0 * law.pull_off_force())};
}

}  // namespace

double damping_factor(double restitution) {
    const double e = std::max(restitution, 1e-9), log_e = std::log(e);
    return 2.0 * std::sqrt(5.0 / 6.0) * -log_e / std::sqrt(log_e * log_e + pi * pi);
}

double restitution_at(const World& w, double v, double angle) {
    double e = w.restitution;
    if (w.loss_coefficient >= 0.0) e = std::max(0.0, 1.0 - w.loss_coefficient * std::pow(v, 0.2));
    if (w.yield_velocity > 0.0 && v > w.yield_velocity) e *= std::pow(w.yield_velocity / v, 0.25);
    if (w.kind == Outside::angle_restitution) {
        const double sine = std::sin(angle);
        e *= std::clamp(1.0 - w.outside * sine * sine, 0.0, 1.0 / std::max(e, 1e-9));
    }
    return e;
}

double friction_at(const World& w, double slip) {
    if (w.friction_velocity <= 0.0) return w.sliding_friction;
    return w.dynamic_friction + (w.sliding_friction - w.dynamic_friction) *
                                    std::exp(-std::abs(slip) / w.friction_velocity);
}

std::vector<ContactNode> hertz_course(double restitution) {
    const double f = damping_factor(restitution), duration = hertz_duration_for(f);
    std::vector<ContactNode> nodes{{0.0, 0.0, 1.0, 0.0, 0.0}};
    State y{0.0, 1.0};
    double t = 0.0;
    // Closer at both ends, where spring and dashpot come and go with infinite slope.
    for (int k = 1; k < course_steps; ++k) {
        const double at = 0.5 * duration * (1.0 - std::cos(pi * k / course_steps));
        y = runge_kutta(y, at - t, f);
        t = at;
        const double x = std::max(y.x, 0.0);
        nodes.push_back({t, y.x, y.v, std::sqrt(x), x * std::sqrt(x)});
    }
    nodes.push_back({duration, 0.0, -restitution, 0.0, 0.0});
    return nodes;
}

NormalContact scaled_course(const Setup& s, const std::vector<ContactNode>& course, double v,
                            double restitution) {
    NormalContact c;
    const double stiffness = 4.0 / 3.0 * s.e_star() * std::sqrt(s.r_star());
    const double length = std::pow(s.mass() * v * v / stiffness, 0.4), time = length / v;
    const double force = stiffness * length * std::sqrt(length);
    const double radius = std::sqrt(s.r_star() * length);
    c.nodes.reserve(course.size());
    for (const ContactNode& n : course)
        c.nodes.push_back(
            {n.t * time, n.overlap * length, n.rate * v, n.radius * radius, n.cap * force});
    c.duration = course.back().t * time;
    c.rebound = restitution * v;
    c.damping_factor = damping_factor(restitution);
    return c;
}

NormalContact adhesive_contact(const World& w, const Setup& s, double v, double e) {
    const Jkr law{s.e_star(), s.r_star(), w.work_of_adhesion};
    const double m = s.mass(), end = law.fold();
    NormalContact c;
    c.damping_factor = damping_factor(e);
    const double stiffness = 4.0 / 3.0 * s.e_star() * std::sqrt(s.r_star());
    const double length = std::max(std::pow(m * v * v / stiffness, 0.4), -end);
    const double time = std::min(length / v, std::sqrt(m / (stiffness * std::sqrt(length))));
    const auto rates = [&](double, const double* y, double* rate) {
        const double a = law.radius(std::max(y[0], end));
        const double dashpot = c.damping_factor * std::sqrt(2.0 * s.e_star() * a * m);
        rate[0] = y[1];
        rate[1] = -(law.force(a) + dashpot * y[1]) / m;
    };
    Stepper stepper(rates, {1e-8 * length, 1e-8 * v}, 1e-7);
    double t = 0.0, h = 0.01 * time, y[2] = {0.0, v}, before[2], rate0[2], rate[2];
    c.nodes.push_back(node_at(law, 0.0, 0.0, v));
    bool outward = false;
    for (int k = 0; k < 4000 && !c.stuck; ++k) {
        const double t0 = t;
        before[0] = y[0], before[1] = y[1];
        rates(t0, before, rate0);
        h = std::min(h, 0.08 * time);
        stepper.advance(t, t + time, h, y);
        if (y[0] <= end && y[1] < 0.0) {
            rates(t, y, rate);
            const auto way = [&](double at) {
                return quintic(at, t0, before[0], rate0[0], rate0[1], t, y[0], rate[0], rate[1]);
            };
            t = root([&](double at) { return way(at).value - end; }, t0, t);
            c.rebound = -way(t).slope;
            y[0] = end, y[1] = -c.rebound;
            break;
        }
        c.nodes.push_back(node_at(law, t, y[0], y[1]));
        if (y[1] < 0.0) outward = true;
        c.stuck = outward && y[1] > 0.0;
    }
    c.stuck = c.stuck || c.rebound <= 0.0;
    c.nodes.push_back(node_at(law, t, y[0], y[1]));
    c.duration = t;
    return c;
}

Slip after_contact(const World& w, const Setup& s, const NormalContact& c, Slip before) {
    if (w.sliding_friction <= 0.0 && w.rolling_friction <= 0.0) return before;
    return w.micro_slip ? with_micro_slip(w, s, c, before)
                        : rigid(w, s, cap_impulse(w, s, c), before);
}

// With L^3 = pi w R^2/(2 E*) and s = sqrt(a/L): overlap R/L^2 = s^4 - 2 s. Fold at s^3 = 1/2.
double Jkr::fold() const {
    const double cubed = pi * w * r_star * r_star / (2.0 * e_star);
    const double s = std::cbrt(0.5);
    return (s * s * s * s - 2.0 * s) * std::cbrt(cubed * cubed) / r_star;
}

double Jkr::radius(double overlap) const {
    const double length = std::cbrt(pi * w * r_star * r_star / (2.0 * e_star));
    const double d = overlap * r_star / (length * length), low = std::cbrt(0.5);
    // Ferrari: s^4 - 2 s - d = 0. y^3 + 4 d y - 4 = 0 has one root y > 0 that matters; the largest s is
    // (sqrt(y) + sqrt(-y + 4/sqrt(y)))/2.
    double y;
    const double p = 4.0 * d / 3.0, disc = 4.0 + p * p * p;
    if (disc >= 0.0) {
        const double big = std::cbrt(2.0 + std::sqrt(disc));
        y = big - p / big;
    } else {
        const double angle = std::acos(std::clamp(2.0 / std::sqrt(-p * p * p), -1.0, 1.0)) / 3.0;
        y = 2.0 * std::sqrt(-p) * std::cos(angle);
    }
    const double root_y = std::sqrt(std::max(y, 0.0));
    double s = 0.5 * (root_y + std::sqrt(std::max(0.0, -y + 4.0 / root_y)));
    // Large overlaps lose digits in y: one or two steps of Newton mend that.
    for (int k = 0; k < 2; ++k) {
        const double slope = 4.0 * s * s * s - 2.0;
        if (slope > 0.1) s -= (s * s * s * s - 2.0 * s - d) / slope;
    }
    s = std::max(s, low);
    return s * s * length;
}

double Jkr::force(double a) const {
    const double a3 = a * a * a;
    return 4.0 * e_star * a3 / (3.0 * r_star) - std::sqrt(8.0 * pi * w * e_star * a3);
}

double Jkr::pull_off_force() const { return 1.5 * pi * w * r_star; }

}  // namespace prove
