// SPDX-License-Identifier: MIT
// The rig `pull_off`: the force at rest, point by point; behind a spring (cantilever) the outermost state on the way in and the
// innermost on the way out.
#include "prove/collision.hpp"
#include "prove/motions.hpp"
#include "prove/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace prove {
namespace {

constexpr double closest = 0.165e-9;  // m

double tail(const World& w, const Setup& s, double gap) {
    if (w.hamaker_constant == 0.0 || gap <= 0.0) return 0.0;
    const double h = std::max(gap, closest);
    return w.hamaker_constant * s.r_star() / (6.0 * h * h);
}

double strange(const World& w, const Setup& s, double separation) {
    const double depth = std::max(-separation, 0.0), scale = 0.01 * s.radius();
    if (w.kind == Outside::stiffening)
        return w.outside * s.e_star() * s.r_star() * s.r_star() * std::pow(depth / scale, 3) * 1e-3;
    if (w.kind == Outside::oscillating_force) {
        const double h = std::max(separation, 0.0), h0 = 1e-3 * s.radius();
        return w.outside * s.e_star() * h0 * h0 *
               (std::sin(2.0 * std::numbers::pi * h / h0 + 0.7) * std::exp(-h / h0));
    }
    if (w.kind == Outside::magnet) {
        // Here by the fourth power of a distance of a hundredth of the radius, in units of E* R^2.
        const double l = 0.01 * s.radius(), h = std::max(separation, 0.0);
        return -w.outside * 1e-5 * s.e_star() * s.r_star() * s.r_star() * std::pow(l / (l + h), 4);
    }
    return 0.0;
}

double in_contact(const World& w, const Setup& s, double separation) {
    if (w.work_of_adhesion > 0.0) {
        const Jkr law{s.e_star(), s.r_star(), w.work_of_adhesion};
        return law.force(law.radius(-separation));
    }
    return 4.0 / 3.0 * s.e_star() * std::sqrt(s.r_star()) *
           std::pow(std::max(-separation, 0.0), 1.5);
}

double fold(const World& w, const Setup& s) {
    if (w.work_of_adhesion <= 0.0) return 0.0;
    return -Jkr{s.e_star(), s.r_star(), w.work_of_adhesion}.fold();
}

// `held`: the branch that was in contact.
double force(const World& w, const Setup& s, double separation, bool held) {
    const bool touches = separation <= (held ? fold(w, s) : 0.0);
    const bool wet = separation <= 0.0 || (held && separation < rupture_gap(w));
    World dry = w;
    if (w.kind == Outside::magnet) dry.kind = Outside::none;
    double f = -attraction(dry, s, separation, wet) + strange(w, s, separation);
    return f + (touches ? in_contact(w, s, separation) : -tail(w, s, separation));
}

// Separations at the drive's positions. The drive's position that belongs to a separation, s + F(s)/k, is laid out on a grid
// that is fine at the plate; the state is the first crossing seen from the side that it comes from.
class Cantilever {
  public:
    Cantilever(const World& w, const Setup& s, bool held) : w_(w), s_(s), held_(held) {
        const double edge = fold(w, s);
        const double deep = std::pow(s.preload / (s.e_star() * std::sqrt(s.r_star())), 2.0 / 3.0);
        const double unit = std::max({deep, edge, 1e-9});
        double far = 4.0 * unit;
        for (const double drive : s.at) far = std::max(far, 2.0 * std::abs(drive) + 4.0 * unit);
        for (int n = 60; n >= 1; --n) add(-4.0 * unit * std::pow(n / 60.0, 2));
        add(0.0);
        for (int n = 1; edge > 0.0 && n <= 12; ++n) add(edge * (n - 1e-9) / 12.0);
        if (edge > 0.0) add(edge * (1.0 + 1e-9));
        for (double h = closest; h < far; h *= 1.35) add(edge + h);
        add(edge + far);
    }

    double separation(double drive) const {
        const auto excess = [&](double at) { return drive_at(at) - drive; };
        const std::size_t last = grid_.size() - 1;
        for (std::size_t k = 0; k < last; ++k) {
            const std::size_t n = held_ ? k : last - 1 - k;
            if (drive_[n] <= drive && drive_[n + 1] > drive)
                return root(excess, grid_[n], grid_[n + 1]);
        }
        return drive;
    }

  private:
    double drive_at(double separation) const {
        return separation + force(w_, s_, separation, held_) / s_.cantilever_stiffness;
    }
    void add(double separation) {
        grid_.push_back(separation);
        drive_.push_back(drive_at(separation));
    }
    const World& w_;
    const Setup& s_;
    bool held_;
    std::vector<double> grid_{}, drive_{};
};

}  // namespace

std::vector<double> pull_off(const World& w, const Setup& s) {
    std::vector<double> all(s.at.size());
    const double middle = 0.5 * (*std::min_element(s.at.begin(), s.at.end()) +
                                 *std::max_element(s.at.begin(), s.at.end()));
    std::optional<Cantilever> in, out;
    if (s.cantilever_stiffness > 0.0) in.emplace(w, s, false), out.emplace(w, s, true);
    for (std::size_t k = 0; k < s.at.size(); ++k) {
        const bool held = s.retract[k];
        double separation = s.at[k];
        if (in) separation = (held ? out : in)->separation(s.at[k]);
        all[k] = force(w, s, separation, held);
        if (s.cantilever_stiffness > 0.0)
            all[k] += s.base_line + s.base_line_slope * (s.at[k] - middle);
    }
    return all;
}

}  // namespace prove
