// SPDX-License-Identifier: MIT
// The rig `pull_off`: the force of one contact, quasi-statically, against separation, or against the drive behind a cantilever
// of stiffness k (docs/pull-off.md). With x the drive's reading from contact_displacement, s the separation, F > 0 repulsive:
//   the spring carries the force:  x = s - F(s)/k
// and of several s the one that the path before leads to: inward from afar, or outward from the pressed contact. Where
// 1 - F'(s)/k falls to 0 the grain jumps.
#include "contact/hertz.hpp"
#include "rigs/ode.hpp"
#include "rigs/single_grain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace rigs {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Where the surfaces are, and what pushes them apart.
struct Place {
    double separation, force;  // m, N
};

class ForceCurve {
  public:
    // `stiffness` of the cantilever, N/m; infinite without one.
    ForceCurve(const OneGrain& g, const MissingForce* missing, double stiffness)
        : g_(g), missing_(missing), k_(stiffness) {
        if (g.work_of_adhesion > 0.0) {
            length_ = g.jkr().length_scale(g.r_star);
            gap_ = -g.jkr().tear_off_overlap(g.r_star, length_);
        }
        if (!(k_ < std::numeric_limits<double>::infinity())) return;
        jumps_in_ = jump_in(k_), lets_go_ = let_go(k_);
    }

    Place at_separation(double s, bool retract) const {
        const bool touches = retract ? s <= gap_ : s <= 0.0;
        return {s, touches ? in_contact(s) : apart(s, retract)};
    }

    Place at_drive(double x, bool retract) const {
        if (!(k_ < std::numeric_limits<double>::infinity())) return at_separation(x, retract);
        return retract ? outward(x) : inward(x);
    }

  private:
    const OneGrain& g_;
    const MissingForce* missing_;
    double k_;
    double length_ = 0.0, gap_ = 0.0;        // m, of JKR
    double jumps_in_ = 0.0, lets_go_ = 0.0;  // m, separations at which the cantilever does

    double further(double s) const {
        return missing_ != nullptr ? straight_between(missing_->knots, missing_->newtons, s) : 0.0;
    }

    double in_contact(double s) const {
        const double elastic = g_.work_of_adhesion > 0.0
                                   ? g_.jkr().at(g_.r_star, length_, -s).force
                                   : contact::Hertz{g_.e_star}.at(g_.r_star, g_.r_star, -s).force;
        return elastic - g_.attraction.in_contact() + further(s);
    }
    double apart(double s, bool bridged) const {
        return -g_.attraction.across(std::max(s, 0.0), bridged) + further(s);
    }

    // The end of the stable part of the contact: where the tension rises as fast as the spring gives way, between the
    // deepest tension and the fold. dF/dd from contact/jkr.hpp in s of its curve.
    double let_go(double stiffness) const {
        if (g_.work_of_adhesion <= 0.0) return 0.0;
        const double unit = 2.0 / 3.0 * std::numbers::pi * g_.work_of_adhesion * g_.r_star *
                            g_.r_star / (length_ * length_);
        const auto margin = [&](double s) {
            return unit * s * s * (6.0 * s * s * s - 9.0) + stiffness * (4.0 * s * s * s - 2.0);
        };
        const double s = crossing(margin, std::cbrt(0.5), std::cbrt(1.5));
        return -length_ * length_ / g_.r_star * s * (s * s * s - 2.0);
    }

    // The largest gap at which the attraction grows faster than the spring holds; 0 where there is none.
    double jump_in(double stiffness) const {
        const auto margin = [&](double s) { return g_.attraction.steepness(s, false) - stiffness; };
        double low = 0.165e-9, high = low;
        if (margin(low) <= 0.0) return 0.0;
        while (margin(high) > 0.0) high *= 4.0;
        return crossing(margin, low, high);
    }

    double reading_apart(double s, bool bridged) const { return s - apart(s, bridged) / k_; }

    Place inward(double x) const {
        const auto excess = [&](double s) { return reading_apart(s, false) - x; };
        if (excess(jumps_in_) >= 0.0) return pressed(x, lets_go_);
        double high = std::max(2.0 * x, 1e-10);
        while (excess(high) < 0.0) high *= 2.0;
        const double s = crossing(excess, jumps_in_, high);
        return {s, apart(s, false)};
    }

    Place outward(double x) const {
        if (x <= lets_go_ - in_contact(lets_go_) / k_) return pressed(x, lets_go_);
        if (g_.attraction.none() && missing_ == nullptr) return {x, 0.0};
        const auto excess = [&](double s) { return reading_apart(s, true) - x; };
        double low = std::max(lets_go_, 1e-12), high = low;
        // Held at the edge by what pulls from outside the contact.
        if (excess(low) > 0.0) return {lets_go_, k_ * (lets_go_ - x)};
        for (high *= 1.4; excess(high) < 0.0; high *= 1.4) low = high;
        const double s = crossing(excess, low, high);
        return {s, apart(s, true)};
    }

    // In contact, at most `outermost` apart.
    Place pressed(double x, double outermost) const {
        const double edge = outermost - in_contact(outermost) / k_ - x;
        if (edge < 0.0) return {outermost, k_ * (outermost - x)};
        if (missing_ == nullptr) return g_.work_of_adhesion > 0.0 ? adhering(x) : elastic(x);
        const auto excess = [&](double s) { return s - in_contact(s) / k_ - x; };
        double high = outermost, depth = std::max(gap_, 1e-10), low = outermost - depth;
        for (; excess(low) > 0.0; low = outermost - depth) high = low, depth *= 2.0;
        const double s = crossing(excess, low, high);
        return {s, in_contact(s)};
    }

    // Where f, rising and convex from the largest zero on, is zero: Newton's steps from a place beyond it. f gives value and slope.
    template <class F>
    static double from_above(const F& f, double q) {
        for (int n = 0; n < 100; ++n) {
            const auto [value, slope] = f(q);
            const double step = value / slope;
            if (!(step > 1e-15 * q)) break;  // nor where it is no number: nothing presses
            q -= step;
        }
        return q;
    }

    // Hertz in q = sqrt(overlap): overlap + F/k = -x, which is a polynomial.
    Place elastic(double x) const {
        const double steep = 4.0 / 3.0 * g_.e_star * std::sqrt(g_.r_star);
        const double pull = g_.attraction.in_contact(), c = pull / k_ - x;
        const double q = from_above(
            [&](double v) {
                return std::pair{v * v * (1.0 + steep / k_ * v) - c,
                                 v * (2.0 + 3.0 * steep / k_ * v)};
            },
            std::min(std::sqrt(c), std::cbrt(c * k_ / steep)));
        return {-q * q, steep * q * q * q - pull};
    }

    // JKR in the s of contact/jkr.hpp: both the overlap and the force are polynomials of it.
    Place adhering(double x) const {
        const double unit = length_ * length_ / g_.r_star;
        const double load = 2.0 / 3.0 * std::numbers::pi * g_.work_of_adhesion * g_.r_star;
        const double pull = g_.attraction.in_contact(), c = pull / k_ - x;
        const double free = std::cbrt(3.0);  // there the contact carries no force
        const double deep = std::max(c, 0.0);
        const double beyond = std::min(std::pow(deep / unit, 0.25) + std::cbrt(2.0),
                                       std::pow(deep * k_ / load, 1.0 / 6.0) + free);
        const double s = from_above(
            [&](double v) {
                const double v3 = v * v * v;
                return std::pair{unit * v * (v3 - 2.0) + load / k_ * v3 * (v3 - 3.0) - c,
                                 unit * (4.0 * v3 - 2.0) + load / k_ * v * v * (6.0 * v3 - 9.0)};
            },
            std::max(free, beyond));
        const double s3 = s * s * s;
        return {-unit * s * (s3 - 2.0), load * s3 * (s3 - 3.0) - pull};
    }
};

class PullOff : public ForwardModel {
  public:
    explicit PullOff(const cases::Experiment& e) : stated_(e) {
        counterpart_ = e.conditions.at("counterpart").text() == "grain" ? Counterpart::grain
                                                                        : Counterpart::plate;
        driven_ = ordinate_name(e) == "displacement";
    }

    Curves predict(const World& world, const Ordinates& o) const override {
        return curve(world, o, "force", [](const Place& p) { return p.force; });
    }
    Curves variables(const World& world, const Ordinates& o) const override {
        return curve(world, o, "separation", [](const Place& p) { return p.separation; });
    }
    std::set<std::string> effects() const override { return pull_off_effects(); }

  private:
    Stated stated_;
    Counterpart counterpart_;
    bool driven_;

    Curves curve(const World& world, const Ordinates& o, const char* name,
                 double (*value)(const Place&)) const {
        check_missing(world, "pull_off", {"separation"});
        const OneGrain grain = one_grain(stated_, world, counterpart_);
        const double k = stated_.value(world, "conditions.cantilever_stiffness",
                                       std::numeric_limits<double>::infinity());
        const ForceCurve law(grain, world.missing ? &*world.missing : nullptr, k);
        const double origin = stated_.value(world, "conditions.contact_displacement", 0.0);
        std::vector<double> found(o.at.size(), nothing);
        for (std::size_t i = 0; i < o.at.size(); ++i) {
            if (!std::isfinite(o.at[i])) continue;
            const bool retract = i < o.retract.size() && o.retract[i];
            found[i] = value(driven_ ? law.at_drive(o.at[i] - origin, retract)
                                     : law.at_separation(o.at[i], retract));
        }
        return {{name, std::move(found)}};
    }
};

}  // namespace

std::set<std::string> pull_off_effects() {
    return {"hertz_mindlin", "hertz_coulomb",    "adhesion",
            "van_der_waals", "capillary_bridge", "electrostatic"};
}

std::unique_ptr<ForwardModel> pull_off_model(const cases::Experiment& e) {
    return std::make_unique<PullOff>(e);
}

}  // namespace rigs
