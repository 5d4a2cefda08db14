// SPDX-License-Identifier: MIT
#include "rigs/one_contact.hpp"

#include "contact/damping_tsuji1992.hpp"
#include "rigs/ode.hpp"
#include "rigs/on_plate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rigs {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t longest_contact = 5000;  // steps; by then it creeps towards rest
constexpr double least_restitution = 1e-6;  // below it a contact lasts ever longer; the grain stays
constexpr std::size_t intervals = 256;  // doubled, friction's impulse moves by less than 2e-4 of it

// Integral of sin^(-1/5) over each interval times 4/5 e^(l f/5): the time from one phase to another.
double hat_time(double from, double to, double loss) {
    // Gauss's two points in the variable u = f^(4/5) near 0 and (pi - f)^(4/5) near pi, in which the integrand is smooth.
    const bool early = from + to < pi;
    const double a = early ? std::pow(from, 0.8) : std::pow(pi - to, 0.8);
    const double b = early ? std::pow(to, 0.8) : std::pow(pi - from, 0.8);
    double sum = 0.0;
    for (const double x : {-0.57735026918962576, 0.57735026918962576}) {
        const double u = 0.5 * (a + b) + 0.5 * (b - a) * x, f = std::pow(u, 1.25);
        const double phase = early ? f : pi - f;
        sum += std::pow(std::sin(f) / f, -0.2) * std::exp(0.2 * loss * phase);
    }
    return 0.5 * (b - a) * sum;  // 4/5 df = f^(1/5) du
}

// Powers of the sine of the phase at the nodes. They crowd towards the ends as time does: f ~ u^(5/4).
struct Phases {
    std::array<double, intervals + 1> phase, root, time,
        middle;  // root: sin^(1/5); time, middle: of the interval that ends here
    Phases() {
        const auto at = [](double u) {
            const double a = std::pow(u, 1.25), b = std::pow(1.0 - u, 1.25);
            return pi * a / (a + b);
        };
        for (std::size_t k = 0; k <= intervals; ++k) {
            phase[k] = at(static_cast<double>(k) / intervals);
            root[k] = k == 0 || k == intervals ? 0.0 : std::pow(std::sin(phase[k]), 0.2);
            time[k] = k == 0 ? 0.0 : hat_time(phase[k - 1], phase[k], 0.0);
            middle[k] = k == 0 ? 0.0 : 0.5 * (phase[k - 1] + phase[k]);
        }
    }
};

const Phases& phases() {
    static const Phases table;
    return table;
}

// The same over the whole contact: e^(pi l/10) times the integral of 4/5 cos^(-1/5)(x) cosh(l x/5) from -pi/2 to pi/2, by its
// series in l, whose moments are taken once.
double whole_time(double loss) {
    static const std::array<double, 12> moments = [] {
        std::array<double, 12> m{};
        constexpr int pieces = 400;
        for (int i = 0; i < pieces; ++i) {
            for (const double g : {-0.57735026918962576, 0.57735026918962576}) {
                const double top = std::pow(0.5 * pi, 0.8), width = top / pieces;
                const double u = (i + 0.5 + 0.5 * g) * width, f = std::pow(u, 1.25);
                const double x = 0.5 * pi - f;
                double term = width * std::pow(std::sin(f) / f, -0.2);
                for (std::size_t k = 0; k < m.size(); ++k) {
                    m[k] += term;
                    term *= x * x / static_cast<double>((2 * k + 1) * (2 * k + 2));
                }
            }
        }
        return m;
    }();
    double sum = 0.0, power = 1.0;
    for (const double moment : moments) sum += power * moment, power *= 0.04 * loss * loss;
    return std::exp(0.1 * pi * loss) * sum;
}

struct NormalMotion {
    contact::Jkr law;
    double r_star, length, mass, dashpot,
        pull;  // dashpot: 2 sqrt(5/6) beta; pull: N into the plate
    Unknowns<2> operator()(double, const Unknowns<2>& y) const {
        const contact::NormalState at = law.at(r_star, length, y[0]);
        const double c =
            contact::DampingTsuji1992{dashpot}.normal(law.e_star, at.contact_radius, mass);
        return {y[1], (pull - at.force - c * y[1]) / mass};
    }
};

}  // namespace

void OneContact::Profile::resize(std::size_t nodes) {
    for (auto* list : {&dt, &cap, &stiffness, &shrunk, &gain, &yields, &pulls, &reach})
        list->assign(nodes, 0.0);
}

void OneContact::Profile::set_spring(std::size_t k, double of, double dashpot, double left) {
    const double half = 0.5 * dt[k];
    stiffness[k] = of, shrunk[k] = left;
    gain[k] = of * half + dashpot;
    yields[k] = 1.0 / (1.0 + 3.5 * half * gain[k]);
    pulls[k] = 3.5 * half * yields[k] * of * left;
    reach[k] = of > 0.0 ? cap[k] / of : 0.0;
}

OneContact::OneContact(const OneGrain& g)
    : grain_(g), weight_(std::abs(g.gravity) * g.resting_overlap(g.mass * std::abs(g.gravity))) {}

Rebound OneContact::touch(const Approach& in) {
    Rebound out{0.0, in.v, in.w, 0.0, 0.0, false};
    times_.clear(), overlaps_.clear();
    if (!(in.normal > 0.0)) return out;
    if (grain_.work_of_adhesion > 0.0)
        tear_off(in, out);
    else
        drive_apart(in, out);
    if (const auto& m = grain_.missing_restitution) {
        const double at =
            m->variable == "impact_angle" ? std::atan2(std::abs(in.v), in.normal) : in.normal;
        out.normal *= std::max(0.0, 1.0 + straight_between(m->knots, m->shares, at));
    }
    return out;
}

void OneContact::drive_apart(const Approach& in, Rebound& out) {
    const OneGrain& g = grain_;
    const double e = g.restitution.at(in.normal);
    const double safe = std::max(e, least_restitution);
    loss_ = -std::log(safe) / pi;
    // D^(5/4) = 5 v/(4 omega), omega^2 = omega_0^2/(1 + l^2), omega_0^2 = 5/4 of 4/3 E* sqrt(R)/m.
    const double omega =
        std::sqrt(5.0 / 3.0 * g.e_star * std::sqrt(g.radius) / g.mass / (1.0 + loss_ * loss_));
    depth_ = std::pow(1.25 * in.normal / omega, 0.8), speed_ = in.normal;
    // A touch so slow that the weight counts is no impact any more, and takes no time of its own.
    stretch_ = in.normal * in.normal / (in.normal * in.normal + weight_);
    out.normal = e * in.normal;
    out.duration = stretch_ * depth_ / speed_ * whole_time(loss_);
    out.stays = e < least_restitution;
    // A grain that grips keeps a slip of round-off.
    const bool slides = std::abs(in.v - in.w) > 1e-10 * (in.normal + std::abs(in.v)) &&
                        g.friction.at_rest + g.friction.dynamic > 0.0;
    const bool resists = g.rolling_friction > 0.0 && in.w != 0.0;
    if (!slides && !resists) return;
    if (!g.compliant) return slide_stiffly((1.0 + e) * in.normal, out);
    sample_impact(safe);
    slide_and_stick(in.normal, out);
}

// Forces in units of m v^2/D, stiffness of m v^2/D^2, time of D/v: 4/3 E* sqrt(R) d^(3/2) is 5/4 (1 + l^2) there.
void OneContact::sample_impact(double e) {
    if (sampled_ && *sampled_ == e) return;
    sampled_ = e;
    const OneGrain& g = grain_;
    const Phases& table = phases();
    const double elastic = 1.25 * (1.0 + loss_ * loss_);
    const double spring = 6.0 * g.stiffness_ratio * g.g_star / g.e_star * elastic;
    const double factor = contact::DampingTsuji1992::from(e).factor;
    Profile& p = profile_;
    p.resize(intervals + 1);
    double before = 0.0;
    for (std::size_t k = 0; k <= intervals; ++k) {
        const double root = table.root[k] * std::exp(-0.2 * loss_ * table.phase[k]);  // d^(1/4)
        const double a = root * root;
        p.cap[k] = elastic * a * a * a;
        p.dt[k] = table.time[k] * std::exp(0.2 * loss_ * table.middle[k]);
        p.set_spring(k, spring * a, factor * std::sqrt(spring) * root,
                     before > 0.0 ? std::min(1.0, a / before) : 1.0);
        before = a;
    }
    p.impulse = 0.0;
    for (std::size_t k = 1; k < p.dt.size(); ++k)
        p.impulse += 0.5 * p.dt[k] * (p.cap[k] + p.cap[k - 1]);
}

void OneContact::slide_stiffly(double impulse, Rebound& out) const {
    OnPlate x{0.0, 0.0, out.v, out.w};
    carry(x, impulse,
          {.press = 1.0, .friction = grain_.friction, .rolling_friction = grain_.rolling_friction});
    out.v = x.v, out.w = x.w;
}

// Spring and dashpot by the trapezoidal rule, cut at the friction of each node; the cut force solves the same equation, because
// it rises with the slip. See contact/mindlin.hpp for the law.
void OneContact::slide_and_stick(double unit, Rebound& out) const {
    const Profile& p = profile_;
    const Friction& friction = grain_.friction;
    const double mu_r = grain_.rolling_friction;
    const bool depends = friction.depends();
    double v = out.v / unit, w = out.w / unit, spring = 0.0, force = 0.0, mu = friction.at_rest;
    // Slip that friction cannot stop in the whole contact is never caught by the spring: a contact's radius shrinks more slowly
    // than its load.
    if (!depends && mu_r == 0.0 && std::abs(v - w) > 3.5 * mu * p.impulse) {
        const double impulse = v > w ? mu * p.impulse : -mu * p.impulse;
        out.v = (v - impulse) * unit, out.w = (w + 2.5 * impulse) * unit;
        return;
    }
    double slip = v - w;
    for (std::size_t k = 1; k < p.dt.size(); ++k) {
        const double half = 0.5 * p.dt[k], q = 3.5 * half;
        if (depends) mu = friction.at(std::abs(slip) * unit);
        const double limit = mu * p.cap[k], reach = mu * p.reach[k];
        const double moved = spring + half * slip;  // and what has slipped so far
        const double kept = p.shrunk[k] * moved;
        double after = (slip - q * force) * p.yields[k] - p.pulls[k] * moved;
        double next = p.stiffness[k] * kept + p.gain[k] * after;
        if (std::abs(next) > limit) {
            next = next > 0.0 ? limit : -limit;
            after = slip - q * (force + next);
        }
        spring = std::clamp(kept + half * after, -reach, reach);
        const double impulse = half * (force + next);
        v -= impulse, w += 2.5 * impulse, force = next;
        slip = after;
        if (mu_r > 0.0) {
            const double brake = 2.5 * mu_r * half * (p.cap[k] + p.cap[k - 1]);
            w = w > 0.0 ? std::max(0.0, w - brake) : std::min(0.0, w + brake);
            slip = v - w;
        }
    }
    out.v = v * unit, out.w = w * unit;
}

void OneContact::tear_off(const Approach& in, Rebound& out) {
    const OneGrain& g = grain_;
    const contact::Jkr law = g.jkr();
    const double length = law.length_scale(g.r_star), fold = law.tear_off_overlap(g.r_star, length);
    const double e = std::max(g.restitution.at(in.normal), least_restitution);
    const double factor = contact::DampingTsuji1992::from(e).factor;
    const double pull = g.mass * g.gravity * std::cos(g.tilt_angle) + g.attraction.in_contact();
    const double stiff =
        std::pow(g.mass * g.mass / (g.radius * g.e_star * g.e_star * in.normal), 0.2);
    const double deep = in.normal * stiff - fold;
    Ode<2, NormalMotion> ode({law, g.r_star, length, g.mass, factor, pull}, 0.0, {0.0, in.normal},
                             {1e-10 * deep, 1e-9 * in.normal}, 0.01 * stiff);
    const double pull_off = g.pull_off_force();
    std::vector<OdeStep<2>> steps;
    double end = 0.0;
    for (bool turned = false;;) {
        const OdeStep<2> step = ode.step(10.0 * stiff);
        const Unknowns<2> y = ode.y();
        steps.push_back(step);
        if (y[0] < fold) {
            const double share = crossing([&](double s) { return step.at(s)[0] - fold; }, 0.0, 1.0);
            end = step.t + share * step.h, out.normal = -step.at(share)[1], out.gap = -fold;
            break;
        }
        if (turned && y[1] > 0.0) {
            const double share = crossing([&](double s) { return step.at(s)[1]; }, 0.0, 1.0);
            end = step.t + share * step.h, out.normal = 0.0, out.stays = true;
            break;
        }
        turned = turned || y[1] < 0.0;
        if (steps.size() < longest_contact && std::isfinite(y[0] + y[1])) continue;
        end = step.t + step.h, out.normal = 0.0, out.stays = true;
        break;
    }
    out.duration = end;
    Profile& p = profile_;
    sampled_.reset();
    p.resize(intervals + 1);
    times_.resize(intervals + 1), overlaps_.resize(intervals + 1);
    p.impulse = 0.0;
    double before = 0.0;
    std::size_t at_step = 0;
    for (std::size_t k = 0; k <= intervals; ++k) {
        const double t = end * static_cast<double>(k) / intervals;
        while (at_step + 1 < steps.size() && t > steps[at_step].t + steps[at_step].h) ++at_step;
        const OdeStep<2>& step = steps[at_step];
        times_[k] = t, overlaps_[k] = step.at(std::min(1.0, (t - step.t) / step.h))[0];
        const contact::NormalState state = law.at(g.r_star, length, overlaps_[k]);
        const double stiffness = g.stiffness_ratio * 8.0 * g.g_star * state.contact_radius / g.mass;
        p.dt[k] = k == 0 ? 0.0 : end / intervals;
        p.cap[k] = std::max(0.0, state.force + 2.0 * pull_off) / g.mass;
        p.set_spring(k, stiffness, factor * std::sqrt(stiffness),
                     before > 0.0 ? std::min(1.0, state.contact_radius / before) : 1.0);
        before = state.contact_radius;
        if (k > 0) p.impulse += 0.5 * p.dt[k] * (p.cap[k] + p.cap[k - 1]);
    }
    if (in.v == in.w && (g.rolling_friction == 0.0 || in.w == 0.0)) return;
    if (g.compliant)
        slide_and_stick(1.0, out);
    else
        slide_stiffly(p.impulse, out);
}

double OneContact::height(double since) const {
    if (!times_.empty()) {
        const double share =
            std::clamp(since / std::max(times_.back(), 1e-300), 0.0, 1.0) * intervals;
        const std::size_t k = std::min<std::size_t>(static_cast<std::size_t>(share), intervals - 1);
        const double part = share - static_cast<double>(k);
        return -(overlaps_[k] + part * (overlaps_[k + 1] - overlaps_[k]));
    }
    if (depth_ <= 0.0 || stretch_ <= 0.0) return 0.0;
    const double wanted = since / stretch_ * speed_ / depth_;
    const Phases& table = phases();
    double t = 0.0;
    for (std::size_t k = 1; k <= intervals; ++k) {
        const double dt = hat_time(table.phase[k - 1], table.phase[k], loss_);
        if (t + dt >= wanted || k == intervals) {
            const double part = std::clamp((wanted - t) / dt, 0.0, 1.0);
            const double f = table.phase[k - 1] + part * (table.phase[k] - table.phase[k - 1]);
            return -stretch_ * depth_ *
                   std::pow(std::exp(-loss_ * f) * std::max(0.0, std::sin(f)), 0.8);
        }
        t += dt;
    }
    return 0.0;
}

}  // namespace rigs
