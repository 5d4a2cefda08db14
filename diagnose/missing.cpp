// SPDX-License-Identifier: MIT
#include "diagnose/missing.hpp"

#include "diagnose/catalogue.hpp"
#include "diagnose/locate.hpp"
#include "diagnose/minima.hpp"
#include "diagnose/starts.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Size and length are chosen among some 120, the variable among those there are; neighbours of the best do well, too.
constexpr double looked_elsewhere = 4.0;  // log evidence

constexpr std::size_t force_knots = 8, restitution_knots = 6, drift_knots = 8;

struct Range {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    std::set<std::string> rigs{};
    void take(double v) {
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    }
};

Term term_of(Missing missing, const std::string& variable, std::vector<double> knots,
             const std::set<std::string>& rigs, const std::string& channel = {}) {
    return {.effect = "unknown",
            .channel = channel,
            .unknowns = {},
            .two_sided = true,
            .missing_variable = variable,
            .missing_rigs = rigs,
            .missing_knots = std::move(knots),
            .missing = missing};
}

std::vector<double> evenly(double low, double high, std::size_t count) {
    const VectorXd all = VectorXd::LinSpaced(static_cast<Index>(count), low, high);
    return {all.begin(), all.end()};
}

std::vector<double> in_equal_ratios(double low, double high, std::size_t count) {
    std::vector<double> list = evenly(std::log(low), std::log(high), count);
    for (double& v : list) v = std::exp(v);
    return list;
}

// Forces: every variable of the state over all recordings that have it. No one force acts for long in an impact.
void add_forces(const Problem& p, const Candidate& start, std::vector<Term>& terms) {
    std::map<std::string, Range> ranges;
    for (const Record& r : p.records) {
        if (r.experiment->rig == "impact" || r.covariance.size() > 0) continue;
        for (const auto& [name, values] :
             r.model->variables(world_at(p, start.h, start.fit.theta, r), r.ordinates)) {
            if (name == "impact_speed") continue;
            ranges[name].rigs.insert(r.experiment->rig);
            for (const double v : values) ranges[name].take(v);
        }
    }
    for (const auto& [name, range] : ranges) {
        if (!(range.high > range.low)) continue;
        terms.push_back(
            term_of(Missing::force, name, evenly(range.low, range.high, force_knots), range.rigs));
    }
}

// Shares of the rebound: over the angle of the way in, and over the normal speed, in equal ratios of it.
void add_restitutions(const Problem& p, const Candidate& start, std::vector<Term>& terms) {
    constexpr double widest = 30.0;  // ratio of speeds: slower impacts show little
    Range speed;
    for (const Record& r : p.records) {
        const std::string& rig = r.experiment->rig;
        if (r.covariance.size() > 0 || (rig != "drop" && rig != "impact")) continue;
        speed.rigs.insert(rig);
        const rigs::Curves state =
            r.model->variables(world_at(p, start.h, start.fit.theta, r), r.ordinates);
        for (const double v : state.at(rig == "drop" ? "impact_speed" : "normal_speed"))
            if (v > 0.0) speed.take(v);
    }
    if (speed.rigs.empty()) return;
    terms.push_back(term_of(Missing::restitution, "impact_angle",
                            evenly(0.0, 0.5 * std::numbers::pi, restitution_knots), speed.rigs));
    if (!(speed.high > 1.05 * speed.low)) return;
    terms.push_back(term_of(
        Missing::restitution, "impact_speed",
        in_equal_ratios(std::max(speed.low, speed.high / widest), speed.high, restitution_knots),
        speed.rigs));
}

// Drifts: of each channel that is read over time, alike in all recordings of a rig. What settles after a start does so fast at
// first: knots go with the square.
void add_drifts(const Problem& p, std::vector<Term>& terms) {
    std::map<std::pair<std::string, std::string>, double> last;  // s, by rig and channel
    for (const Record& r : p.records) {
        if (r.ordinate != "t" || r.covariance.size() > 0) continue;
        for (const Channel& c : r.channels) {
            double& end = last[{r.experiment->rig, c.name}];
            end = std::max(end, *std::max_element(r.ordinates.at.begin(), r.ordinates.at.end()));
        }
    }
    for (const auto& [where, end] : last) {
        if (!(end > 0.0 && channel_range(p, where.second) > 0.0)) continue;
        std::vector<double> knots = evenly(0.0, 1.0, drift_knots);
        for (double& k : knots) k *= k * end;
        terms.push_back(term_of(Missing::drift, "t", knots, {where.first}, where.second));
    }
}

// N that forces are measured by: a grain's weight, or a twentieth of the largest force recorded.
double unit_of_force(const Problem& p) {
    double unit = 0.0;
    for (const Record& r : p.records) {
        if (r.experiment->rig == "impact" || r.covariance.size() > 0) continue;
        const double d = r.experiment->grain.diameter.value.value();
        unit = std::max(unit, r.experiment->grain.density.value.value() * std::numbers::pi / 6.0 *
                                  d * d * d * 9.81);
        if (r.experiment->rig == "pull_off")
            for (const double v : r.channels.front().recorded)
                if (std::isfinite(v)) unit = std::max(unit, 0.05 * std::abs(v));
    }
    return unit;
}

// A Gaussian about nothing over the values at n knots, whose correlation falls with their distance as exp(-x^2/2 l^2), l in
// knots: its main axes [n][axes], each as long as its deviation. l = 0: every knot by itself.
MatrixXd axes_of(Index n, double l) {
    MatrixXd k = MatrixXd::Identity(n, n);
    if (l > 0.0)
        for (Index a = 0; a < n; ++a)
            for (Index b = 0; b < n; ++b)
                k(a, b) = std::exp(-0.5 * static_cast<double>((a - b) * (a - b)) / (l * l));
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(k);
    constexpr double least = 1e-4;  // of the largest variance: shapes below it move nothing
    Index kept = 0;
    while (kept < n && eigen.eigenvalues()[n - 1 - kept] > least * eigen.eigenvalues()[n - 1])
        ++kept;
    MatrixXd axes(n, kept);
    for (Index m = 0; m < kept; ++m)
        axes.col(m) =
            eigen.eigenvectors().col(n - 1 - m) * std::sqrt(eigen.eigenvalues()[n - 1 - m]);
    return axes;
}

// What a term may be, of greatest evidence at first order: log det(1 + s^2 A) and b' (A + 1/s^2)^-1 b.
struct Guess {
    double log_evidence = std::numeric_limits<double>::lowest(), size = 1.0;
    MatrixXd axes{};
};

Guess likeliest(const MatrixXd& slopes, const VectorXd& left) {
    Guess best;
    for (const double share : {0.0, 0.1, 0.2, 0.4, 0.8, 1.6}) {  // of the range
        const MatrixXd axes = axes_of(slopes.cols(), share * static_cast<double>(slopes.cols()));
        const MatrixXd a = axes.transpose() * slopes.transpose() * slopes * axes;
        const VectorXd b = axes.transpose() * slopes.transpose() * left;
        for (double s = 1e-4; s < 300.0; s *= 2.0) {
            MatrixXd m = a;
            m.diagonal().array() += 1.0 / (s * s);
            const Eigen::LDLT<MatrixXd> ldlt(m);
            const double log_det = ldlt.vectorD().array().abs().log().sum() +
                                   2.0 * static_cast<double>(b.size()) * std::log(s);
            const double log_z = 0.5 * b.dot(ldlt.solve(b)) - 0.5 * log_det;
            if (log_z > best.log_evidence) best = {log_z, s, axes};
        }
    }
    return best;
}

// One unknown for each axis.
void set_shapes(Term& term, const MatrixXd& axes, double size) {
    const std::string unit = term.missing == Missing::force   ? "N"
                             : term.missing == Missing::drift ? unit_of_channel(term.channel)
                                                              : "1";
    term.unknowns.clear(), term.missing_shapes.clear();
    for (Index k = 0; k < axes.cols(); ++k) {
        term.unknowns.push_back({.name = fmt::format("shape_{}", k + 1),
                                 .unit = unit,
                                 .target = Target::missing_shape,
                                 .prior = Prior::gaussian,
                                 .low = -100.0 * size,
                                 .high = 100.0 * size,
                                 .deviation = size,
                                 .index = static_cast<std::size_t>(k)});
        const VectorXd shape = axes.col(k);
        term.missing_shapes.emplace_back(shape.begin(), shape.end());
    }
}

}  // namespace

std::vector<Candidate> with_missing(const Problem& p, const Whitener& w, const Candidate& start,
                                    std::vector<Term>& terms) {
    terms.clear();
    add_forces(p, start, terms);
    add_restitutions(p, start, terms);
    add_drifts(p, terms);
    const Footing on{p, w, start.h, start.fit};
    const Projection project(start.h.unknowns, start.fit);
    const VectorXd left = project(start.fit.white);
    const double force = unit_of_force(p);
    // Where a curve jumps the first order says little: larger sizes are tried, too.
    const std::vector<double> factors =
        has_force_curve(p) ? std::vector{1.0, 10.0, 100.0} : std::vector{1.0};
    std::vector<Candidate> all;
    for (Term& term : terms) {
        const double unit = term.missing == Missing::force   ? force
                            : term.missing == Missing::drift ? 0.01 * channel_range(p, term.channel)
                                                             : 1.0;
        const auto knots = static_cast<Index>(term.missing_knots.size());
        set_shapes(term, MatrixXd::Identity(knots, knots), unit);
        const Hypothesised each = plus(p, start.h, term);
        MatrixXd slopes(static_cast<Index>(p.size), knots);
        for (Index k = 0; k < knots; ++k) {
            VectorXd own = VectorXd::Zero(knots);
            own[k] = 1e-3 * unit;
            const VectorXd up = predicted(p, each, carried(on, each, own));
            const VectorXd down = predicted(p, each, carried(on, each, -own));
            slopes.col(k) = project(w((up - down) / 2e-3));
        }
        const Guess guess = likeliest(slopes, left);
        const VectorXd none = VectorXd::Zero(guess.axes.cols());
        Candidate c;
        for (const double factor : factors) {
            set_shapes(term, guess.axes, factor * guess.size * unit);
            const Hypothesised h = plus(p, start.h, term);
            Fit f = fit(p, w, h, carried(on, h, none), false, 10);
            const double evidence = f.log_evidence - looked_elsewhere;
            if (factor == 1.0 || evidence > c.log_evidence)
                c = {.h = h, .fit = std::move(f), .log_evidence = evidence};
        }
        all.push_back(std::move(c));
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& x, const auto& y) { return x.log_evidence > y.log_evidence; });
    return all;
}

}  // namespace diagnose
