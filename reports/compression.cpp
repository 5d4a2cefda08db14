// SPDX-License-Identifier: MIT
#include "reports/compression.hpp"

#include "reports/compression_figures.hpp"
#include "reports/numbers.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace reports {

namespace {

using verify::CompressionCellResult;
using verify::CompressionSide;
using verify::CompressionStudy;
using verify::RuleResult;

// Three digits: the fourth of a mean of some seeds is chance.
std::string rounded(double value) { return fmt::format("{:.3g}", value); }

std::string interval_text(const statistics::Interval& i) {
    return fmt::format("[{:.2f}, {:.2f}]", i.low, i.high);
}

std::string mean_text(const statistics::Summary& s, double unit) {
    return fmt::format("{} (sd {:.2g})", rounded(s.mean / unit), s.standard_deviation / unit);
}

std::vector<std::string> row_of(const CompressionSide& side, const verify::Quantity& q) {
    const statistics::Interval i = q.test.interval;
    const bool outside = i.low > q.test.margin || i.high < -q.test.margin;
    const double unit = q.unit == "Pa" ? 1e3 : 1.0;
    return {fmt::format("h = {:g}, {}{}", side.h, words(q.name), q.unit == "Pa" ? ", kPa" : ""),
            mean_text(q.reference, unit),
            mean_text(q.scaled, unit),
            fmt::format("{} [{}, {}]", rounded(q.test.difference / unit), rounded(i.low / unit),
                        rounded(i.high / unit)),
            rounded(q.test.margin / unit),
            q.seeds_for_power > 0 ? fmt::format("{}", q.seeds_for_power) : "none is enough",
            map_word(outside             ? verify::Answer::different
                     : q.test.equivalent ? verify::Answer::equivalent
                                         : verify::Answer::not_decided)};
}

const std::vector<std::string> heading = {
    "quantity", "reference", "larger grains", "difference [90 %]", "margin", "seeds needed", ""};

TextTable table_of(const std::vector<const CompressionCellResult*>& cells) {
    TextTable rows = {heading};
    for (const CompressionCellResult* cell : cells)
        for (const verify::Quantity& q : cell->quantities) rows.push_back(row_of(cell->side, q));
    return rows;
}

TextTable table_of(const RuleResult& r) {
    std::vector<const CompressionCellResult*> cells;
    for (const CompressionCellResult& cell : r.cells) cells.push_back(&cell);
    return table_of(cells);
}

std::string answers_of(const RuleResult& r) {
    std::string text;
    for (const CompressionCellResult& cell : r.cells)
        text += fmt::format("{}h = {:g} {}", text.empty() ? "" : ", ", cell.side.h,
                            map_word(cell.answer));
    return text;
}

// All cells of a rule in one word; too few seeds leave it open unless it breaks.
Answer answer_of(const RuleResult& r) {
    bool all = true;
    for (const CompressionCellResult& cell : r.cells) {
        if (cell.answer == verify::Answer::different) return Answer::no;
        all = all && cell.answer == verify::Answer::equivalent && cell.claims;
    }
    return all ? Answer::yes : Answer::cannot_tell;
}

RunSection rule_section(const RuleResult& r) {
    RunSection s{
        .name = r.rule.what,
        .verdict = {answer_of(r), answers_of(r),
                    r.rule.adhesive
                        ? fmt::format(
                              "strength as h to the power {:.2f}, 95 % interval [{:.2f}, {:.2f}]",
                              r.strength_exponent, r.strength_exponent_interval.low,
                              r.strength_exponent_interval.high)
                        : "the control: nothing to be scaled but the grains"},
        .notes = {},
        .figure = confined_figure(r),
        .quantities = table_of(r),
        .intervals = {}};
    s.intervals.push_back(crushed_figure(r));
    const auto note = [&](const CompressionSide& side) {
        s.notes.push_back(fmt::format("h = {:g}: {} grains of {}, w = {}, {} seeds", side.h,
                                      number(side.samples.front().grains), quantity(side.d, "m"),
                                      quantity(side.work_of_adhesion, "J/m^2"),
                                      side.samples.size()));
    };
    note(r.reference);
    for (const CompressionCellResult& cell : r.cells) note(cell.side);
    return s;
}

// What the abstract states, and no more: figures and tables of the paper were not seen.
TextTable source_table(const CompressionStudy& study) {
    const auto exponent = [&](std::size_t k) {
        const RuleResult& r = study.rules[k];
        return fmt::format("strength as h to the power {:.2f} {}; {}", r.strength_exponent,
                           interval_text(r.strength_exponent_interval), answers_of(r));
    };
    return {
        {"Thakur, Ooi & Ahmadian 2016, abstract", "here"},
        {"stiffness of contacts, normal and tangential, scales linearly with the particle size",
         "one E and G: a Hertz or Mindlin contact is h times as stiff at one overlap over R; "
         "not varied"},
        {"the adhesive force scales very well with the square of the particle size", exponent(0)},
        {"(not stated) force as d", exponent(1)},
        {"(not stated) force as d^3", exponent(2)},
        {"scale independent predictions are sought for cohesionless solid, too",
         "no adhesion: " + answers_of(study.rules[3])}};
}

RunSection strength_section(const CompressionStudy& study) {
    return {.name = "Beside the source",
            .verdict = verdict_of(study),
            .notes = {"Thakur, Ooi & Ahmadian (2016), Powder Technol. 293, 130: a bilinear "
                      "elasto-plastic adhesive frictional law; here JKR, which is elastic."},
            .figure = strength_figure(study),
            .quantities = source_table(study),
            .intervals = {}};
}

RunSection speed_section(const CompressionStudy& study) {
    const CompressionCellResult& cell = study.half_speed;
    const bool same = cell.answer == verify::Answer::equivalent;
    return {.name = "Half of the speed",
            .verdict = {same ? Answer::yes : Answer::cannot_tell,
                        same ? "nothing changes beyond the margins" : map_word(cell.answer),
                        fmt::format(
                            "inertial numbers of the study: at most {:.1e} confined, {:.1e} "
                            "while sticky samples are crushed",
                            study.largest_inertial_number, study.largest_inertial_number_of_crush)},
            .notes = {fmt::format("{}; the reference is the same at full speed.",
                                  study.rules.front().rule.what)},
            .figure = {},
            .quantities = table_of({&cell}),
            .intervals = {}};
}

std::string bits_text(const CompressionStudy& s) {
    return fmt::format("{} grains, cell and all, h = {:g} under exact: {} ({:016x}, {:016x})",
                       s.bits.grains, s.bits.h, s.bits.equal ? "the same bits" : "DIFFERENT bits",
                       s.bits.reference, s.bits.scaled);
}

Json summary_json(const statistics::Summary& s) {
    return {{"mean", s.mean}, {"standard_deviation", s.standard_deviation}, {"count", s.count}};
}

Json cell_json(const CompressionCellResult& cell) {
    Json quantities = Json::array();
    for (const verify::Quantity& q : cell.quantities)
        quantities.push_back({{"name", q.name},
                              {"unit", q.unit},
                              {"reference", summary_json(q.reference)},
                              {"scaled", summary_json(q.scaled)},
                              {"difference", q.test.difference},
                              {"interval", {q.test.interval.low, q.test.interval.high}},
                              {"margin", q.test.margin},
                              {"p_value", q.test.p},
                              {"equivalent", q.test.equivalent},
                              {"seeds_for_power", q.seeds_for_power}});
    return {{"h", cell.side.h},
            {"answer", map_word(cell.answer)},
            {"claimed", cell.claims},
            {"quantities", std::move(quantities)}};
}

Json side_json(const CompressionSide& side) {
    Json samples = Json::array();
    for (const verify::CompressionSample& s : side.samples)
        samples.push_back({{"seed", s.seed},
                           {"grains", s.grains},
                           {"strength", s.strength},
                           {"strain_at_strength", s.strain_at_strength},
                           {"strain", s.strain},
                           {"packing_fraction", s.packing_fraction},
                           {"coordination", s.coordination},
                           {"floor_over_piston", s.floor_over_piston},
                           {"inertial_number", s.inertial_number},
                           {"inertial_number_of_crush", s.inertial_number_of_crush},
                           {"steps", s.steps},
                           {"hash", fmt::format("{:016x}", s.hash)}});
    return {{"h", side.h},
            {"diameter", side.d},
            {"work_of_adhesion", side.work_of_adhesion},
            {"samples", std::move(samples)}};
}

Json rule_json(const RuleResult& r) {
    Json cells = Json::array(), sides = Json::array({side_json(r.reference)});
    for (const CompressionCellResult& cell : r.cells)
        cells.push_back(cell_json(cell)), sides.push_back(side_json(cell.side));
    Json json = {{"rule", r.rule.name}, {"what", r.rule.what}};
    if (r.rule.adhesive)
        json["strength_exponent"] = {
            {"value", r.strength_exponent},
            {"interval", {r.strength_exponent_interval.low, r.strength_exponent_interval.high}}};
    json["cells"] = std::move(cells);
    json["sides"] = std::move(sides);
    return json;
}

}  // namespace

const char* map_word(verify::Answer answer) {
    return answer == verify::Answer::equivalent  ? "holds"
           : answer == verify::Answer::different ? "breaks"
                                                 : "not decided";
}

Verdict verdict_of(const CompressionStudy& study) {
    const std::string why =
        fmt::format("force as d^2: {}; force as d: {}; force as d^3: {}; {} seeds a side",
                    answers_of(study.rules[0]), answers_of(study.rules[1]),
                    answers_of(study.rules[2]), study.plan.seeds);
    const Answer main = answer_of(study.rules[0]);
    bool others_break = true, other_holds = false;
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
        const CompressionCellResult& largest = study.rules[k].cells.back();
        others_break = others_break && largest.answer == verify::Answer::different;
        other_holds = other_holds || largest.answer == verify::Answer::equivalent;
    }
    if (!study.bits.equal) return {Answer::no, "Bits are not kept under exact scaling", why};
    if (main == Answer::no)
        return {Answer::no, "Force as d^2 does not keep every quantity inside its margin", why};
    if (other_holds) return {Answer::no, "A rule other than force as d^2 passes", why};
    const bool slow = study.half_speed.answer == verify::Answer::equivalent;
    if (main == Answer::yes && others_break && slow)
        return {Answer::yes,
                "Strength and compression collapse for force as d^2, and not otherwise", why};
    return {Answer::cannot_tell,
            others_break ? "Force as d and as d^3 break; force as d^2 is not decided everywhere"
                         : "Not decided",
            why};
}

std::string text_of(const CompressionStudy& study) {
    const Verdict verdict = verdict_of(study);
    std::string text = fmt::format("{}\n{}\n\n", verdict.headline, wrapped(verdict.why, 110, 0));
    const std::vector<bool> right = {false, true, true, true, true, true, false};
    for (const RuleResult& r : study.rules) {
        text += fmt::format("{}: {}", r.rule.what, answers_of(r));
        if (r.rule.adhesive)
            text += fmt::format("; strength as h to the power {:.2f} {}", r.strength_exponent,
                                interval_text(r.strength_exponent_interval));
        text += fmt::format("\n{}\n", columns(table_of(r), right));
    }
    text += fmt::format("half of the speed\n{}\n", columns(table_of({&study.half_speed}), right));
    text += fmt::format("inertial number at most {:.1e} confined, {:.1e} crushed (sticky)\n",
                        study.largest_inertial_number, study.largest_inertial_number_of_crush);
    return text + bits_text(study) + "\n";
}

Json to_json(const CompressionStudy& study) {
    const Verdict verdict = verdict_of(study);
    const verify::CompressionPowder& p = study.powder;
    Json rules = Json::array();
    for (const RuleResult& r : study.rules) rules.push_back(rule_json(r));
    return {{"verdict", to_string(verdict.answer)},
            {"why", verdict.why},
            {"powder",
             {{"diameter", p.d},
              {"density", p.density},
              {"youngs_modulus", p.youngs_modulus},
              {"poisson_ratio", p.poisson_ratio},
              {"work_of_adhesion", p.work_of_adhesion},
              {"consolidation_stress", p.stress},
              {"pull_off_over_stress_d2", p.pull_off_over_stress}}},
            {"speed", study.plan.speed},
            {"margins",
             {{"strength_relative", study.margins.strength},
              {"strain", study.margins.strain},
              {"packing_fraction", study.margins.packing_fraction},
              {"coordination", study.margins.coordination},
              {"alpha", study.margins.alpha}}},
            {"rules", std::move(rules)},
            {"half_speed", cell_json(study.half_speed)},
            {"largest_inertial_number", study.largest_inertial_number},
            {"largest_inertial_number_of_crush", study.largest_inertial_number_of_crush},
            {"bits",
             {{"scheme", study.bits.scheme},
              {"h", study.bits.h},
              {"grains", study.bits.grains},
              {"reference", fmt::format("{:016x}", study.bits.reference)},
              {"scaled", fmt::format("{:016x}", study.bits.scaled)},
              {"equal", study.bits.equal}}}};
}

Page page_of(const CompressionStudy& study, const Provenance& who) {
    const verify::CompressionPowder& p = study.powder;
    Page page{
        .title = "A powder of larger grains, compressed and crushed",
        .source = "Thakur, Ooi & Ahmadian (2016), Powder Technol. 293, 130",
        .verdict = verdict_of(study),
        .runs = {strength_section(study)},
        .runs_heading = "Compression",
        .limits = {"One powder: spheres with JKR adhesion, which is elastic; the source has an "
                   "elasto-plastic law, and of it only the abstract was read.",
                   fmt::format("One consolidation stress: {}, F_po/(stress d^2) = {}, E over "
                               "stress {}.",
                               quantity(p.stress, "Pa"), number(p.pull_off_over_stress),
                               number(p.youngs_modulus / p.stress)),
                   fmt::format("The cell is {} to {} grains wide.", number(study.plan.width),
                               number(study.plan.width / study.plan.h.back())),
                   bits_text(study) + "."},
        .provenance = who};
    for (const RuleResult& r : study.rules) page.runs.push_back(rule_section(r));
    page.runs.push_back(speed_section(study));
    return page;
}

}  // namespace reports
