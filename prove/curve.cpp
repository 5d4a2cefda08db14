// SPDX-License-Identifier: MIT
// The rig `pull_off`: the force at rest, point by point; behind a spring (cantilever) the outermost state on the way in and the
// innermost on the way out.
#include "prove/collision.hpp"
#include "prove/motions.hpp"
#include "prove/stepper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

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

enum class State { contact, bridged, free };

double force(const World& w, const Setup& s, double separation, State state) {
    World bare = w;
    if (w.kind == Outside::magnet) bare.kind = Outside::none;
    // In contact the gap is 0, even where a neck of JKR reaches beyond the surface.
    const double gap = state == State::contact ? 0.0 : separation;
    const double f = -attraction(bare, s, gap, state != State::free) + strange(w, s, separation);
    return f + (state == State::contact ? in_contact(w, s, separation) : -tail(w, s, separation));
}

// Where the separation is known: in contact up to the fold on the way out, from touch on the way in.
State state_at(const World& w, const Setup& s, double separation, bool retract) {
    if (separation <= (retract ? fold(w, s) : 0.0)) return State::contact;
    return retract && w.surface_tension > 0.0 && separation < rupture_gap(w) ? State::bridged
                                                                             : State::free;
}

// A force bends the spring: the drive's position that belongs to a separation is s - F(s)/k; where that rises the grain is stable. On the
// way in the grain is free as long as it can be, on the way out it holds on as long as it can: contact, then at its edge by what
// pulls from across the gap, then the bridge.
class Cantilever {
  public:
    Cantilever(const World& w, const Setup& s) : w_(w), s_(s), edge_(fold(w, s)) {
        const double edge = edge_;
        const double deep = std::pow(s.preload / (s.e_star() * std::sqrt(s.r_star())), 2.0 / 3.0);
        const double unit = std::max({deep, edge, 1e-9});
        double far = 4.0 * unit;
        for (const double drive : s.at) far = std::max(far, 2.0 * std::abs(drive) + 4.0 * unit);
        for (int n = 60; n >= 1; --n) add(State::contact, -6.0 * unit * std::pow(n / 60.0, 2));
        for (int n = 0; n <= 24; ++n) add(State::contact, edge * n / 24.0);
        for (double h = 0.1 * closest; h < far; h *= 1.3) {
            add(State::free, h);
            if (w.surface_tension > 0.0 && h < rupture_gap(w)) add(State::bridged, h);
        }
        if (w.surface_tension > 0.0) add(State::bridged, rupture_gap(w));
        add(State::free, far);
    }

    double force_at(double drive, bool retract) const {
        const auto at = [&](State state) -> std::optional<double> {
            const std::optional<double> separation = stable(drive, state, retract);
            if (!separation) return std::nullopt;
            return force(w_, s_, *separation, state);
        };
        if (!retract)
            if (const auto f = at(State::free)) return *f;
        if (const auto f = at(State::contact)) return *f;
        const State near = retract && w_.surface_tension > 0.0 ? State::bridged : State::free;
        if (drive <= drive_at(std::max(edge_, 1e-3 * closest), near))
            return s_.cantilever_stiffness * (edge_ - drive);
        if (near == State::bridged)
            if (const auto f = at(State::bridged)) return *f;
        return at(State::free).value_or(0.0);
    }

  private:
    struct Branch {
        std::vector<double> separation, drive;
    };
    double drive_at(double separation, State state) const {
        return separation - force(w_, s_, separation, state) / s_.cantilever_stiffness;
    }
    void add(State state, double separation) {
        Branch& b = branches_[static_cast<std::size_t>(state)];
        b.separation.push_back(separation);
        b.drive.push_back(drive_at(separation, state));
    }
    // Free on the way in: the outermost one; else the innermost.
    std::optional<double> stable(double drive, State state, bool retract) const {
        const Branch& b = branches_[static_cast<std::size_t>(state)];
        for (std::size_t k = 0; k + 1 < b.drive.size(); ++k) {
            const std::size_t n = state == State::free && !retract ? b.drive.size() - 2 - k : k;
            if (b.drive[n] > drive || b.drive[n + 1] <= drive) continue;
            return root([&](double at) { return drive_at(at, state) - drive; }, b.separation[n],
                        b.separation[n + 1]);
        }
        return std::nullopt;
    }
    const World& w_;
    const Setup& s_;
    double edge_;  // m, of the contact
    std::array<Branch, 3> branches_{};
};

}  // namespace

std::vector<double> pull_off(const World& w, const Setup& s) {
    std::vector<double> all(s.at.size());
    const double middle = 0.5 * (*std::min_element(s.at.begin(), s.at.end()) +
                                 *std::max_element(s.at.begin(), s.at.end()));
    std::optional<Cantilever> cantilever;
    if (s.cantilever_stiffness > 0.0) cantilever.emplace(w, s);
    for (std::size_t k = 0; k < s.at.size(); ++k) {
        if (cantilever) {
            all[k] = cantilever->force_at(s.at[k], s.retract[k]) + s.base_line +
                     s.base_line_slope * (s.at[k] - middle);
        } else {
            all[k] = force(w, s, s.at[k], state_at(w, s, s.at[k], s.retract[k]));
        }
    }
    return all;
}

}  // namespace prove
