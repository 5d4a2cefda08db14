// SPDX-License-Identifier: MIT
#include "reports/calibration.hpp"
#include "reports/calibration_figures.hpp"
#include "reports/numbers.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace reports {

namespace {

using namespace calibrate;

std::string signed_number(double value) { return fmt::format("{:+.2f}", value); }

RunSection numbers_section(const Replayed& r) {
    RunSection s{.name = "Every printed number again",
                 .verdict = {},
                 .notes = r.published.restored,
                 .figure = {},
                 .quantities = {{"table", "numbers", "agree", "which differ"}},
                 .intervals = {}};
    std::vector<std::string> tables;
    for (const Recomputed& d : r.replay.digits)
        if (std::find(tables.begin(), tables.end(), d.table) == tables.end())
            tables.push_back(d.table);
    for (const std::string& table : tables) {
        int all = 0, agree = 0;
        std::string differ;
        for (const Recomputed& d : r.replay.digits) {
            if (d.table != table) continue;
            ++all;
            agree += d.agrees;
            if (!d.agrees)
                differ += fmt::format("{}{}: printed {}, recomputed {}", differ.empty() ? "" : "; ",
                                      d.what, d.printed.text, number(d.value));
        }
        s.quantities.push_back(
            {table, std::to_string(all), std::to_string(agree), differ.empty() ? "none" : differ});
    }
    const int n = r.replay.mismatches;
    s.verdict = {
        n == 0 ? Answer::yes : Answer::no,
        n == 0 ? "All come out again"
               : fmt::format("{} of {} differ{}", n, r.replay.digits.size(), n == 1 ? "s" : ""),
        "Each number was computed from the runs as printed and rounded to the digits that "
        "were printed."};
    return s;
}

RunSection effects_section(const Replayed& r) {
    const Audit& a = r.audit;
    RunSection s{.name = "Screening: which effects the runs fix",
                 .verdict = {},
                 .notes = {},
                 .figure = effects_figure(r),
                 .quantities = {},
                 .intervals = {}};
    s.verdict = {
        a.ranking.identifiable ? Answer::yes : Answer::no,
        fmt::format("Rank {} of {}, D-efficiency {} of {} as planned", a.rank, a.terms,
                    number(a.d_efficiency), number(a.planned_d_efficiency)),
        a.null_vectors.empty()
            ? "Every effect can be estimated."
            : fmt::format("In every run that formed {}; what can be estimated of these "
                          "factors is {} only.",
                          a.null_vectors.front().text, fmt::join(a.estimable_pairs, ", "))};
    s.notes.push_back(fmt::format("Ranking {}: {}.", a.ranking.claimed, a.ranking.why));
    s.quantities = {{"factor", "mean high", "mean low", "effect", "rank", "what it is"}};
    for (std::size_t k = 0; k < a.means.size(); ++k) {
        const LevelMeans& m = a.means[k];
        s.quantities.push_back(
            {m.factor, fmt::format("{:.4f} ({})", m.mean_high, m.count_high),
             fmt::format("{:.4f} ({})", m.mean_low, m.count_low), fmt::format("{:+.3f}", m.effect),
             std::to_string(m.rank),
             r.published.factors[k].name + (a.estimable[k + 1] ? "" : "; not by itself")});
    }
    return s;
}

RunSection aliases_section(const Replayed& r) {
    RunSection s{.name = "Aliases: what each main effect carries",
                 .verdict = {},
                 .notes = {},
                 .figure = {},
                 .quantities = {{"main effect", "carries of two-factor interactions"}},
                 .intervals = {}};
    s.verdict = {Answer::cannot_tell, "Free of interactions only where those are small",
                 "Of the planned design, before runs failed. Folding it over would free main "
                 "effects of all of these."};
    for (const PublishedFactor& f : r.published.factors) {
        std::map<std::string, std::string> pairs;  // by how much of each is carried
        for (const Alias& alias : r.audit.aliases) {
            if (std::string(1, alias.text.front()) != f.letter) continue;
            const std::string what = alias.text.substr(alias.text.find("carries ") + 8);
            std::string& list = pairs[what.substr(0, what.size() - 2)];
            list += (list.empty() ? "" : ", ") + what.substr(what.size() - 2);
        }
        std::string carries;
        for (const auto& [part, list] : pairs)
            carries += fmt::format("{}{}{}of {}", carries.empty() ? "" : "; ", part,
                                   part.size() == 1 ? "1 " : "", list);
        s.quantities.push_back({f.letter, carries.empty() ? "none" : carries});
    }
    return s;
}

std::string range_text(const Audit& a, const std::string& factor) {
    for (const ImpliedRange& r : a.implied) {
        if (r.factor != factor) continue;
        if (r.effect.low == r.effect.high) return signed_number(r.effect.low);
        return std::isfinite(r.effect.low) ? "at least " + signed_number(r.effect.low)
                                           : "at most " + signed_number(r.effect.high);
    }
    return "";
}

RunSection failed_section(const Replayed& r) {
    const Audit& a = r.audit;
    RunSection s{.name = "What the failed runs say",
                 .verdict = {},
                 .notes = {},
                 .figure = imputed_figure(r),
                 .quantities = {},
                 .intervals = {}};
    s.verdict = {
        Answer::cannot_tell,
        fmt::format("{} of {} runs failed, and their reading decides signs", a.failed, a.runs),
        r.published.failure + "."};
    s.quantities = {{"factor", "dropped", "as 10", "as 18", "censored", "log odds", "bound"}};
    for (std::size_t k = 0; k < r.published.factors.size(); ++k) {
        const auto at = [&](double value) {
            for (const Imputed& i : a.imputed)
                if (i.value == value) return signed_number(i.effects[k]);
            return std::string();
        };
        const CensoredEffect& c = a.censored->effects[k];
        const CensoredEffect& f = a.feasibility->slopes[k];
        s.quantities.push_back({r.published.factors[k].letter, signed_number(a.means[k].effect),
                                at(10.0), at(18.0),
                                fmt::format("{:+.2f} +- {:.2f}", c.estimate, c.standard_error),
                                fmt::format("{:+.2f} +- {:.2f}", f.estimate, f.standard_error),
                                range_text(a, r.published.factors[k].letter)});
    }
    const std::string& unit = r.published.unit;
    s.notes.push_back(
        fmt::format("Effects in {}, with the failed runs dropped, or counted as 10 {} "
                    "and 18 {}.",
                    unit, unit, unit));
    s.notes.push_back(fmt::format(
        "Censored: a failed heap would have lain below {:g} {}.{}", a.bound, unit,
        a.censored->prior
            ? fmt::format(
                  " The runs that formed leave one combination free, so that the "
                  "likelihood has no maximum of its own: it has one with a prior of {:.3g} "
                  "{} on half an effect. What holds without is the bound, on one side only.",
                  *a.censored->prior, unit)
            : ""));
    s.notes.push_back("Log odds: change of the log odds of forming a heap, from low to high.");
    return s;
}

RunSection refinement_section(const Replayed& r) {
    const AnalysisOfVariance& v = r.replay.orthogonal;
    RunSection s{
        .name = "Ascent, orthogonal test and line",
        .verdict = {},
        .notes = {},
        .figure = response_figure(r),
        .quantities = {{"source", "sum of squares", "degrees of freedom", "mean square", "F", "p"}},
        .intervals = {}};
    std::vector<VarianceRow> rows = v.factors;
    rows.push_back(v.residual);
    rows.push_back(v.total);
    const auto shown = [](double x) { return std::isfinite(x) ? number(x) : std::string(); };
    for (const VarianceRow& row : rows)
        s.quantities.push_back({row.source, fmt::format("{:.2f}", row.sum_of_squares),
                                std::to_string(row.degrees_of_freedom), shown(row.mean_square),
                                shown(row.f), shown(row.p)});
    std::string crossings;
    for (const Crossing& c : r.replay.crossings)
        crossings += fmt::format("{}{:.4f} at {} = {:g}", crossings.empty() ? "" : ", ", c.second,
                                 r.published.orthogonal.factors[0], c.first);
    s.verdict = {Answer::cannot_tell, "One of the two factors is fixed by the runs",
                 "The target is met at " + crossings + "."};
    return s;
}

RunSection topic_section(const Replayed& r, const std::string& topic) {
    RunSection s{.name = "Findings: " + topic,
                 .verdict = {},
                 .notes = {},
                 .figure = {},
                 .quantities = {{"finding", "value", "judgement", "what it means"}},
                 .intervals = {}};
    int cautions = 0, all = 0;
    for (const Observation& o : r.observations) {
        if (o.topic != topic) continue;
        ++all;
        cautions += o.judgement != scaling::Judgement::fine;
        const std::string unit = o.unit == "1" ? "" : " " + o.unit;
        s.quantities.push_back({words(o.name) + (o.where.empty() ? "" : ", " + o.where),
                                std::isfinite(o.value) ? number(o.value) + unit : "",
                                scaling::to_string(o.judgement), o.text});
    }
    s.verdict = {cautions == 0 ? Answer::yes : Answer::cannot_tell,
                 fmt::format("{} of {} ask for care", cautions, all), ""};
    return s;
}

RunSection every_number_section(const Replayed& r) {
    RunSection s{.name = "Every number",
                 .verdict = {},
                 .notes = {},
                 .figure = {},
                 .quantities = {{"where", "printed", "recomputed", "agrees"}},
                 .intervals = {}};
    for (const Recomputed& d : r.replay.digits)
        s.quantities.push_back({d.table + ": " + d.what, d.printed.text,
                                fmt::format("{:.6g}", d.value), d.agrees ? "yes" : "no"});
    s.verdict = {r.replay.mismatches == 0 ? Answer::yes : Answer::no,
                 fmt::format("{} compared", r.replay.digits.size()), ""};
    return s;
}

}  // namespace

std::vector<RunSection> calibration_sections(const Replayed& r) {
    std::vector<RunSection> all{numbers_section(r), effects_section(r), aliases_section(r)};
    if (r.audit.failed > 0 && r.audit.censored) all.push_back(failed_section(r));
    all.push_back(refinement_section(r));
    for (const char* topic :
         {"screening", "ascent", "orthogonal test", "experiment", "numerics", "similarity"})
        all.push_back(topic_section(r, topic));
    all.push_back(every_number_section(r));
    return all;
}

Page page_of(const Replayed& r, const Provenance& who) {
    Page page{.title = "Replay and audit: " + r.published.title,
              .source = r.published.source,
              .verdict = verdict_of(r),
              .runs = calibration_sections(r),
              .runs_heading = "What was printed, and what it can carry",
              .provenance = who,
              .data = text_of(to_json(r))};
    page.limits = {
        "What was recomputed is arithmetic on printed numbers; no run of the publication was made "
        "again here.",
        "Findings say what these runs can carry. They do not say that a conclusion is wrong: "
        "friction and adhesion may well matter most.",
        "Linear models of seven factors over one wide step; interactions and curvature are not in "
        "them."};
    return page;
}

}  // namespace reports
