// SPDX-License-Identifier: MIT
#include "rigs/stepped_drop.hpp"

#include "contact/coulomb.hpp"
#include "contact/damping_tsuji1992.hpp"
#include "contact/effective.hpp"
#include "contact/friction_cap.hpp"
#include "contact/hertz.hpp"
#include "contact/mindlin.hpp"
#include "contact/rolling_epsd.hpp"
#include "rigs/flight.hpp"

#include <algorithm>
#include <cmath>

namespace rigs {
namespace {

using contact::Vec3;

constexpr Vec3 down{0.0, 0.0, -1.0};  // from the grain (i) to the plate (j)
constexpr int patience =
    400;  // steps of calm until the grain counts as settled; a turning point is calm for fewer

// The contact as it was left by the last step.
struct History {
    bool touches = false;
    double radius = 0.0;  // m
    Vec3 spring, rolling;
    double damping = 0.0;  // 2 sqrt(5/6) beta, of the impact that began it
};

struct Rates {
    double ax, az, aw;
};

Rates contact_rates(const OneGrain& g, const DropState& s, double overlap, double dt, History& h) {
    const contact::Hertz hertz{g.e_star};
    const contact::Jkr jkr = g.jkr();
    const bool sticky = g.work_of_adhesion > 0.0;
    const double length = sticky ? jkr.length_scale(g.r_star) : 0.0;
    const contact::NormalState n =
        sticky ? jkr.at(g.r_star, length, overlap) : hertz.at(g.r_star, length, overlap);
    const double vn = -s.vz + g.vibration.velocity(s.t);
    const double pull_off = g.pull_off_force();
    const double damped =
        contact::DampingTsuji1992{h.damping}.normal(g.e_star, n.contact_radius, g.mass) * vn;
    const double cap = contact::cap_force(contact::FrictionCap::elastic_plus_two_pull_off, n.force,
                                          damped, pull_off, 0.0);
    const double slip = s.vx - s.w;
    const double mu = g.friction.at(std::abs(slip));
    const contact::TangentialInput in{.spring = h.spring,
                                      .previous_radius = h.radius,
                                      .contact_radius = n.contact_radius,
                                      .n = down,
                                      .slip_velocity = {-slip, 0.0, 0.0},
                                      .cap_force = cap,
                                      .damping_factor = h.damping,
                                      .m_star = g.mass,
                                      .dt = dt};
    contact::TangentialState tangential{};
    if (g.compliant)
        tangential = contact::Mindlin{g.stiffness_ratio * g.g_star, mu}.step(in);
    else if (slip != 0.0)
        tangential = contact::Coulomb{mu}.step(in);
    double torque = 0.0;
    if (g.rolling_friction > 0.0) {
        const contact::RollingInput roll{.spring = h.rolling,
                                         .n = down,
                                         .spin_i = {0.0, s.w / g.radius, 0.0},
                                         .spin_j = {},
                                         .r_i = g.radius,
                                         .r_j = contact::wall_radius,
                                         .r_star = g.radius,
                                         .inverse_inertia_i = 1.0 / g.inertia,
                                         .inverse_inertia_j = 0.0,
                                         .e_star = g.e_star,
                                         .previous_radius = h.radius,
                                         .contact_radius = n.contact_radius,
                                         .cap_force = cap,
                                         .dt = dt};
        const contact::RollingState state =
            contact::RollingEpsd{g.rolling_friction, 1.0}.step(roll);
        h.rolling = state.spring, torque = state.torque_on_i.y;
    }
    h.spring = tangential.spring, h.radius = n.contact_radius;
    const double along = -tangential.force_on_j.x;
    return {along / g.mass, (n.force + damped) / g.mass,
            g.radius * (torque - g.radius * along) / g.inertia};
}

class SteppedDrop {
  public:
    SteppedDrop(const DropWorld& world, DropState& s, DropRows& out)
        : world_(world),
          g_(*world.grain),
          s_(s),
          out_(out),
          dt_(world.numerics->time_step->value()),
          euler_(world.numerics->integrator == "euler") {
        if (g_.work_of_adhesion > 0.0) {
            const contact::Jkr law = g_.jkr();
            fold_ = law.tear_off_overlap(g_.r_star, law.length_scale(g_.r_star));
        }
    }

    void run() {
        int calm = 0;
        rates_ = rates();
        while (!out_.done()) {
            if (!history_.touches && world_.ballistic() && g_.vibration.amplitude == 0.0)
                jump();
            else if (!history_.touches && dt_ < resolved_in_flight && !fly_resolved())
                return;
            if (out_.done()) return;
            step();
            calm = history_.touches && is_calm() ? calm + 1 : 0;
            if (calm < patience) continue;
            out_.path.settled = true, out_.path.settled_at = s_.t;
            return stay(world_, s_, out_);
        }
    }

  private:
    // s. A flight in drag or a field changes over milliseconds: with steps below this its error is far below that of the
    // contact, and it is integrated as exactly as need be, not in millions of steps.
    static constexpr double resolved_in_flight = 1e-4;

    const DropWorld& world_;
    const OneGrain& g_;
    DropState& s_;
    DropRows& out_;
    double dt_;
    bool euler_;
    double fold_ = 0.0;
    History history_{};
    Rates rates_{};

    double overlap() const { return g_.vibration.height(s_.t) - s_.z; }

    Rates rates() {
        Rates r{world_.along, -world_.into, 0.0};
        if (g_.drag.factor != 0.0) {
            const double speed = s_.speed();
            const double c = g_.drag.resistance(speed, g_.drag.beyond(speed)) / g_.mass;
            r.ax -= c * s_.vx, r.az -= c * s_.vz;
        }
        const double d = overlap();
        if (!history_.touches && d >= 0.0) begin();
        if (history_.touches && d < fold_) history_ = {};
        if (!history_.touches) {
            r.az += world_.lift(s_, std::max(0.0, -d)) / g_.mass;
            return r;
        }
        const Rates c = contact_rates(g_, s_, d, dt_, history_);
        r.ax += c.ax, r.az += c.az - g_.attraction.in_contact() / g_.mass, r.aw += c.aw;
        return r;
    }

    void begin() {
        const double normal = std::max(1e-12, g_.vibration.velocity(s_.t) - s_.vz);
        history_ = {};
        history_.touches = true;
        history_.damping = contact::DampingTsuji1992::from(g_.restitution.at(normal)).factor;
        s_.impact_speed = normal, s_.bridged = g_.attraction.bridge > 0.0;
        ++out_.path.impacts;
    }

    void step() {
        const DropState before = s_;
        const double kick = euler_ ? 0.0 : 0.5 * dt_;
        s_.vx += kick * rates_.ax, s_.vz += kick * rates_.az, s_.w += kick * rates_.aw;
        s_.x += dt_ * s_.vx, s_.z += dt_ * s_.vz, s_.t += dt_;
        if (euler_) s_.vx += dt_ * rates_.ax, s_.vz += dt_ * rates_.az, s_.w += dt_ * rates_.aw;
        rates_ = rates();
        s_.vx += kick * rates_.ax, s_.vz += kick * rates_.az, s_.w += kick * rates_.aw;
        ++out_.path.steps;
        if (s_.bridged && !history_.touches && -overlap() > g_.attraction.rupture)
            s_.bridged = false;
        while (!out_.done() && out_.rows.time() <= s_.t) {
            const double share = (out_.rows.time() - before.t) / dt_;
            DropState r = s_;
            r.t = out_.rows.time();
            r.x = before.x + share * (s_.x - before.x), r.z = before.z + share * (s_.z - before.z);
            r.vx = before.vx + share * (s_.vx - before.vx);
            r.vz = before.vz + share * (s_.vz - before.vz);
            out_.add(r);
        }
    }

    // To the plate; false where the rows end before.
    bool fly_resolved() {
        const double before = s_.t;
        const bool lands = fly(world_, s_, out_);
        out_.path.steps += static_cast<std::int64_t>((s_.t - before) / dt_);
        rates_ = rates();
        return lands;
    }

    // All steps in the air but the last two.
    void jump() {
        DropState from = s_;
        const double shift = euler_ ? 0.5 * dt_ : 0.0;
        from.vz += shift * world_.into, from.vx -= shift * world_.along;
        const double horizon = out_.rows.at.back() - s_.t, g = world_.into;
        const double square = from.vz * from.vz + 2.0 * g * std::max(s_.z, 0.0);
        double landing = horizon + 3.0 * dt_;
        if (square >= 0.0 && (g > 0.0 || from.vz < 0.0))
            landing = g != 0.0 ? (from.vz + std::sqrt(square)) / g : -s_.z / from.vz;
        if (!(landing >= 0.0)) landing = horizon + 3.0 * dt_;
        const double whole = std::floor(std::min(landing, horizon + 3.0 * dt_) / dt_) - 2.0;
        if (whole < 1.0) return;
        const double duration = whole * dt_;
        while (!out_.done() && out_.rows.time() <= s_.t + duration)
            out_.add(thrown(world_, from, out_.rows.time() - s_.t));
        const DropState end = thrown(world_, from, duration);
        s_.t = end.t, s_.x = end.x, s_.z = end.z;
        s_.vx = end.vx + shift * world_.along, s_.vz = end.vz - shift * world_.into;
        out_.path.steps += static_cast<std::int64_t>(whole);
        rates_ = rates();
    }

    // Calm along the normal: a grain that still slides or rolls is pressed evenly, and what brakes it is known without steps.
    bool is_calm() const {
        const double vn = s_.vz - g_.vibration.velocity(s_.t);
        return vn * vn <= 1e-12 * 2.0 * world_.holding() * g_.radius;
    }
};

}  // namespace

void step_drop(const DropWorld& world, DropState& s, DropRows& out) {
    SteppedDrop(world, s, out).run();
}

}  // namespace rigs
