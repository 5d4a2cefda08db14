// SPDX-License-Identifier: MIT
#include "road_trials.hpp"

#include <algorithm>
#include <cmath>

namespace synthetic {
namespace {

using namespace calibrate;
using Eigen::VectorXd;

double target_of(const Powder& p) { return *p.problem.targets.front().value; }

// The powder along its lead factor, others as in the answer, at the middles of even cells of the range.
struct Line {
    std::vector<double> share, off_deg;  // of the range; angle minus the true one
};

Line along_lead(const Powder& p, const VectorXd& answer, std::size_t lead) {
    constexpr int cells = 2000;
    Line line;
    VectorXd c = coded(p.problem, answer);
    for (int k = 0; k < cells; ++k) {
        line.share.push_back((k + 0.5) / cells);
        c[static_cast<Eigen::Index>(lead)] = 2.0 * line.share.back() - 1.0;
        line.off_deg.push_back(p.angle_deg(point_of(p.problem, c)) - p.angle_deg(p.truth));
    }
    return line;
}

// `low` and `high` of the interval as shares of the range.
bool holds_crossing(const Line& line, double low, double high) {
    std::size_t nearest = 0;
    bool crosses = false;
    for (std::size_t k = 0; k < line.share.size(); ++k) {
        if (std::abs(line.off_deg[k]) < std::abs(line.off_deg[nearest])) nearest = k;
        if (k == 0 || line.off_deg[k - 1] * line.off_deg[k] > 0.0) continue;
        crosses = true;
        if (low <= line.share[k] && line.share[k - 1] <= high) return true;
    }
    const double end_cell = 0.005;  // of the range: a quantile never lies at its very end
    return !crosses && low - end_cell <= line.share[nearest] &&
           line.share[nearest] <= high + end_cell;
}

// Between the quantiles 2.5 % and 97.5 % of N(measured; angle, s^2) along the line.
double width_if_known(const Powder& p, const Line& line) {
    const Target& t = p.problem.targets.front();
    std::vector<double> below{0.0};
    for (const double off : line.off_deg) {
        const double z = (off + p.angle_deg(p.truth) - *t.value) / t.standard_deviation;
        below.push_back(below.back() + std::exp(-0.5 * z * z));
    }
    const auto rank = [&](double q) {
        return std::lower_bound(below.begin(), below.end(), q * below.back()) - below.begin();
    };
    return static_cast<double>(rank(0.975) - rank(0.025)) / static_cast<double>(line.share.size());
}

}  // namespace

PaperTrial paper_trial(const Powder& p, bool quarters) {
    std::vector<Run> history;
    PaperOptions options;
    const auto factors = static_cast<Eigen::Index>(p.problem.factors.size());
    const VectorXd quarter = point_of(p.problem, VectorXd::Constant(factors, -0.5));
    const VectorXd middle = point_of(p.problem, VectorXd::Zero(factors));
    for (Eigen::Index k = 0; quarters && k < factors; ++k)
        options.screening_levels.push_back({quarter[k], middle[k]});
    for (;;) {
        const PaperStep step = next(p.problem, options, history);
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
    SurrogateTrial t{static_cast<int>(history.size()), 90.0, false, false, false, false, 1.0, 1.0};
    if (!step.result) return t;
    const SurrogateResult& r = *step.result;
    t.answered = p.margin(r.answer) > 0.0;
    if (t.answered) t.miss_deg = p.angle_deg(r.answer) - target_of(p);
    const auto share = [&](double x) {
        VectorXd at = r.answer;
        at[static_cast<Eigen::Index>(r.lead)] = x;
        return 0.5 * (1.0 + coded(p.problem, at)[static_cast<Eigen::Index>(r.lead)]);
    };
    const double low = share(r.held[r.lead].low), high = share(r.held[r.lead].high);
    const Line line = along_lead(p, r.answer, r.lead);
    t.held = holds_crossing(line, low, high);
    t.held_share = high - low;
    t.known_share = width_if_known(p, line);
    t.foretold = std::abs(p.angle_deg(r.answer) - r.foretold[0].mean) <
                 1.96 * r.foretold[0].standard_deviation;
    const Surrogate s(p.problem, history, 1);
    t.region = mass_above(posterior(s, 2), s, coded(p.problem, p.truth)) < 0.95;
    return t;
}

}  // namespace synthetic
