// SPDX-License-Identifier: MIT
#include "calibrate/calibration.hpp"

#include <algorithm>
#include <cmath>

namespace calibrate {

namespace {

constexpr double of_95 = 1.959963984540054;  // standard deviations of a normal

std::vector<double> values(const std::vector<Run>& runs, std::size_t target) {
    std::vector<double> list;
    for (const Run& run : runs)
        if (run.values) list.push_back(run.values->at(target));
    return list;
}

}  // namespace

std::optional<Eigen::VectorXd> Calibration::answer() const {
    if (surrogate) return surrogate->answer;
    if (given) return given;
    return paper ? paper->answer : std::nullopt;
}

std::vector<Run> Calibration::confirming() const {
    std::vector<Run> runs;
    for (const Run& run : history)
        if (run.request.stage == "confirming") runs.push_back(run);
    return runs;
}

std::optional<Confirmation> confirmed(const Calibration& c, std::size_t target) {
    const std::vector<double> found = values(c.confirming(), target);
    const Target& t = c.pile.problem.targets.at(target);
    if (found.empty() || !t.value) return std::nullopt;
    if (found.size() == 1)
        return Confirmation{1, found[0], std::nullopt,
                            std::abs(found[0] - *t.value) <= of_95 * t.standard_deviation};
    const statistics::Summary s = statistics::summary(found);
    const double of_mean = s.standard_deviation / std::sqrt(static_cast<double>(s.count));
    return Confirmation{
        s.count, s.mean, statistics::student_interval(s, 0.95),
        std::abs(s.mean - *t.value) <= of_95 * std::hypot(of_mean, t.standard_deviation)};
}

bool holds(const Calibration& c) {
    for (std::size_t k = 0; k < c.pile.problem.targets.size(); ++k) {
        if (!c.pile.problem.targets[k].value) continue;
        const auto there = confirmed(c, k);
        if (!there || !there->agrees) return false;
    }
    return true;
}

double share_of_range(const Factor& f, double value) {
    return f.logarithmic ? std::log(value / f.low) / std::log(f.high / f.low)
                         : (value - f.low) / (f.high - f.low);
}

std::optional<Slice> slice(const Calibration& c, std::size_t target, std::size_t factor,
                           int points) {
    const Problem& p = c.pile.problem;
    const auto formed = std::count_if(c.history.begin(), c.history.end(),
                                      [](const Run& r) { return r.values.has_value(); });
    if (formed < 2 || !c.answer()) return std::nullopt;
    const Surrogate s(p, c.history, p.seed);
    Eigen::MatrixXd at = coded(p, *c.answer()).transpose().replicate(points, 1);
    at.col(static_cast<Eigen::Index>(factor)) = Eigen::VectorXd::LinSpaced(points, -1.0, 1.0);
    const statistics::Prediction found = s.at(target, at);
    const Eigen::VectorXd forms = s.forms(at);
    Slice result;
    for (Eigen::Index k = 0; k < at.rows(); ++k) {
        const double wide = of_95 * std::sqrt(found.variance[k]);
        result.at.push_back(point_of(p, at.row(k))[static_cast<Eigen::Index>(factor)]);
        result.mean.push_back(found.mean[k]);
        result.low.push_back(found.mean[k] - wide);
        result.high.push_back(found.mean[k] + wide);
        result.forms.push_back(forms[k]);
    }
    return result;
}

}  // namespace calibrate
