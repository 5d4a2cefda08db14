// SPDX-License-Identifier: MIT
#include "reports/against.hpp"

#include "reports/numbers.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace reports {

namespace {

using verify::AgainstLammps;

std::string share(double size) {
    return std::isfinite(size) ? fmt::format("{:.2g}", size) : "not a number";
}

std::string degrees_or_none(const std::optional<double>& angle) {
    return angle ? fmt::format("{:.1f}", *angle) : "none";
}

std::size_t met(const AgainstLammps& a) {
    return static_cast<std::size_t>(std::count_if(a.checks.begin(), a.checks.end(),
                                                  [](const verify::Check& c) { return c.passed; }));
}

TextTable figures(const AgainstLammps& a) {
    TextTable rows = {{"figure", "expected", "got", "bar", ""}};
    for (const verify::Check& c : a.checks)
        rows.push_back({c.name, quantity(c.expected, c.unit), quantity(c.got, c.unit),
                        tolerance_text(c), c.passed ? "met" : "NOT MET"});
    return rows;
}

TextTable differences(const AgainstLammps& a) {
    TextTable rows = {{"where the rules differ", "size", "shown by"}};
    for (const verify::RuleDifference& d : a.differences)
        rows.push_back({d.rule, share(d.size), d.conditions + "; " + d.measure});
    return rows;
}

TextTable heaps(const verify::HeapRound& h) {
    TextTable rows = {{"seed", "ours, deg", "LAMMPS, deg", "control, deg", "grains",
                       "LAMMPS' grains", "time, ours and LAMMPS"}};
    for (const verify::HeapAngle& one : h.heaps)
        rows.push_back({fmt::format("{}", one.seed), degrees_or_none(one.ours_deg),
                        degrees_or_none(one.lammps_deg), degrees_or_none(one.control_deg),
                        fmt::format("{}", one.ours_on_base), fmt::format("{}", one.lammps_on_base),
                        fmt::format("{:.0f} s, {:.0f} s", one.ours_seconds, one.lammps_seconds)});
    return rows;
}

RunSection differences_section(const AgainstLammps& a) {
    RunSection s{
        .name = "Where the rules differ",
        .verdict = {Answer::yes, "listed, not tolerated",
                    "Each is kept out of the figures by their conditions; its size is what "
                    "it does where it is let in."},
        .notes = {},
        .figure = {},
        .quantities = differences(a),
        .intervals = {}};
    for (const verify::RuleDifference& d : a.differences)
        s.notes.push_back(fmt::format("{}. Ours: {}. LAMMPS: {}.", d.rule, d.ours, d.theirs));
    return s;
}

RunSection heaps_section(const verify::HeapRound& h) {
    const bool same = h.test.equivalent;
    return {
        .name = "Heaps of a slumped column",
        .verdict = {same ? Answer::yes : Answer::no,
                    same ? "equivalent" : "not shown to be equivalent",
                    fmt::format("Ours minus LAMMPS {:.2f} deg, 90 % interval [{:.2f}, {:.2f}], "
                                "margin {} deg.",
                                h.test.difference, h.test.interval.low, h.test.interval.high,
                                number(h.margin.angle_deg))},
        .notes = {fmt::format("F_po/(m g) = {}, E/(rho g d) = {}; 2000 grains let go on a base of "
                              "20 d, glued; the control has 80 % of its friction lost.",
                              number(h.bond_number), number(h.elasticity))},
        .figure = {},
        .quantities = heaps(h),
        .intervals = {}};
}

Json known(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json difference_json(const verify::RuleDifference& d) {
    return {{"rule", d.rule},       {"ours", d.ours},
            {"lammps", d.theirs},   {"conditions", d.conditions},
            {"measure", d.measure}, {"size", std::isfinite(d.size) ? Json(d.size) : Json(nullptr)}};
}

Json heaps_json(const verify::HeapRound& h) {
    Json all = Json::array();
    for (const verify::HeapAngle& one : h.heaps)
        all.push_back({{"seed", one.seed},
                       {"ours_deg", known(one.ours_deg)},
                       {"lammps_deg", known(one.lammps_deg)},
                       {"control_deg", known(one.control_deg)},
                       {"ours_kinetic_energy_over_m_g_d", one.ours_moving},
                       {"lammps_kinetic_energy_over_m_g_d", one.lammps_moving},
                       {"ours_grains_on_base", one.ours_on_base},
                       {"lammps_grains_on_base", one.lammps_on_base},
                       {"ours_seconds", one.ours_seconds},
                       {"lammps_seconds", one.lammps_seconds}});
    return {{"margin_deg", h.margin.angle_deg},
            {"alpha", h.margin.alpha},
            {"difference_deg", h.test.difference},
            {"interval_deg", {h.test.interval.low, h.test.interval.high}},
            {"p_value", h.test.p},
            {"equivalent", h.test.equivalent},
            {"control_interval_deg", {h.control_test.interval.low, h.control_test.interval.high}},
            {"seeds_for_power", h.seeds_for_power},
            {"pull_off_in_grain_weights", h.bond_number},
            {"youngs_modulus_over_rho_g_d", h.elasticity},
            {"samples", std::move(all)}};
}

}  // namespace

Verdict verdict_of(const AgainstLammps& a) {
    const std::string which = fmt::format("{} of {} figures are inside their bars; LAMMPS {}",
                                          met(a), a.checks.size(), a.release);
    if (met(a) == a.checks.size()) return {Answer::yes, "The core agrees with LAMMPS", which};
    return {Answer::no, "The core and LAMMPS differ", which};
}

std::string text_of(const AgainstLammps& a) {
    const Verdict verdict = verdict_of(a);
    std::string text = fmt::format("{}\n{}\n\n", verdict.headline, verdict.why);
    text += columns(figures(a), {false, true, true, true, false}) + "\n";
    text += columns(differences(a), {false, true, false});
    if (!a.heaps) return text;
    return text + "\n" + columns(heaps(*a.heaps), {true, true, true, true, true, true, false});
}

Json to_json(const AgainstLammps& a) {
    const Verdict verdict = verdict_of(a);
    Json json = to_json(Verification{a.checks, std::nullopt});
    Json listed = Json::array();
    for (const verify::RuleDifference& d : a.differences) listed.push_back(difference_json(d));
    json["verdict"] = to_string(verdict.answer);
    json["why"] = verdict.why;
    json["against"] = {{"engine", "lammps"},
                       {"release", a.release},
                       {"differences", std::move(listed)},
                       {"heaps", a.heaps ? heaps_json(*a.heaps) : Json(nullptr)},
                       {"seconds", a.seconds}};
    return json;
}

Page page_of(const AgainstLammps& a, const Provenance& who) {
    Page page{
        .title = "Our core against LAMMPS",
        .source = "LAMMPS " + a.release,
        .verdict = verdict_of(a),
        .verification = Verification{a.checks, std::nullopt},
        .runs = {differences_section(a)},
        .checks_heading = "Figures and their bars",
        .limits = {"Both codes have one set of rules here: this shows that ours does what these "
                   "rules say, not that the rules are those of a powder.",
                   "The heaps are of one size, 2000 like grains, soft and moderately sticky."},
        .provenance = who};
    if (a.heaps) page.runs.push_back(heaps_section(*a.heaps));
    return page;
}

}  // namespace reports
