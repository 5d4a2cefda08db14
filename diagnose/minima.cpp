// SPDX-License-Identifier: MIT
#include "diagnose/minima.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

bool has_range(const Unknown& x) { return x.prior != Prior::gaussian; }

// u with each unknown in turn put to the middles of equal parts of its range.
void along_ranges(const Hypothesised& h, const VectorXd& u, std::vector<VectorXd>& list) {
    constexpr int parts = 6;
    for (Index k = 0; k < u.size(); ++k) {
        if (!has_range(h.unknowns[static_cast<std::size_t>(k)])) continue;
        for (int n = 0; n < parts; ++n) list.push_back(u), list.back()[k] = (n + 0.5) / parts;
    }
}

// u with each unknown in turn a little off, by ever less: a grain that lets go one row later moves a force curve by a step, which
// no slope tells of.
void close_by(const Hypothesised& h, const VectorXd& u, std::vector<VectorXd>& list) {
    for (Index k = 0; k < u.size(); ++k) {
        if (!has_range(h.unknowns[static_cast<std::size_t>(k)])) continue;
        for (double step = 0.05; step > 5e-4; step *= 0.5)
            for (const double sign : {-1.0, 1.0}) list.push_back(u), list.back()[k] += sign * step;
    }
}

// Away from the fit along the directions that it leaves open, by some and by many deviations: bounces that come a little sooner or
// later make ripples on the floor of a valley.
void along_the_valley(const Fit& f, const VectorXd& u, std::vector<VectorXd>& list) {
    constexpr int points = 8;
    const Eigen::LLT<Eigen::MatrixXd> llt(f.covariance);
    if (llt.info() != Eigen::Success) return;
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (const double deviations : {3.0, 12.0, 48.0})
        for (int n = 0; n < points; ++n) {
            VectorXd way(u.size());
            for (double& x : way) x = normal(random);
            const VectorXd step = llt.matrixL() * way;
            list.push_back(u + deviations / std::sqrt(static_cast<double>(u.size())) * step);
        }
}

}  // namespace

bool has_force_curve(const Problem& p) {
    return std::any_of(p.records.begin(), p.records.end(),
                       [](const Record& r) { return r.experiment->rig == "pull_off"; });
}

Deeper deeper_minimum(const Problem& p, const Whitener& w, const Hypothesised& h, const Fit& from) {
    constexpr int rounds = 3, short_fit = 4, long_fit = 25;
    constexpr std::size_t fitted_out = 3;
    constexpr double promising = 40.0, worth_a_round = 0.5;  // in chi squared; in evidence
    const bool steps = has_force_curve(p);
    const double fresh = steps ? 2e-4 : 0.01;  // u
    Deeper best{from, {}};
    if (h.unknowns.empty()) return best;
    for (int round = 0; round < rounds; ++round) {
        const VectorXd u = to_u(h.unknowns, best.fit.theta);
        std::vector<VectorXd> trials;
        along_ranges(h, u, trials);
        along_the_valley(best.fit, u, trials);
        if (steps) close_by(h, u, trials);
        std::vector<Place> ends;
        for (const VectorXd& trial : trials) {
            Place end = descended(p, w, h, trial, short_fit);
            if (std::isfinite(end.objective)) ends.push_back(std::move(end));
        }
        std::stable_sort(ends.begin(), ends.end(), deeper);
        const double before = best.fit.objective(), evidence = best.fit.log_evidence;
        std::vector<VectorXd> tried{u};
        for (const Place& end : ends) {
            if (tried.size() > fitted_out || end.objective > before + promising) break;
            if (!is_fresh(end.u, tried, fresh)) continue;
            tried.push_back(end.u);
            Fit f = fit(p, w, h, end.theta, false, long_fit);
            if (f.log_evidence > best.fit.log_evidence) {
                best.left.push_back({best.fit.objective(), u, best.fit.theta});
                best.fit = std::move(f);
            } else {
                best.left.push_back({f.objective(), end.u, f.theta});
            }
        }
        if (best.fit.log_evidence < evidence + worth_a_round) break;
    }
    return best;
}

std::vector<Place> followed_in_time(const Problem& p, const Whitener& w, const Hypothesised& h,
                                    const std::vector<VectorXd>& from) {
    constexpr int short_fit = 4, long_fit = 12;
    constexpr std::size_t fewest = 5;
    constexpr double goes_on = 0.7;  // of the places, those with the least left
    std::vector<Place> ends;
    for (const double first : {0.2, 0.5}) {
        std::vector<Place> places;
        for (const VectorXd& u : from) places.push_back({0.0, u, {}});
        for (double share = first; share < 0.95; share += 0.1) {
            const VectorXd rows = early_rows(p, share);
            for (Place& place : places) place = descended(p, w, h, place.u, short_fit, rows);
            std::erase_if(places,
                          [](const Place& place) { return !std::isfinite(place.objective); });
            std::stable_sort(places.begin(), places.end(), deeper);
            const auto stay =
                static_cast<std::size_t>(goes_on * static_cast<double>(places.size()));
            places.resize(std::min(places.size(), std::max(fewest, stay)));
        }
        for (const Place& place : places) ends.push_back(descended(p, w, h, place.u, long_fit));
    }
    std::stable_sort(ends.begin(), ends.end(), deeper);
    return ends;
}

}  // namespace diagnose
