// SPDX-License-Identifier: MIT
#include "prove/heap_response.hpp"

#include "prove/dice.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace prove {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;
constexpr std::array<double, 5> base_frictions{0.15, 0.25, 0.4, 0.6, 0.9};
constexpr std::array<double, 3> effect_frictions{0.2, 0.42, 0.85};
constexpr int base_seeds = 3;

Eigen::RowVector3d base_row(double friction) {
    const double x = std::log(friction);
    return {1.0, x, x * x};
}
// Steep at first: adhesion and rolling resistance saturate.
double growth(double share) { return std::log1p(4.0 * share) / std::log(5.0); }
Eigen::RowVector4d effect_row(double share, double friction) {
    const double t = growth(share), x = std::log(friction);
    return {t, t * t, t * x, t * t * x};
}

std::size_t ring_of(std::size_t radius) {
    return radius * static_cast<std::size_t>(ring_count) / spot_radii;
}

// [runs, values] fitted as base and effects; the residuals are left in `values`. `uncertain` as in Response.
void fit(const std::vector<DesignPour>& design, const std::map<std::string, double>& largest,
         MatrixXd& values, MatrixXd& base, std::map<std::string, MatrixXd>& effects,
         std::map<std::string, MatrixXd>& uncertain) {
    std::vector<Index> rows;
    for (std::size_t k = 0; k < design.size(); ++k)
        if (design[k].effect.empty()) rows.push_back(static_cast<Index>(k));
    MatrixXd left(rows.size(), 3);
    for (std::size_t k = 0; k < rows.size(); ++k)
        left.row(static_cast<Index>(k)) =
            base_row(design[static_cast<std::size_t>(rows[k])].friction);
    const MatrixXd of_base = left.colPivHouseholderQr().solve(values(rows, Eigen::all));
    base = of_base.transpose();
    const MatrixXd known = (left.transpose() * left).inverse();
    uncertain[""] = known;
    for (std::size_t k = 0; k < design.size(); ++k)
        values.row(static_cast<Index>(k)) -= base_row(design[k].friction) * of_base;
    for (const auto& [name, most] : largest) {
        rows.clear();
        for (std::size_t k = 0; k < design.size(); ++k)
            if (design[k].effect == name) rows.push_back(static_cast<Index>(k));
        MatrixXd terms(rows.size(), 4), under(rows.size(), 3);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const DesignPour& p = design[static_cast<std::size_t>(rows[k])];
            terms.row(static_cast<Index>(k)) = effect_row(p.strength / most, p.friction);
            under.row(static_cast<Index>(k)) = base_row(p.friction);
        }
        const MatrixXd of_effect = terms.colPivHouseholderQr().solve(values(rows, Eigen::all));
        // The effect's coefficients are those of what these runs have less the base that other runs tell.
        const MatrixXd squares = (terms.transpose() * terms).inverse();
        const MatrixXd by_base = -squares * terms.transpose() * under;
        MatrixXd both(7, 7);
        both << known, known * by_base.transpose(), by_base * known,
            squares + by_base * known * by_base.transpose();
        uncertain[name] = both;
        effects[name] = of_effect.transpose();
        values(rows, Eigen::all) -= terms * of_effect;
    }
}

// m^2: variances that white noise of the instrument gives the features.
VectorXd instrument(const Arrangement& a) {
    VectorXd v = VectorXd::Zero(feature_count);
    double weight = 0.0, square = 0.0;
    VectorXd seen = VectorXd::Zero(ring_count);
    for (std::size_t k = 0; k < a.spots.size(); ++k) {
        seen[static_cast<Index>(ring_of(k % spot_radii))] += 1.0;
        weight += a.spots[k].r, square += a.spots[k].r * a.spots[k].r;
    }
    v.head(ring_count).array() = 1.0 / seen.array();
    v.segment(ring_count, 2).setConstant(2.0 * square / (weight * weight));
    v[feature_count - 1] = 0.5 / static_cast<double>(a.spots.size());
    return a.noise * a.noise * v;
}

// One world of the design's catalogue.
struct Told {
    std::string effect;
    double strength, friction, azimuth;
};

VectorXd mean_of(const Response& r, const Told& w) {
    return mean_features(r, w.effect, w.strength, w.friction, w.azimuth);
}

// What the mean there weighs each coefficient with, those of the base first.
VectorXd weights(const Response& r, const Told& w) {
    const bool acts = r.effects.contains(w.effect);
    VectorXd all(acts ? 7 : 3);
    all.head(3) = base_row(w.friction).transpose();
    if (acts) all.tail(4) = effect_row(w.strength / r.largest.at(w.effect), w.friction).transpose();
    if (w.effect == "measurement_scale") all *= 1.0 + w.strength;
    return all;
}

// What r' S^-1 r of the two means has on average by their own uncertainty. Two effects share the runs of the base alone.
double by_uncertainty(const Response& r, const Told& a, const Told& b) {
    if (r.uncertain.empty()) return 0.0;
    const auto of = [&](const Told& w) -> const MatrixXd& {
        return r.uncertain.at(r.effects.contains(w.effect) ? w.effect : "");
    };
    const MatrixXd &x = of(a), &y = of(b);
    const VectorXd u = weights(r, a), v = weights(r, b);
    double share = u.dot(x * u) + v.dot(y * v);
    if (&x == &y)
        share -= 2.0 * u.dot(x * v);
    else  // columns of the base: how it goes with each's own coefficients
        share -= 2.0 * (x.leftCols(3).transpose() * u)
                           .dot(r.uncertain.at("").ldlt().solve(y.leftCols(3).transpose() * v));
    return r.scatter * share;
}

// Least r' S^-1 r over the user's frictions, less what uncertainty adds there.
struct Least {
    double value, friction;
};
Least least(const HeapFamily& f, const std::vector<Response>& responses, const Told& truth,
            const std::string& effect, double strength, double azimuth) {
    constexpr int steps = 150;
    Least best{1e300, f.low};
    std::vector<VectorXd> means;
    for (const Response& r : responses) means.push_back(mean_of(r, truth));
    for (int k = 0; k <= steps; ++k) {
        const double friction = f.low + (f.high - f.low) * k / steps;
        double sum = 0.0;
        for (std::size_t a = 0; a < responses.size(); ++a) {
            const VectorXd r =
                means[a] - mean_of(responses[a], {effect, strength, friction, azimuth});
            sum += repeats * r.dot(responses[a].inverse_covariance * r);
        }
        if (sum < best.value) best = {sum, friction};
    }
    for (const Response& r : responses)
        best.value -=
            repeats * by_uncertainty(r, truth, {effect, strength, best.friction, azimuth});
    best.value = std::max(0.0, best.value);
    return best;
}

}  // namespace

std::vector<DesignPour> heap_design(std::uint64_t seed, const HeapFamily& f,
                                    std::size_t arrangement) {
    std::vector<DesignPour> all;
    const auto add = [&](const std::string& effect, double strength, double friction) {
        Dice dice(seed, static_cast<std::uint64_t>(f.number) * 1000 + all.size(), 31 + arrangement);
        all.push_back(
            {effect, strength, friction, static_cast<std::uint64_t>(dice.uniform() * 9e15)});
    };
    for (const double friction : base_frictions)
        for (int k = 0; k < base_seeds; ++k) add("", 0.0, friction);
    for (const HeapEffect& e : heap_effects(f))
        if (acts_among_grains(e.name))
            for (const double friction : effect_frictions)
                for (const double strength : {e.low, std::sqrt(e.low * e.high), e.high})
                    add(e.name, strength, friction);
    return all;
}

VectorXd heap_features(const Arrangement& a, const std::vector<double>& heights) {
    VectorXd f = VectorXd::Zero(feature_count);
    VectorXd seen = VectorXd::Zero(ring_count);
    double weight = 0.0;
    for (std::size_t k = 0; k < heights.size(); ++k) {
        const auto ring = static_cast<Index>(ring_of(k % spot_radii));
        f[ring] += heights[k], seen[ring] += 1.0;
        f[ring_count] += 2.0 * a.spots[k].r * heights[k] * std::cos(a.spots[k].azimuth);
        f[ring_count + 1] += 2.0 * a.spots[k].r * heights[k] * std::sin(a.spots[k].azimuth);
        weight += a.spots[k].r;
    }
    f.head(ring_count).array() /= seen.array();
    f.segment(ring_count, 2) /= weight;
    double rough = 0.0;
    for (std::size_t j = 0; j < spot_radii; ++j) {
        double mean = 0.0, square = 0.0;
        for (std::size_t k = j; k < heights.size(); k += spot_radii)
            mean += heights[k], square += heights[k] * heights[k];
        const auto n = static_cast<double>(spot_azimuths);
        mean /= n;
        rough += std::max(0.0, square / n - mean * mean);
    }
    f[feature_count - 1] = std::sqrt(rough / static_cast<double>(spot_radii));
    return f;
}

Response heap_response(const HeapFamily& f, const Arrangement& a,
                       const std::vector<DesignPour>& design, const std::vector<VectorXd>& features,
                       const std::vector<std::vector<double>>& heights) {
    Response r;
    for (const HeapEffect& e : heap_effects(f))
        if (acts_among_grains(e.name)) r.largest[e.name] = e.high;
    const auto runs = static_cast<Index>(design.size());
    const double unknowns = 3.0 + 4.0 * static_cast<double>(r.largest.size());
    const double freedom = static_cast<double>(design.size()) - unknowns;
    MatrixXd values(runs, feature_count);
    for (Index k = 0; k < runs; ++k)
        values.row(k) = features[static_cast<std::size_t>(k)].transpose();
    fit(design, r.largest, values, r.base, r.effects, r.uncertain);
    MatrixXd covariance = values.transpose() * values / freedom;
    // A covariance from some thirty degrees of freedom is drawn a fifth towards its own diagonal (Ledoit & Wolf 2004).
    constexpr double shrink = 0.2;
    const MatrixXd diagonal = covariance.diagonal().asDiagonal();
    covariance = (1.0 - shrink) * covariance + shrink * diagonal;
    const MatrixXd seeds = covariance;
    covariance.diagonal() += instrument(a);
    r.inverse_covariance = covariance.inverse();
    r.scatter = (r.inverse_covariance * seeds).trace();
    MatrixXd spots(runs, static_cast<Index>(heights.front().size()));
    for (Index k = 0; k < runs; ++k)
        for (Index j = 0; j < spots.cols(); ++j)
            spots(k, j) = heights[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)];
    MatrixXd unused;
    std::map<std::string, MatrixXd> none, neither;
    fit(design, r.largest, spots, unused, none, neither);
    r.spot_scatter = std::sqrt(spots.squaredNorm() / (freedom * static_cast<double>(spots.cols())));
    return r;
}

VectorXd mean_features(const Response& r, const std::string& effect, double strength,
                       double friction, double azimuth) {
    VectorXd f = r.base * base_row(friction).transpose();
    if (effect == "measurement_offset") f.head(ring_count).array() += strength;
    if (const auto found = r.effects.find(effect); found != r.effects.end()) {
        VectorXd more =
            found->second * effect_row(strength / r.largest.at(effect), friction).transpose();
        // The design leans towards azimuth 0.
        const double along = more[ring_count], across = more[ring_count + 1];
        more[ring_count] = along * std::cos(azimuth) - across * std::sin(azimuth);
        more[ring_count + 1] = along * std::sin(azimuth) + across * std::cos(azimuth);
        f += more;
    }
    if (effect == "measurement_scale") f *= 1.0 + strength;
    return f;
}

double flank(const Arrangement& a, const VectorXd& f) {
    const double width = 0.5 * a.rig.base_diameter / static_cast<double>(ring_count);
    return (f[1] - f[ring_count - 1]) / (width * static_cast<double>(ring_count - 2));
}

double heap_lambda(const HeapFamily& f, const std::vector<Response>& responses,
                   const std::string& effect, double strength, double friction, double azimuth) {
    return least(f, responses, {effect, strength, friction, azimuth}, "", 0.0, 0.0).value;
}

Oracle heap_oracle(const HeapFamily& f, const std::vector<Response>& responses,
                   const std::string& effect, double strength, double friction, double azimuth) {
    const Told truth{effect, strength, friction, azimuth};
    const Least none = least(f, responses, truth, "", 0.0, 0.0);
    Oracle o{none.value, none.friction, std::sqrt(none.value), ""};
    double nearest = none.value;
    for (const HeapEffect& e : heap_effects(f)) {
        if (e.name == effect) continue;
        constexpr int strengths = 12, azimuths = 16;
        const int turns = e.name == "tilt" ? azimuths : 1;
        for (const double sign : {1.0, -1.0}) {
            if (sign < 0.0 && acts_among_grains(e.name)) continue;
            for (int k = 0; k < strengths; ++k)
                for (int turn = 0; turn < turns; ++turn) {
                    const double s =
                        sign * 0.5 * e.low * std::pow(2.0 * e.high / e.low, k / (strengths - 1.0));
                    const Least l =
                        least(f, responses, truth, e.name, s, 2.0 * pi * turn / azimuths);
                    if (l.value < nearest) nearest = l.value, o.nearest = e.name;
                }
        }
    }
    o.d = std::sqrt(nearest);
    return o;
}

}  // namespace prove
