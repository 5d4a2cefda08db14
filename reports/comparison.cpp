// SPDX-License-Identifier: MIT
#include "reports/checks.hpp"
#include "reports/numbers.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace reports {

namespace {

constexpr double confidence =
    0.95;  // of a side's own interval; that of the difference follows from the test's alpha

struct Measured {
    const char *name, *axis;
    std::function<std::optional<double>(const verify::PileSample&)> value;
};

// By the names that the comparison gives its quantities; an unknown one has no figure.
const Measured* measured(const std::string& name) {
    static const std::vector<Measured> all = {
        {"angle_of_repose", "angle of repose, deg",
         [](const verify::PileSample& s) { return s.angle_deg(rigs::Estimator::two_h_over_d); }},
        {"packing_fraction", "packing fraction",
         [](const verify::PileSample& s) { return s.packing_fraction; }},
        {"coordination", "contacts per grain",
         [](const verify::PileSample& s) { return std::optional<double>(s.coordination); }}};
    for (const Measured& m : all)
        if (name == m.name) return &m;
    return nullptr;
}

std::string interval_text(double low, double high) {
    return fmt::format("[{}, {}]", number(low), number(high));
}

std::string mean_text(const statistics::Summary& s) {
    if (s.count < 2) return s.count == 1 ? number(s.mean) : "none";
    const statistics::Interval i = statistics::student_interval(s, confidence);
    return fmt::format("{} {}", number(s.mean), interval_text(i.low, i.high));
}

std::vector<std::string> quantity_row(const verify::Quantity& q) {
    const bool tested = q.reference.count >= 2 && q.scaled.count >= 2;
    const std::string unit = q.unit == "1" ? "" : ", " + q.unit;
    return {words(q.name) + unit,
            mean_text(q.reference),
            mean_text(q.scaled),
            tested ? fmt::format("{} {}", number(q.test.difference),
                                 interval_text(q.test.interval.low, q.test.interval.high))
                   : "none",
            number(q.test.margin),
            q.seeds_for_power > 0 ? fmt::format("{}", q.seeds_for_power) : "none is enough",
            !tested             ? "too few seeds"
            : q.test.equivalent ? "inside the margin"
                                : "not shown to be inside"};
}

IntervalRow interval_row(const verify::Side& side, const statistics::Summary& s, const Measured& m,
                         int style) {
    const statistics::Interval i = s.count >= 2 ? statistics::student_interval(s, confidence)
                                                : statistics::Interval{s.mean, s.mean};
    IntervalRow row{side.label, s.mean, i.low, i.high, {}, style};
    for (const verify::PileSample& sample : side.samples)
        if (const auto value = m.value(sample)) row.values.push_back(*value);
    return row;
}

Figure interval_figure(const verify::Comparison& c, const verify::Quantity& q, const Measured& m,
                       const std::string& id) {
    const std::string title = fmt::format("{}: {} on both sides", c.name, words(q.name));
    const std::string description = fmt::format(
        "{} {}, {} {}; mean and {:.0f} % interval.", c.reference.label, mean_text(q.reference),
        c.scaled.label, mean_text(q.scaled), 100.0 * confidence);
    return {interval_svg(title, description, m.axis,
                         {interval_row(c.reference, q.reference, m, 0),
                          interval_row(c.scaled, q.scaled, m, 1)},
                         id),
            fmt::format("Mean with its {:.0f} % interval; ticks below: one per seed. Margin for "
                        "the difference of the means: {}.",
                        100.0 * confidence, number(q.test.margin))};
}

std::string side_text(const verify::Side& s) {
    return fmt::format(
        "{}: d = {}, g = {}, E = {}, w = {}, F_po/(m g) = {}, E/(rho g d) = {}, {} seeds, of which "
        "{} formed a heap by "
        "every criterion (the others stand as a cake: docs/verify.md) and {} came to rest",
        s.label, quantity(s.diameter, "m"), quantity(s.gravity, "m/s^2"),
        quantity(s.youngs_modulus, "Pa"), quantity(s.work_of_adhesion, "J/m^2"),
        number(s.bond_number), number(s.elasticity), s.samples.size(),
        std::count_if(s.samples.begin(), s.samples.end(),
                      [](const auto& sample) { return sample.formed; }),
        std::count_if(s.samples.begin(), s.samples.end(),
                      [](const auto& sample) { return sample.at_rest; }));
}

HeapGroup group_of(const verify::Side& side) {
    HeapGroup group{fmt::format("{}, d = {}", side.label, quantity(side.diameter, "m")), {}};
    for (const verify::PileSample& s : side.samples)
        if (!s.profile_r.empty()) group.profiles.push_back({s.profile_r, s.profile_z});
    return group;
}

Verdict verdict_of(const verify::Comparison& c) {
    const std::string why =
        fmt::format("compared: {}{}", c.what_differs,
                    c.claims ? "" : "; a claim of equivalence at 95 % power needs more seeds");
    if (c.must_differ) {
        const bool seen = c.answer != verify::Answer::equivalent;
        return {seen ? Answer::yes : Answer::no,
                seen ? "A control, and it does not pass, as it must not"
                     : "A control that passes although it must not",
                why};
    }
    switch (c.answer) {
        case verify::Answer::equivalent:
            return {c.claims ? Answer::yes : Answer::cannot_tell,
                    c.claims ? "Equivalent" : "Inside the margins, not claimed", why};
        case verify::Answer::different:
            return {Answer::no, "Different", why};
        case verify::Answer::not_decided:
            return {Answer::cannot_tell, c.claims ? "Not decided" : "Too few seeds to decide", why};
    }
    return {};
}

}  // namespace

RunSection comparison_section(const verify::Comparison& c) {
    RunSection section{
        words(c.name),
        verdict_of(c),
        {side_text(c.reference), side_text(c.scaled)},
        profile_figure({group_of(c.reference), group_of(c.scaled)}, "profile-" + c.name),
        {},
        {}};
    section.quantities = {{"quantity", c.reference.label + " [95 %]", c.scaled.label + " [95 %]",
                           "difference [90 %]", "margin", "seeds needed", "verdict"}};
    for (const verify::Quantity& q : c.quantities) {
        section.quantities.push_back(quantity_row(q));
        if (const Measured* m = measured(q.name);
            m != nullptr && q.reference.count > 0 && q.scaled.count > 0)
            section.intervals.push_back(interval_figure(c, q, *m, c.name + "-" + q.name));
    }
    return section;
}

}  // namespace reports
