// SPDX-License-Identifier: MIT
#include "reports/diagnosis.hpp"

#include "reports/numbers.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace reports {

namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t width = 100;

// Terms that tell of instrument or arithmetic, not of the powder.
bool no_physics(const std::string& effect) {
    return effect.starts_with("measurement_") || effect == "time_base" ||
           effect == "numerical_artefact";
}

std::vector<std::string> named(const diagnose::Verdict& v, bool physics) {
    std::vector<std::string> names;
    for (const diagnose::Effect& e : v.effects)
        if (e.named && e.name != "unknown" && no_physics(e.name) != physics)
            names.push_back(e.name);
    return names;
}

std::string explained(const diagnose::Verdict& v) {
    const std::vector<std::string> physics = named(v, true), rest = named(v, false);
    if (physics.empty() && rest.empty()) return "Explained";
    if (physics.empty()) return "Explained without physics left out: " + effects_in_words(rest);
    std::string text = fmt::format("Explained: {} {} left out", effects_in_words(physics),
                                   physics.size() > 1 ? "were" : "was");
    if (!rest.empty()) text += ", and " + effects_in_words(rest) + " stands beside it";
    return text;
}

std::string ambiguous(const diagnose::Verdict& v) {
    if (v.alike.size() < 2) return "Ambiguous: a mismatch with more than one explanation";
    std::string others;
    for (std::size_t k = 1; k < v.alike.size(); ++k)
        others += ", or " + effects_in_words(v.alike[k]);
    return fmt::format("Ambiguous: {}{}", effects_in_words(v.alike[0]), others);
}

std::string unexplained(const diagnose::Verdict& v) {
    std::vector<std::string> part = named(v, true);
    for (const std::string& name : named(v, false)) part.push_back(name);
    if (part.empty()) return "Unexplained: a mismatch that nothing in the catalogue accounts for";
    return "Unexplained: a mismatch beyond what " + effects_in_words(part) + " accounts for";
}

std::string headline(const diagnose::Verdict& v) {
    switch (v.answer) {
        case diagnose::Answer::consistent:
            return "Consistent: these recordings show nothing that was left out";
        case diagnose::Answer::explained:
            return explained(v);
        case diagnose::Answer::ambiguous:
            return ambiguous(v);
        case diagnose::Answer::unexplained:
            return unexplained(v);
        case diagnose::Answer::undecided:
            return "Undecided: these recordings cannot show whether physics was left out";
    }
    return "";
}

std::string paragraph(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& s : sentences) text += (text.empty() ? "" : " ") + s;
    return text;
}

std::string percent(double value) {
    return std::isfinite(value) ? fmt::format("{:.2g}", value) : "none";
}

// A table after an empty line; nothing where there is only its heading.
std::string below(const Rows& rows, const std::vector<bool>& right) {
    return rows.size() == 1 ? "" : fmt::format("\n{}", columns(rows, right));
}

// Hypotheses worth a line: the first six that have a chance of one in a thousand or more.
std::string hypotheses_text(const diagnose::Verdict& v) {
    Rows rows = {{"probability", "hypothesis"}};
    for (const diagnose::Hypothesis& h : v.hypotheses)
        if (rows.size() < 7 && h.probability >= 1e-3)
            rows.push_back({fmt::format("{:.3f}", h.probability), effects_in_words(h.effects)});
    return below(rows, {true, false});
}

std::string parameters_text(const diagnose::Verdict& v) {
    Rows rows = {{"parameter", "value", "90 % interval", "of"}};
    const auto add = [&](const diagnose::Estimate& e, const std::string& of) {
        rows.push_back({words(e.name), quantity(e.value, e.unit), interval_in_words(e), of});
    };
    for (const diagnose::Effect& e : v.effects) {
        if (!e.named) continue;
        for (const diagnose::Estimate& p : e.parameters) add(p, words(e.name));
    }
    for (const diagnose::Estimate& p : v.refitted) add(p, "the model, refitted");
    return below(rows, {false, true, true, false});
}

std::string errors_text(const diagnose::Verdict& v) {
    Rows rows = {{"error, % of the range", "before", "after", "noise alone"}};
    const auto add = [&](const char* name, const std::optional<diagnose::Scores>& s) {
        if (s)
            rows.push_back({name, percent(s->nrmse_base), percent(s->nrmse_extended),
                            percent(s->noise_floor)});
    };
    add("fitted", v.fit);
    add("held out", v.held_out);
    return below(rows, {false, true, true, true});
}

std::string gates_text(const diagnose::Verdict& v) {
    std::string text;
    for (const diagnose::Effect& e : v.effects)
        for (const diagnose::Gate& g : e.gates)
            if (g.result == diagnose::GateResult::failed && e.probability >= 0.05)
                text += wrapped(fmt::format("  {} fails the gate {}: {}", words(e.name),
                                            words(g.name), g.why),
                                width, 4) +
                        "\n";
    return text.empty() ? "" : "\nNot named because\n" + text;
}

std::string list_text(const char* heading, const std::vector<std::string>& lines) {
    if (lines.empty()) return "";
    std::string text = fmt::format("\n{}\n", heading);
    for (const std::string& line : lines) text += wrapped("  " + line, width, 4) + "\n";
    return text;
}

std::vector<std::string> next_lines(const diagnose::Verdict& v) {
    if (!v.next_experiment) return {};
    const diagnose::NextExperiment& n = *v.next_experiment;
    std::string what = fmt::format("rig {}", n.rig);
    for (const auto& [name, value] : n.conditions)
        what += fmt::format(", {} {}", words(name), value);
    for (const auto& [name, value] : n.grain)
        what += fmt::format(", grain {} {}", words(name), value);
    what +=
        fmt::format("; {} rows of {} for {} from {} to {}", n.rows, fmt::join(n.channels, ", "),
                    n.ordinate, quantity(n.from, n.ordinate_unit), quantity(n.to, n.ordinate_unit));
    const std::string apart = std::isfinite(n.separation_sigma)
                                  ? fmt::format("Expected: {} sigma.", number(n.separation_sigma))
                                  : "";
    return {what + ".", n.why + (n.why.empty() || apart.empty() ? "" : " ") + apart};
}

}  // namespace

Answer answer_of(diagnose::Answer answer) {
    switch (answer) {
        case diagnose::Answer::consistent:
            return Answer::yes;
        case diagnose::Answer::explained:
        case diagnose::Answer::unexplained:
            return Answer::no;
        case diagnose::Answer::ambiguous:
        case diagnose::Answer::undecided:
            return Answer::cannot_tell;
    }
    return Answer::cannot_tell;
}

Verdict verdict_of(const diagnose::Verdict& v) {
    return {answer_of(v.answer), headline(v), paragraph(v.summary)};
}

std::vector<std::string> limits_of(const diagnose::Verdict& v) {
    std::vector<std::string> limits = {
        "A name says which effect of the catalogue, in the form written there, describes these "
        "recordings best. An effect of the same form that is not in the catalogue would get the "
        "same name.",
        "What the recordings do not vary is not tested: a gate that is untestable is no gate "
        "passed."};
    if (v.answer == diagnose::Answer::consistent)
        limits.emplace_back(
            "Consistent means that nothing shows above this noise, not that nothing is missing.");
    if (!v.held_out)
        limits.emplace_back(
            "No recording that took no part in the fit was predicted, so that nothing was put to "
            "that "
            "test.");
    return limits;
}

std::string effects_in_words(const std::vector<std::string>& effects) {
    if (effects.empty()) return "nothing left out";
    std::string text;
    for (std::size_t k = 0; k < effects.size(); ++k) {
        if (k > 0) text += k + 1 == effects.size() ? " and " : ", ";
        text +=
            effects[k] == "unknown" ? "something that is not in the catalogue" : words(effects[k]);
    }
    return text;
}

std::string located_in_words(const diagnose::Located& l) {
    return fmt::format("{}, {}: recorded lies {} simulated by {} (rms) for {} from {} to {}",
                       l.experiment, words(l.channel), l.sign < 0 ? "below" : "above",
                       quantity(l.size, l.size_unit), words(l.variable), quantity(l.from, l.unit),
                       quantity(l.to, l.unit));
}

std::string interval_in_words(const diagnose::Estimate& e) {
    return fmt::format("{} to {}", quantity(e.low, e.unit), quantity(e.high, e.unit));
}

std::string chance_in_words(double p) {
    if (!std::isfinite(p)) return "not known";
    return p < 1e-3 ? "less than 0.001" : fmt::format("{:.2g}", p);
}

std::string text_of(const diagnose::Verdict& v) {
    const Verdict verdict = verdict_of(v);
    std::string text = verdict.headline + ".\n";
    if (!v.summary.empty()) text += wrapped(paragraph(v.summary), width, 0) + "\n";
    std::vector<std::string> where;
    for (const diagnose::Located& l : v.located) where.push_back(located_in_words(l) + ".");
    text += list_text("Where", where);
    text += hypotheses_text(v) + parameters_text(v) + errors_text(v) + gates_text(v);
    text += list_text("What would change this verdict", v.flips);
    text += list_text("What to record next", next_lines(v));
    return text + list_text("Warnings", v.warnings);
}

}  // namespace reports
