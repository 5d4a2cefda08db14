// SPDX-License-Identifier: MIT
#include "scaling/scale_study.hpp"

#include "scaling/nearest_name.hpp"
#include "scaling/numbers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace scaling {

namespace {

std::vector<FactorRow> factor_rows(const ScaleMap& map) {
    std::vector<FactorRow> rows;
    for (const NamedQuantity& q : quantity_table()) {
        const Exponents e = map.exponents(q.name);
        if (q.name == "apparatus_length" && !map.distorted()) continue;
        if (q.name == "contact_time" && !map.distorted()) continue;
        rows.push_back({q.name, e, map.value(e), map.imposed().contains(q.name)});
    }
    return rows;
}

std::vector<AdhesionPrediction> other_predictions(const ScaleInput& in, const ScaleMap& open_map) {
    std::vector<AdhesionPrediction> predictions;
    if (!in.adhesion) return predictions;
    for (const Invariant invariant : all_invariants()) {
        if (!open_map.adhesion_is_open() || invariant == in.invariant) continue;
        predictions.push_back(predict_adhesion(in.grain, open_map, invariant, *in.adhesion));
    }
    return predictions;
}

Finding similarity_finding(const ScaleMap& map, const std::vector<GroupChange>& groups) {
    std::vector<std::string> broken;
    for (const GroupChange& g : groups) {
        if (!g.kept) broken.push_back(fmt::format("{} x {:.4g}", g.group.name, g.ratio));
    }
    const std::string text = broken.empty()
                                 ? "every group is kept: original and scaled system are similar"
                                 : "broken: " + joined(broken);
    return {
        "broken_groups", static_cast<double>(broken.size()), "= 0",
        broken.empty() ? Judgement::fine : Judgement::caution,
        map.apparatus_kept() && !broken.empty()
            ? text +
                  "; with the apparatus kept only slow flow and many grains across D forgive this"
            : text};
}

CostInput original_cost_input(const ScaleInput& in) {
    CostInput made{in.grain, in.grains, in.duration, in.rayleigh_fraction,
                   in.grain_steps_per_second};
    if (!made.grains && in.base_diameter) {
        made.grains =
            grains_in({*in.base_diameter, in.heap_angle, in.packing_fraction}, in.grain.diameter);
    }
    return made;
}

}  // namespace

std::vector<Variable> study_variables(const ScaleInput& in,
                                      std::optional<EnergyPerArea> work_of_adhesion) {
    const Grain& grain = in.grain;
    std::vector<Variable> variables = {
        {"density", "density", grain.density.value()},
        {"gravity", "gravity", grain.gravity.value()},
        {"grain_diameter", "length", grain.diameter.value()},
        {"apparatus_length", "apparatus_length", in.apparatus_length.value()},
        {"youngs_modulus", "youngs_modulus", grain.youngs_modulus.value()},
    };
    const auto add = [&](const char* name, const char* quantity, double value) {
        variables.push_back({name, quantity, value});
    };
    if (work_of_adhesion) {
        add("work_of_adhesion", "work_of_adhesion", work_of_adhesion->value());
        add("equilibrium_separation", "length", equilibrium_separation.value());
    }
    if (in.base_diameter) add("base_diameter", "apparatus_length", in.base_diameter->value());
    // The speed of the flow: that of the drop, else of a fall over half the apparatus, v^2 = g D.
    const Length fall = grain.drop_height ? *grain.drop_height : 0.5 * in.apparatus_length;
    if (grain.drop_height) add("drop_height", "apparatus_length", fall.value());
    add("velocity", "velocity", std::sqrt(2.0 * grain.gravity.value() * fall.value()));
    if (in.fluid) {
        add("fluid_density", "density", in.fluid->density.value());
        add("fluid_viscosity", "viscosity", in.fluid->viscosity.value());
    }
    if (in.liquid) {
        add("surface_tension", "surface_tension", in.liquid->surface_tension.value());
        add("liquid_volume", "liquid_volume", in.liquid->volume.value());
    }
    for (const auto& [name, value] : in.coefficients) variables.push_back({name, "strain", value});
    return variables;
}

ScaleStudy study(const ScaleInput& in) {
    check(in.grain);
    const ScaleMap open_map = ScaleMap::solve(in.scheme, in.h, in.softening);
    const ScaleMap map = with_adhesion(open_map, in.invariant);

    std::optional<AdhesionPrediction> adhesion;
    std::optional<EnergyPerArea> original_w;
    if (in.adhesion) {
        adhesion = predict_adhesion(in.grain, open_map, in.invariant, *in.adhesion);
        original_w = adhesion->original.work_of_adhesion;
    }
    const std::vector<Variable> variables = study_variables(in, original_w);
    const std::vector<PiGroup> named = named_groups(in.grain.poisson_ratio);
    std::vector<GroupChange> groups = compare_groups(groups_of(variables, named), variables, map);

    const CostInput original = original_cost_input(in), after = scaled(original, map);
    const double originals = originals_per_grain(map);
    std::vector<Finding> findings = {similarity_finding(map, groups)};
    for (Finding& f : stated_findings(in.stated, after, originals))
        findings.push_back(std::move(f));

    return {.scheme = in.scheme,
            .h = in.h,
            .softening = in.softening,
            .distorted = map.distorted(),
            .exact_in_binary = map.exact_in_binary(),
            .factors = factor_rows(map),
            .groups = std::move(groups),
            .adhesion = std::move(adhesion),
            .other_invariants = other_predictions(in, open_map),
            .original_scale_number = scale_number(in.apparatus_length, in.grain.diameter),
            .scaled_scale_number = scaled_scale_number(in.apparatus_length, in.grain.diameter, map),
            .originals_per_grain = originals,
            .original_cost = cost(original),
            .scaled_cost = cost(after),
            .findings = std::move(findings)};
}

}  // namespace scaling
