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
#include <map>
#include <mutex>
#include <numeric>
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
VectorXd carried(const Hypothesised& from, const VectorXd& theta, const Hypothesised& to,
                 const VectorXd& own) {
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
    if (start && c.unseen > 0.0)
        c.log_evidence = log_sum(c.log_evidence, start->log_evidence + std::log(c.unseen));
}

int grid_points(const Term& t, Index k) {
    const std::string& key = t.unknowns[static_cast<std::size_t>(k)].key;
    if (t.effect == "vibration") return key == "frequency" ? 40 : key == "phase" ? 6 : 3;
    return k == 0 ? 8 : 4;
}

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

// The term's own fit, and other strengths with its further unknowns as there.
std::vector<VectorXd> near(const Term& t, const VectorXd& u) {
    std::vector<VectorXd> list{u};
    if (t.unknowns.empty()) return list;
    const int count = grid_points(t, 0);
    for (int c = 0; c < count; ++c)
        list.push_back(u), list.back()[0] = grid_value(t.unknowns[0], (c + 0.5) / count);
    return list;
}

struct Tried {
    std::vector<std::pair<double, VectorXd>>
        best_first;  // chi squared at first order, values of the term's unknowns
    double unseen;   // share of the grid that moves nothing by a sigma
};

Tried tried_on(const Problem& p, const Whitener& w, const Candidate& start, const Hypothesised& h,
               const Term& term, const std::vector<VectorXd>& grid) {
    const Projection project(start.h.unknowns, start.fit);
    const VectorXd left = project(start.fit.white);
    Tried t{{}, 0.0};
    for (const VectorXd& u : grid) {
        const VectorXd values = to_theta(term.unknowns, u);
        const VectorXd d = project(w(predicted(p, h, carried(start.h, start.fit.theta, h, values)) -
                                     start.fit.prediction));
        if (d.squaredNorm() < 1.0) t.unseen += 1.0 / static_cast<double>(grid.size());
        const double chi = (left - d).squaredNorm();
        if (std::isfinite(chi)) t.best_first.push_back({chi, values});
    }
    std::stable_sort(t.best_first.begin(), t.best_first.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    return t;
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
    for (int n = 1; n < threads && static_cast<std::size_t>(n) < count; ++n)
        team.emplace_back(work);
    work();
    for (std::thread& t : team) t.join();
    if (trouble) std::rethrow_exception(trouble);
}

Candidate extended(const Problem& p, const Whitener& w, const Candidate& start, const Term& term) {
    Candidate c{.h = plus(p, start.h, term), .fit = {}};
    if (term.unknowns.empty()) {
        c.fit = fit(p, w, c.h, carried(start.h, start.fit.theta, c.h, VectorXd(0)), true);
        c.log_evidence = c.fit.log_evidence;
        return c;
    }
    const Tried tried = tried_on(p, w, start, c.h, term, grid_of(term));
    c.unseen = tried.unseen;
    std::vector<std::pair<VectorXd, bool>> starts;
    for (std::size_t k = 0; k < std::min<std::size_t>(2, tried.best_first.size()); ++k)
        starts.push_back({tried.best_first[k].second, false});
    if (!starts.empty()) starts.push_back({tried.best_first.front().second, true});
    if (tried.best_first.size() > 4)
        starts.push_back({tried.best_first[tried.best_first.size() / 2].second, true});
    bool first = true;
    for (const auto& [values, staged] : starts) {
        Fit f = fit(p, w, c.h, carried(start.h, start.fit.theta, c.h, values), staged);
        if (first || f.objective() < c.fit.objective()) c.fit = std::move(f), first = false;
    }
    weigh(c, &start);
    return c;
}

std::vector<Candidate> pairs_of(const Problem& p, const Whitener& w,
                                const std::vector<Candidate>& singles, std::size_t beam,
                                std::size_t most, int threads) {
    std::vector<std::size_t> order(singles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return singles[a].log_evidence > singles[b].log_evidence;
    });
    struct Pair {
        std::size_t start, added;
        double chi_squared = std::numeric_limits<double>::max();
        VectorXd own{};
    };
    std::vector<Pair> list;
    for (std::size_t a = 0; a < std::min(beam, order.size()); ++a)
        for (std::size_t b = 0; b < order.size(); ++b)
            if (singles[order[a]].h.terms[0]->effect != singles[order[b]].h.terms[0]->effect &&
                (b >= beam || b > a))
                list.push_back({order[a], order[b]});
    in_parallel(list.size(), threads, [&](std::size_t k) {
        Pair& pair = list[k];
        const Candidate& start = singles[pair.start];
        const Term& term = *singles[pair.added].h.terms[0];
        const Hypothesised h = plus(p, start.h, term);
        const auto own = static_cast<Index>(term.unknowns.size());
        const Tried tried =
            tried_on(p, w, start, h, term,
                     near(term, to_u(term.unknowns, singles[pair.added].fit.theta.tail(own))));
        if (tried.best_first.empty()) return;
        pair.chi_squared =
            tried.best_first.front().first + start.fit.penalty + 3.0 * static_cast<double>(own);
        pair.own = tried.best_first.front().second;
    });
    std::stable_sort(list.begin(), list.end(),
                     [](const Pair& a, const Pair& b) { return a.chi_squared < b.chi_squared; });
    list.resize(std::min(list.size(), most));
    std::erase_if(list, [](const Pair& pair) {
        return pair.chi_squared == std::numeric_limits<double>::max();
    });
    std::vector<Candidate> pairs(list.size());
    in_parallel(list.size(), threads, [&](std::size_t k) {
        const Candidate& start = singles[list[k].start];
        const Term& term = *singles[list[k].added].h.terms[0];
        Candidate c{.h = plus(p, start.h, term), .fit = {}};
        c.fit = fit(p, w, c.h, carried(start.h, start.fit.theta, c.h, list[k].own), false, 15);
        c.log_evidence = c.fit.log_evidence;
        pairs[k] = std::move(c);
    });
    return pairs;
}

void refit(const Problem& p, const Whitener& w, Candidate& c, const Candidate* start) {
    c.fit = fit(p, w, c.h, c.fit.theta, false, 12);
    weigh(c, start);
}

std::vector<Candidate> with_missing_force(const Problem& p, const Whitener& w,
                                          const Candidate& start, std::vector<Term>& terms) {
    constexpr std::size_t knots = 8;
    // Range of every variable of the state over all recordings, of one rig.
    std::map<std::string, std::pair<double, double>> ranges;
    double weight = 0.0;
    for (const Record& r : p.records) {
        if (r.experiment->rig == "impact") return {};
        const double d = r.experiment->grain.diameter.value.value();
        weight =
            std::max(weight, r.experiment->grain.density.value.value() * 0.5236 * d * d * d * 9.81);
        if (r.experiment->rig == "pull_off")
            for (const double v : r.channels.front().recorded)
                if (std::isfinite(v)) weight = std::max(weight, 0.05 * std::abs(v));
        for (const auto& [name, values] :
             r.model->variables(world_at(p, start.h, start.fit.theta, r), r.ordinates)) {
            auto& range = ranges
                              .try_emplace(name, std::numeric_limits<double>::max(),
                                           std::numeric_limits<double>::lowest())
                              .first->second;
            for (const double v : values)
                if (std::isfinite(v)) range = {std::min(range.first, v), std::max(range.second, v)};
        }
    }
    terms.clear();
    terms.reserve(ranges.size());
    for (const auto& [name, range] : ranges)
        if (range.second > range.first && name != "impact_speed")
            terms.push_back(missing_force(name, range.first, range.second, knots, weight));
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
            const double log_det = ldlt.vectorD().array().abs().log().sum() +
                                   2.0 * static_cast<double>(knots) * std::log(s);
            const double log_z = 0.5 * b.dot(ldlt.solve(b)) - 0.5 * log_det;
            if (log_z > best) best = log_z, chosen = s;
        }
        for (Unknown& u : term.unknowns)
            u.deviation = chosen * weight, u.low = -100.0 * u.deviation,
            u.high = 100.0 * u.deviation;
        h = plus(p, start.h, term);
        Candidate c{.h = h,
                    .fit = fit(p, w, h,
                               carried(start.h, start.fit.theta, h,
                                       VectorXd::Zero(static_cast<Index>(knots))),
                               false, 10)};
        // The size was chosen among some 20, the variable among those there are.
        c.log_evidence = c.fit.log_evidence - 2.0;
        all.push_back(std::move(c));
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& x, const auto& y) { return x.log_evidence > y.log_evidence; });
    return all;
}

double separation(const Problem& p, const Whitener& w, const Candidate& truth,
                  const Candidate& other) {
    const VectorXd shown = predicted(p, truth.h, truth.fit.theta);
    return fit_to(p, w, other.h, shown, other.fit.theta, false, 12).white.norm();
}

}  // namespace diagnose
