// SPDX-License-Identifier: MIT
#include "calibrate/surrogate_road.hpp"

#include "calibrate/designs.hpp"
#include "calibrate/teaching.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double confidence = 0.95;

int start_of(const Problem& p, const SurrogateOptions& o) {
    if (o.start > 0) return o.start;
    return std::max(2, std::min(o.budget / 2, 2 + 2 * static_cast<int>(p.factors.size())));
}

MatrixXd spread_out(int runs, int factors, std::uint64_t seed) {
    constexpr std::uint64_t tries = 64;
    MatrixXd best;
    double widest = -1.0;
    for (std::uint64_t k = 0; k < tries; ++k) {
        const MatrixXd design = latin_hypercube(runs, factors, seed * tries + k);
        double nearest = std::numeric_limits<double>::infinity();
        for (Index i = 0; i < runs; ++i)
            for (Index j = 0; j < i; ++j)
                nearest = std::min(nearest, (design.row(i) - design.row(j)).squaredNorm());
        if (nearest > widest) widest = nearest, best = design;
    }
    return best;
}

VectorXd costs(const Surrogate& s, const MatrixXd& points) {
    VectorXd sum = -2.0 * s.forms(points).cwiseMax(1e-6).array().log();
    for (std::size_t j = 0; j < s.problem().targets.size(); ++j) {
        const Target& t = s.problem().targets[j];
        if (!t.value) continue;
        const auto at = s.at(j, points);
        sum.array() += ((at.mean.array() - *t.value).square() + at.variance.array()) /
                       (t.standard_deviation * t.standard_deviation);
    }
    return sum;
}

// Runs with the numbers 0 to count - 1; the history is sorted.
std::vector<Run> first_runs(const std::vector<Run>& history, std::size_t count) {
    return {history.begin(), history.begin() + static_cast<std::ptrdiff_t>(count)};
}

bool two_formed(const std::vector<Run>& history) {
    return std::count_if(history.begin(), history.end(),
                         [](const Run& r) { return r.values.has_value(); }) >= 2;
}

// Where the campaign stands: batches are whole before the next is decided.
struct Stand {
    const Problem& problem;
    const SurrogateOptions& options;
    std::vector<Run> history;  // sorted by number

    std::size_t number(const Run& r) const { return r.request.seed - problem.seed; }
    std::uint64_t seed_after(std::size_t runs) const { return 7919 * problem.seed + runs; }
    std::size_t start() const { return static_cast<std::size_t>(start_of(problem, options)); }
    std::size_t last() const {  // number of the first confirming run where the budget is spent
        return static_cast<std::size_t>(options.budget - options.confirmations);
    }
    std::optional<std::size_t> confirming() const {
        for (const Run& r : history)
            if (r.request.stage == "confirming") return number(r);
        return std::nullopt;
    }
    std::vector<Request> decided(std::size_t runs) const;
    std::vector<Request> learning(const std::vector<Run>& before) const;
    std::vector<Request> confirming_at(const VectorXd& answer, std::size_t first) const;
    std::vector<Request> missing(const std::vector<Request>& batch) const;
    SurrogateResult result(std::size_t before_confirming) const;
};

std::vector<Request> Stand::missing(const std::vector<Request>& batch) const {
    std::vector<Request> list;
    for (const Request& r : batch)
        if (!find_run(problem, history, r.seed - problem.seed, r.point)) list.push_back(r);
    return list;
}

std::vector<Request> Stand::confirming_at(const VectorXd& answer, std::size_t first) const {
    std::vector<Request> batch;
    for (int k = 0; k < options.confirmations; ++k)
        batch.push_back({point_of(problem, answer), problem.seed + first + static_cast<unsigned>(k),
                         "confirming"});
    return batch;
}

// The batch that follows the first `runs` runs.
std::vector<Request> Stand::decided(std::size_t runs) const {
    const auto factors = static_cast<int>(problem.factors.size());
    std::vector<Request> batch;
    if (runs < start()) {
        const MatrixXd design = spread_out(static_cast<int>(start()), factors, problem.seed);
        for (std::size_t k = 0; k < start(); ++k)
            batch.push_back(
                {point_of(problem, design.row(static_cast<Index>(k))), problem.seed + k, "start"});
        return batch;
    }
    const std::vector<Run> before = first_runs(history, runs);
    if (two_formed(before)) return learning(before);
    if (runs >= last()) return {};
    // Hardly a heap yet: further points of the space, each budget a new hypercube.
    const MatrixXd more = spread_out(options.budget, factors, problem.seed + 1);
    const std::size_t size =
        std::min<std::size_t>(static_cast<std::size_t>(options.batch), last() - runs);
    for (std::size_t k = runs; k < runs + size; ++k)
        batch.push_back(
            {point_of(problem, more.row(static_cast<Index>(k))), problem.seed + k, "start"});
    return batch;
}

bool is_settled(const Surrogate& s, const VectorXd& answer, double share) {
    for (std::size_t j = 0; j < s.problem().targets.size(); ++j) {
        const Target& t = s.problem().targets[j];
        if (!t.value) continue;
        const auto at = s.at(j, answer.transpose());
        const double miss = std::hypot(at.mean[0] - *t.value, std::sqrt(at.variance[0]));
        if (miss > share * t.standard_deviation) return false;
    }
    return true;
}

std::vector<Request> Stand::learning(const std::vector<Run>& before) const {
    constexpr double worth_a_run = 0.1;  // of what is open
    const std::size_t runs = before.size();
    Surrogate s(problem, before, seed_after(runs));
    const Posterior p = posterior(s, seed_after(runs));
    const VectorXd answer = best_answer(s, p);
    if (runs >= last()) return confirming_at(answer, runs);
    const bool settled = is_settled(s, answer, options.settled);
    const std::size_t size =
        std::min<std::size_t>(static_cast<std::size_t>(options.batch), last() - runs);
    const bool answer_first = options.batch > 1 || (runs - start()) % 2 == 0;
    std::vector<Request> batch;
    for (std::size_t k = 0; k < size; ++k) {
        const bool answers = k == 0 && answer_first;
        if (answers && !settled) {
            batch.push_back({point_of(problem, answer), problem.seed + runs, "answer"});
            if (k + 1 < size) s = s.believing(answer);
            continue;
        }
        const Lesson lesson = best_lesson(s, p, seed_after(runs) + k);
        if (settled && k == 0 && lesson.gain < worth_a_run) return confirming_at(answer, runs);
        batch.push_back({point_of(problem, lesson.point), problem.seed + runs + k, "learning"});
        if (k + 1 < size) s = s.believing(lesson.point);
    }
    return batch;
}

std::vector<std::string> dead_factors(const Surrogate& s, const Posterior& p) {
    std::vector<std::string> dead;
    constexpr int asked = 64;
    const auto rows = resampled(p.weights, asked, 0.5);
    for (Index f = 0; f < p.points.cols(); ++f) {
        bool moves = false;
        for (std::size_t j = 0; j < s.problem().targets.size() && !moves; ++j) {
            double square = 0.0;
            MatrixXd low(asked, p.points.cols()), high = low;
            for (Index k = 0; k < asked; ++k)
                low.row(k) = high.row(k) = p.points.row(rows[static_cast<std::size_t>(k)]);
            low.col(f).setConstant(-1.0), high.col(f).setConstant(1.0);
            for (const auto& process : s.draws(j))
                square += (process.at(high).mean - process.at(low).mean).squaredNorm() /
                          (asked * static_cast<double>(s.draws(j).size()));
            moves = std::sqrt(square) > s.problem().targets[j].standard_deviation;
        }
        if (!moves) dead.push_back(s.problem().factors[static_cast<std::size_t>(f)].name);
    }
    return dead;
}

statistics::Interval in_units(const Problem& p, Index factor, const statistics::Interval& coded) {
    VectorXd low = VectorXd::Zero(static_cast<Index>(p.factors.size())), high = low;
    low[factor] = coded.low, high[factor] = coded.high;
    return {point_of(p, low)[factor], point_of(p, high)[factor]};
}

SurrogateResult Stand::result(std::size_t before_confirming) const {
    SurrogateResult r{};
    const Surrogate s(problem, history, seed_after(history.size()));
    const Posterior p = posterior(s, seed_after(history.size()));
    // The answer is where the confirming runs were, if there are any.
    r.answer = options.confirmations > 0 ? history[before_confirming].request.point
                                         : point_of(problem, best_answer(s, p));
    const VectorXd at = coded(problem, r.answer);
    r.forms = s.forms(at.transpose())[0];
    double narrowest = std::numeric_limits<double>::infinity();
    for (Index k = 0; k < at.size(); ++k) {
        const auto held = conditional(s, at, k, confidence);
        r.free.push_back(in_units(problem, k, marginal(p, k, confidence)));
        r.held.push_back(in_units(problem, k, held));
        if (held.high - held.low < narrowest)
            narrowest = held.high - held.low, r.lead = static_cast<std::size_t>(k);
    }
    const auto earlier = first_runs(history, before_confirming);
    const Surrogate then(problem, earlier, seed_after(earlier.size()));
    for (std::size_t j = 0; j < problem.targets.size(); ++j) {
        const auto a = then.at(j, at.transpose()), b = s.at(j, at.transpose());
        r.foretold.push_back({a.mean[0], std::sqrt(a.variance[0])});
        r.found.push_back({b.mean[0], std::sqrt(b.variance[0])});
        r.confirmed.emplace_back();
        for (std::size_t k = before_confirming; k < history.size(); ++k)
            if (history[k].values) r.confirmed[j].push_back((*history[k].values)[j]);
    }
    r.dead = dead_factors(s, p);
    r.identification = identify(s, p, at);
    r.runs = static_cast<int>(history.size());
    for (const Run& run : history) r.formed += run.values.has_value();
    r.settled = r.runs < options.budget;
    if (r.formed < r.runs)
        r.notes.push_back(
            fmt::format("{} of {} runs formed no heap: they stand in the probability "
                        "that one forms",
                        r.runs - r.formed, r.runs));
    if (p.effective() < 100.0)
        r.notes.push_back(
            fmt::format("the posterior rests on {:.0f} effective samples: its "
                        "intervals are rough",
                        p.effective()));
    return r;
}

void check(const Problem& p, const SurrogateOptions& o) {
    const auto refuse = [](const std::string& where, int value, const std::string& rule) {
        throw scaling::InvalidParameter(scaling::mistake("options." + where, std::to_string(value),
                                                         rule, "see surrogate_road.hpp"));
    };
    if (o.batch < 1) refuse("batch", o.batch, "must be >= 1");
    if (o.confirmations < 0) refuse("confirmations", o.confirmations, "must be >= 0");
    if (o.start < 0) refuse("start", o.start, "must be >= 0");
    if (o.budget < start_of(p, o) + o.confirmations)
        refuse("budget", o.budget, "must hold the start and the confirming runs");
    if (!(o.settled >= 0.0)) refuse("settled", 0, "must be >= 0");
}

}  // namespace

VectorXd best_answer(const Surrogate& s, const Posterior& p) {
    constexpr int starts = 8;
    const VectorXd first = costs(s, p.points);
    std::vector<Index> order(static_cast<std::size_t>(first.size()));
    std::iota(order.begin(), order.end(), Index{0});
    std::partial_sort(order.begin(), order.begin() + starts, order.end(),
                      [&](Index a, Index b) { return first[a] < first[b]; });
    const Index d = p.points.cols();
    VectorXd best;
    double least = std::numeric_limits<double>::infinity();
    for (int n = 0; n < starts; ++n) {
        VectorXd at = p.points.row(order[static_cast<std::size_t>(n)]);
        double here = first[order[static_cast<std::size_t>(n)]];
        // Compass search: Hooke & Jeeves (1961), J. ACM 8, 212, its exploring moves.
        for (double step = 0.2; step > 2e-3;) {
            MatrixXd round = at.transpose().replicate(2 * d, 1);
            for (Index k = 0; k < d; ++k) round(2 * k, k) += step, round(2 * k + 1, k) -= step;
            round = round.cwiseMax(-1.0).cwiseMin(1.0);
            Index lowest = 0;
            const double found = costs(s, round).minCoeff(&lowest);
            if (found < here)
                here = found, at = round.row(lowest);
            else
                step *= 0.5;
        }
        if (here < least) least = here, best = at;
    }
    return best;
}

SurrogateStep next(const Problem& p, const SurrogateOptions& o, const std::vector<Run>& history) {
    check(p, history);
    check(p, o);
    Stand stand{p, o, history};
    std::sort(stand.history.begin(), stand.history.end(),
              [](const Run& a, const Run& b) { return a.request.seed < b.request.seed; });
    // The first batch that is not whole; those before it need not be decided again.
    std::size_t whole = 0;
    while (whole < stand.history.size() && stand.number(stand.history[whole]) == whole) ++whole;
    const auto confirming = stand.confirming();
    const std::size_t batch = static_cast<std::size_t>(o.batch);
    std::size_t first = whole < stand.start() ? 0
                        : whole >= stand.last()
                            ? stand.last()
                            : stand.start() + (whole - stand.start()) / batch * batch;
    if (confirming) first = *confirming;
    if (first >= stand.last() + static_cast<std::size_t>(o.confirmations) ||
        (confirming && whole >= *confirming + static_cast<std::size_t>(o.confirmations))) {
        if (!two_formed(history)) return {};
        return {{}, stand.result(confirming.value_or(whole))};
    }
    const auto requests = stand.missing(stand.decided(first));
    if (!requests.empty()) return {requests, std::nullopt};
    if (!two_formed(history)) return {};
    return {{}, stand.result(first)};
}

}  // namespace calibrate
