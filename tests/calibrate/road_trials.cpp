// SPDX-License-Identifier: MIT
#include "road_trials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace synthetic {
namespace {

using namespace calibrate;
using Eigen::VectorXd;

double target_of(const Powder& p) { return *p.problem.targets.front().value; }

// Whether the interval of the lead factor holds the place of the true angle, others as in `answer`.
bool holds_crossing(const Powder& p, const VectorXd& answer, std::size_t lead,
                    const statistics::Interval& i) {
    constexpr int cells = 2000;
    const Factor& f = p.problem.factors[lead];
    const double truth = p.angle_deg(p.truth);
    const auto off = [&](double x) {
        VectorXd at = answer;
        at[static_cast<Eigen::Index>(lead)] = x;
        return p.angle_deg(at) - truth;
    };
    const auto along = [&](int k) {
        const double share = static_cast<double>(k) / cells;
        return f.logarithmic ? f.low * std::pow(f.high / f.low, share)
                             : f.low + share * (f.high - f.low);
    };
    bool crosses = false;
    double least = std::numeric_limits<double>::infinity(), nearest = f.low;
    for (int k = 0; k < cells; ++k) {
        const double a = along(k), b = along(k + 1);
        if (off(a) * off(b) <= 0.0) {
            crosses = true;
            const double x = a + (b - a) * off(a) / (off(a) - off(b));
            if (i.low <= x && x <= i.high) return true;
        }
        if (std::abs(off(a)) < least) least = std::abs(off(a)), nearest = a;
    }
    // No crossing in the range: the nearest approach, to one part in 50 of the range.
    const double slack = 0.02 * (f.high - f.low);
    return !crosses && i.low - slack <= nearest && nearest <= i.high + slack;
}

}  // namespace

PaperTrial paper_trial(const Powder& p) {
    std::vector<Run> history;
    for (;;) {
        const PaperStep step = next(p.problem, PaperOptions{}, history);
        for (const Request& r : step.requests) history.push_back(p.run(r));
        if (!step.result) continue;
        const auto& answer = step.result->answer;
        if (!answer || p.margin(*answer) <= 0.0)
            return {step.result->runs, 90.0, false, step.result->passed};
        return {step.result->runs, p.angle_deg(*answer) - target_of(p), true, step.result->passed};
    }
}

std::vector<Run> history_of(const Powder& p, const SurrogateOptions& o) {
    std::vector<Run> history;
    for (;;) {
        const SurrogateStep step = next(p.problem, o, history);
        if (step.requests.empty()) return history;
        for (const Request& r : step.requests) history.push_back(p.run(r));
    }
}

SurrogateTrial surrogate_trial(const Powder& p, const SurrogateOptions& o) {
    const std::vector<Run> history = history_of(p, o);
    const SurrogateStep step = next(p.problem, o, history);
    SurrogateTrial t{static_cast<int>(history.size()), 90.0, false, false, false, false, 1.0};
    if (!step.result) return t;
    const SurrogateResult& r = *step.result;
    const Factor& f = p.problem.factors[r.lead];
    const auto i = r.held[r.lead];
    t.answered = p.margin(r.answer) > 0.0;
    if (t.answered) t.miss_deg = p.angle_deg(r.answer) - target_of(p);
    t.held = holds_crossing(p, r.answer, r.lead, i);
    t.held_share = f.logarithmic ? std::log(i.high / i.low) / std::log(f.high / f.low)
                                 : (i.high - i.low) / (f.high - f.low);
    t.foretold = std::abs(p.angle_deg(r.answer) - r.foretold[0].mean) <
                 1.96 * r.foretold[0].standard_deviation;
    const Surrogate s(p.problem, history, 1);
    t.region = mass_above(posterior(s, 2), s, coded(p.problem, p.truth)) < 0.95;
    return t;
}

}  // namespace synthetic
