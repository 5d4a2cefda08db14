// SPDX-License-Identifier: MIT
#include "reports/diagnosis.hpp"
#include "reports/diagnosis_figures.hpp"
#include "reports/numbers.hpp"
#include "reports/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace reports {

namespace {

constexpr double worth_a_line = 1e-3, worth_a_section = 0.05;  // probability
constexpr std::size_t most_hypotheses = 8;

std::string probability_text(double p) {
    if (!std::isfinite(p)) return "none";
    return p < worth_a_line ? "< 0.001" : fmt::format("{:.3f}", p);
}

std::string percent(double value) {
    return std::isfinite(value) ? fmt::format("{:.2g} %", value) : "none";
}

data located_data(const diagnose::Located& l) {
    data d;
    d["experiment"] = l.experiment;
    d["channel"] = words(l.channel);
    d["interval"] = typeset(fmt::format("{} {} to {}", words(l.variable), quantity(l.from, l.unit),
                                        quantity(l.to, l.unit)));
    d["sign"] = l.sign < 0 ? "below the simulated" : "above the simulated";
    d["size"] = typeset(quantity(l.size, l.size_unit));
    return d;
}

data figure_data(const Figure& figure) {
    data d("figure", figure.svg);
    d["caption"] = figure.caption;
    return d;
}

data curves_data(const diagnose::Verdict& v) {
    data list{data::type::list};
    for (const CurveFigures& f : curve_figures(v)) {
        data d("name", f.name);
        d["figure"] = f.curve.svg;
        d["residual"] = f.residual.svg;
        d["caption"] = f.residual.caption;
        list << d;
    }
    return list;
}

data bar_data(const std::string& name, double probability) {
    data d("name", name);
    d["probability"] = probability_text(probability);
    d["width"] = fmt::format("{:.1f}", 100.0 * std::clamp(probability, 0.0, 1.0));
    return d;
}

data hypotheses_data(const std::vector<diagnose::Hypothesis>& hypotheses) {
    data list{data::type::list};
    double others = 0.0;
    std::size_t shown = 0, left_out = 0;
    for (const diagnose::Hypothesis& h : hypotheses) {
        if (shown < most_hypotheses && h.probability >= worth_a_line) {
            list << bar_data(effects_in_words(h.effects), h.probability);
            ++shown;
        } else {
            others += std::isfinite(h.probability) ? h.probability : 0.0;
            ++left_out;
        }
    }
    if (left_out > 0)
        list << bar_data(left_out == 1 ? "one other" : fmt::format("{} others together", left_out),
                         others);
    return list;
}

data gate_data(const diagnose::Gate& g) {
    data d("name", words(g.name));
    d["why"] = typeset(g.why);
    switch (g.result) {
        case diagnose::GateResult::passed:
            d["status"] = "\u2713 passed";
            d["class"] = "yes";
            break;
        case diagnose::GateResult::failed:
            d["status"] = "\u2717 failed";
            d["class"] = "no";
            break;
        case diagnose::GateResult::untestable:
            d["status"] = "? untestable";
            d["class"] = "open";
            break;
    }
    return d;
}

data estimates_data(const std::vector<diagnose::Estimate>& estimates) {
    data list{data::type::list};
    for (const diagnose::Estimate& e : estimates) {
        data d("name", words(e.name));
        d["value"] = typeset(quantity(e.value, e.unit));
        d["interval"] = typeset(interval_in_words(e));
        list << d;
    }
    return list;
}

data effect_data(const diagnose::Effect& e, std::size_t number) {
    data d("name", e.name == "unknown" ? effects_in_words({e.name}) : words(e.name));
    d["named"] = e.named ? "named" : "not named";
    d["class"] = e.named ? "yes" : "open";
    d["probability"] = probability_text(e.probability);
    data why{data::type::list}, gates{data::type::list}, figures{data::type::list};
    for (const std::string& sentence : e.why) why << data("text", typeset(sentence));
    for (const diagnose::Gate& g : e.gates) gates << gate_data(g);
    if (e.missing)
        figures << figure_data(missing_figure(*e.missing, fmt::format("missing-{}", number)));
    set_list(d, "why", std::move(why));
    set_list(d, "parameters", estimates_data(e.parameters));
    set_list(d, "gates", std::move(gates));
    set_list(d, "figures", std::move(figures));
    return d;
}

data effects_data(const diagnose::Verdict& v) {
    data list{data::type::list};
    std::size_t number = 0;
    for (const diagnose::Effect& e : v.effects)
        if (e.named || e.missing || e.probability >= worth_a_section)
            list << effect_data(e, ++number);
    return list;
}

data scores_data(const diagnose::Verdict& v) {
    data list{data::type::list};
    const auto add = [&](const std::string& name, const std::optional<diagnose::Scores>& s) {
        if (!s) return;
        data d("name", s->experiments.empty()
                           ? name
                           : fmt::format("{}: {}", name, fmt::join(s->experiments, ", ")));
        d["before"] = percent(s->nrmse_base);
        d["after"] = percent(s->nrmse_extended);
        d["noise"] = percent(s->noise_floor);
        list << d;
    };
    add("fitted", v.fit);
    add("held out", v.held_out);
    return list;
}

data sentences(const std::vector<std::string>& lines) {
    data list{data::type::list};
    for (const std::string& line : lines) list << data("text", typeset(line));
    return list;
}

data pair_data(const std::string& name, const std::string& value) {
    data d("name", name);
    d["value"] = typeset(value);
    return d;
}

data next_data(const diagnose::NextExperiment& n) {
    data rows{data::type::list};
    rows << pair_data("rig", words(n.rig));
    for (const auto& [name, value] : n.conditions) rows << pair_data(words(name), value);
    for (const auto& [name, value] : n.grain) rows << pair_data("grain: " + words(name), value);
    rows << pair_data("channels", fmt::format("{}", fmt::join(n.channels, ", ")));
    rows << pair_data(
        "rows", fmt::format("{} for {} from {} to {}", n.rows, words(n.ordinate),
                            quantity(n.from, n.ordinate_unit), quantity(n.to, n.ordinate_unit)));
    std::string between;
    for (const std::string& h : n.between)
        between += (between.empty() ? "" : " from ") + (h.empty() ? "nothing left out" : words(h));
    if (!between.empty()) rows << pair_data("tells apart", between);
    if (std::isfinite(n.separation_sigma))
        rows << pair_data("by", number(n.separation_sigma) + " sigma, expected");
    data d("why", typeset(n.why));
    d["rows"] = std::move(rows);
    return d;
}

}  // namespace

data diagnosis_part(const diagnose::Verdict& v) {
    data d, located{data::type::list};
    for (const diagnose::Located& l : v.located) located << located_data(l);
    set_list(d, "located", std::move(located));
    d["p_value"] = optional_text(std::isfinite(v.p_value) ? chance_in_words(v.p_value) : "");
    set_list(d, "curves", curves_data(v));
    set_list(d, "hypotheses", hypotheses_data(v.hypotheses));
    set_list(d, "effects", effects_data(v));
    set_list(d, "refitted", estimates_data(v.refitted));
    set_list(d, "scores", scores_data(v));
    set_list(d, "flips", sentences(v.flips));
    d["plan"] = v.next_experiment ? next_data(*v.next_experiment) : data(data::type::bool_false);
    set_list(d, "warnings", sentences(v.warnings));
    return d;
}

}  // namespace reports
