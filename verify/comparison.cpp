// SPDX-License-Identifier: MIT
#include "verify/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace verify {
namespace {

constexpr double power = 0.95;

statistics::Summary summary_of(const std::vector<PileSample>& samples,
                               const std::string& quantity) {
    std::vector<double> values;
    for (const PileSample& sample : samples) {
        if (const auto angle = sample.angle_deg(rigs::Estimator::two_h_over_d);
            quantity == "angle_of_repose" && angle)
            values.push_back(*angle);
        if (quantity == "packing_fraction" && sample.packing_fraction)
            values.push_back(*sample.packing_fraction);
        if (quantity == "coordination") values.push_back(sample.coordination);
    }
    if (values.size() <
        2)  // heaps too small for a packing fraction, say: nothing to be told of the scatter
        return {values.empty() ? 0.0 : values.front(), 0.0, values.size()};
    return statistics::summary(values);
}

Quantity compare(const std::string& name, const std::string& unit, double margin, double alpha,
                 const Side& reference, const Side& scaled) {
    Quantity q{};
    q.name = name;
    q.unit = unit;
    q.reference = summary_of(reference.samples, name);
    q.scaled = summary_of(scaled.samples, name);
    if (q.reference.count < 2 || q.scaled.count < 2) {
        q.test.margin = margin;
        q.test.alpha = alpha;
        q.test.p = 1.0;
        return q;
    }
    q.test = statistics::two_one_sided_tests(q.reference, q.scaled, margin, alpha);
    const double pooled =
        std::sqrt(0.5 * (q.reference.standard_deviation * q.reference.standard_deviation +
                         q.scaled.standard_deviation * q.scaled.standard_deviation));
    q.seeds_for_power = statistics::seeds_per_side(pooled, margin, power, alpha);
    return q;
}

}  // namespace

double youngs_modulus(const rigs::PileSetup& s, double poisson_ratio) {
    return 2.0 * (1.0 - poisson_ratio * poisson_ratio) * s.grains.e_star;  // E* of two like grains
}

Side side_of(const std::string& label, const PileJob& job, double poisson_ratio) {
    const rigs::PileSetup& s = job.setup;
    Side side{};
    side.label = label;
    side.diameter = s.d;
    side.gravity = s.gravity;
    side.youngs_modulus = youngs_modulus(s, poisson_ratio);
    side.work_of_adhesion = s.grains.work_of_adhesion;
    const double weight = s.density * std::numbers::pi / 6.0 * s.d * s.d * s.d * s.gravity;
    side.bond_number = 1.5 * std::numbers::pi * s.grains.work_of_adhesion * (0.25 * s.d) / weight;
    side.elasticity = side.youngs_modulus / (s.density * s.gravity * s.d);
    return side;
}

Comparison compare(const std::string& name, const std::string& what_differs, Side reference,
                   Side scaled, const Margins& m) {
    Comparison c{.name = name,
                 .what_differs = what_differs,
                 .reference = std::move(reference),
                 .scaled = std::move(scaled),
                 .quantities = {},
                 .answer = Answer::not_decided,
                 .must_differ = false,
                 .claims = true};
    c.quantities = {
        compare("angle_of_repose", "deg", m.angle_deg, m.alpha, c.reference, c.scaled),
        compare("packing_fraction", "1", m.packing_fraction, m.alpha, c.reference, c.scaled),
        compare("coordination", "1", m.coordination, m.alpha, c.reference, c.scaled),
    };
    bool all_inside = true, some_outside = false;
    for (const Quantity& q : c.quantities) {
        const std::size_t least = std::min(q.reference.count, q.scaled.count);
        c.claims = c.claims && least >= 2 && q.seeds_for_power > 0 && least >= q.seeds_for_power;
        all_inside = all_inside && q.test.equivalent;
        some_outside = some_outside || q.test.interval.low > q.test.margin ||
                       q.test.interval.high < -q.test.margin;
    }
    c.answer = some_outside ? Answer::different
               : all_inside ? Answer::equivalent
                            : Answer::not_decided;
    return c;
}

std::vector<PileJob> jobs(int seeds, std::uint64_t first,
                          const std::function<PileJob(std::uint64_t)>& make) {
    std::vector<PileJob> result;
    for (int k = 0; k < seeds; ++k) result.push_back(make(first + static_cast<std::uint64_t>(k)));
    return result;
}

std::size_t Plan::add(std::vector<PileJob> jobs) {
    groups_.push_back({all_.size(), jobs.size()});
    all_.insert(all_.end(), std::make_move_iterator(jobs.begin()),
                std::make_move_iterator(jobs.end()));
    return groups_.size() - 1;
}

std::vector<PileSample> Plan::samples(std::size_t group) const {
    const auto from = samples_.begin() + static_cast<std::ptrdiff_t>(groups_[group].first);
    return {from, from + static_cast<std::ptrdiff_t>(groups_[group].count)};
}

const char* to_string(Answer answer) {
    switch (answer) {
        case Answer::equivalent:
            return "equivalent";
        case Answer::different:
            return "different";
        case Answer::not_decided:
            return "not decided";
    }
    return "";
}

}  // namespace verify
