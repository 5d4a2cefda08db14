// SPDX-License-Identifier: MIT
#include "reports/scaling_map.hpp"

#include "reports/numbers.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace reports {

namespace {

using verify::MapCell;
using verify::MapQuantity;
using verify::MapVerdict;
using verify::ScalingMap;

struct Counts {
    std::size_t holds = 0, breaks = 0, open = 0, missing = 0;
};

Counts counts_of(const ScalingMap& map, const std::string& study) {
    Counts n;
    for (const MapCell& c : map.cells) {
        if (!study.empty() && c.study != study) continue;
        switch (c.verdict) {
            case MapVerdict::holds:
                ++n.holds;
                break;
            case MapVerdict::breaks:
                ++n.breaks;
                break;
            case MapVerdict::not_decided:
                ++n.open;
                break;
            case MapVerdict::not_poured:
                ++n.missing;
        }
    }
    return n;
}

std::string counted(const Counts& n) {
    return fmt::format("{} hold, {} break, {} are not decided", n.holds, n.breaks, n.open) +
           (n.missing > 0 ? fmt::format(", {} are not poured yet", n.missing) : "");
}

double grain_steps(const ScalingMap& map) {
    double sum = 0.0;
    for (const verify::MapHeap& h : map.heaps) sum += h.grain_steps;
    return sum;
}

std::string poured(const ScalingMap& map) {
    std::string text =
        fmt::format("{} of {} heaps are poured, {} of about {} grain-steps", map.heaps.size(),
                    map.heaps_planned, count(grain_steps(map)), count(map.grain_steps_planned));
    if (map.heaps_stale > 0)
        text += fmt::format(
            "; {} more heaps of the file were poured for another setup or by older laws, and are "
            "not used",
            map.heaps_stale);
    return text;
}

std::string quantity_text(const MapCell& c, const char* name) {
    for (const MapQuantity& q : c.quantities)
        if (q.name == name && q.reference.count > 1 && q.scaled.count > 1)
            return fmt::format("{} [{}, {}]", number(q.difference), number(q.interval.low),
                               number(q.interval.high));
    return "none";
}

// The largest number of seeds that any open quantity would take; where one can have none, that.
std::string seeds_text(const MapCell& c) {
    std::size_t most = 0;
    for (const MapQuantity& q : c.quantities) {
        if (q.verdict != MapVerdict::not_decided) continue;
        if (!q.seeds_needed)
            return q.reference.count < 2 || q.scaled.count < 2 ? "too few to tell" : "over 100 000";
        most = std::max(most, *q.seeds_needed);
    }
    return most == 0 ? "" : fmt::format("{}", most);
}

// "breaks: coordination, force per area"; of more than three quantities their number alone, which the pictures show.
std::string verdict_text(const MapCell& c) {
    const auto commas = std::count(c.why.begin(), c.why.end(), ',');
    const std::string why =
        commas < 3 ? map_words(c.why) : fmt::format("{} quantities", commas + 1);
    return words(to_string(c.verdict)) + ": " + why;
}

TextTable rows_of(const ScalingMap& map, const std::string& study) {
    const bool impacts = study == "single_impact";
    TextTable rows = {{"rule", "F_po/(m g)", "factor", "D/d", "heaps", "formed",
                       "flank, deg [90 %]", "seeds", "verdict: why"}};
    if (impacts)
        rows = {{"rule", "F_po/(m g)", "factor", "F_po/(m g) here", "E/(rho g d) here",
                 "verdict: why"}};
    for (const MapCell& c : map.cells) {
        if (c.study != study) continue;
        if (impacts)
            rows.push_back({map_words(c.rule), number(c.bond), number(c.factor),
                            number(c.scaled.bond), number(c.scaled.elasticity), verdict_text(c)});
        else
            rows.push_back({map_words(c.rule), number(c.bond), number(c.factor),
                            number(c.scaled.size_ratio),
                            fmt::format("{} + {}", c.reference.heaps, c.scaled.heaps),
                            fmt::format("{} + {}", c.reference.formed, c.scaled.formed),
                            quantity_text(c, "angle_flank_20_80"), seeds_text(c), verdict_text(c)});
    }
    return rows;
}

// Margins as a table, each with its reason.
RunSection margins_section() {
    RunSection s{.name = "Margins, stated before the map was poured",
                 .verdict = {Answer::yes, "One table for all cells", ""},
                 .notes = {},
                 .figure = {},
                 .quantities = {{"quantity", "unit", "margin", "reason"}},
                 .intervals = {}};
    for (const auto* list : {&verify::map_margins(), &verify::impact_margins()})
        for (const verify::MapMargin& m : *list)
            s.quantities.push_back({map_words(m.name), m.unit,
                                    number(m.margin) + (m.relative ? " of the reference's" : ""),
                                    m.reason});
    return s;
}

constexpr const char* pictured[] = {"angle_flank_20_80", "angle_two_h_over_d", "packing_fraction",
                                    "coordination", "force_per_area"};

std::string unit_of(const std::string& quantity) {
    for (const verify::MapMargin& m : verify::map_margins())
        if (quantity == m.name)
            return (m.unit == std::string("1") ? "" : fmt::format("in {}; ", m.unit)) + "margin " +
                   number(m.margin);
    return "";
}

RunSection study_section(const ScalingMap& map, const std::string& study) {
    const Counts n = counts_of(map, study);
    RunSection s{.name = words(study),
                 .verdict = {n.breaks > 0             ? Answer::no
                             : n.open + n.missing > 0 ? Answer::cannot_tell
                                                      : Answer::yes,
                             counted(n), ""},
                 .notes = {},
                 .figure = {map_svg(map, study, "", study),
                            "Verdict of each cell, all quantities together; below it what breaks "
                            "it or is open."},
                 .quantities = rows_of(map, study),
                 .intervals = {}};
    for (const char* quantity : pictured) {
        const std::string picture = map_svg(map, study, quantity, study + "-" + quantity);
        if (!picture.empty())
            s.intervals.push_back({picture, fmt::format("{}: scaled minus reference, with its 90 % "
                                                        "interval; {}.",
                                                        map_words(quantity), unit_of(quantity))});
    }
    return s;
}

bool has(const ScalingMap& map, const std::string& study) {
    return std::any_of(map.cells.begin(), map.cells.end(),
                       [&](const MapCell& c) { return c.study == study; });
}

}  // namespace

Verdict verdict_of(const ScalingMap& map) {
    const bool whole = map.heaps.size() == map.heaps_planned;
    return {whole ? Answer::yes : Answer::cannot_tell,
            fmt::format("{}: of {} cells {}", whole ? "Poured whole" : "Not poured whole",
                        map.cells.size(), counted(counts_of(map, ""))),
            poured(map)};
}

std::string map_words(const std::string& names) {
    std::string text = words(names);
    for (const auto& [name, known] :
         {std::pair{"angle flank 20 80", "flank angle"},
          std::pair{"angle two h over d", "2h/D angle"}, std::pair{"tear off gap", "tear-off gap"},
          std::pair{"pull off", "pull-off"}})
        for (std::size_t at; (at = text.find(name)) != std::string::npos;)
            text.replace(at, std::strlen(name), known);
    return text;
}

std::string text_of(const ScalingMap& map) {
    const Verdict verdict = verdict_of(map);
    std::string text = verdict.headline + "\n" + verdict.why + "\n";
    for (const char* study : verify::map_studies) {
        if (!has(map, study)) continue;
        TextTable rows = {{"rule", "Bond", "factor", "seeds", "verdict: why"}};
        for (const MapCell& c : map.cells)
            if (c.study == study)
                rows.push_back(
                    {c.rule, number(c.bond), number(c.factor), seeds_text(c), verdict_text(c)});
        text += fmt::format("\n{}: {}\n", words(study), counted(counts_of(map, study)));
        text += columns(rows, {false, true, true, true, false});
    }
    return text;
}

Page page_of(const ScalingMap& map, const Provenance& who) {
    Page page{
        .title = "Where scaling holds and where it breaks",
        .source = fmt::format("extent: {}; reference of {} grains", map.extent,
                              count(map.reference_grains)),
        .verdict = verdict_of(map),
        .runs_heading = "The map",
        .limits = {"Spheres of five sizes within 20 % of d, one set of frictions (0.5 sliding, "
                   "0.1 rolling, restitution 0.5), heaps on glued grains under a round stream "
                   "a third of the base wide: another apparatus asks for its own map.",
                   "Both sides are this program's: the map says which rule keeps the model's "
                   "pile, not that the model is the powder.",
                   "A cell is judged by eight or nine quantities at 5 % each and not "
                   "corrected for their number: of cells that truly sit on a margin, some "
                   "break by chance."},
        .provenance = who};
    for (const char* study : verify::map_studies)
        if (has(map, study)) page.runs.push_back(study_section(map, study));
    page.runs.push_back(margins_section());
    return page;
}

}  // namespace reports
