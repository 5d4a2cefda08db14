// SPDX-License-Identifier: MIT
#include "diagnose/missing.hpp"

#include "diagnose/locate.hpp"
#include "diagnose/starts.hpp"

#include <Eigen/Cholesky>

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

constexpr std::size_t force_knots = 8, restitution_knots = 6;

struct Range {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    std::set<std::string> rigs{};
    void take(double v) {
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    }
};

Term term_of(const std::string& variable, const std::vector<double>& knots, bool of_restitution) {
    Term t{.effect = "unknown",
           .unknowns = {},
           .two_sided = true,
           .missing_variable = variable,
           .missing_knots = knots,
           .of_restitution = of_restitution};
    for (std::size_t k = 0; k < knots.size(); ++k)
        t.unknowns.push_back(
            {.name = (of_restitution ? "share_" : "force_") + std::to_string(k + 1),
             .unit = of_restitution ? "1" : "N",
             .target =
                 of_restitution ? Target::missing_restitution_knot : Target::missing_force_knot,
             .prior = Prior::gaussian,
             .index = k});
    return t;
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
        terms.push_back(term_of(name, evenly(range.low, range.high, force_knots), false));
        terms.back().missing_rigs = range.rigs;
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
    terms.push_back(
        term_of("impact_angle", evenly(0.0, 0.5 * std::numbers::pi, restitution_knots), true));
    terms.back().missing_rigs = speed.rigs;
    if (!(speed.high > 1.05 * speed.low)) return;
    terms.push_back(term_of(
        "impact_speed",
        in_equal_ratios(std::max(speed.low, speed.high / widest), speed.high, restitution_knots),
        true));
    terms.back().missing_rigs = speed.rigs;
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

// Size of the knots, in units, of greatest evidence at first order: log det(1 + s^2 A) and b' (A + 1/s^2)^-1 b.
double likeliest_size(const MatrixXd& slopes, const VectorXd& left) {
    const MatrixXd a = slopes.transpose() * slopes;
    const VectorXd b = slopes.transpose() * left;
    double best = std::numeric_limits<double>::lowest(), chosen = 1.0;
    for (double s = 1e-4; s < 300.0; s *= 2.0) {
        MatrixXd m = a;
        m.diagonal().array() += 1.0 / (s * s);
        const Eigen::LDLT<MatrixXd> ldlt(m);
        const double log_det = ldlt.vectorD().array().abs().log().sum() +
                               2.0 * static_cast<double>(b.size()) * std::log(s);
        const double log_z = 0.5 * b.dot(ldlt.solve(b)) - 0.5 * log_det;
        if (log_z > best) best = log_z, chosen = s;
    }
    return chosen;
}

}  // namespace

std::vector<Candidate> with_missing(const Problem& p, const Whitener& w, const Candidate& start,
                                    std::vector<Term>& terms) {
    terms.clear();
    add_forces(p, start, terms);
    add_restitutions(p, start, terms);
    const Footing on{p, w, start.h, start.fit};
    const Projection project(start.h.unknowns, start.fit);
    const VectorXd left = project(start.fit.white);
    const double force = unit_of_force(p);
    std::vector<Candidate> all;
    for (Term& term : terms) {
        const double unit = term.of_restitution ? 1.0 : force;
        const auto set_size = [&](double size) {
            for (Unknown& u : term.unknowns)
                u.deviation = size * unit, u.low = -100.0 * u.deviation,
                u.high = 100.0 * u.deviation;
            return plus(p, start.h, term);
        };
        Hypothesised h = set_size(1.0);
        const auto knots = static_cast<Index>(term.unknowns.size());
        MatrixXd slopes(static_cast<Index>(p.size), knots);
        for (Index k = 0; k < knots; ++k) {
            VectorXd own = VectorXd::Zero(knots);
            own[k] = 1e-3 * unit;
            const VectorXd up = predicted(p, h, carried(on, h, own));
            const VectorXd down = predicted(p, h, carried(on, h, -own));
            slopes.col(k) = project(w((up - down) / 2e-3));
        }
        h = set_size(likeliest_size(slopes, left));
        Candidate c{.h = h, .fit = fit(p, w, h, carried(on, h, VectorXd::Zero(knots)), false, 10)};
        // The size was chosen among some 20, the variable among those there are, and neighbours of the best do well, too.
        c.log_evidence = c.fit.log_evidence - 4.0;
        all.push_back(std::move(c));
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& x, const auto& y) { return x.log_evidence > y.log_evidence; });
    return all;
}

}  // namespace diagnose
