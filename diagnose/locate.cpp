// SPDX-License-Identifier: MIT
#include "diagnose/locate.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Where the first unknown of a term is such that it does nothing; NaN where that is the low end.
double null_value(const Term& t, const Hypothesised& h, const Fit& f) {
    if (t.effect == "velocity_dependent_friction") {
        for (std::size_t k = 0; k < h.unknowns.size(); ++k)
            if (h.unknowns[k].key == "sliding_friction") return f.theta[static_cast<Index>(k)];
        return std::nan("");
    }
    return t.two_sided && !t.unknowns.empty() ? t.unknowns.front().start : std::nan("");
}

struct ShapeMaker {
    const Problem& problem;
    const Whitener& whiten;
    const Hypothesised& h;
    const Fit& fit;
    const Projection& project;

    VectorXd shape(const Hypothesised& with, const VectorXd& own) const {
        VectorXd theta(static_cast<Index>(with.unknowns.size()));
        for (Index k = 0; k < theta.size() - own.size(); ++k)
            for (std::size_t n = 0; n < h.unknowns.size(); ++n)
                if (h.unknowns[n].name == with.unknowns[static_cast<std::size_t>(k)].name)
                    theta[k] = fit.theta[static_cast<Index>(n)];
        theta.tail(own.size()) = own;
        VectorXd d = predicted(problem, with, theta) - fit.prediction;
        return project(whiten(d));
    }
};

}  // namespace

double normal_of_squares(double sum, double count) {
    return (std::cbrt(sum / count) - (1.0 - 2.0 / (9.0 * count))) / std::sqrt(2.0 / (9.0 * count));
}

Projection::Projection(const std::vector<Unknown>& unknowns, const Fit& f) : jacobian_(f.jacobian) {
    MatrixXd normal = jacobian_.transpose() * jacobian_;
    for (Index k = 0; k < normal.rows(); ++k)
        normal(k, k) += unknowns[static_cast<std::size_t>(k)].prior == Prior::gaussian
                            ? 1.0
                            : 1e-9 * (1.0 + normal(k, k));
    gain_ = normal.ldlt().solve(jacobian_.transpose());
}

VectorXd Projection::operator()(const VectorXd& white) const {
    if (jacobian_.cols() == 0) return white;
    return white - jacobian_ * (gain_ * white);
}

std::vector<Shape> shapes(const Problem& p, const Whitener& w, const Hypothesised& h, const Fit& f,
                          const std::vector<Term>& terms) {
    constexpr double visible = 4.0;
    const Projection project(h.unknowns, f);
    const ShapeMaker maker{p, w, h, f, project};
    std::vector<Shape> list;
    const auto add = [&](std::size_t term, bool two_sided, const VectorXd& d) {
        const double size = d.norm();
        if (size > 1e-3 && std::isfinite(size)) list.push_back({term, two_sided, d / size});
    };
    for (std::size_t t = 0; t < terms.size(); ++t) {
        const Term& term = terms[t];
        if (std::find(h.terms.begin(), h.terms.end(), &term) != h.terms.end()) continue;
        std::vector<const Term*> with = h.terms;
        with.push_back(&term);
        const Hypothesised extended = p.hypothesis(std::move(with));
        const auto n = static_cast<Index>(term.unknowns.size());
        if (n == 0) {
            add(t, false, maker.shape(extended, VectorXd(0)));
            continue;
        }
        // The further unknowns on a coarse grid, the first at strengths around what is visible.
        std::vector<VectorXd> grid{VectorXd::Zero(n)};
        for (Index k = 1; k < n; ++k) {
            const Unknown& x = term.unknowns[static_cast<std::size_t>(k)];
            const int count = x.key == "frequency" ? 24 : x.key == "phase" ? 4 : 3;
            std::vector<VectorXd> finer;
            for (const VectorXd& g : grid)
                for (int c = 0; c < count; ++c)
                    finer.push_back(g), finer.back()[k] = (c + 0.5) / count;
            grid = std::move(finer);
        }
        const double nothing = null_value(term, h, f);
        for (VectorXd u : grid) {
            if (std::isfinite(nothing)) {
                VectorXd own = to_theta(term.unknowns, u);
                own[0] = std::min(nothing + 0.004 * (term.unknowns[0].high - term.unknowns[0].low),
                                  term.unknowns[0].high);
                add(t, true, maker.shape(extended, own));
                if (term.effect != "velocity_dependent_friction") continue;
                // A grain that grips feels nothing of a little more or less friction.
                for (const double share : {0.1, 0.3, 3.0}) {
                    own[0] =
                        std::clamp(share * nothing, term.unknowns[0].low, term.unknowns[0].high);
                    add(t, false, maker.shape(extended, own));
                }
                continue;
            }
            const bool falling = term.effect == "plastic_restitution";  // strongest at the low end
            const auto size_at = [&](double strength) {
                u[0] = falling ? 1.0 - strength : strength;
                return maker.shape(extended, to_theta(term.unknowns, u));
            };
            if (term.effect == "vibration") {  // linear in its amplitude, and its grid is large
                add(t, true, size_at(0.4));
                continue;
            }
            VectorXd weakest;
            double low = 0.0;
            for (const double strength : {0.15, 0.3, 0.45, 0.6, 0.75, 0.9}) {
                const VectorXd d = size_at(strength);
                if (d.norm() < visible) {
                    low = strength;
                    continue;
                }
                double a = low, b = strength;
                weakest = d;
                for (int k = 0; k < 4; ++k) {
                    const double middle = 0.5 * (a + b);
                    const VectorXd e = size_at(middle);
                    if (e.norm() < visible)
                        a = middle;
                    else
                        b = middle, weakest = e;
                }
                add(t, false, weakest);
                add(t, false, size_at(std::min(1.0, b + 0.12)));
                break;
            }
        }
    }
    return list;
}

namespace {

// A heap that leans: the half of the turn on which it is too high. `cosine` and `sine` are rows of its channels.
Located lean(const Record& r, const Channel& cosine, const Channel& sine,
             const VectorXd& difference, double p_value) {
    double along = 0.0, across = 0.0, squares = 0.0, count = 0.0;
    for (std::size_t k = 0; k < cosine.recorded.size(); ++k) {
        if (!std::isfinite(cosine.recorded[k])) continue;
        const double a = difference[static_cast<Index>(cosine.first + k)],
                     b = difference[static_cast<Index>(sine.first + k)];
        along += a, across += b, squares += a * a + b * b, count += 1.0;
    }
    const double middle = std::atan2(across, along), quarter = 0.5 * std::numbers::pi;
    return {.experiment = r.experiment->id,
            .channel = "z",
            .variable = "azimuth",
            .unit = "rad",
            .from = middle - quarter,
            .to = middle + quarter,
            .sign = 1,
            .size = std::sqrt(squares / std::max(1.0, count)),
            .size_unit = "m",
            .p_value = p_value};
}

}  // namespace

std::vector<Located> located(const Problem& p, const VectorXd& white, const VectorXd& difference,
                             double p_value) {
    const double all = white.squaredNorm();
    std::map<std::string, double> of_channel;  // squares in all recordings
    std::vector<std::pair<double, Located>> list;
    for (const Record& r : p.records) {
        for (const Channel& c : r.channels) {
            if (c.name == "z_sin") continue;
            std::vector<std::pair<double, Index>> rows;
            double total = 0.0;
            for (std::size_t k = 0; k < c.recorded.size(); ++k) {
                if (!std::isfinite(c.recorded[k])) continue;
                const auto at = static_cast<Index>(c.first + k);
                rows.push_back({r.ordinates.at[k], at});
                total += white[at] * white[at];
            }
            if (c.name == "z_cos") {
                const Channel& sine = (&c)[1];  // they come together
                total += white
                             .segment(static_cast<Index>(sine.first),
                                      static_cast<Index>(sine.recorded.size()))
                             .squaredNorm();
                of_channel["azimuth"] += total;
                if (total >= 0.02 * all && total > 0.0)
                    list.push_back({total, lean(r, c, sine, difference, p_value)});
                continue;
            }
            of_channel[c.name] += total;
            if (rows.size() < 2 || total < 0.02 * all || total <= 0.0) continue;
            std::stable_sort(rows.begin(), rows.end(),
                             [](const auto& a, const auto& b) { return a.first < b.first; });
            std::size_t best_from = 0, best_to = rows.size() - 1, from = 0;
            double inside = 0.0;
            for (std::size_t to = 0; to < rows.size(); ++to) {
                inside += white[rows[to].second] * white[rows[to].second];
                while (from < to && inside - white[rows[from].second] * white[rows[from].second] >=
                                        0.8 * total) {
                    inside -= white[rows[from].second] * white[rows[from].second];
                    ++from;
                }
                if (inside >= 0.8 * total &&
                    rows[to].first - rows[from].first < rows[best_to].first - rows[best_from].first)
                    best_from = from, best_to = to;
            }
            double signed_sum = 0.0, squares = 0.0;
            for (std::size_t k = best_from; k <= best_to; ++k) {
                const double d = difference[rows[k].second];
                signed_sum += d * std::abs(d), squares += d * d;
            }
            list.push_back(
                {total,
                 {.experiment = r.experiment->id,
                  .channel = c.name,
                  .variable = r.ordinate,
                  .unit = r.ordinate == "t"       ? "s"
                          : r.ordinate == "angle" ? "rad"
                                                  : "m",
                  .from = rows[best_from].first,
                  .to = rows[best_to].first,
                  .sign = signed_sum >= 0.0 ? 1 : -1,
                  .size = std::sqrt(squares / static_cast<double>(best_to - best_from + 1)),
                  .size_unit = unit_of_channel(c.name),
                  .p_value = p_value}});
        }
    }
    std::stable_sort(list.begin(), list.end(), [&](const auto& a, const auto& b) {
        const auto squares = [&](const Located& l) {
            return of_channel[l.variable == "azimuth" ? l.variable : l.channel];
        };
        const double one = squares(a.second), other = squares(b.second);
        return one != other ? one > other : a.first > b.first;
    });
    std::vector<Located> result;
    for (auto& entry : list) result.push_back(std::move(entry.second));
    return result;
}

}  // namespace diagnose
