// SPDX-License-Identifier: MIT
#include "reports/road.hpp"

#include "reports/numbers.hpp"
#include "reports/road_figures.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace reports {

namespace {

using calibrate::Calibration;
using calibrate::Factor;
using calibrate::Run;
using calibrate::Target;

std::string of_factor(const Factor& f, double value) {
    return f.unit == "1" ? number(value) : quantity(value, f.unit);
}

std::string of_target(const Target& t, double value) {
    return fmt::format("{} {}", number(value), t.unit);
}

std::string between(const Factor& f, const statistics::Interval& i) {
    return fmt::format("{} to {}", of_factor(f, i.low), of_factor(f, i.high));
}

// 95 % of a uniform prior is 0.95 of its range: what is left to wander over half of it is not fixed.
bool fixed(const Factor& f, const statistics::Interval& i) {
    return calibrate::share_of_range(f, i.high) - calibrate::share_of_range(f, i.low) < 0.5;
}

std::vector<std::string> not_fixed(const Calibration& c) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < c.surrogate->free.size(); ++k)
        if (const Factor& f = c.pile.problem.factors[k]; !fixed(f, c.surrogate->free[k]))
            names.push_back(words(f.name));
    return names;
}

std::string place(const Calibration& c) { return c.given ? "the given point" : "the answer"; }

// Names in a sentence.
std::string spaced(std::string sentence) {
    std::replace(sentence.begin(), sentence.end(), '_', ' ');
    return sentence;
}

TextTable factor_table(const Calibration& c) {
    const std::vector<Factor>& factors = c.pile.problem.factors;
    TextTable table{{"parameter", "range", c.given ? "given" : "answer"}};
    if (c.surrogate)
        table[0].insert(table[0].end(), {"95 %, others free", "95 %, others as in the answer"});
    else if (!c.given)
        table[0].emplace_back("effect in the screening");
    for (std::size_t k = 0; k < factors.size(); ++k) {
        const Factor& f = factors[k];
        const auto answer = c.answer();
        table.push_back({words(f.name), between(f, {f.low, f.high}),
                         answer ? of_factor(f, (*answer)[static_cast<Eigen::Index>(k)]) : "none"});
        if (c.surrogate) {
            table.back().push_back(between(f, c.surrogate->free[k]));
            table.back().push_back(between(f, c.surrogate->held[k]));
            continue;
        }
        if (c.given) continue;
        std::string effect = "none";
        for (const calibrate::PaperEffect& e :
             c.paper ? c.paper->ranking : std::vector<calibrate::PaperEffect>{})
            if (e.factor == f.name) effect = of_target(c.pile.problem.targets[0], e.value);
        table.back().push_back(effect);
    }
    return table;
}

// Of the road at its answer: the surrogate's mean, or the paper's line.
std::string foretold(const Calibration& c, std::size_t target) {
    const Target& t = c.pile.problem.targets[target];
    if (c.surrogate)
        return fmt::format("{} +- {}", number(c.surrogate->foretold[target].mean),
                           number(c.surrogate->foretold[target].standard_deviation));
    return target == 0 && c.paper && c.paper->predicted ? of_target(t, *c.paper->predicted)
                                                        : "none";
}

TextTable target_table(const Calibration& c) {
    TextTable table{{"target", "measured"}};
    if (!c.given) table[0].emplace_back("foretold");
    table[0].insert(table[0].end(), {"heaps of fresh seeds", "95 % of their mean", "agrees"});
    const std::vector<Target>& targets = c.pile.problem.targets;
    for (std::size_t k = 0; k < targets.size(); ++k) {
        const Target& t = targets[k];
        if (!t.value) continue;
        const auto there = calibrate::confirmed(c, k);
        table.push_back({fmt::format("{}, {}", words(t.name), t.unit),
                         fmt::format("{} +- {}", number(*t.value), number(t.standard_deviation))});
        std::vector<std::string>& row = table.back();
        if (!c.given) row.push_back(foretold(c, k));
        row.push_back(there ? number(there->mean) : "none");
        row.push_back(there && there->interval
                          ? fmt::format("[{}, {}]", number(there->interval->low),
                                        number(there->interval->high))
                          : "none");
        row.emplace_back(!there ? "no heap formed" : there->agrees ? "yes" : "no");
    }
    return table;
}

Answer parameters_known(const Calibration& c) {
    return c.surrogate && not_fixed(c).empty() ? Answer::yes : Answer::cannot_tell;
}

std::string fixed_words(const Calibration& c) {
    if (c.given) return "As given";
    if (!c.surrogate) return "One value each, without an interval";
    const std::size_t all = c.surrogate->free.size();
    return fmt::format("{} of {} are known to half of their range while the others are free",
                       all - not_fixed(c).size(), all);
}

std::size_t formed(const std::vector<Run>& runs) {
    return static_cast<std::size_t>(
        std::count_if(runs.begin(), runs.end(), [](const Run& r) { return r.values.has_value(); }));
}

std::vector<std::string> notes_of(const Calibration& c) {
    std::vector<std::string> notes{fmt::format(
        "{} heaps poured, {} formed; of these {} of {} at {} with fresh seeds", c.history.size(),
        formed(c.history), formed(c.confirming()), c.confirming().size(), place(c))};
    notes.insert(notes.end(), c.pile.notes.begin(), c.pile.notes.end());
    const std::vector<std::string>& of_road = c.surrogate ? c.surrogate->notes
                                              : c.paper   ? c.paper->notes
                                                          : c.pile.notes;
    if (c.surrogate || c.paper) notes.insert(notes.end(), of_road.begin(), of_road.end());
    if (!c.surrogate) return notes;
    if (const std::vector<std::string> open = not_fixed(c); !open.empty())
        notes.push_back(
            fmt::format("not known to half of their range while the others are free: {}",
                        fmt::join(open, ", ")));
    for (const std::string& name : c.surrogate->dead)
        notes.push_back("moves no target by as much as its measurement is uncertain: " +
                        words(name));
    for (const calibrate::Trade& trade : c.surrogate->identification.trades)
        notes.push_back("a trade that leaves the targets where they are: " + spaced(trade.words));
    for (const calibrate::Offer& offer : c.surrogate->identification.offers)
        notes.push_back("a further measurement: " + spaced(offer.words));
    return notes;
}

Json json_of(const std::vector<Run>& runs) {
    Json list = Json::array();
    for (const Run& run : runs)
        list.push_back(
            {{"seed", run.request.seed},
             {"stage", run.request.stage},
             {"point", std::vector<double>(run.request.point.begin(), run.request.point.end())},
             {"values", run.values ? Json(*run.values) : Json(nullptr)}});
    return list;
}

Json json_of(const calibrate::SurrogateResult& r) {
    const auto pair = [](const statistics::Interval& i) { return Json{i.low, i.high}; };
    Json free = Json::array(), held = Json::array(), before = Json::array();
    for (const auto& i : r.free) free.push_back(pair(i));
    for (const auto& i : r.held) held.push_back(pair(i));
    for (const auto& f : r.foretold) before.push_back({f.mean, f.standard_deviation});
    Json trades = Json::array(), offers = Json::array();
    for (const calibrate::Trade& t : r.identification.trades)
        trades.push_back({{"factor", t.factor}, {"step", t.step}, {"with", t.with}, {"by", t.by}});
    for (const calibrate::Offer& o : r.identification.offers)
        offers.push_back({{"target", o.target}, {"bits", o.bits}, {"shrinkage", o.shrinkage}});
    return {{"trades", trades},
            {"further_measurements", offers},
            {"interval_others_free", free},
            {"interval_others_held", held},
            {"foretold", before},
            {"probability_of_a_heap", r.forms},
            {"settled", r.settled},
            {"moves_nothing", r.dead},
            {"notes", r.notes}};
}

Json json_of(const calibrate::PaperResult& r) {
    Json ranking = Json::array();
    for (const calibrate::PaperEffect& e : r.ranking)
        ranking.push_back({{"factor", e.factor}, {"effect", e.value}});
    Json line;
    if (r.line)
        line = {
            {"factor", r.line->factor}, {"slope", r.line->slope}, {"intercept", r.line->intercept}};
    return {{"ranking", ranking},
            {"line", line},
            {"predicted", r.predicted ? Json(*r.predicted) : Json(nullptr)},
            {"target_passed", r.passed},
            {"notes", r.notes}};
}

}  // namespace

Json to_json(const Calibration& c, const Provenance& who) {
    Json factors = Json::array(), targets = Json::array();
    for (const Factor& f : c.pile.problem.factors)
        factors.push_back({{"name", f.name}, {"unit", f.unit}, {"range", {f.low, f.high}}});
    for (std::size_t k = 0; k < c.pile.problem.targets.size(); ++k) {
        const Target& t = c.pile.problem.targets[k];
        targets.push_back({{"name", t.name},
                           {"unit", t.unit},
                           {"measured", t.value ? Json(*t.value) : Json(nullptr)},
                           {"standard_deviation", t.standard_deviation}});
        const auto there = calibrate::confirmed(c, k);
        if (!there) continue;
        targets.back()["confirmed"] = {
            {"heaps", there->heaps},
            {"mean", there->mean},
            {"interval_95",
             there->interval ? Json{there->interval->low, there->interval->high} : Json(nullptr)},
            {"agrees", there->agrees}};
    }
    const auto answer = c.answer();
    Json json{
        {"format", "similitude-calibration/1"},
        {"tool", to_json(who)},
        {"experiment", c.pile.experiment},
        {"estimator", c.pile.estimator ? Json(rigs::to_string(*c.pile.estimator)) : Json(nullptr)},
        {"road", c.given   ? "none"
                 : c.paper ? "paper"
                           : "surrogate"},
        {"factors", factors},
        {"targets", targets},
        {"answer",
         answer ? Json(std::vector<double>(answer->begin(), answer->end())) : Json(nullptr)},
        {"holds", calibrate::holds(c)}};
    if (c.surrogate) json["surrogate"] = json_of(*c.surrogate);
    if (c.paper) json["paper"] = json_of(*c.paper);
    json["notes"] = c.pile.notes;
    json["runs"] = json_of(c.history);
    return json;
}

Verdict verdict_of(const Calibration& c) {
    if (!c.answer())
        return {Answer::cannot_tell, "No answer: hardly a heap formed",
                fmt::format("{} of {} runs formed a heap", formed(c.history), c.history.size())};
    std::string why;
    const std::vector<Target>& targets = c.pile.problem.targets;
    for (std::size_t k = 0; k < targets.size(); ++k) {
        if (!targets[k].value) continue;
        const auto there = calibrate::confirmed(c, k);
        why += fmt::format(
            "{}{}: measured {} +- {} {}, {}", why.empty() ? "" : "; ", words(targets[k].name),
            number(*targets[k].value), number(targets[k].standard_deviation), targets[k].unit,
            there ? fmt::format("{} of {} fresh heaps formed at {} and have {}", there->heaps,
                                c.confirming().size(), place(c), number(there->mean))
                  : "no fresh heap formed");
    }
    if (formed(c.confirming()) == 0)
        return {Answer::no, "No fresh heap formed at " + place(c), why};
    return calibrate::holds(c) ? Verdict{Answer::yes, "Fresh heaps meet what was measured", why}
                               : Verdict{Answer::no, "Fresh heaps miss what was measured", why};
}

std::string text_of(const Calibration& c) {
    const Verdict v = verdict_of(c);
    std::string text = v.headline + "\n  " + wrapped(v.why, 98, 2) + "\n";
    for (const std::string& note : notes_of(c)) text += "  " + wrapped(note, 98, 4) + "\n";
    const TextTable factors = factor_table(c);
    std::vector<bool> right(factors.front().size(), true);
    right[0] = false;
    text += columns(factors, right) + "\n";
    const TextTable targets = target_table(c);
    right.assign(targets.front().size(), true);
    right.front() = right.back() = false;
    return text + columns(targets, right);
}

Page page_of(const cases::Case& given, const Calibration& c, const Provenance& who) {
    Page page{.title = given.title, .source = given.source};
    page.verdict = verdict_of(c);
    RunSection result{"What was met",  {page.verdict.answer, page.verdict.headline, ""},
                      notes_of(c),     {},
                      target_table(c), {}};
    result.figure = confirmation_figure(c);
    RunSection parameters{"What the parameters are",
                          {parameters_known(c), fixed_words(c), ""},
                          {},
                          range_figure(c),
                          factor_table(c),
                          {}};
    page.runs = {result, parameters};
    for (std::size_t k = 0; k < c.pile.problem.targets.size(); ++k)
        for (Figure& f : response_figures(c, k)) page.runs.back().intervals.push_back(std::move(f));
    page.runs_heading = "The calibration";
    page.limits = {
        "Parameters that meet an angle are not the powder's own: other sets meet it as well, and "
        "the intervals with the others free say how far they go.",
        "What was met is one apparatus at one size of grain; another scale or base wants its own "
        "check (similitude verify).",
        "The surrogate's intervals hold where its Gaussian process describes the heaps; fresh "
        "seeds at the answer do not lean on it."};
    page.provenance = who;
    return page;
}

}  // namespace reports
