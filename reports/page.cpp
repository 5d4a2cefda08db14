// SPDX-License-Identifier: MIT
#include "reports/page.hpp"

#include "reports/diagnosis.hpp"
#include "reports/numbers.hpp"
#include "reports/page_parts.hpp"
#include "reports/page_template.hpp"

#include <fmt/format.h>

#include <cctype>
#include <utility>

namespace reports {

namespace {

const char* sign_of(Answer answer) {
    switch (answer) {
        case Answer::yes:
            return "\u2713";
        case Answer::no:
            return "\u2717";
        case Answer::cannot_tell:
            return "?";
        case Answer::outside_validity:
            return "\u26a0";
    }
    return "";
}

data named(const char* name, const std::string& value) {
    data d;
    d["name"] = name;
    d["value"] = value;
    return d;
}

data provenance_data(const Provenance& p) {
    data list{data::type::list};
    list << named("similitude", p.version) << named("git", p.git) << named("compiler", p.compiler);
    if (!p.case_path.empty()) list << named("case", p.case_path);
    if (!p.seeds.empty()) list << named("seeds", fmt::format("{}", fmt::join(p.seeds, ", ")));
    if (p.threads) list << named("threads", fmt::format("{}", *p.threads));
    return list;
}

std::vector<RunSection> runs_of(const Page& page) {
    std::vector<RunSection> all = page.runs;
    if (!page.verification) return all;
    const std::size_t first = all.size();
    for (const verify::Comparison* c : comparisons_of(*page.verification))
        all.push_back(comparison_section(*c));
    if (all.size() == first || !page.verification->similarity) return all;
    const verify::SimilarityResult& similarity = *page.verification->similarity;
    std::string beyond;
    for (const scaling::Finding& f : similarity.findings)
        if (f.judgement != scaling::Judgement::fine)
            beyond += fmt::format("{}{} = {} ({})", beyond.empty() ? "" : "; ", words(f.name),
                                  number(f.value), f.rule);
    if (!beyond.empty())
        all[first].notes.push_back(
            "On both sides alike, these softened grains lie outside the usual rules: " + beyond +
            ".");
    return all;
}

bool has_checks(const Page& page) {
    return page.verification &&
           (!page.verification->checks.empty() || page.verification->similarity);
}

void set_checks(data& d, const Page& page) {
    const bool any = has_checks(page);
    d["has_checks"] = any;
    d["checks_heading"] = page.checks_heading;
    const std::vector<verify::Check> none;
    set_list(d, "check_groups", checks_part(any ? page.verification->checks : none));
    const bool bits = any && page.verification->similarity;
    set_list(
        d, "bits",
        bits_part(bits ? page.verification->similarity->bits : std::vector<verify::BitsCheck>{}));
}

void set_runs(data& d, const Page& page) {
    const bool heaps = page.verification && page.verification->similarity;
    const bool sleep = page.verification && page.verification->sleep;
    d["runs_heading"] = !page.runs_heading.empty() ? page.runs_heading
                        : sleep ? "Heaps awake and heaps that may sleep, laid over each other"
                        : heaps ? "Reference and scaled heaps, laid over each other"
                                : "What was simulated";
    set_list(d, "runs", runs_part(runs_of(page)));
}

data sections_data(const Page& page) {
    std::vector<std::pair<const char*, const char*>> all;
    if (page.study)
        all = {{"scale", "scale factors"},
               {"groups", "groups"},
               {"adhesion", "adhesion"},
               {"cost", "cost"}};
    if (page.diagnosis)
        all = {{"where", "where"},
               {"hypotheses", "hypotheses"},
               {"effects", "effects"},
               {"numbers", "parameters and errors"},
               {"next", "what next"}};
    const bool heaps =
        page.verification && (page.verification->similarity || page.verification->sleep);
    if (!runs_of(page).empty())
        all.emplace_back("runs", heaps                       ? "heaps"
                                 : page.runs_heading.empty() ? "runs"
                                                             : page.runs_heading.c_str());
    if (has_checks(page)) all.emplace_back("checks", "checks");
    if (!page.limits.empty()) all.emplace_back("limits", "limits");
    all.emplace_back("repeat", "repeat it");
    data list{data::type::list};
    for (const auto& [anchor, name] : all) {
        data d = named(name, "");
        d["anchor"] = anchor;
        list << d;
    }
    return list;
}

// "</script>" inside a JSON text would end the element that holds it.
std::string embedded(const std::string& json) {
    std::string out;
    for (std::size_t k = 0; k < json.size(); ++k) {
        out += json[k];
        if (json[k] == '<' && k + 1 < json.size() && json[k + 1] == '/') out += '\\';
    }
    return out;
}

}  // namespace

data optional_text(const std::string& text) {
    return text.empty() ? data(data::type::bool_false) : data(text);
}

void set_list(data& object, const std::string& name, data list) {
    object["has_" + name] =
        list.is_non_empty_list() ? data::type::bool_true : data::type::bool_false;
    object[name] = std::move(list);
}

const char* class_of(Answer answer) {
    switch (answer) {
        case Answer::yes:
            return "yes";
        case Answer::no:
            return "no";
        case Answer::cannot_tell:
            return "open";
        case Answer::outside_validity:
            return "outside";
    }
    return "";
}

std::vector<std::string> limits_of(const scaling::ScaleStudy& study) {
    std::vector<std::string> limits = {
        "Scale factors say which numbers stay equal. Whether a heap or a flow notices the ones "
        "that change is shown by "
        "simulating both sides, not by this table.",
        "Only the variables of this case are in the groups: charge, humidity, shape and what else "
        "is not stated is not judged."};
    if (study.adhesion)
        limits.emplace_back(
            "The adhesion of the other grain is computed back from the one that is stated; it is "
            "no measurement of the powder.");
    if (study.original_cost.wall_time)
        limits.emplace_back(
            "Wall times are estimates from a short run on this machine, with as many grains in "
            "contact at once as fill the heap.");
    return limits;
}

std::vector<std::string> limits_of(const Verification& v) {
    std::vector<std::string> limits;
    if (v.sleep)
        return {saved_text(*v.sleep),
                "This holds for this pile. What sleep saves hangs on how much of a heap is quiet "
                "while it is fed; the heap of another powder must be tested anew."};
    if (!v.similarity)
        return {
            "Exact answers test laws and core on one or two grains; they say nothing about a "
            "powder."};
    const verify::ReferenceHeap& heap = v.similarity->heap;
    limits.push_back(
        fmt::format("The heaps are small: {} grains fed onto a base {} d wide. Flow through a "
                    "funnel, discharge and heaps of other sizes are not tested.",
                    heap.grains, number(heap.base)));
    limits.push_back(
        fmt::format("The modulus is softened to E/(rho g d) = {} on both sides alike; with the "
                    "real one grains are stiffer than here.",
                    number(heap.elasticity)));
    limits.emplace_back(
        "All grains are spheres of one size, and one program is compared with itself: this shows "
        "that the scaling holds in the model, not that the model is the powder.");
    limits.push_back("Heaps by " + heaps_by(*v.similarity) + ".");
    return limits;
}

Page page_of(const cases::Case& c, const scaling::ScaleStudy& study, const Provenance& who) {
    return {.title = c.title,
            .source = c.source,
            .verdict = verdict_of(study),
            .study = study,
            .limits = limits_of(study),
            .provenance = who};
}

namespace {

// Of one run its own; of several what each came to.
Verdict verdict_of(const std::vector<RunSection>& runs) {
    if (runs.size() == 1) return runs.front().verdict;
    Verdict all{Answer::yes, "", ""};
    std::size_t well = 0;
    for (const RunSection& run : runs) {
        if (run.verdict.answer == Answer::yes)
            ++well;
        else if (all.answer != Answer::cannot_tell)
            all.answer = run.verdict.answer;
        std::string words = run.verdict.headline;
        words.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(words.front())));
        all.why += (all.why.empty() ? "" : "; ") + run.name + ": " + words;
    }
    all.headline = well == runs.size()
                       ? fmt::format("{} experiments were run", well)
                       : fmt::format("{} of {} experiments ran as meant", well, runs.size());
    return all;
}

}  // namespace

Page page_of(const cases::Case& c, const std::vector<RunSection>& runs, const Provenance& who) {
    Page page{.title = c.title,
              .source = c.source,
              .verdict = {Answer::cannot_tell, "Interrupted before anything was finished",
                          "run the command again with --resume"},
              .runs = runs,
              .provenance = who};
    if (!runs.empty()) page.verdict = verdict_of(runs);
    page.limits = {
        "One run of many grains is one draw from chance: the angle of a heap scatters from seed "
        "to seed by a degree or more. Run several seeds before two runs are compared.",
        "The spread over sectors is that within one heap; it is no uncertainty of the angle of "
        "repose."};
    return page;
}

Page page_of(const cases::Case& c, const diagnose::Verdict& v, const Provenance& who) {
    return {.title = c.title,
            .source = c.source,
            .verdict = verdict_of(v),
            .diagnosis = v,
            .limits = limits_of(v),
            .provenance = who};
}

std::string html(const Page& page) {
    data d;
    d["title"] = page.title.empty() ? "similitude" : page.title;
    d["source"] = optional_text(page.source);
    d["verdict_class"] = class_of(page.verdict.answer);
    d["verdict_sign"] = sign_of(page.verdict.answer);
    d["verdict_headline"] = page.verdict.headline;
    d["verdict_why"] = typeset(page.verdict.why);
    d["sections"] = sections_data(page);
    d["scale"] = page.study ? scale_part(*page.study, page.beside) : data(data::type::bool_false);
    d["diagnosis"] =
        page.diagnosis ? diagnosis_part(*page.diagnosis) : data(data::type::bool_false);
    set_runs(d, page);
    set_checks(d, page);
    data limits{data::type::list};
    for (const std::string& limit : page.limits) limits << data(limit);
    set_list(d, "limits", std::move(limits));
    d["command"] = page.provenance.command;
    d["provenance"] = provenance_data(page.provenance);
    d["data"] = optional_text(embedded(page.data));
    kainjow::mustache::mustache form(page_template());
    return form.render(d);
}

}  // namespace reports
