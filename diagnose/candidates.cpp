// SPDX-License-Identifier: MIT
#include "diagnose/candidates.hpp"

#include "diagnose/catalogue.hpp"
#include "diagnose/locate.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double log_sum(double a, double b) {
    const double top = std::max(a, b);
    return top + std::log(std::exp(a - top) + std::exp(b - top));
}

Hypothesised plus(const Problem& p, const Hypothesised& h, const Term& term) {
    std::vector<const Term*> terms = h.terms;
    terms.push_back(&term);
    return p.hypothesis(std::move(terms));
}

// theta of `to`: what it shares with `from` from there, its last unknowns `own`.
VectorXd carried(const Hypothesised& from, const VectorXd& theta, const Hypothesised& to, const VectorXd& own) {
    VectorXd result = start_of(to.unknowns);
    for (Index k = 0; k < result.size() - own.size(); ++k)
        for (std::size_t n = 0; n < from.unknowns.size(); ++n)
            if (from.unknowns[n].name == to.unknowns[static_cast<std::size_t>(k)].name &&
                from.unknowns[n].key == to.unknowns[static_cast<std::size_t>(k)].key)
                result[k] = theta[static_cast<Index>(n)];
    result.tail(own.size()) = own;
    return result;
}

// Evidence of the fit and, for the share of strengths that cannot be seen, of the hypothesis without the term.
void weigh(Candidate& c, const Candidate* start) {
    c.log_evidence = c.fit.log_evidence;
    if (start && c.unseen > 0.0) c.log_evidence = log_sum(c.log_evidence, start->log_evidence + std::log(c.unseen));
}

int grid_points(const Term& t, Index k) {
    const std::string& key = t.unknowns[static_cast<std::size_t>(k)].key;
    if (t.effect == "vibration") return key == "frequency" ? 40 : key == "phase" ? 6 : 3;
    return k == 0 ? 8 : 4;
}

std::vector<VectorXd> grid_of(const Term& t) {
    const auto n = static_cast<Index>(t.unknowns.size());
    std::vector<VectorXd> grid{VectorXd::Zero(n)};
    for (Index k = 0; k < n; ++k) {
        const int count = grid_points(t, k);
        std::vector<VectorXd> finer;
        for (const VectorXd& g : grid)
            for (int c = 0; c < count; ++c) finer.push_back(g), finer.back()[k] = (c + 0.5) / count;
        grid = std::move(finer);
    }
    return grid;
}

}  // namespace

void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& f) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr trouble;
    std::mutex guard;
    const auto work = [&] {
        for (std::size_t k = next++; k < count; k = next++) {
            try {
                f(k);
            } catch (...) {
                const std::lock_guard lock(guard);
                if (!trouble) trouble = std::current_exception();
            }
        }
    };
    std::vector<std::thread> team;
    for (int n = 1; n < threads && static_cast<std::size_t>(n) < count; ++n) team.emplace_back(work);
    work();
    for (std::thread& t : team) t.join();
    if (trouble) std::rethrow_exception(trouble);
}

Candidate extended(const Problem& p, const Whitener& w, const Candidate& start, const Term& term) {
    Candidate c{.h = plus(p, start.h, term), .fit = {}};
    const auto own = static_cast<Index>(term.unknowns.size());
    if (own == 0) {
        c.fit = fit(p, w, c.h, carried(start.h, start.fit.theta, c.h, VectorXd(0)), true);
        c.log_evidence = c.fit.log_evidence;
        return c;
    }
    const Projection project(start.h.unknowns, start.fit);
    const VectorXd left = project(start.fit.white);
    std::vector<std::pair<double, VectorXd>> tried;
    int unseen = 0;
    for (const VectorXd& u : grid_of(term)) {
        const VectorXd theta = carried(start.h, start.fit.theta, c.h, to_theta(term.unknowns, u));
        const VectorXd d = project(w(predicted(p, c.h, theta) - start.fit.prediction));
        const double size = d.squaredNorm();
        unseen += size < 1.0 ? 1 : 0;
        const double chi = (left - d).squaredNorm();
        if (std::isfinite(chi)) tried.push_back({chi, to_theta(term.unknowns, u)});
    }
    c.unseen = static_cast<double>(unseen) / static_cast<double>(std::max<std::size_t>(1, tried.size()));
    std::stable_sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::pair<VectorXd, bool>> starts;
    for (std::size_t k = 0; k < std::min<std::size_t>(2, tried.size()); ++k) starts.push_back({tried[k].second, false});
    if (!tried.empty()) starts.push_back({tried.front().second, true});
    if (tried.size() > 4) starts.push_back({tried[tried.size() / 2].second, true});
    bool first = true;
    for (const auto& [values, staged] : starts) {
        Fit f = fit(p, w, c.h, carried(start.h, start.fit.theta, c.h, values), staged);
        if (first || f.objective() < c.fit.objective()) c.fit = std::move(f), first = false;
    }
    weigh(c, &start);
    return c;
}

void refit(const Problem& p, const Whitener& w, Candidate& c, const Candidate* start) {
    c.fit = fit(p, w, c.h, c.fit.theta, false, 12);
    weigh(c, start);
}

std::vector<Candidate> with_missing_force(const Problem& p, const Whitener& w, const Candidate& start, std::vector<Term>& terms) {
    constexpr std::size_t knots = 8;
    // Range of every variable of the state over all recordings, of one rig.
    std::map<std::string, std::pair<double, double>> ranges;
    double weight = 0.0;
    for (const Record& r : p.records) {
        if (r.experiment->rig == "impact") return {};
        const double d = r.experiment->grain.diameter.value.value();
        weight = std::max(weight, r.experiment->grain.density.value.value() * 0.5236 * d * d * d * 9.81);
        if (r.experiment->rig == "pull_off")
            for (const double v : r.channels.front().recorded)
                if (std::isfinite(v)) weight = std::max(weight, 0.05 * std::abs(v));
        for (const auto& [name, values] : r.model->variables(world_at(p, start.h, start.fit.theta, r), r.ordinates)) {
            auto& range = ranges.try_emplace(name, std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()).first->second;
            for (const double v : values)
                if (std::isfinite(v)) range = {std::min(range.first, v), std::max(range.second, v)};
        }
    }
    terms.clear();
    terms.reserve(ranges.size());
    for (const auto& [name, range] : ranges)
        if (range.second > range.first && name != "impact_speed") terms.push_back(missing_force(name, range.first, range.second, knots, weight));
    const Projection project(start.h.unknowns, start.fit);
    const VectorXd left = project(start.fit.white);
    std::vector<Candidate> all;
    for (Term& term : terms) {
        Hypothesised h = plus(p, start.h, term);
        MatrixXd slopes(static_cast<Index>(p.size), static_cast<Index>(knots));
        for (std::size_t k = 0; k < knots; ++k) {
            VectorXd own = VectorXd::Zero(static_cast<Index>(knots));
            own[static_cast<Index>(k)] = 1e-3 * weight;
            const VectorXd up = predicted(p, h, carried(start.h, start.fit.theta, h, own));
            const VectorXd down = predicted(p, h, carried(start.h, start.fit.theta, h, -own));
            slopes.col(static_cast<Index>(k)) = project(w((up - down) / 2e-3));  // per weight
        }
        // Size of greatest evidence, at first order: log det(1 + s^2 A) and b' (A + 1/s^2)^-1 b.
        const MatrixXd a = slopes.transpose() * slopes;
        const VectorXd b = slopes.transpose() * left;
        double best = std::numeric_limits<double>::lowest(), chosen = 1.0;
        for (double s = 1e-4; s < 300.0; s *= 2.0) {
            MatrixXd m = a;
            m.diagonal().array() += 1.0 / (s * s);
            const Eigen::LDLT<MatrixXd> ldlt(m);
            const double log_det = ldlt.vectorD().array().abs().log().sum() + 2.0 * static_cast<double>(knots) * std::log(s);
            const double log_z = 0.5 * b.dot(ldlt.solve(b)) - 0.5 * log_det;
            if (log_z > best) best = log_z, chosen = s;
        }
        for (Unknown& u : term.unknowns) u.deviation = chosen * weight, u.low = -100.0 * u.deviation, u.high = 100.0 * u.deviation;
        h = plus(p, start.h, term);
        Candidate c{.h = h, .fit = fit(p, w, h, carried(start.h, start.fit.theta, h, VectorXd::Zero(static_cast<Index>(knots))), false, 10)};
        // The size was chosen among some 20, the variable among those there are.
        c.log_evidence = c.fit.log_evidence - 2.0;
        all.push_back(std::move(c));
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.log_evidence > y.log_evidence; });
    return all;
}

double separation(const Problem& p, const Whitener& w, const Candidate& truth, const Candidate& other) {
    const VectorXd shown = predicted(p, truth.h, truth.fit.theta);
    return fit_to(p, w, other.h, shown, other.fit.theta, false, 12).white.norm();
}

}  // namespace diagnose
