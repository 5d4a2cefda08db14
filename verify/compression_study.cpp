// SPDX-License-Identifier: MIT
#include "verify/compression_study.hpp"

#include "contact/effective.hpp"
#include "scaling/scale_map.hpp"
#include "scaling/schemes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

namespace verify {
namespace {

constexpr double power = 0.95, confidence = 0.95;
constexpr double filled = 0.28;   // solid share of the cell as it is filled
constexpr double gravity = 9.81;  // m/s^2
constexpr double crush_strain = 0.15;
constexpr double pause_strain =
    0.05;  // the piston's way in a pause, if it went on, over half of the cell's height
constexpr double bits_h = 2.0;

CompressionJob job_of(const CompressionPlan& plan, const AdhesionRule& rule, double h,
                      std::uint64_t seed) {
    return {.name = fmt::format("{}-h{:g}-{}", rule.name, h, seed),
            .seed = seed,
            .setup = compression_setup(plan, rule, h, seed)};
}

CompressionJob image_of(CompressionJob job) {
    const auto map = scaling::ScaleMap::solve(scaling::named_scheme("exact"), bits_h);
    job.name = "exact-2-of-" + job.name;
    job.setup = rigs::scaled(job.setup, map);
    job.unit_of_length = map.factor("length"), job.unit_of_time = map.factor("time");
    return job;
}

BitsCheck bits_of(const CompressionSample& original, const CompressionSample& image) {
    return {.scheme = "exact",
            .h = bits_h,
            .grains = static_cast<std::size_t>(image.grains),
            .reference = original.hash,
            .scaled = image.hash,
            .equal = original.hash == image.hash};
}

// What samples are compared by, in the order of the table.
struct Measured {
    const char *name, *unit;
    double CompressionSample::*value;
    double CompressionMargins::*margin;
    bool relative;  // the margin is a share of the reference's mean
};
constexpr Measured measured[] = {
    {"strength", "Pa", &CompressionSample::strength, &CompressionMargins::strength, true},
    {"strain", "1", &CompressionSample::strain, &CompressionMargins::strain, false},
    {"packing_fraction", "1", &CompressionSample::packing_fraction,
     &CompressionMargins::packing_fraction, false},
    {"coordination", "1", &CompressionSample::coordination, &CompressionMargins::coordination,
     false},
};

statistics::Summary summary_of(const CompressionSide& side, double CompressionSample::*value) {
    std::vector<double> values;
    for (const CompressionSample& s : side.samples) values.push_back(s.*value);
    return statistics::summary(values);
}

Quantity compare(const Measured& m, const CompressionSide& reference, const CompressionSide& side,
                 const CompressionMargins& margins) {
    Quantity q{};
    q.name = m.name, q.unit = m.unit;
    q.reference = summary_of(reference, m.value);
    q.scaled = summary_of(side, m.value);
    const double margin = margins.*m.margin * (m.relative ? q.reference.mean : 1.0);
    q.test = statistics::two_one_sided_tests(q.reference, q.scaled, margin, margins.alpha);
    const double pooled = std::hypot(q.reference.standard_deviation, q.scaled.standard_deviation) /
                          std::numbers::sqrt2;
    q.seeds_for_power = statistics::seeds_per_side(pooled, margin, power, margins.alpha);
    return q;
}

CompressionCellResult compared(const AdhesionRule& rule, const CompressionSide& reference,
                               CompressionSide side, const CompressionMargins& margins) {
    CompressionCellResult cell{
        .side = std::move(side), .quantities = {}, .answer = {}, .claims = true};
    bool all_inside = true, some_outside = false;
    for (const Measured& m : measured) {
        if (m.relative && !rule.adhesive) continue;  // dry grains carry nothing
        const Quantity q = compare(m, reference, cell.side, margins);
        const double low = q.test.interval.low, high = q.test.interval.high;
        all_inside = all_inside && q.test.equivalent;
        some_outside = some_outside || low > q.test.margin || high < -q.test.margin;
        cell.claims = cell.claims && q.seeds_for_power > 0 &&
                      std::min(q.reference.count, q.scaled.count) >= q.seeds_for_power;
        cell.quantities.push_back(q);
    }
    cell.answer = some_outside ? Answer::different
                  : all_inside ? Answer::equivalent
                               : Answer::not_decided;
    return cell;
}

// ln(strength) = a + p ln(h), least squares with its own scatter. Needs two h and three samples.
void fit_exponent(RuleResult& result) {
    std::vector<std::pair<double, double>> points;
    const auto take = [&](const CompressionSide& side) {
        for (const CompressionSample& s : side.samples)
            points.emplace_back(std::log(side.h), std::log(s.strength));
    };
    take(result.reference);
    for (const CompressionCellResult& cell : result.cells) take(cell.side);
    const auto n = static_cast<double>(points.size());
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, rest = 0.0;
    for (const auto& [a, b] : points) x += a / n, y += b / n;
    for (const auto& [a, b] : points) xx += (a - x) * (a - x), xy += (a - x) * (b - y);
    const double p = xy / xx;
    for (const auto& [a, b] : points) rest += std::pow(b - y - p * (a - x), 2.0);
    const double half = statistics::student_quantile(0.5 * (1.0 + confidence), n - 2.0) *
                        std::sqrt(rest / (n - 2.0) / xx);
    result.strength_exponent = p;
    result.strength_exponent_interval = {p - half, p + half};
}

// Groups of jobs that differ in the seed alone. No seed stands in two of them.
struct Groups {
    int seeds;  // a group
    std::vector<CompressionJob> jobs{};
    std::vector<double> h{};  // [groups]

    std::size_t add(const CompressionPlan& plan, const AdhesionRule& rule, double of_h,
                    std::uint64_t from) {
        for (int k = 0; k < seeds; ++k)
            jobs.push_back(job_of(plan, rule, of_h, from + static_cast<std::uint64_t>(k)));
        h.push_back(of_h);
        return h.size() - 1;
    }
    const CompressionJob& job(std::size_t group) const {
        return jobs[group * static_cast<std::size_t>(seeds)];
    }
    CompressionSide side(std::size_t group, const std::vector<CompressionSample>& samples) const {
        const rigs::CompressionSetup& s = job(group).setup;
        const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(group) * seeds;
        return {h[group], s.grains.work_of_adhesion, s.d, {begin, begin + seeds}};
    }
};

// Over all samples; of crushing over those that stick, since a dry sample offers no stress to divide by.
void find_inertial_numbers(CompressionStudy& study) {
    for (const RuleResult& result : study.rules) {
        std::vector<const CompressionSide*> sides = {&result.reference};
        for (const CompressionCellResult& cell : result.cells) sides.push_back(&cell.side);
        for (const CompressionSide* side : sides)
            for (const CompressionSample& s : side->samples) {
                double& confined = study.largest_inertial_number;
                confined = std::max(confined, s.inertial_number);
                double& crush = study.largest_inertial_number_of_crush;
                if (result.rule.adhesive) crush = std::max(crush, s.inertial_number_of_crush);
            }
    }
}

}  // namespace

CompressionPlan small_plan() { return {.width = 8.0, .height = 31.0, .h = {2.0}, .seeds = 3}; }

CompressionPowder compression_powder() {
    CompressionPowder p{.d = 1e-4,
                        .density = 2500.0,
                        .youngs_modulus = 3e7,
                        .poisson_ratio = 0.3,
                        .work_of_adhesion = 0.25,
                        .stress = 1e4,
                        .pull_off_over_stress = 0.0};
    p.pull_off_over_stress =
        1.5 * std::numbers::pi * p.work_of_adhesion * (0.25 * p.d) / (p.stress * p.d * p.d);
    return p;
}

const std::vector<AdhesionRule>& adhesion_rules() {
    static const std::vector<AdhesionRule> rules = {
        {"stress_bond", "w times h: force as d^2", 1.0, true},
        {"no_correction", "w kept: force as d", 0.0, true},
        {"weight_bond", "w times h^2: force as d^3", 2.0, true},
        {"dry", "no adhesion", 0.0, false},
    };
    return rules;
}

rigs::CompressionSetup compression_setup(const CompressionPlan& plan, const AdhesionRule& rule,
                                         double h, std::uint64_t seed) {
    const CompressionPowder p = compression_powder();
    rigs::CompressionSetup s{};
    const double width = plan.width * p.d, height = plan.height * p.d;
    s.cell = {.width = width,
              .height = height,
              .solid_volume = filled * width * width * height,
              .stress = p.stress,
              .speed = plan.speed,
              .crush_strain = crush_strain,
              .pause = pause_strain * 0.5 * height / plan.speed};
    s.d = h * p.d;
    s.density = p.density;
    s.gravity = gravity;
    const contact::Material stuff{scaling::Pressure::from_value(p.youngs_modulus), p.poisson_ratio,
                                  scaling::Density::from_value(p.density)};
    s.grains = {
        .e_star = contact::e_star(stuff, stuff).value(),
        .g_star = contact::g_star(stuff, stuff).value(),
        .work_of_adhesion = rule.adhesive ? p.work_of_adhesion * std::pow(h, rule.exponent) : 0.0,
        .sliding_friction = 0.5,
        .rolling_friction = 0.1,
        .restitution = 0.3};
    s.plates = s.grains;
    s.plates.work_of_adhesion = 0.0;
    rigs::fill_cell(s, seed);
    return s;
}

CompressionStudy compression_study(const CompressionPlan& plan, std::uint64_t seed,
                                   const Campaign& campaign) {
    const auto start = std::chrono::steady_clock::now();
    CompressionStudy study{.plan = plan,
                           .powder = compression_powder(),
                           .margins = {},
                           .rules = {},
                           .half_speed = {},
                           .bits = {},
                           .largest_inertial_number = 0.0,
                           .largest_inertial_number_of_crush = 0.0};
    const std::vector<AdhesionRule>& rules = adhesion_rules();
    const AdhesionRule &main_rule = rules.front(), &dry = rules.back();
    Groups groups{.seeds = plan.seeds};
    // A group's seeds do not hang on which others are run, so that its samples are found again.
    std::uint64_t number = 0;
    const auto seeds_of_next = [&] { return seed + 1000 * number++; };
    std::vector<std::vector<std::size_t>> of_rule(rules.size());  // groups, by h
    for (std::size_t k = 0; k < rules.size(); ++k)
        for (const double h : plan.h)
            of_rule[k].push_back(groups.add(plan, rules[k], h, seeds_of_next()));
    // Adhesive rules are the same powder at h = 1: one reference serves them all.
    const std::uint64_t of_sticky = seeds_of_next(), of_loose = seeds_of_next();
    std::optional<std::size_t> sticky, loose;
    if (!plan.among_larger) {
        sticky = groups.add(plan, main_rule, 1.0, of_sticky);
        loose = groups.add(plan, dry, 1.0, of_loose);
    }
    CompressionPlan slow = plan;
    slow.speed *= 0.5;
    const std::size_t slowly = groups.add(slow, main_rule, plan.h.back(), seeds_of_next());
    const std::size_t original = of_rule.front().back();
    groups.jobs.push_back(image_of(groups.job(original)));
    const std::vector<CompressionSample> samples = run_compressions(groups.jobs, campaign);

    for (std::size_t k = 0; k < rules.size(); ++k) {
        const std::size_t reference =
            (rules[k].adhesive ? sticky : loose).value_or(of_rule[k].front());
        RuleResult result{.rule = rules[k],
                          .reference = groups.side(reference, samples),
                          .cells = {},
                          .strength_exponent = 0.0,
                          .strength_exponent_interval = {}};
        for (const std::size_t group : of_rule[k])
            if (group != reference)
                result.cells.push_back(compared(rules[k], result.reference,
                                                groups.side(group, samples), study.margins));
        if (rules[k].adhesive) fit_exponent(result);
        study.rules.push_back(std::move(result));
    }
    const CompressionSide at_speed = groups.side(original, samples);
    study.half_speed = compared(main_rule, at_speed, groups.side(slowly, samples), study.margins);
    study.bits = bits_of(at_speed.samples.front(), samples.back());
    find_inertial_numbers(study);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    study.seconds = seconds.count();
    return study;
}

}  // namespace verify
