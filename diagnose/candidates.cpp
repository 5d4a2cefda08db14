// SPDX-License-Identifier: MIT
#include "diagnose/candidates.hpp"

#include "diagnose/minima.hpp"
#include "diagnose/starts.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <numeric>
#include <thread>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Evidence of the fit and, for the share of strengths that cannot be seen, of the hypothesis without the term.
void weigh(Candidate& c, const Candidate* start) {
    c.log_evidence = c.fit.log_evidence;
    if (start && c.unseen > 0.0)
        c.log_evidence = log_sum(c.log_evidence, start->log_evidence + std::log(c.unseen));
}

constexpr double nearly_as_deep =
    12.0;  // in chi squared: a minimum worth keeping beside the deepest

// From how many places a fit is begun: a term of one unknown has few minima, others many.
std::size_t places_of(const Term& term, std::size_t at_least) {
    return term.unknowns.size() > 1 ? 3 * at_least : at_least + 1;
}

// The first, and as further minima those of the others that are nearly as deep.
void take_first(std::vector<Fit> fits, Candidate& c) {
    for (std::size_t k = 1; k < fits.size(); ++k)
        if (fits[k].objective() < fits[0].objective() + nearly_as_deep)
            c.modes.push_back(fits[k].theta);
    c.fit = std::move(fits.front());
}

// The best of fits from all places, and the other minima: where there are many places, short fits first.
void fit_from(const Footing& on, const std::vector<VectorXd>& places, int iterations,
              Candidate& c) {
    constexpr std::size_t few = 4;
    const bool many = places.size() > 2;
    std::vector<std::pair<double, VectorXd>> ends;
    for (const VectorXd& own : places)
        for (const bool staged : {false, true}) {
            const Fit f = fit(on.problem, on.whiten, c.h, carried(on, c.h, own), staged,
                              many ? 5 : iterations);
            ends.push_back({f.objective(), f.theta});
        }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<VectorXd> tried;  // u
    std::vector<Fit> fits;
    for (const auto& [objective, theta] : ends) {
        if (fits.size() >= few || (fits.size() > 1 && objective > ends[0].first + nearly_as_deep))
            break;
        const VectorXd u = to_u(c.h.unknowns, theta);
        if (!is_fresh(u, tried, 0.02)) continue;
        tried.push_back(u);
        fits.push_back(fit(on.problem, on.whiten, c.h, theta, false, iterations));
    }
    std::stable_sort(fits.begin(), fits.end(),
                     [](const Fit& a, const Fit& b) { return a.objective() < b.objective(); });
    take_first(std::move(fits), c);
}

// A vibration has as many minima as bounces allow: it is followed in time from many places.
void fit_vibration(const Footing& on, const std::vector<VectorXd>& places, Candidate& c) {
    constexpr std::size_t fitted_out = 4, at_once = 8;
    std::vector<VectorXd> from;
    for (const VectorXd& own : places) from.push_back(to_u(c.h.unknowns, carried(on, c.h, own)));
    std::vector<Place> ends = followed_in_time(on.problem, on.whiten, c.h, from);
    for (std::size_t k = 0; k < std::min(at_once, from.size()); ++k)  // weak ones need no leading
        ends.push_back(descended(on.problem, on.whiten, c.h, from[k], 5));
    std::stable_sort(ends.begin(), ends.end(), deeper);
    std::vector<Fit> fits;
    for (std::size_t k = 0; k < std::min(fitted_out, ends.size()); ++k)
        fits.push_back(fit(on.problem, on.whiten, c.h, ends[k].theta, false, 25));
    std::stable_sort(fits.begin(), fits.end(),
                     [](const Fit& a, const Fit& b) { return a.log_evidence > b.log_evidence; });
    take_first(std::move(fits), c);
}

}  // namespace

double log_sum(double a, double b) {
    const double top = std::max(a, b);
    return top + std::log(std::exp(a - top) + std::exp(b - top));
}

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
    const Footing on{p, w, start.h, start.fit};
    Candidate c{.h = plus(p, start.h, term), .fit = {}};
    if (term.unknowns.empty()) {
        c.fit = fit(p, w, c.h, carried(on, c.h, VectorXd(0)), true);
        c.log_evidence = c.fit.log_evidence;
        return c;
    }
    const Starts starts = starts_of(on, term);
    c.unseen = starts.unseen;
    if (term.effect == "vibration")
        fit_vibration(on, distinct(term, starts, 36), c);
    else
        fit_from(on, distinct(term, starts, places_of(term, 2)), 25, c);
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
    // A fit of the two begins in that of one of them, where the other is added.
    struct Way {
        std::size_t start, added;
        std::vector<VectorXd> own{};  // where it begins
    };
    struct Pair {
        std::vector<Way> ways;
        double chi_squared = std::numeric_limits<double>::max();
    };
    std::vector<Pair> list;
    // Each two once; a vibration beside the two best others, since alone it may have found another frequency.
    const auto effect = [&](std::size_t rank) { return singles[order[rank]].h.terms[0]->effect; };
    std::size_t others = 0;
    for (std::size_t a = 0; a < std::min(beam, order.size()); ++a) {
        others += effect(a) != "vibration";
        for (std::size_t b = 0; b < order.size(); ++b)
            if (effect(a) != effect(b) &&
                (effect(b) == "vibration" ? others <= 2 : b >= beam || b > a)) {
                list.push_back({{{order[a], order[b]}}});
                if (effect(a) != "vibration" && effect(b) != "vibration")
                    list.back().ways.push_back({order[b], order[a]});
            }
    }
    in_parallel(list.size(), threads, [&](std::size_t k) {
        for (Way& way : list[k].ways) {
            const Candidate& start = singles[way.start];
            const Term& term = *singles[way.added].h.terms[0];
            const auto own = static_cast<Index>(term.unknowns.size());
            const Starts starts =
                starts_beside({p, w, start.h, start.fit}, term,
                              to_u(term.unknowns, singles[way.added].fit.theta.tail(own)));
            if (starts.best_first.empty()) continue;
            list[k].chi_squared =
                std::min(list[k].chi_squared, starts.best_first.front().first + start.fit.penalty +
                                                  3.0 * static_cast<double>(own));
            way.own = distinct(term, starts, term.effect == "vibration" ? 8 : places_of(term, 1));
        }
        std::erase_if(list[k].ways, [](const Way& way) { return way.own.empty(); });
    });
    std::stable_sort(list.begin(), list.end(),
                     [](const Pair& a, const Pair& b) { return a.chi_squared < b.chi_squared; });
    list.resize(std::min(list.size(), most));
    std::erase_if(list, [](const Pair& pair) { return pair.ways.empty(); });
    std::vector<Candidate> pairs(list.size());
    in_parallel(list.size(), threads, [&](std::size_t k) {
        for (const Way& way : list[k].ways) {
            const Candidate& start = singles[way.start];
            Candidate c{.h = plus(p, start.h, *singles[way.added].h.terms[0]), .fit = {}};
            fit_from({p, w, start.h, start.fit}, way.own, 15, c);
            c.log_evidence = c.fit.log_evidence;
            if (pairs[k].h.terms.empty() || c.log_evidence > pairs[k].log_evidence)
                pairs[k] = std::move(c);
        }
    });
    return pairs;
}

void drop_idle(std::vector<Candidate>& pairs, const std::vector<Candidate>& singles) {
    std::erase_if(pairs, [&](const Candidate& pair) {
        return std::any_of(singles.begin(), singles.end(), [&](const Candidate& single) {
            const Term* term = single.h.terms.front();
            return std::find(pair.h.terms.begin(), pair.h.terms.end(), term) !=
                       pair.h.terms.end() &&
                   single.fit.objective() < pair.fit.objective() + seen;
        });
    });
}

void deepen(const Problem& p, const Whitener& w, Candidate& c, const Candidate* start) {
    Deeper found = deeper_minimum(p, w, c.h, c.fit);
    c.fit = std::move(found.fit);
    for (const Place& other : found.left)
        if (other.objective < c.fit.objective() + nearly_as_deep) c.modes.push_back(other.theta);
    weigh(c, start);
}

void refit(const Problem& p, const Whitener& w, Candidate& c, const Candidate* start) {
    c.fit = fit(p, w, c.h, c.fit.theta, false, 12);
    weigh(c, start);
}

double separation(const Problem& p, const Whitener& w, const Candidate& truth,
                  const Candidate& other) {
    const VectorXd shown = predicted(p, truth.h, truth.fit.theta);
    Hypothesised h = other.h;
    for (Unknown& u : h.unknowns)
        for (std::size_t k = 0; k < truth.h.unknowns.size(); ++k)
            if (u.prior == Prior::gaussian && u.name == truth.h.unknowns[k].name)
                u.mean = truth.fit.theta[static_cast<Index>(k)];
    return std::sqrt(fit_to(p, w, h, shown, other.fit.theta, false, 12).objective());
}

}  // namespace diagnose
