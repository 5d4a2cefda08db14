// SPDX-License-Identifier: MIT
#include "reports/numbers.hpp"
#include "reports/page_parts.hpp"

#include <fmt/format.h>

#include <utility>

namespace reports {

namespace {

using scaling::AdhesionPrediction;
using scaling::Cost;
using scaling::Finding;
using scaling::ScaleStudy;

data finding_data(const Finding& f) {
    data d;
    d["name"] = words(f.name);
    d["value"] = typeset(number(f.value));
    d["rule"] = typeset(f.rule);
    d["judgement"] = scaling::to_string(f.judgement);
    d["class"] = class_of(f.judgement);
    d["text"] = typeset(f.text);
    return d;
}

data findings_data(const std::vector<Finding>& findings) {
    data list{data::type::list};
    for (const Finding& f : findings) list << finding_data(f);
    return list;
}

// "kept" where the factor is 1, else what became of the quantity.
data factor_data(const scaling::FactorRow& row) {
    const bool kept = row.exponents == scaling::Exponents{};
    data d;
    d["quantity"] = words(row.quantity);
    d["law"] = typeset(scaling::to_string(row.exponents));
    d["factor"] = typeset(number(row.factor));
    d["status"] = row.imposed ? "set apart from the rest" : kept ? "kept" : "";
    d["class"] = row.imposed ? "open" : kept ? "yes" : "";
    return d;
}

// The same group's ratio under the study beside this one; empty where that has no such group.
std::string ratio_beside(const std::optional<ScaleStudy>& beside, const std::string& name) {
    if (!beside) return "";
    for (const scaling::GroupChange& g : beside->groups)
        if (g.group.name == name)
            return g.kept ? "\u2713 kept" : "\u2717 " + typeset(number(g.ratio)) + " times";
    return "";
}

std::string law_beside(const std::optional<ScaleStudy>& beside, const std::string& quantity) {
    if (!beside) return "";
    for (const scaling::FactorRow& row : beside->factors)
        if (row.quantity == quantity) return typeset(scaling::to_string(row.exponents));
    return "";
}

data group_data(const scaling::GroupChange& g) {
    data d;
    d["name"] = words(g.group.name);
    d["formula"] = g.group.formula == g.group.name ? "" : typeset(g.group.formula);
    d["original"] = typeset(number(g.original));
    d["scaled"] = typeset(number(g.scaled));
    d["ratio"] = typeset(number(g.ratio));
    d["status"] = g.kept ? "\u2713 kept" : "\u2717 broken";
    d["class"] = g.kept ? "yes" : "no";
    return d;
}

data row_data(const std::string& name, const std::string& original, const std::string& scaled) {
    data d;
    d["name"] = name;
    d["original"] = typeset(original);
    d["scaled"] = typeset(scaled);
    return d;
}

data adhesion_rows(const AdhesionPrediction& p) {
    const auto row = [](const char* name, double a, double b, const char* unit) {
        return row_data(name, quantity(a, unit), quantity(b, unit));
    };
    data list{data::type::list};
    list << row("work of adhesion w", p.original.work_of_adhesion.value(),
                p.scaled.work_of_adhesion.value(), "J/m^2");
    list << row("surface energy, w/2", p.original.surface_energy.value(),
                p.scaled.surface_energy.value(), "J/m^2");
    list << row("pull-off force", p.original.pull_off_force.value(),
                p.scaled.pull_off_force.value(), "N");
    list << row_data("pull-off force in grain weights",
                     number(p.original.pull_off_in_grain_weights),
                     number(p.scaled.pull_off_in_grain_weights));
    return list;
}

data other_data(const AdhesionPrediction& p) {
    data d;
    d["name"] = words(scaling::to_string(*p.invariant));
    d["law"] = typeset(scaling::to_string(p.exponents));
    d["original"] = typeset(quantity(p.original.work_of_adhesion.value(), "J/m^2"));
    d["scaled"] = typeset(quantity(p.scaled.work_of_adhesion.value(), "J/m^2"));
    d["usable"] = p.physically_usable ? "\u2713 yes" : "\u2717 no";
    d["class"] = p.physically_usable ? "yes" : "no";
    return d;
}

data adhesion_data(const ScaleStudy& study) {
    const AdhesionPrediction& p = *study.adhesion;
    const std::string law = scaling::to_string(p.exponents);
    data d;
    d["basis"] = typeset(
        p.invariant
            ? fmt::format("Kept by choice: {}. The work of adhesion then goes as {}.",
                          words(scaling::to_string(*p.invariant)), law)
            : fmt::format("What is kept settles the adhesion: the work of adhesion goes as {}.",
                          law));
    d["rows"] = adhesion_rows(p);
    d["findings"] = findings_data(p.findings);
    data others{data::type::list};
    for (const AdhesionPrediction& o : study.other_invariants) others << other_data(o);
    set_list(d, "others", std::move(others));
    return d;
}

data cost_data(const ScaleStudy& study) {
    const Cost &a = study.original_cost, &b = study.scaled_cost;
    const auto many = [](const std::optional<double>& n) {
        return n ? count(*n) : std::string("not known");
    };
    const auto time = [](const std::optional<scaling::Time>& t) {
        return t ? quantity(t->value(), "s") : std::string("not known");
    };
    const auto sized = [](const scaling::ScaleNumber& s) {
        return fmt::format("{} ({})", number(s.value), scaling::to_string(s.size_class));
    };
    data list{data::type::list};
    list << row_data("scale number, apparatus over grain radius",
                     sized(study.original_scale_number), sized(study.scaled_scale_number));
    list << row_data("grains", many(a.grains), many(b.grains));
    list << row_data("original grains that one grain stands for", "1",
                     count(study.originals_per_grain));
    list << row_data("Rayleigh time", quantity(a.rayleigh_time.value(), "s"),
                     quantity(b.rayleigh_time.value(), "s"));
    list << row_data("time step", quantity(a.time_step.value(), "s"),
                     quantity(b.time_step.value(), "s"));
    list << row_data("steps", many(a.steps), many(b.steps));
    list << row_data("wall time on this machine", time(a.wall_time), time(b.wall_time));
    return list;
}

std::string demands(const ScaleStudy& study) {
    std::string text;
    for (const scaling::Demand& d : study.scheme.demands) {
        text += (text.empty() ? "" : ", ") + words(d.quantity);
        text += d.exponents == scaling::Exponents{} ? " kept"
                                                    : " as " + scaling::to_string(d.exponents);
    }
    return text.empty() ? "nothing beyond the size" : text;
}

}  // namespace

const char* class_of(scaling::Judgement judgement) {
    switch (judgement) {
        case scaling::Judgement::fine:
            return "yes";
        case scaling::Judgement::caution:
            return "open";
        case scaling::Judgement::unusable:
            return "no";
    }
    return "";
}

data scale_part(const ScaleStudy& study, const std::optional<ScaleStudy>& beside) {
    data d;
    d["scheme"] = words(study.scheme.name);
    d["beside"] = beside ? data(words(beside->scheme.name)) : data(data::type::bool_false);
    d["h"] = number(study.h);
    d["kept"] = demands(study);
    d["nature"] = study.distorted ? "The map is distorted: grain and surroundings have a ruler and "
                                    "a clock each, so that groups must break."
                                  : "Grain and surroundings share one ruler and one clock.";
    data factors{data::type::list}, groups{data::type::list};
    for (const scaling::FactorRow& row : study.factors) {
        data one = factor_data(row);
        one["other"] = law_beside(beside, row.quantity);
        factors << one;
    }
    for (const scaling::GroupChange& g : study.groups) {
        data one = group_data(g);
        one["other"] = ratio_beside(beside, g.group.name);
        groups << one;
    }
    d["factors"] = std::move(factors);
    d["groups"] = std::move(groups);
    d["adhesion"] = study.adhesion ? adhesion_data(study) : data(data::type::bool_false);
    d["cost"] = cost_data(study);
    set_list(d, "findings", findings_data(study.findings));
    return d;
}

}  // namespace reports
