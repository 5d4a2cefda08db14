// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "calibrate/identifiability.hpp"
#include "calibrate/observations.hpp"
#include "statistics/intervals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace calibrate {

namespace {

using scaling::Judgement;

void add_ascent(std::vector<Observation>& all, const Published& p, const Replay& r) {
    for (std::size_t k = 1; k < r.steps.size(); ++k) {
        const AscentStep& s = r.steps[k];
        const double ratio = s.taken / s.by_effects;
        const bool along = ratio > 0.8 && ratio < 1.25;  // steps are said to one figure
        all.push_back(
            {"ascent", "step_taken_over_step_by_effects_of_" + s.factor, ratio, "1", p.ascent.table,
             along ? Judgement::fine : Judgement::caution,
             fmt::format("beside {:+g} of {}, the effects of {} give {:+.2g} of {}; {:+g} "
                         "was taken",
                         r.steps.front().taken, r.steps.front().factor, p.effects_table,
                         s.by_effects, s.factor, s.taken)});
    }
    Trials path = trials_of(p.ascent);
    const int known = rank(model_matrix(path.design, Terms::linear));
    const auto failed = std::count_if(p.ascent.rows.begin(), p.ascent.rows.end(),
                                      [](const PublishedRow& row) { return !row.formed; });
    all.push_back(
        {"ascent", "rank_of_the_path", static_cast<double>(known), "1", p.ascent.table,
         Judgement::caution,
         fmt::format("{} of {} runs formed no heap. All {} factors moved together (rank {} "
                     "of {}), so that these runs do not say which of them is to blame, "
                     "nor give a threshold for one alone",
                     failed, p.ascent.rows.size(), p.ascent.factors.size(), known,
                     p.ascent.factors.size() + 1)});
}

void add_repeats(std::vector<Observation>& all, const Published& p) {
    int again = 0;
    for (const PublishedRow& row : p.orthogonal.rows) {
        for (const PublishedRow& before : p.second_ascent.rows) {
            bool same = row.response->text == before.response->text;
            for (std::size_t k = 0; k < row.values.size(); ++k)
                same = same && row.values[k].value == before.values[k].value;
            again += same;
        }
    }
    all.push_back(
        {"orthogonal test", "runs_used_again", static_cast<double>(again), "1", p.orthogonal.table,
         Judgement::caution,
         fmt::format("two factors at three levels in {} runs are all combinations, so nothing is "
                     "left of an orthogonal array's saving; {} of the runs are those of {}. No run "
                     "was made twice: there is no pure error, and the scatter between seeds is not "
                     "known",
                     p.orthogonal.rows.size(), again, p.second_ascent.table)});
}

void add_variance(std::vector<Observation>& all, const Published& p, const Replay& r) {
    for (const VarianceRow& row : r.orthogonal.factors) {
        const bool seen = row.p < 0.05;
        all.push_back(
            {"orthogonal test", "f_of_" + row.source, row.f, "1", p.orthogonal.table,
             seen ? Judgement::fine : Judgement::unusable,
             fmt::format("{} has a sum of squares of {:.2f} on {} degrees of freedom, p = {:.2g}: "
                         "the response {} it over the levels tried",
                         row.source, row.sum_of_squares, row.degrees_of_freedom, row.p,
                         seen ? "shows" : "does not fix")});
    }
    std::string values;
    for (const Crossing& c : r.crossings)
        values += fmt::format("{}{:g}: {:.4f} (slope {:.0f})", values.empty() ? "" : ", ", c.first,
                              c.second, c.slope);
    const auto [least, most] = std::minmax_element(
        r.crossings.begin(), r.crossings.end(),
        [](const Crossing& a, const Crossing& b) { return a.second < b.second; });
    if (!r.crossings.empty())
        all.push_back(
            {"orthogonal test", "spread_of_the_solution", most->second - least->second,
             p.factor(p.orthogonal.factors[1]).unit, p.orthogonal.table, Judgement::caution,
             fmt::format("the target is met at every {}: at {}. It is a ridge, of which "
                         "one point was taken; a quadratic through all runs gives {:.4f}. "
                         "A second target would cut it",
                         p.orthogonal.factors[0], values, r.pooled_solution)});
}

void add_confirmation(std::vector<Observation>& all, const Published& p, const Replay& r) {
    const double off = std::abs(p.confirmed.value - p.experiment.target.value);
    const double s = r.orthogonal.spread;
    all.push_back({"orthogonal test", "confirmed_off_target_over_spread", off / s, "1",
                   p.confirmed_table, Judgement::caution,
                   fmt::format("the confirming run lies {:.2f} {} off, {} %; the runs scatter by "
                               "{:.2f} {} about additive effects ({} degrees of freedom), so that "
                               "one run this near is luck in part",
                               off, p.unit, p.confirmed_error.text, s, p.unit,
                               r.orthogonal.residual.degrees_of_freedom)});
    all.push_back({"orthogonal test", "line_at_the_printed_solution", r.line.at_printed, p.unit,
                   p.line.table, Judgement::fine,
                   fmt::format("the line is {:.4g} x + {:.5g} and meets the target at {:.6f}; at "
                               "{} it gives {:.3f} {}",
                               r.line.slope, r.line.intercept, r.line.solution,
                               p.line.solution.text, r.line.at_printed, p.unit)});
}

void add_experiment(std::vector<Observation>& all, const Published& p, const Replay& r) {
    const statistics::Summary s = statistics::summary(p.experiment.readings);
    const statistics::Interval i = statistics::student_interval(s, 0.95);
    const double half = 0.5 * (i.high - i.low);
    const std::string& unit = p.factor(p.orthogonal.factors[1]).unit;
    all.push_back({"experiment", "half_width_of_95_percent", half, p.unit, p.experiment.table,
                   Judgement::caution,
                   fmt::format("{} readings on one heap have s = {:.2f} {} and a mean known to +- "
                               "{:.2f} {}; through the line that is +- {:.2f} {} of {}",
                               s.count, s.standard_deviation, p.unit, half, p.unit,
                               half / r.line.slope, unit, p.orthogonal.factors[1])});
    const auto [low, high] =
        std::minmax_element(p.experiment.readings.begin(), p.experiment.readings.end());
    const double from = (*low - r.line.intercept) / r.line.slope;
    const double to = (*high - r.line.intercept) / r.line.slope;
    all.push_back({"experiment", "solutions_over_the_readings", to - from, unit, p.experiment.table,
                   Judgement::caution,
                   fmt::format("the readings {:g} to {:g} {} are met from {:.3f} to {:.3f} {}: two "
                               "figures of {} are more than the experiment carries",
                               *low, *high, p.unit, from, to, unit, p.line.solution.text)});
    all.push_back({"experiment", "targets_per_parameter",
                   1.0 / static_cast<double>(p.factors.size()), "1", p.experiment.table,
                   Judgement::caution,
                   fmt::format("one number is the target of {} parameters; the bulk density was "
                               "measured and could be a second",
                               p.factors.size())});
    // Full angle of the funnel's cone; its outlet is its smaller end.
    const double cone = 2.0 *
                        std::atan2(0.5 * (p.experiment.top_diameter - p.experiment.outlet_diameter),
                                   p.experiment.cone_height) *
                        180.0 / std::numbers::pi;
    all.push_back(
        {"experiment", "funnel_cone_angle", cone, "deg", p.experiment.table, Judgement::caution,
         fmt::format("GB/T 16913-2008, 4.5, asks for an outlet of 5 mm, a cone of 60 +- "
                     "0.5 deg, 80 +- 2 mm to the plate, and 3 to 5 heaps with mean and "
                     "standard deviation; here {:g} mm, {:.1f} deg, {:g} mm, and one heap "
                     "read at {} places",
                     1e3 * p.experiment.outlet_diameter, cone, 1e3 * p.experiment.outlet_height,
                     s.count)});
}

}  // namespace

std::vector<Observation> refinement_observations(const Published& p, const Replay& r) {
    std::vector<Observation> all;
    add_ascent(all, p, r);
    add_repeats(all, p);
    add_variance(all, p, r);
    add_confirmation(all, p, r);
    add_experiment(all, p, r);
    return all;
}

}  // namespace calibrate
