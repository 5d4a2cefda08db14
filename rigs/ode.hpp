// SPDX-License-Identifier: MIT
// Dormand and Prince's fifth-order step with error control and dense output, for the few unknowns of one grain.
//   Dormand & Prince (1980), J. Comput. Appl. Math. 6, 19; dense output after Hairer, Norsett & Wanner (1993), Solving
//   Ordinary Differential Equations I, section II.6.
// The tolerance is far below what anyone records, so that a step more or less cannot be seen in the answer. What is not smooth
// (a touch, a rupture, a regime) is found on the dense output, and the integration starts anew there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rigs {

template <std::size_t n>
using Unknowns = std::array<double, n>;

// One accepted step; share 0 at its start, 1 at its end.
template <std::size_t n>
struct OdeStep {
    double t, h;
    std::array<Unknowns<n>, 5> r;

    Unknowns<n> at(double share) const {
        const double rest = 1.0 - share;
        Unknowns<n> y;
        for (std::size_t i = 0; i < n; ++i)
            y[i] =
                r[0][i] + share * (r[1][i] + rest * (r[2][i] + share * (r[3][i] + rest * r[4][i])));
        return y;
    }
};

template <std::size_t n, class Rates>
class Ode {
  public:
    // `rates(t, y)` is dy/dt; `small` [unknowns]: below this an error does not count; `first` s: a guess of the step.
    Ode(Rates rates, double t, const Unknowns<n>& y, const Unknowns<n>& small, double first)
        : rates_(std::move(rates)), t_(t), h_(first), y_(y), small_(small), k1_(rates_(t, y)) {}

    double t() const { return t_; }
    const Unknowns<n>& y() const { return y_; }

    // Goes on by at most `longest`, > 0.
    OdeStep<n> step(double longest);

    // Goes on from another place: after an event, or where the rates have changed.
    void restart(double t, const Unknowns<n>& y) {
        t_ = t;
        y_ = y;
        k1_ = rates_(t, y);
    }

  private:
    static constexpr double tolerance = 1e-8;
    Rates rates_;
    double t_, h_;
    Unknowns<n> y_, small_, k1_;

    template <class... Stage>
    Unknowns<n> moved(double h, const Stage&... stages) const {
        Unknowns<n> y = y_;
        for (std::size_t i = 0; i < n; ++i) y[i] += h * (... + (stages.first * stages.second[i]));
        return y;
    }
};

template <std::size_t n, class Rates>
OdeStep<n> Ode<n, Rates>::step(double longest) {
    using P = std::pair<double, const Unknowns<n>&>;
    for (;;) {
        const double h = std::min(h_, longest);
        const Unknowns<n> k2 = rates_(t_ + 0.2 * h, moved(h, P{0.2, k1_}));
        const Unknowns<n> k3 =
            rates_(t_ + 0.3 * h, moved(h, P{3.0 / 40.0, k1_}, P{9.0 / 40.0, k2}));
        const Unknowns<n> k4 = rates_(
            t_ + 0.8 * h, moved(h, P{44.0 / 45.0, k1_}, P{-56.0 / 15.0, k2}, P{32.0 / 9.0, k3}));
        const Unknowns<n> k5 =
            rates_(t_ + 8.0 / 9.0 * h, moved(h, P{19372.0 / 6561.0, k1_}, P{-25360.0 / 2187.0, k2},
                                             P{64448.0 / 6561.0, k3}, P{-212.0 / 729.0, k4}));
        const Unknowns<n> k6 = rates_(
            t_ + h, moved(h, P{9017.0 / 3168.0, k1_}, P{-355.0 / 33.0, k2}, P{46732.0 / 5247.0, k3},
                          P{49.0 / 176.0, k4}, P{-5103.0 / 18656.0, k5}));
        const Unknowns<n> end =
            moved(h, P{35.0 / 384.0, k1_}, P{500.0 / 1113.0, k3}, P{125.0 / 192.0, k4},
                  P{-2187.0 / 6784.0, k5}, P{11.0 / 84.0, k6});
        const Unknowns<n> k7 = rates_(t_ + h, end);
        double error = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double e =
                h * (71.0 / 57600.0 * k1_[i] - 71.0 / 16695.0 * k3[i] + 71.0 / 1920.0 * k4[i] -
                     17253.0 / 339200.0 * k5[i] + 22.0 / 525.0 * k6[i] - k7[i] / 40.0);
            const double size = std::max(std::abs(y_[i]), std::abs(end[i]));
            error = std::max(error, std::abs(e) / (tolerance * size + small_[i]));
        }
        const double change = error > 0.0 ? std::clamp(0.9 * std::pow(error, -0.2), 0.2, 5.0) : 5.0;
        const bool hopeless = h < 1e-14 * std::max(std::abs(t_), 1e-9);
        if (error > 1.0 && !hopeless) {
            h_ = h * change;
            continue;
        }
        h_ = std::max(h * change, h_ > h ? h_ : 0.0);
        OdeStep<n> done{t_, h, {}};
        for (std::size_t i = 0; i < n; ++i) {
            const double way = end[i] - y_[i], bend = h * k1_[i] - way;
            done.r[0][i] = y_[i];
            done.r[1][i] = way;
            done.r[2][i] = bend;
            done.r[3][i] = way - h * k7[i] - bend;
            done.r[4][i] =
                h *
                (-12715105075.0 / 11282082432.0 * k1_[i] + 87487479700.0 / 32700410799.0 * k3[i] -
                 10690763975.0 / 1880347072.0 * k4[i] + 701980252875.0 / 199316789632.0 * k5[i] -
                 1453857185.0 / 822651844.0 * k6[i] + 69997945.0 / 29380423.0 * k7[i]);
        }
        t_ += h;
        y_ = end;
        k1_ = k7;
        return done;
    }
}

// Where f, which changes its sign between `low` and `high`, is zero: bracketed regula falsi (Illinois), then halving.
template <class F>
double crossing(const F& f, double low, double high) {
    double f_low = f(low), f_high = f(high);
    if (f_low == 0.0) return low;
    if (f_high == 0.0 || (f_low > 0.0) == (f_high > 0.0)) return high;
    int side = 0;
    for (int k = 0; k < 200 && std::abs(high - low) > 4e-16 * (std::abs(low) + std::abs(high));
         ++k) {
        const double x =
            k < 60 ? high - f_high * (high - low) / (f_high - f_low) : 0.5 * (low + high);
        const double value = f(x);
        if (value == 0.0) return x;
        if ((value > 0.0) == (f_high > 0.0)) {
            if (std::abs(x - high) <= 2e-16 * std::abs(x)) return x;
            high = x, f_high = value;
            if (side == 1) f_low *= 0.5;
            side = 1;
        } else {
            if (std::abs(x - low) <= 2e-16 * std::abs(x)) return x;
            low = x, f_low = value;
            if (side == -1) f_high *= 0.5;
            side = -1;
        }
    }
    return high;
}

}  // namespace rigs
