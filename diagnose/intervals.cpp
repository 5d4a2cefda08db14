// SPDX-License-Identifier: MIT
#include "diagnose/intervals.hpp"

#include "diagnose/catalogue.hpp"
#include "diagnose/words.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double deviations = 1.645;  // two-sided 90 %

// u at which the least objective has risen by 1.645^2 on one side of the fit; the end where it does not.
double bound(const Problem& p, const Whitener& w, const Candidate& c, Index k, double side) {
    const Unknown& x = c.h.unknowns[static_cast<std::size_t>(k)];
    const double best = to_u(c.h.unknowns, c.fit.theta)[k];
    const double room = x.turns ? 0.5 : side > 0.0 ? highest(x) - best : best - lowest(x);
    // The others follow the valley: at first order from the fit, then on the way they went last.
    VectorXd here = to_u(c.h.unknowns, c.fit.theta);
    VectorXd along = side * c.fit.covariance.col(k) / c.fit.covariance(k, k);
    double reach = deviations * std::sqrt(c.fit.covariance(k, k));
    double inside = 0.0, rise_inside = 0.0, outside = -1.0, rise_outside = 0.0;  // sqrt of the rise
    for (int n = 0; n < 6; ++n) {
        reach = std::min(reach, room);
        const VectorXd start = to_theta(c.h.unknowns, here + (reach - inside) * along);
        const Place held = fit_holding(p, w, c.h, start, k, best + side * reach, 15);
        const double rise = std::sqrt(std::max(0.0, held.objective - c.fit.objective()));
        if (rise < deviations) {
            if (reach >= room) return best + side * room;
            const VectorXd& there = held.u;
            if (reach > inside) along = (there - here) / (reach - inside);
            inside = reach, rise_inside = rise, here = there;
        } else {
            outside = reach, rise_outside = rise;
        }
        if (outside < 0.0) {
            reach *= std::clamp(deviations / std::max(rise, 0.1), 1.2, 4.0);
            continue;
        }
        reach =
            inside + (outside - inside) * (deviations - rise_inside) / (rise_outside - rise_inside);
        if (outside - inside < 0.1 * outside) break;
    }
    return best + side * std::min(reach, room);
}

double at(const Candidate& c, Index k, double u) {
    VectorXd all = to_u(c.h.unknowns, c.fit.theta);
    all[k] = u;
    return to_theta(c.h.unknowns, all)[k];
}

struct Ends {
    double low, high;  // u
};

// At first order, cut at the hard ends.
Ends first_order(const std::vector<Unknown>& unknowns, const Fit& f, Index k) {
    const Unknown& x = unknowns[static_cast<std::size_t>(k)];
    const double u = to_u(unknowns, f.theta)[k];
    const double reach = deviations * std::sqrt(f.covariance(k, k));
    return {std::max(u - reach, lowest(x)), std::min(u + reach, highest(x))};
}

// The user's drag factor as the coefficient of the fastest sphere.
Estimate told(const Problem& p, const Candidate& c, const Unknown& x, Estimate e) {
    if (x.key != "drag_factor") return e;
    const double cd = drag_coefficient(p, c.h, c.fit.theta, 1.0);
    return {"drag_coefficient", e.unit, e.value * cd, e.low * cd, e.high * cd};
}

// A fall shows only the part along x of a tilt: the plate may lean further, to any side. With every azimuth alike, nine of ten
// lie within 81 degrees of x.
void open_azimuth(const Problem& p, std::vector<Estimate>& list) {
    constexpr double widest = 81.0 / 180.0 * std::numbers::pi;
    const bool falls = std::all_of(p.records.begin(), p.records.end(),
                                   [](const Record& r) { return r.experiment->rig == "drop"; });
    if (!falls || list.size() != 1 || list.front().name != "tilt_angle") return;
    Estimate& e = list.front();
    const double azimuth = e.value < 0.0 ? std::numbers::pi : 0.0;
    const double a = std::abs(e.low), b = std::abs(e.high);
    const double least = e.low * e.high < 0.0 ? 0.0 : std::min(a, b);
    e = {e.name, e.unit, std::abs(e.value), least,
         std::min(0.5 * std::numbers::pi, std::max(a, b) / std::cos(widest))};
    list.push_back({"tilt_azimuth", "rad", azimuth, azimuth - widest, azimuth + widest});
}

}  // namespace

std::vector<Estimate> estimates(const Problem& p, const Whitener& w, const Candidate& c,
                                const Term& term) {
    std::size_t last = c.h.unknowns.size(), first = last;
    for (std::size_t k = c.h.terms.size(); k-- > 0;) {
        first = last - c.h.terms[k]->unknowns.size();
        if (c.h.terms[k] == &term) break;
        last = first;
    }
    // Other minima as good as that belong to the interval, too.
    std::vector<Fit> others;
    for (const VectorXd& theta : c.modes) {
        Fit f = fit(p, w, c.h, theta, false, 8);
        if (f.objective() < c.fit.objective() + deviations * deviations)
            others.push_back(std::move(f));
    }
    std::vector<Estimate> list;
    for (std::size_t k = first; k < last; ++k) {
        const auto i = static_cast<Index>(k);
        const Unknown& x = c.h.unknowns[k];
        double a = bound(p, w, c, i, -1.0), b = bound(p, w, c, i, 1.0);
        for (const Fit& f : others) {
            const Ends there = first_order(c.h.unknowns, f, i);
            a = std::min(a, there.low), b = std::max(b, there.high);
        }
        a = at(c, i, a), b = at(c, i, b);
        list.push_back(told(p, c, x, {x.name, x.unit, c.fit.theta[i], a, b}));
    }
    open_azimuth(p, list);
    return list;
}

std::vector<Estimate> refitted(const Problem& p, const Candidate& c) {
    std::size_t last = c.h.unknowns.size();
    for (const Term* t : c.h.terms) last -= t->unknowns.size();
    std::vector<Estimate> list;
    for (std::size_t k = 0; k < last; ++k) {
        const auto i = static_cast<Index>(k);
        const Unknown& x = c.h.unknowns[k];
        const Ends ends = first_order(c.h.unknowns, c.fit, i);
        list.push_back(told(
            p, c, x, {x.name, x.unit, c.fit.theta[i], at(c, i, ends.low), at(c, i, ends.high)}));
    }
    return list;
}

MissingEstimate missing_of(const Candidate& c) {
    const Term& term = *c.h.terms.back();
    MissingEstimate m{.variable = term.missing_variable,
                      .unit = "",
                      .knots = term.missing_knots,
                      .values = missing_at(c.h, c.fit.theta, term),
                      .low = {},
                      .high = {},
                      .words = "",
                      .of = term.missing,
                      .unit_of_values = term.unknowns.front().unit,
                      .channel = term.channel};
    m.unit = m.variable == "t"                                       ? "s"
             : m.variable.ends_with("speed") || m.variable == "slip" ? "m/s"
             : m.variable == "spin"                                  ? "rad/s"
             : m.variable == "impact_angle"                          ? "rad"
                                                                     : "m";
    const auto n = static_cast<Index>(term.unknowns.size());
    const Eigen::MatrixXd covariance = c.fit.covariance.bottomRightCorner(n, n);
    for (std::size_t j = 0; j < m.knots.size(); ++j) {
        VectorXd shape(n);  // in deviations of each unknown, as the covariance is
        for (Index k = 0; k < n; ++k) {
            const auto at = static_cast<std::size_t>(k);
            shape[k] = term.unknowns[at].deviation * term.missing_shapes[at][j];
        }
        const double error = std::sqrt(shape.dot(covariance * shape));
        m.low.push_back(m.values[j] - deviations * error);
        m.high.push_back(m.values[j] + deviations * error);
    }
    m.words = described(m);
    return m;
}

}  // namespace diagnose
