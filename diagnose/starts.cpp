// SPDX-License-Identifier: MIT
#include "diagnose/starts.hpp"

#include "diagnose/locate.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

int grid_points(const Term& t, Index k) { return t.unknowns.size() == 1 ? 24 : k == 0 ? 8 : 4; }

// u at a share of the way from one end of a grid to the other: the range, or two deviations either side.
double grid_value(const Unknown& x, double share) {
    return x.prior == Prior::gaussian ? 4.0 * share - 2.0 : share;
}

std::vector<VectorXd> grid_of(const Term& t) {
    const auto n = static_cast<Index>(t.unknowns.size());
    std::vector<VectorXd> grid{VectorXd::Zero(n)};
    for (Index k = 0; k < n; ++k) {
        const int count = grid_points(t, k);
        std::vector<VectorXd> finer;
        for (const VectorXd& g : grid)
            for (int c = 0; c < count; ++c)
                finer.push_back(g), finer.back()[k] = grid_value(
                                        t.unknowns[static_cast<std::size_t>(k)], (c + 0.5) / count);
        grid = std::move(finer);
    }
    return grid;
}

// The term's own fit, other strengths with its further unknowns as there, and the grid where it has such.
std::vector<VectorXd> strengths(const Term& t, const VectorXd& u) {
    std::vector<VectorXd> list{u};
    if (t.unknowns.empty()) return list;
    const int count = grid_points(t, 0);
    for (int c = 0; c < count; ++c)
        list.push_back(u), list.back()[0] = grid_value(t.unknowns[0], (c + 0.5) / count);
    if (t.unknowns.size() > 1)
        for (VectorXd& other : grid_of(t)) list.push_back(std::move(other));
    return list;
}

using Places = std::vector<std::pair<double, VectorXd>>;

void sort(Places& list) {
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
}

Starts tried(const Footing& on, const Term& term, const std::vector<VectorXd>& grid) {
    const Hypothesised h = plus(on.problem, on.h, term);
    const Projection project(on.h.unknowns, on.fit);
    const VectorXd left = project(on.fit.white);
    Starts s;
    for (const VectorXd& u : grid) {
        const VectorXd values = to_theta(term.unknowns, u);
        const VectorXd d = project(
            on.whiten(predicted(on.problem, h, carried(on, h, values)) - on.fit.prediction));
        if (d.squaredNorm() < 1.0) s.unseen += 1.0 / static_cast<double>(grid.size());
        const double chi = (left - d).squaredNorm();
        if (std::isfinite(chi)) s.best_first.push_back({chi, values});
    }
    sort(s.best_first);
    return s;
}

// m/s^2
double gravity_of(const Problem& p) {
    const double g = p.records.front().experiment->surroundings.gravity.value();
    return g > 0.0 ? g : 9.81;
}

double longest_record(const Problem& p) {
    double longest = 0.0;
    for (const Record& r : p.records)
        if (r.ordinate == "t" && !r.ordinates.at.empty())
            longest = std::max(longest, r.ordinates.at.back() - r.ordinates.at.front());
    return longest;
}

// Half a period over the longest recording apart, where that is more than 1.5 %.
std::vector<double> frequencies(double low, double high, double duration) {
    const double least = duration > 0.0 ? 0.5 / duration : high;
    std::vector<double> list;
    for (double f = low; f <= high; f += std::max(std::min(least, 0.1 * f), 0.015 * f))
        list.push_back(f);
    return list;
}

// The best few by all rows, and by the first 40 % of each recording: past the third bounce or so everything is out of step
// unless the frequency is right already.
std::array<Places, 2> large_vibrations(const Footing& on, const Term& term, int points) {
    constexpr std::size_t few = 20;
    const Hypothesised h = plus(on.problem, on.h, term);
    const VectorXd early = early_rows(on.problem, 0.4);
    const double g = gravity_of(on.problem);
    Places by_all, by_early;
    VectorXd u(3);
    for (int k = 1; k <= points; ++k) {
        // Evenly spread: multiples of the powers of 1/1.22074..., the root of x^4 = x + 1.
        for (Index n = 0; n < 3; ++n)
            u[n] = std::fmod(0.5 + k * std::pow(1.0 / 1.2207440846057596, n + 1), 1.0);
        VectorXd values = to_theta(term.unknowns, u);
        // By peak acceleration, 0.03 to 3 g: below, the linear answer serves; above, bounces are chaos.
        const double omega = 2.0 * pi * values[1];
        values[0] = std::clamp(0.03 * std::pow(100.0, u[0]) * g / (omega * omega),
                               term.unknowns[0].low, term.unknowns[0].high);
        const VectorXd z =
            on.fit.white -
            on.whiten(predicted(on.problem, h, carried(on, h, values)) - on.fit.prediction);
        const double all = z.squaredNorm(), part = z.cwiseProduct(early).squaredNorm();
        if (std::isfinite(all)) by_all.push_back({all, values});
        if (std::isfinite(part)) by_early.push_back({part, values});
    }
    for (auto* list : {&by_all, &by_early}) {
        sort(*list);
        list->resize(std::min(list->size(), few));
    }
    return {by_all, by_early};
}

// Unknowns amplitude, frequency, phase.
Starts vibrations(const Footing& on, const Term& term, int points) {
    const Hypothesised h = plus(on.problem, on.h, term);
    const Projection project(on.h.unknowns, on.fit);
    const VectorXd left = project(on.fit.white);
    const Unknown &amplitude = term.unknowns[0], &frequency = term.unknowns[1];
    const double g = gravity_of(on.problem);
    const std::vector<double> list =
        frequencies(frequency.low, frequency.high, longest_record(on.problem));
    Starts s;
    for (const double f : list) {
        // Small: plate speeds a thousandth of those at which the largest amplitude of the prior moves at 20 Hz.
        const double small = std::clamp(0.02 * amplitude.high / f, amplitude.low, amplitude.high);
        MatrixXd two(left.size(), 2);
        for (const int k : {0, 1}) {
            VectorXd values(3);
            values << small, f, k == 0 ? 0.0 : 0.5 * pi;
            two.col(k) = project(
                on.whiten(predicted(on.problem, h, carried(on, h, values)) - on.fit.prediction));
        }
        Eigen::Matrix2d normal = two.transpose() * two;
        const double size = 0.5 * normal.trace();
        const double visible = size > 0.0 ? small / std::sqrt(size) : amplitude.high;
        s.unseen +=
            std::clamp(std::log(visible / amplitude.low) / std::log(amplitude.high / amplitude.low),
                       0.0, 1.0) /
            static_cast<double>(list.size());
        normal.diagonal().array() += 1e-9 * size + 1e-12;
        const Eigen::Vector2d solved = normal.inverse() * (two.transpose() * left);
        const double chi = (left - two * solved).squaredNorm();
        const double peak = small * solved.norm() * 4.0 * pi * pi * f * f;
        if (!std::isfinite(chi) || peak > 3.0 * g) continue;
        VectorXd values(3);
        values << std::clamp(small * solved.norm(), amplitude.low, amplitude.high), f,
            std::fmod(std::atan2(solved[1], solved[0]) + 2.0 * pi, 2.0 * pi);
        s.best_first.push_back({chi, values});
    }
    sort(s.best_first);
    // By turns: no way of looking is the best for all.
    const std::array<Places, 2> large = large_vibrations(on, term, points);
    Places small;
    std::swap(small, s.best_first);
    for (std::size_t k = 0; k < 20; ++k)
        for (const Places* places : {&std::as_const(small), &large[0], &large[1]})
            if (k < places->size()) s.best_first.push_back((*places)[k]);
    return s;
}

}  // namespace

Hypothesised plus(const Problem& p, const Hypothesised& h, const Term& term) {
    std::vector<const Term*> terms = h.terms;
    terms.push_back(&term);
    return p.hypothesis(std::move(terms));
}

VectorXd carried(const Footing& on, const Hypothesised& to, const VectorXd& own) {
    VectorXd result = start_of(to.unknowns);
    for (Index k = 0; k < result.size() - own.size(); ++k)
        for (std::size_t n = 0; n < on.h.unknowns.size(); ++n)
            if (on.h.unknowns[n].name == to.unknowns[static_cast<std::size_t>(k)].name &&
                on.h.unknowns[n].key == to.unknowns[static_cast<std::size_t>(k)].key)
                result[k] = on.fit.theta[static_cast<Index>(n)];
    result.tail(own.size()) = own;
    return result;
}

Starts starts_of(const Footing& on, const Term& term) {
    return term.effect == "vibration" ? vibrations(on, term, 2000) : tried(on, term, grid_of(term));
}

Starts starts_beside(const Footing& on, const Term& term, const VectorXd& u) {
    return term.effect == "vibration" ? vibrations(on, term, 400)
                                      : tried(on, term, strengths(term, u));
}

std::vector<VectorXd> distinct(const Term& term, const Starts& s, std::size_t most) {
    std::vector<VectorXd> list, places;
    for (const auto& [chi, values] : s.best_first) {
        if (list.size() >= most) break;
        const VectorXd u = to_u(term.unknowns, values);
        const bool fresh = std::all_of(places.begin(), places.end(), [&](const VectorXd& other) {
            double farthest = 0.0;
            for (Index k = 0; k < u.size(); ++k) {
                const Unknown& x = term.unknowns[static_cast<std::size_t>(k)];
                double apart = std::abs(u[k] - other[k]);
                if (x.turns) apart = std::min(apart, 1.0 - apart);
                if (x.key == "frequency") apart *= 6.0;  // a tenth in frequency is another one
                farthest = std::max(farthest, apart);
            }
            return farthest > 0.1;
        });
        if (fresh) list.push_back(values), places.push_back(u);
    }
    if (list.empty()) list.push_back(start_of(term.unknowns));  // no place gave a number
    return list;
}

}  // namespace diagnose
