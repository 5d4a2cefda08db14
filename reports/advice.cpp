// SPDX-License-Identifier: MIT
#include "reports/advice.hpp"

#include "reports/checks.hpp"
#include "reports/numbers.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace reports {

namespace {

using verify::AdvisedGrain;
using verify::AngleSays;

const AdvisedGrain* chosen_of(const Advice& a) {
    return a.chosen ? &a.considered[*a.chosen] : nullptr;
}

std::string interval_text(const verify::MapReading& r) {
    return r.cells.empty() ? "none" : fmt::format("[{}, {}]", number(r.low), number(r.high));
}

std::string fate_of(const AdvisedGrain& g) {
    if (!g.unusable.empty()) return "no such grain";
    const char* angle = g.says() == AngleSays::within   ? "stays"
                        : g.says() == AngleSays::beyond ? "moves"
                                                        : "open";
    return std::string(angle) + (g.outside() ? ", beyond the map" : "") +
           (g.affordable ? "" : ", too dear");
}

TextTable rows_of(const Advice& a) {
    TextTable rows{{"rule", "h", "D/d", "F_po/(m g)", "w, J/m^2", "grains", "time",
                    "angle moves, deg", "angle"}};
    for (const AdvisedGrain& g : a.considered)
        rows.push_back({words(g.rule), number(g.h), number(g.size_ratio), number(g.bond),
                        number(g.work_of_adhesion), count(g.grains), quantity(g.seconds, "s"),
                        interval_text(g.coarse), fate_of(g)});
    return rows;
}

// What stands beside the verdict, a sentence each.
std::vector<std::string> sentences_of(const Advice& a) {
    std::vector<std::string> list;
    const AdvisedGrain* g = chosen_of(a);
    if (!g) return list;
    for (const std::vector<std::string>* outside : {&g->coarse.outside, &g->soft.outside})
        for (const std::string& s : *outside) list.push_back("Beyond the map: " + s + ".");
    std::vector<std::string> lost = g->coarse.lost;
    lost.insert(lost.end(), g->soft.lost.begin(), g->soft.lost.end());
    std::string what;
    for (const std::string& l : lost) what += (what.empty() ? "" : ", ") + words(l);
    list.push_back(what.empty() ? "Lost by the cells that were read: nothing that they can show."
                                : "Lost by the cells that were read: " + what + ".");
    if (a.check)
        for (const verify::Quantity& q : a.check->quantities)
            if (q.reference.count > 1 && q.scaled.count > 1 && !q.test.equivalent)
                list.push_back(fmt::format(
                    "Not kept in the check: {}, from {} to {} [{}, {}] {}.", words(q.name),
                    number(q.reference.mean), number(q.scaled.mean), number(q.test.interval.low),
                    number(q.test.interval.high), q.unit == "1" ? "apart" : q.unit + " apart"));
    for (const std::string& note : a.notes)
        list.push_back("Changed beside the grain: " + note + ".");
    list.push_back(fmt::format(
        "What would catch the loss: {} heaps of this grain and {} of one with h = {} ({} each), "
        "the angles "
        "equal within {} deg by two one-sided tests; from seed to seed they scatter by {} deg{}.",
        a.seeds, a.seeds, number(a.finer_h), quantity(a.finer_seconds, "s"), number(a.tolerance),
        number(a.spread),
        g->coarse.spread ? " in the map" : " (taken: the map has no cell to say)"));
    return list;
}

std::string check_text(const Advice& a) {
    const verify::Quantity& q = a.check->quantities.front();
    if (q.reference.count < 2 || q.scaled.count < 2) return "checked: too few heaps with an angle";
    return fmt::format("checked by {} and {} heaps: the angle moves by {} [{}, {}] deg",
                       q.reference.count, q.scaled.count, number(q.test.difference),
                       number(q.test.interval.low), number(q.test.interval.high));
}

// Of the angle alone: that is what the tolerance is of.
Answer answer_of(const verify::Comparison& c, double tolerance) {
    const verify::Quantity& q = c.quantities.front();
    if (q.reference.count < 2 || q.scaled.count < 2) return Answer::cannot_tell;
    if (q.test.equivalent) return Answer::yes;
    return q.test.interval.low > tolerance || q.test.interval.high < -tolerance
               ? Answer::no
               : Answer::cannot_tell;
}

}  // namespace

Verdict verdict_of(const Advice& a) {
    const AdvisedGrain* g = chosen_of(a);
    if (!g) {
        const AdvisedGrain* cheapest = nullptr;
        for (const AdvisedGrain& other : a.considered) {
            if (!other.unusable.empty()) continue;
            if (other.says() == AngleSays::within &&
                (!cheapest || other.seconds < cheapest->seconds))
                cheapest = &other;
        }
        if (cheapest)
            return {Answer::no, "No grain that keeps the angle can be afforded",
                    fmt::format("the cheapest one, h = {} by {}, takes {} a heap, the budget is {}",
                                number(cheapest->h), words(cheapest->rule),
                                quantity(cheapest->seconds, "s"), quantity(a.budget, "s"))};
        return {Answer::no, "No grain of the map keeps the angle",
                fmt::format("asked for: within {} deg", number(a.tolerance))};
    }
    std::string headline = fmt::format("Grains {} times as large", number(g->h));
    if (g->work_of_adhesion > 0.0)
        headline +=
            fmt::format(", w = {} by {}", quantity(g->work_of_adhesion, "J/m^2"), words(g->rule));
    if (g->softening < 1.0) headline += fmt::format(", modulus times {}", number(g->softening));
    std::string why = fmt::format("{} grains, step {}, {} a heap", count(g->grains),
                                  quantity(g->time_step, "s"), quantity(g->seconds, "s"));
    const bool open = g->says() != AngleSays::within;
    Answer answer = g->outside() ? Answer::outside_validity : Answer::yes;
    if (open && !a.check) answer = Answer::cannot_tell;
    if (a.check) {
        why += "; " + check_text(a);
        const Answer checked = answer_of(*a.check, a.tolerance);
        if (checked != Answer::yes) answer = checked;
    } else if (open) {
        why += "; whether the angle stays the map leaves open: only a check can tell";
    } else if (g->outside()) {
        why += "; partly beyond the map, so that only a check can tell";
    }
    return {answer, headline, why};
}

std::string text_of(const Advice& a) {
    const Verdict v = verdict_of(a);
    std::string text = v.headline + "\n" + wrapped(v.why, 100, 0) + "\n\n";
    text += fmt::format("the powder: D/d = {}, E/(rho g d) = {}, F_po/(m g) = {}\n",
                        number(a.powder.size_ratio), number(a.powder.elasticity),
                        number(a.powder.bond));
    text += fmt::format("asked: {} a heap, angle within {} deg; map: {}\n\n",
                        quantity(a.budget, "s"), number(a.tolerance), a.map);
    text += columns(rows_of(a), {false, true, true, true, true, true, true, false, false});
    text += "\n";
    for (const std::string& s : sentences_of(a)) text += wrapped(s, 100, 2) + "\n";
    if (!a.next.empty()) text += "\n" + a.next + "\n";
    return text;
}

Json to_json(const Advice& a, const Provenance& who) {
    const auto reading = [](const verify::MapReading& r) {
        return Json{{"says", verify::to_string(r.says)},
                    {"angle_moves_deg", r.cells.empty() ? Json(nullptr) : Json{r.low, r.high}},
                    {"cells", r.cells},
                    {"beyond_the_map", r.outside},
                    {"lost", r.lost}};
    };
    Json considered = Json::array();
    for (const AdvisedGrain& g : a.considered)
        considered.push_back(
            {{"rule", g.rule},
             {"h", g.h},
             {"softening", g.softening},
             {"base_over_grain", g.size_ratio},
             {"youngs_modulus_over_rho_g_d", g.elasticity},
             {"pull_off_in_grain_weights", g.bond},
             {"work_of_adhesion", {{"value", g.work_of_adhesion}, {"unit", "J/m^2"}}},
             {"grains", g.grains},
             {"time_step", {{"value", g.time_step}, {"unit", "s"}}},
             {"time_of_a_heap", {{"value", g.seconds}, {"unit", "s"}}},
             {"affordable", g.affordable},
             {"unusable", g.unusable},
             {"verdict", fate_of(g)},
             {"coarse_graining", reading(g.coarse)},
             {"softening_read", reading(g.soft)}});
    const Verdict v = verdict_of(a);
    Json json{
        {"format", "similitude-advice/1"},
        {"tool", to_json(who)},
        {"case", a.title},
        {"answer", to_string(v.answer)},
        {"headline", v.headline},
        {"why", v.why},
        {"budget", {{"value", a.budget}, {"unit", "s"}}},
        {"tolerance", {{"value", a.tolerance}, {"unit", "deg"}}},
        {"map", a.map},
        {"powder",
         {{"base_over_grain", a.powder.size_ratio},
          {"youngs_modulus_over_rho_g_d", a.powder.elasticity},
          {"pull_off_in_grain_weights", a.powder.bond}}},
        {"chosen", a.chosen ? Json(*a.chosen) : Json(nullptr)},
        {"considered", std::move(considered)},
        {"verification", {{"h", a.finer_h}, {"seeds_a_side", a.seeds}, {"spread_deg", a.spread}}},
        {"sentences", sentences_of(a)}};
    if (a.check) json["check"] = to_json(*a.check);
    return json;
}

Page page_of(const Advice& a, const Provenance& who) {
    Page page{.title = a.title.empty() ? "Advice" : a.title,
              .source = a.source,
              .verdict = verdict_of(a),
              .runs_heading = "What was considered",
              .limits = {"The map was made with one set of frictions on glued grains "
                         "(docs/scaling-map.md); a powder on another "
                         "base or of another rolling resistance may behave otherwise.",
                         "Costs are estimates from this machine's speed; a heap that topples late "
                         "takes longer."},
              .provenance = who};
    RunSection s{.name = "Grains in place of the powder's",
                 .verdict = page.verdict,
                 .notes = sentences_of(a),
                 .figure = {},
                 .quantities = rows_of(a),
                 .intervals = {}};
    page.runs.push_back(std::move(s));
    if (a.check) page.runs.push_back(comparison_section(*a.check));
    return page;
}

}  // namespace reports
