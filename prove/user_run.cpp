// SPDX-License-Identifier: MIT
#include "prove/user_run.hpp"

#include "prove/collision.hpp"
#include "prove/motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace prove {
namespace {

struct Grain {
    double z, vz, x, vx, spin;
    double spring = 0.0, last_radius = 0.0;
};

struct Force {
    double z, x, spin;  // accelerations, per mass and per moment of inertia
};

class Program {
  public:
    Program(const World& w, const Setup& s, double gravity)
        : w_(w),
          s_(s),
          gravity_(gravity),
          m_(s.mass()),
          e_star_(s.e_star() * s.user.softening),
          g_star_(s.g_star() * s.user.softening) {}

    void step(Grain& g) {
        const double dt = s_.user.time_step;
        if (s_.user.euler) {
            const Force f = force(g, dt);
            g.z += g.vz * dt, g.x += g.vx * dt;
            kick(g, f, dt);
            return;
        }
        if (!ready_) before_ = force(g, 0.0), ready_ = true;
        kick(g, before_, 0.5 * dt);
        g.z += g.vz * dt, g.x += g.vx * dt;
        before_ = force(g, dt);
        kick(g, before_, 0.5 * dt);
    }

  private:
    static void kick(Grain& g, const Force& f, double dt) {
        g.vz += f.z * dt, g.vx += f.x * dt, g.spin += f.spin * dt;
    }

    Force force(Grain& g, double dt) {
        const double weight = gravity_ * (1.0 - w_.buoyancy * s_.fluid_density / s_.density);
        const double speed = std::hypot(g.vz, g.vx);
        const double drag = speed > 0.0 ? drag_deceleration(w_, s_, speed) / speed : 0.0;
        Force f{-weight - drag * g.vz, -drag * g.vx, 0.0};
        const double overlap = -g.z;
        if (overlap <= 0.0) {
            g.spring = g.last_radius = 0.0;
            return f;
        }
        // e of the speed at touch; held while the contact lasts.
        if (g.last_radius == 0.0)
            damping_ = damping_factor(restitution_at(w_, std::abs(g.vz), 0.0));
        const double a = std::sqrt(s_.r_star() * overlap);
        const double elastic = 4.0 / 3.0 * e_star_ * a * overlap;
        const double normal = elastic - damping_ * std::sqrt(2.0 * e_star_ * a * m_) * g.vz;
        const double along = tangential(g, a, elastic, dt);
        f.z += normal / m_;
        f.x += along / m_;
        f.spin -= 2.5 * along / (m_ * s_.radius());
        return f;
    }

    double tangential(Grain& g, double a, double cap, double dt) {
        const double u = g.vx - s_.radius() * g.spin, limit = friction_at(w_, u) * cap;
        if (!w_.micro_slip) {
            const double stopping = dt > 0.0 ? 2.0 / 7.0 * m_ * std::abs(u) / dt : limit;
            g.last_radius = a;
            return -std::copysign(std::min(limit, stopping), u);
        }
        const double k = 8.0 * g_star_ * w_.stiffness_ratio * a;
        if (g.last_radius > a) g.spring *= a / g.last_radius;
        g.last_radius = a;
        g.spring = std::clamp(g.spring + u * dt, -limit / k, limit / k);
        return -std::clamp(k * g.spring + damping_ * std::sqrt(k * m_) * u, -limit, limit);
    }

    const World& w_;
    const Setup& s_;
    double gravity_, m_, e_star_, g_star_;
    double damping_ = 0.0;
    Force before_{};
    bool ready_ = false;
};

std::vector<double> user_drop(const World& w, const Setup& s) {
    const std::size_t rows = s.at.size();
    std::vector<double> all(s.size());
    Program program(w, s, s.gravity);
    Grain g{s.height, -s.speed, 0.0, s.horizontal_speed, s.spin};
    const double dt = s.user.time_step;
    std::size_t row = 0;
    for (long n = 0; row < rows; ++n) {
        const double t = s.release_time + static_cast<double>(n) * dt;
        const Grain before = g;
        program.step(g);
        for (; row < rows && s.at[row] <= t + dt; ++row) {
            const double share = std::clamp((s.at[row] - t) / dt, 0.0, 1.0);
            for (std::size_t c = 0; c < s.recorded.size(); ++c)
                all[c * rows + row] = s.recorded[c] == Channel::z
                                          ? before.z + share * (g.z - before.z)
                                          : before.x + share * (g.x - before.x);
        }
    }
    return all;
}

std::vector<double> user_impact(const World& w, const Setup& s) {
    const std::size_t rows = s.at.size();
    std::vector<double> all(s.size());
    for (std::size_t k = 0; k < rows; ++k) {
        const double vn = s.speed * std::cos(s.at[k]), vt = s.speed * std::sin(s.at[k]);
        Program program(w, s, 0.0);
        Grain g{-1e-15, -vn, 0.0, vt, s.spin};
        for (long n = 0; n < 200000 && (g.z < 0.0 || n == 0); ++n) program.step(g);
        for (std::size_t c = 0; c < s.recorded.size(); ++c) {
            double& y = all[c * rows + k];
            y = s.recorded[c] == Channel::rebound_angle            ? std::atan2(g.vx, g.vz)
                : s.recorded[c] == Channel::normal_restitution     ? g.vz / vn
                : s.recorded[c] == Channel::tangential_restitution ? g.vx / vt
                                                                   : g.spin;
        }
    }
    return all;
}

std::vector<double> user_incline(const World& w, const Setup& s) {
    const std::size_t rows = s.at.size();
    std::vector<double> all(s.size());
    const double dt = s.user.time_step, r = s.radius();
    const double weight = s.gravity * (1.0 - w.buoyancy * s.fluid_density / s.density);
    const double along = weight * std::sin(s.angle), press = weight * std::cos(s.angle);
    double x = 0.0, v = s.speed, spin = s.spin;
    std::size_t row = 0;
    for (long n = 0; row < rows; ++n) {
        const double t = static_cast<double>(n) * dt, x0 = x, spin0 = spin;
        const double u = v - r * spin;
        // Friction that at most stops the slip within the step, and holds a rolling grain.
        const double held = 2.0 / 7.0 * (u / dt + along);
        const double f = std::clamp(held, -friction_at(w, u) * press, friction_at(w, u) * press);
        const double turn = std::clamp(r * spin / dt, -2.5 * w.rolling_friction * press,
                                       2.5 * w.rolling_friction * press);
        const double a = along - f - drag_deceleration(w, s, v);
        const double b = (2.5 * f - turn) / r;
        x += v * dt + (s.user.euler ? 0.0 : 0.5 * a * dt * dt);
        v += a * dt;
        spin += b * dt;
        for (; row < rows && s.at[row] <= t + dt; ++row) {
            const double share = std::clamp((s.at[row] - t) / dt, 0.0, 1.0);
            for (std::size_t c = 0; c < s.recorded.size(); ++c)
                all[c * rows + row] = s.recorded[c] == Channel::s ? x0 + share * (x - x0)
                                                                  : spin0 + share * (spin - spin0);
        }
    }
    return all;
}

std::vector<double> user_curve(const World& w, const Setup& s) {
    Setup soft = s;
    soft.user = {};
    soft.youngs_modulus *= s.user.softening;
    soft.plate_youngs_modulus *= s.user.softening;
    return predict(w, soft);
}

std::vector<Setup> run_by(const std::vector<Setup>& setups, const UserRun& run) {
    std::vector<Setup> all = setups;
    for (Setup& s : all) s.user = run;
    return all;
}

double shortest_contact(const Skeleton& sk) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Setup& s : sk.stated) {
        const double v = s.rig == Rig::drop ? std::sqrt(2.0 * s.gravity * s.height) : s.speed;
        if (v > 0.0) shortest = std::min(shortest, hertz_duration(s, v));
    }
    return std::isfinite(shortest) ? shortest : 1e-5;
}

UserRun run_at(const Skeleton& sk, UserRun run, double bad) {
    const double contact = shortest_contact(sk);
    const Setup& s = sk.stated.front();
    switch (sk.rig) {
        case Rig::pull_off:
            run.time_step = rounded(contact / 30.0, 1);
            run.softening = rounded(std::exp(-6.0 * bad), 3);
            break;
        case Rig::incline:
            run.time_step = rounded(4.0 * bad * (s.at.back() - s.at.front()) / 50.0, 2);
            break;
        case Rig::impact:
            run.time_step = rounded(contact * std::exp(-4.0 + 4.0 * bad), 2);
            break;
        case Rig::drop:
            // A contact of ten steps; t_c goes as E^(-2/5).
            run.time_step = rounded(0.1 * bad * s.at.back(), 2);
            run.softening =
                rounded(std::min(1.0, std::pow(10.0 * run.time_step / contact, -2.5)), 2);
    }
    return run;
}

}  // namespace

double hertz_duration(const Setup& s, double v) {
    const double k = 4.0 / 3.0 * s.e_star() * std::sqrt(s.r_star());
    return 3.218 * std::pow(s.mass() * v * v / k, 0.4) / v;
}

std::vector<double> user_run(const World& w, const Setup& s) {
    switch (s.rig) {
        case Rig::drop:
            return user_drop(w, s);
        case Rig::incline:
            return user_incline(w, s);
        case Rig::impact:
            return user_impact(w, s);
        case Rig::pull_off:
            break;
    }
    return user_curve(w, s);
}

Mismatch user_mismatch(const Skeleton& sk, const UserRun& run) {
    Skeleton by_user = sk;
    by_user.stated = run_by(sk.stated, run);
    return mismatch(by_user, sk.world);
}

std::optional<UserRun> draw_user_run(Skeleton& sk, double target, Dice& dice) {
    UserRun run{.used = true};
    run.euler = sk.rig == Rig::incline || dice.chance(0.5);
    run.hands_over = dice.chance(0.5);
    const auto idr = [&](double bad) { return user_mismatch(sk, run_at(sk, run, bad)).idr; };
    // From fine to coarse: too coarse a run is no run any more.
    double fine = 0.0;
    for (double bad = sk.rig == Rig::drop ? 5e-4 : 0.02; bad <= 1.0; bad *= 1.6) {
        double here = idr(bad);
        if (!std::isfinite(here)) return std::nullopt;
        if (here < 0.7 * target) {
            fine = bad;
            continue;
        }
        double coarse = bad;
        for (int k = 0; k < 5 && here > 1.4 * target && fine > 0.0; ++k) {
            const double middle = std::sqrt(fine * coarse);
            const double there = idr(middle);
            if (there < 0.7 * target)
                fine = middle;
            else
                coarse = middle, here = there;
        }
        if (here > 2.0 * target) return std::nullopt;
        return run_at(sk, run, coarse);
    }
    return std::nullopt;
}

UserRun harmless_run(const Skeleton& sk) {
    UserRun run{.used = true};
    // A step of a sixtieth of the contact, which is common, would be seen by instruments as good as some here.
    run.time_step = rounded(shortest_contact(sk) / 1000.0, 1);
    return run;
}

Eigen::VectorXd start_run(const Skeleton& sk, const UserRun& run) {
    World w = sk.world;
    for (const Stated& p : sk.parameters) w.*p.place = p.start;
    return predict(w, run_by(sk.stated, run));
}

std::string numerics_text(const UserRun& run) {
    return fmt::format(
        "{{\"time_step\": \"{:.4g} us\", \"integrator\": \"{}\", \"youngs_modulus_factor\": "
        "{:.4g}}}",
        run.time_step / 1e-6, run.euler ? "euler" : "verlet", run.softening);
}

}  // namespace prove
