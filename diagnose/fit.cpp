// SPDX-License-Identifier: MIT
#include "diagnose/fit.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double difference_step = 2e-4;  // of u

double value_at(const Unknown& x, double u) {
    if (x.prior == Prior::gaussian) return x.mean + u * x.deviation;
    if (x.prior == Prior::log_uniform) return x.low * std::pow(x.high / x.low, u);
    return x.low + u * (x.high - x.low);
}
double reduced(const Unknown& x, double value) {
    if (x.prior == Prior::gaussian) return (value - x.mean) / x.deviation;
    if (x.prior == Prior::log_uniform) return std::log(value / x.low) / std::log(x.high / x.low);
    return (value - x.low) / (x.high - x.low);
}
VectorXd clipped(const std::vector<Unknown>& list, VectorXd u) {
    for (Index k = 0; k < u.size(); ++k) {
        const Unknown& x = list[static_cast<std::size_t>(k)];
        if (x.turns && std::isfinite(u[k])) u[k] -= std::floor(u[k]);
        u[k] = std::clamp(std::isfinite(u[k]) ? u[k] : 0.5, lowest(x), highest(x));
    }
    return u;
}

// Of each record, how many of its first rows hold all that have a weight.
std::vector<std::size_t> rows_with_weight(const Problem& p, const VectorXd& weight) {
    std::vector<std::size_t> rows;
    for (const Record& r : p.records) {
        std::size_t last = 0;
        for (const Channel& c : r.channels)
            for (std::size_t k = c.recorded.size(); k > last; --k)
                if (weight[static_cast<Index>(c.first + k - 1)] != 0.0) last = k;
        rows.push_back(last);
    }
    return rows;
}

struct Solver {
    const Problem& problem;
    const Whitener& whiten;
    const Hypothesised& h;
    VectorXd weight;  // [size], 0 or 1
    const VectorXd& recorded;
    Index held = -1;  // an unknown that stays where it is
    std::vector<std::size_t> rows = rows_with_weight(problem, weight);

    VectorXd predict(const VectorXd& u, int only = -1) const {
        return predicted(problem, h, to_theta(h.unknowns, u), only, rows);
    }
    VectorXd white(const VectorXd& prediction) const {
        VectorXd r = recorded - prediction;
        for (Index k = 0; k < r.size(); ++k)
            if (!std::isfinite(r[k])) r[k] = 0.0;
        return whiten(r);
    }
    double penalty(const VectorXd& u) const {
        double sum = 0.0;
        for (Index k = 0; k < u.size(); ++k)
            if (h.unknowns[static_cast<std::size_t>(k)].prior == Prior::gaussian)
                sum += u[k] * u[k];
        return sum;
    }
    double objective(const VectorXd& z, const VectorXd& u) const {
        return z.cwiseProduct(weight).squaredNorm() + penalty(u);
    }
    int record_of(const Unknown& x) const {
        if (x.experiment.empty()) return -1;
        for (std::size_t j = 0; j < problem.records.size(); ++j)
            if (problem.records[j].experiment->id == x.experiment) return static_cast<int>(j);
        return -1;
    }
    // One-sided differences from `here`, the prediction at u: enough for a step.
    MatrixXd slopes(const VectorXd& u, const VectorXd& here) const {
        MatrixXd j(static_cast<Index>(problem.size), u.size());
        for (Index k = 0; k < u.size(); ++k) {
            if (k == held) {
                j.col(k).setZero();
                continue;
            }
            const Unknown& x = h.unknowns[static_cast<std::size_t>(k)];
            const double h_step =
                u[k] + difference_step > highest(x) ? -difference_step : difference_step;
            const int only = record_of(x);
            VectorXd moved = u;
            moved[k] += h_step;
            VectorXd d = predict(moved, only) - here;
            if (only >= 0) d = rows_of(problem, static_cast<std::size_t>(only), d);
            j.col(k) = whiten(d / h_step);
        }
        return j;
    }
    MatrixXd jacobian(const VectorXd& u) const {
        MatrixXd j(static_cast<Index>(problem.size), u.size());
        for (Index k = 0; k < u.size(); ++k) {
            const Unknown& x = h.unknowns[static_cast<std::size_t>(k)];
            const double up = std::min(u[k] + difference_step, highest(x));
            const double down = std::max(u[k] - difference_step, lowest(x));
            const int only = record_of(x);
            VectorXd a = u, b = u;
            a[k] = up, b[k] = down;
            j.col(k) = whiten((predict(a, only) - predict(b, only)) / (up - down));
        }
        return j;
    }
    MatrixXd prior_precision() const {
        VectorXd d(static_cast<Index>(h.unknowns.size()));
        for (Index k = 0; k < d.size(); ++k)
            d[k] = h.unknowns[static_cast<std::size_t>(k)].prior == Prior::gaussian ? 1.0 : 0.0;
        return d.asDiagonal();
    }
    VectorXd gradient_of_penalty(const VectorXd& u) const { return prior_precision() * u; }

    // Levenberg-Marquardt; unknowns at an end with a step beyond it are held.
    VectorXd solve(VectorXd u, int iterations) const {
        if (u.size() == 0) return u;
        VectorXd here = predict(u), z = white(here);
        double best = objective(z, u), damping = 1e-3;
        for (int n = 0; n < iterations; ++n) {
            const MatrixXd j = weight.asDiagonal() * slopes(u, here);
            const MatrixXd normal = j.transpose() * j + prior_precision();
            const VectorXd gradient =
                j.transpose() * z.cwiseProduct(weight) - gradient_of_penalty(u);
            bool moved = false;
            double gained = 0.0, growth = 6.0;  // in five tries up to 80000 times
            for (int tries = 0; tries < 5 && !moved; ++tries) {
                const VectorXd trial = clipped(h.unknowns, u + step(normal, gradient, u, damping));
                const VectorXd there = predict(trial), z_trial = white(there);
                const double now = objective(z_trial, trial);
                if (now < best) {
                    gained = best - now;
                    u = trial, here = there, z = z_trial, best = now,
                    damping = std::max(damping * 0.2, 1e-9), moved = true;
                } else {
                    damping *= growth, growth *= 2.0;
                }
            }
            if (!moved || gained < 0.01 + 1e-6 * best) break;
        }
        return u;
    }
    Place place(const VectorXd& from, int iterations) const {
        const VectorXd u = solve(from, iterations);
        return {objective(white(predict(u)), u), u, to_theta(h.unknowns, u)};
    }
    VectorXd step(const MatrixXd& normal, const VectorXd& gradient, const VectorXd& u,
                  double damping) const {
        std::vector<Index> open;
        for (Index k = 0; k < u.size(); ++k) {
            const Unknown& x = h.unknowns[static_cast<std::size_t>(k)];
            const bool stopped = (u[k] <= lowest(x) && gradient[k] < 0.0) ||
                                 (u[k] >= highest(x) && gradient[k] > 0.0);
            if (!stopped && k != held) open.push_back(k);
        }
        const auto n = static_cast<Index>(open.size());
        MatrixXd a(n, n);
        VectorXd g(n), result = VectorXd::Zero(u.size());
        for (Index r = 0; r < n; ++r) {
            g[r] = gradient[open[static_cast<std::size_t>(r)]];
            for (Index c = 0; c < n; ++c)
                a(r, c) =
                    normal(open[static_cast<std::size_t>(r)], open[static_cast<std::size_t>(c)]);
        }
        const double floor = 1e-12 * std::max(1.0, n > 0 ? a.diagonal().maxCoeff() : 1.0);
        for (Index r = 0; r < n; ++r) a(r, r) += damping * a(r, r) + floor + damping;
        const VectorXd s = a.ldlt().solve(g);
        for (Index r = 0; r < n; ++r) result[open[static_cast<std::size_t>(r)]] = s[r];
        return result;
    }
};

bool over_time(const Problem& p) {
    return std::any_of(p.records.begin(), p.records.end(),
                       [](const Record& r) { return r.ordinate == "t"; });
}

Fit finished(const Solver& s, const VectorXd& u) {
    Fit f;
    f.theta = to_theta(s.h.unknowns, u);
    f.prediction = s.predict(u);
    f.white = s.white(f.prediction);
    f.jacobian = s.jacobian(u);
    f.chi_squared = f.white.squaredNorm();
    f.penalty = s.penalty(u);
    // A uniform prior of width 1 counts as a precision of 2 pi about the fit: the Laplace integral of an unknown that the
    // recordings do not fix is then 1, its prior's own, and of one that they do fix what it should be.
    const auto n = u.size();
    MatrixXd precision = f.jacobian.transpose() * f.jacobian;
    for (Index k = 0; k < n; ++k)
        precision(k, k) += s.h.unknowns[static_cast<std::size_t>(k)].prior == Prior::gaussian
                               ? 1.0
                               : 2.0 * std::numbers::pi;
    const Eigen::LLT<MatrixXd> llt(precision);
    f.covariance = llt.solve(MatrixXd::Identity(n, n));
    double log_det = 0.0;
    for (Index k = 0; k < n; ++k) log_det += 2.0 * std::log(llt.matrixL()(k, k));
    double log_volume = 0.0;
    for (const Unknown& x : s.h.unknowns)
        if (x.prior != Prior::gaussian) log_volume += 0.5 * std::log(2.0 * std::numbers::pi);
    f.log_evidence = s.whiten.log_normaliser() - 0.5 * f.objective() + log_volume - 0.5 * log_det;
    return f;
}

}  // namespace

VectorXd early_rows(const Problem& p, double share) {
    VectorXd weight = VectorXd::Ones(static_cast<Index>(p.size));
    for (const Record& r : p.records) {
        if (r.ordinate != "t" || share >= 1.0) continue;
        for (const Channel& c : r.channels)
            for (std::size_t k =
                     static_cast<std::size_t>(share * static_cast<double>(c.recorded.size()));
                 k < c.recorded.size(); ++k)
                weight[static_cast<Index>(c.first + k)] = 0.0;
    }
    return weight;
}

double lowest(const Unknown& x) {
    if (x.turns) return -0.5;  // never reached: what turns is kept between 0 and 1
    return x.prior == Prior::gaussian ? (x.low - x.mean) / x.deviation : 0.0;
}
double highest(const Unknown& x) {
    if (x.turns) return 1.5;
    return x.prior == Prior::gaussian ? (x.high - x.mean) / x.deviation : 1.0;
}

VectorXd to_theta(const std::vector<Unknown>& list, const VectorXd& u) {
    VectorXd theta(u.size());
    for (Index k = 0; k < u.size(); ++k)
        theta[k] = value_at(list[static_cast<std::size_t>(k)], u[k]);
    return theta;
}

VectorXd to_u(const std::vector<Unknown>& list, const VectorXd& theta) {
    VectorXd u(theta.size());
    for (Index k = 0; k < theta.size(); ++k)
        u[k] = reduced(list[static_cast<std::size_t>(k)], theta[k]);
    return clipped(list, u);
}

VectorXd start_of(const std::vector<Unknown>& list) {
    VectorXd theta(static_cast<Index>(list.size()));
    for (Index k = 0; k < theta.size(); ++k) theta[k] = list[static_cast<std::size_t>(k)].start;
    return theta;
}

Fit fit_to(const Problem& p, const Whitener& w, const Hypothesised& h, const VectorXd& recorded,
           const VectorXd& start, bool staged, int iterations) {
    VectorXd u = to_u(h.unknowns, start);
    if (staged && over_time(p)) {
        for (const double share : {0.25, 0.5})
            u = Solver{p, w, h, early_rows(p, share), recorded}.solve(u, 6);
    }
    const Solver all{p, w, h, early_rows(p, 1.0), recorded};
    return finished(all, all.solve(u, iterations));
}

Fit fit(const Problem& p, const Whitener& w, const Hypothesised& h, const VectorXd& start,
        bool staged, int iterations) {
    return fit_to(p, w, h, p.recorded, start, staged, iterations);
}

bool deeper(const Place& a, const Place& b) { return a.objective < b.objective; }

bool is_fresh(const VectorXd& u, const std::vector<VectorXd>& tried, double distance) {
    return std::all_of(tried.begin(), tried.end(), [&](const VectorXd& other) {
        return (u - other).lpNorm<Eigen::Infinity>() > distance;  // 0 where there is no unknown
    });
}

Place descended(const Problem& p, const Whitener& w, const Hypothesised& h, const VectorXd& u,
                int iterations, const VectorXd& rows) {
    return Solver{p, w, h, rows.size() > 0 ? rows : early_rows(p, 1.0), p.recorded}.place(
        clipped(h.unknowns, u), iterations);
}

Place fit_holding(const Problem& p, const Whitener& w, const Hypothesised& h, const VectorXd& theta,
                  Index k, double at, int iterations) {
    VectorXd u = to_u(h.unknowns, theta);
    u[k] = at;
    return Solver{p, w, h, early_rows(p, 1.0), p.recorded, k}.place(u, iterations);
}

Fit fit_base(const Problem& p, const Whitener& w, const Hypothesised& h) {
    constexpr int grid = 20;
    const VectorXd stated = to_u(h.unknowns, start_of(h.unknowns));
    std::vector<VectorXd> starts{stated};
    const Solver early{p, w, h, early_rows(p, 0.4), p.recorded};
    VectorXd u = stated;
    double best = early.objective(early.white(early.predict(u)), u);
    for (Index k = 0; k < u.size(); ++k) {
        if (h.unknowns[static_cast<std::size_t>(k)].prior == Prior::gaussian) continue;
        VectorXd trial = u;
        for (int n = 0; n < grid; ++n) {
            trial[k] = (n + 0.5) / grid;
            const double now = early.objective(early.white(early.predict(trial)), trial);
            if (now < best) best = now, u[k] = trial[k];
        }
    }
    starts.push_back(u);
    Fit chosen;
    bool first = true;
    for (const VectorXd& s : starts)
        for (const bool staged : {true, false}) {
            if (!staged && !over_time(p)) continue;
            Fit f = fit(p, w, h, to_theta(h.unknowns, s), staged);
            if (first || f.objective() < chosen.objective()) chosen = std::move(f), first = false;
        }
    return chosen;
}

Fit evaluated(const Problem& p, const Whitener& w, const Hypothesised& h, const VectorXd& theta) {
    return finished(Solver{p, w, h, early_rows(p, 1.0), p.recorded}, to_u(h.unknowns, theta));
}

VectorXd standard_errors(const std::vector<Unknown>& list, const Fit& f) {
    VectorXd errors(f.theta.size());
    const VectorXd u = to_u(list, f.theta);
    for (Index k = 0; k < u.size(); ++k) {
        const Unknown& x = list[static_cast<std::size_t>(k)];
        const double slope = (value_at(x, u[k] + 1e-6) - value_at(x, u[k] - 1e-6)) / 2e-6;
        errors[k] = std::abs(slope) * std::sqrt(f.covariance(k, k));
    }
    return errors;
}

}  // namespace diagnose
