// SPDX-License-Identifier: MIT
#include "calibrate/replay.hpp"

#include "scaling/errors.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace calibrate {

namespace {

struct Comparison {
    std::vector<Recomputed> digits;

    void add(const std::string& table, const std::string& what, const Printed& p, double value) {
        digits.push_back({table, what, p, value, p.agrees(value)});
    }
};

void compare_effects(Comparison& c, const Published& p, const std::vector<LevelMeans>& means) {
    for (const PublishedEffect& e : p.effects) {
        const auto same = [&](const LevelMeans& m) { return m.factor == e.factor; };
        const auto found = std::find_if(means.begin(), means.end(), same);
        if (found == means.end()) continue;
        const LevelMeans& m = *found;
        const auto add = [&](const char* what, const Printed& printed, double value) {
            c.add(p.effects_table, e.factor + ": " + what, printed, value);
        };
        add("sum at the high level", e.sum_high, m.sum_high);
        add("runs at the high level", e.count_high, m.count_high);
        add("mean at the high level", e.mean_high, m.mean_high);
        add("sum at the low level", e.sum_low, m.sum_low);
        add("runs at the low level", e.count_low, m.count_low);
        add("mean at the low level", e.mean_low, m.mean_low);
        add("effect", e.effect, m.effect);
        add("rank", e.rank, m.rank);
    }
}

void compare_errors(Comparison& c, const PublishedTable& t, double target) {
    for (std::size_t k = 0; k < t.rows.size(); ++k) {
        const PublishedRow& row = t.rows[k];
        if (!row.response || !row.relative_error) continue;
        c.add(t.table, fmt::format("run {}: relative error, %", k + 1), *row.relative_error,
              relative_error(row.response->value, target));
    }
}

// The path as it follows from its first row and the steps said.
void compare_path(Comparison& c, const Published& p) {
    for (std::size_t k = 0; k < p.ascent.rows.size(); ++k) {
        for (std::size_t f = 0; f < p.ascent.factors.size(); ++f) {
            const double start = p.ascent.rows.front().values[f].value;
            c.add(p.ascent.table, fmt::format("run {}: {}", k + 1, p.ascent.factors[f]),
                  p.ascent.rows[k].values[f], start + static_cast<double>(k) * p.ascent_steps[f]);
        }
    }
}

std::vector<AscentStep> steps_of(const Published& p, const std::vector<LevelMeans>& means) {
    const auto effect = [&](const std::string& letter) {
        for (const LevelMeans& m : means)
            if (m.factor == letter) return m.effect;
        return 0.0;
    };
    const auto half = [&](const std::string& letter) {
        return 0.5 * (p.factor(letter).high - p.factor(letter).low);
    };
    const std::string& lead = p.ascent.factors.front();
    const double coded = p.ascent_steps.front() / half(lead) / effect(lead);
    std::vector<AscentStep> steps;
    for (std::size_t k = 0; k < p.ascent.factors.size(); ++k) {
        const std::string& letter = p.ascent.factors[k];
        steps.push_back({letter, p.ascent_steps[k], coded * effect(letter) * half(letter)});
    }
    return steps;
}

Line line_of(const Published& p) {
    const PublishedRow& a = p.orthogonal.rows[static_cast<std::size_t>(p.line.first - 1)];
    const PublishedRow& b = p.orthogonal.rows[static_cast<std::size_t>(p.line.second - 1)];
    const double x1 = a.values[1].value, x2 = b.values[1].value;
    Line line{};
    line.slope = (b.response.value().value - a.response.value().value) / (x2 - x1);
    line.intercept = a.response->value - line.slope * x1;
    line.solution = (p.experiment.target.value - line.intercept) / line.slope;
    line.at_printed = line.intercept + line.slope * p.line.solution.value;
    return line;
}

std::vector<Crossing> crossings_of(const PublishedTable& t, double target) {
    std::vector<Crossing> all;
    for (std::size_t k = 0; k + 1 < t.rows.size(); ++k) {
        const PublishedRow &a = t.rows[k], &b = t.rows[k + 1];
        if (a.values[0].value != b.values[0].value || !a.response || !b.response) continue;
        if ((a.response->value - target) * (b.response->value - target) > 0.0) continue;
        const double slope =
            (b.response->value - a.response->value) / (b.values[1].value - a.values[1].value);
        all.push_back(
            {a.values[0].value, a.values[1].value + (target - a.response->value) / slope, slope});
    }
    return all;
}

// Root of the quadratic in the second factor, inside its levels; NaN where there is none.
double pooled_solution(const PublishedTable& t, double target) {
    const Eigen::Index n = static_cast<Eigen::Index>(t.rows.size());
    Eigen::MatrixXd x(n, 3);
    Eigen::VectorXd y(n);
    double low = t.rows.front().values[1].value, high = low;
    for (Eigen::Index k = 0; k < n; ++k) {
        const PublishedRow& row = t.rows[static_cast<std::size_t>(k)];
        const double g = row.values[1].value;
        x.row(k) << 1.0, g, g * g;
        y(k) = row.response.value().value - target;
        low = std::min(low, g);
        high = std::max(high, g);
    }
    const Eigen::Vector3d c = x.colPivHouseholderQr().solve(y);
    const double root = std::sqrt(c(1) * c(1) - 4.0 * c(0) * c(2));
    for (const double sign : {1.0, -1.0}) {
        const double g = (-c(1) + sign * root) / (2.0 * c(2));
        if (g >= low && g <= high) return g;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

void require_responses(const Published& p) {
    for (const PublishedRow& row : p.orthogonal.rows)
        if (!row.response)
            throw scaling::InvalidInput(
                scaling::mistake(p.path + ": orthogonal.rows", "a run without a response",
                                 "must all have one", "the interpolation needs the whole table"));
}

}  // namespace

double relative_error(double response, double target) {
    return 100.0 * std::abs(response - target) / target;
}

Trials trials_of(const PublishedTable& t) {
    const Eigen::Index runs = static_cast<Eigen::Index>(t.rows.size());
    Trials trials{Eigen::MatrixXd(runs, static_cast<Eigen::Index>(t.factors.size())), {}};
    for (std::size_t f = 0; f < t.factors.size(); ++f) {
        std::set<double> levels;
        for (const PublishedRow& row : t.rows) levels.insert(row.values[f].value);
        const double low = *levels.begin(), high = *levels.rbegin();
        for (Eigen::Index run = 0; run < runs; ++run) {
            const double value = t.rows[static_cast<std::size_t>(run)].values[f].value;
            trials.design(run, static_cast<Eigen::Index>(f)) =
                -1.0 + 2.0 * (value - low) / (high - low);
        }
    }
    for (const PublishedRow& row : t.rows)
        trials.responses.push_back(row.response ? std::optional<double>(row.response->value)
                                                : std::nullopt);
    return trials;
}

Replay replay(const Published& p, const scaling::ScaleStudy& study) {
    require_responses(p);
    Replay r{};
    Comparison c;
    const std::vector<double>& readings = p.experiment.readings;
    const double target = p.experiment.target.value;
    c.add(p.experiment.table, "mean of the readings", p.experiment.target,
          std::accumulate(readings.begin(), readings.end(), 0.0) /
              static_cast<double>(readings.size()));
    r.means = level_means(usable(p.screening));
    compare_effects(c, p, r.means);
    for (const PublishedFactor& f : p.factors)
        if (f.fixed)
            c.add(p.ascent.table, f.letter + ": middle of its levels", *f.fixed,
                  0.5 * (f.low + f.high));
    compare_path(c, p);
    compare_errors(c, p.second_ascent, target);
    compare_errors(c, p.orthogonal, target);
    r.line = line_of(p);
    c.add(p.line.table, "slope", p.line.slope, r.line.slope);
    c.add(p.line.table, "intercept", p.line.intercept, r.line.intercept);
    c.add(p.line.table, "solution at the target", p.line.solution, r.line.solution);
    c.add(p.confirmed_table, "relative error of the confirming run, %", p.confirmed_error,
          relative_error(p.confirmed.value, target));
    c.add(p.simulation_table, "scale number of the original grains", p.scale_number,
          study.original_scale_number.value);
    c.add(p.simulation_table,
          fmt::format("time step, {} % of the Rayleigh time", p.rayleigh_percent.text), p.time_step,
          0.01 * p.rayleigh_percent.value * study.scaled_cost.rayleigh_time.value());
    r.digits = std::move(c.digits);
    r.mismatches = static_cast<int>(std::count_if(r.digits.begin(), r.digits.end(),
                                                  [](const Recomputed& d) { return !d.agrees; }));
    r.steps = steps_of(p, r.means);
    r.orthogonal = analysis_of_variance(trials_of(p.orthogonal));
    for (std::size_t k = 0; k < p.orthogonal.factors.size(); ++k)
        r.orthogonal.factors[k].source = p.orthogonal.factors[k];
    r.crossings = crossings_of(p.orthogonal, target);
    r.pooled_solution = pooled_solution(p.orthogonal, target);
    return r;
}

}  // namespace calibrate
