// SPDX-License-Identifier: MIT
#include "scaling/adhesion.hpp"

#include "scaling/adhesion_findings.hpp"
#include "scaling/errors.hpp"
#include "scaling/jkr_estimates.hpp"
#include "scaling/nearest_name.hpp"
#include "scaling/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scaling {

namespace {

std::string with_unit(double value, const char* unit) {
    return fmt::format("{:.6g} {}", value, unit);
}

// The invariant's group is named like it. Its exponents do not depend on the Poisson ratio.
PiGroup group_of(Invariant invariant) {
    const std::vector<PiGroup> named = named_groups(0.0);
    return *std::find_if(named.begin(), named.end(),
                         [&](const PiGroup& g) { return g.name == to_string(invariant); });
}

// The quantity whose factor a group's variable has.
std::string quantity_of(const std::string& variable) {
    return variable == "grain_diameter" ? "length" : variable;
}

Rational exponent_in(const PiGroup& group, const std::string& variable) {
    const auto found = std::find_if(group.powers.begin(), group.powers.end(),
                                    [&](const Power& p) { return p.name == variable; });
    return found == group.powers.end() ? Rational(0) : found->exponent;
}

void check_positive(const char* member, double value, const char* unit) {
    if (value > 0.0 && std::isfinite(value)) return;
    throw InvalidParameter(mistake(std::string("grain.") + member, with_unit(value, unit),
                                   "must be > 0 and finite", "give the original grain's value"));
}

GrainAdhesion adhesion_of(const Grain& grain, EnergyPerArea w) {
    const JkrPair pair{w, effective_modulus(grain.youngs_modulus, grain.poisson_ratio),
                       0.25 * grain.diameter};
    const Force pull_off = pair.pull_off_force();
    return {w, 0.5 * w, pull_off,
            weight_bond_number(pull_off, grain_mass(grain.diameter, grain.density), grain.gravity)};
}

}  // namespace

const std::vector<Invariant>& all_invariants() {
    static const std::vector<Invariant> all = {Invariant::weight_bond, Invariant::stress_bond,
                                               Invariant::cohesion_number,
                                               Invariant::sticking_velocity};
    return all;
}

const char* to_string(Invariant invariant) {
    switch (invariant) {
        case Invariant::weight_bond:
            return "weight_bond";
        case Invariant::stress_bond:
            return "stress_bond";
        case Invariant::cohesion_number:
            return "cohesion_number";
        case Invariant::sticking_velocity:
            return "sticking_velocity";
    }
    return "";
}

Invariant invariant_from(const std::string& name) {
    std::vector<std::string> names;
    for (const Invariant invariant : all_invariants()) {
        if (name == to_string(invariant)) return invariant;
        names.emplace_back(to_string(invariant));
    }
    throw InvalidParameter(mistake("invariant", '"' + name + '"', "must be one of " + joined(names),
                                   "did you mean " + nearest_name(name, names) + "?"));
}

Exponents adhesion_exponents(const ScaleMap& map, Invariant invariant) {
    Exponents others;
    const PiGroup group = group_of(invariant);
    for (const Power& p : group.powers) {
        if (p.name != "work_of_adhesion")
            others = others + p.exponent * map.exponents(quantity_of(p.name));
    }
    return (Rational(-1) / exponent_in(group, "work_of_adhesion")) * others;
}

Rational modulus_exponent(Invariant invariant) {
    const PiGroup group = group_of(invariant);
    return -exponent_in(group, "youngs_modulus") / exponent_in(group, "work_of_adhesion");
}

void check(const Grain& grain) {
    check_positive("diameter", grain.diameter.value(), "m");
    check_positive("density", grain.density.value(), "kg/m^3");
    check_positive("youngs_modulus", grain.youngs_modulus.value(), "Pa");
    check_positive("gravity", grain.gravity.value(), "m/s^2");
    if (grain.drop_height) check_positive("drop_height", grain.drop_height->value(), "m");
    if (!(grain.poisson_ratio > -1.0 && grain.poisson_ratio < 0.5)) {
        throw InvalidParameter(mistake("grain.poisson_ratio",
                                       fmt::format("{:.6g}", grain.poisson_ratio),
                                       "must lie between -1 and 0.5", "0.3 suits most solids"));
    }
}

Grain scaled(const Grain& grain, const ScaleMap& map) {
    Grain made = grain;
    made.diameter *= map.factor("length");
    made.density *= map.factor("density");
    made.youngs_modulus *= map.factor("youngs_modulus");
    made.gravity *= map.factor("gravity");
    if (made.drop_height) *made.drop_height *= map.factor("apparatus_length");
    return made;
}

ScaleMap with_adhesion(const ScaleMap& map, std::optional<Invariant> invariant) {
    if (map.adhesion_is_open() && !invariant) {
        throw InvalidParameter(
            mistake("invariant", "none", "must be stated, because this scheme leaves adhesion open",
                    "weight_bond, stress_bond, cohesion_number or sticking_velocity"));
    }
    if (!invariant) return map;
    const Exponents demanded = map.exponents("work_of_adhesion"),
                    exponents = adhesion_exponents(map, *invariant);
    if (!map.adhesion_is_open() && !(demanded == exponents)) {
        throw InvalidParameter(mistake("invariant", to_string(*invariant),
                                       "asks for work_of_adhesion " + to_string(exponents) +
                                           ", but the kept quantities demand " +
                                           to_string(demanded),
                                       "leave one of the two out"));
    }
    return map.adhesion_is_open() ? map.with_imposed("work_of_adhesion", exponents) : map;
}

AdhesionPrediction predict_adhesion(const Grain& original, const ScaleMap& open_map,
                                    std::optional<Invariant> invariant,
                                    const StatedAdhesion& stated) {
    check(original);
    if (!(stated.work_of_adhesion.value() > 0.0 &&
          std::isfinite(stated.work_of_adhesion.value()))) {
        throw InvalidParameter(
            mistake("work_of_adhesion", with_unit(stated.work_of_adhesion.value(), "J/m^2"),
                    "must be > 0", "w = 2 gamma for like grains; leave it out where none sticks"));
    }
    const ScaleMap map = with_adhesion(open_map, invariant);
    const double factor = map.factor("work_of_adhesion");
    const EnergyPerArea w = stated.work_of_adhesion;
    const EnergyPerArea w_original = stated.of == Of::original ? w : w / factor;
    const EnergyPerArea w_scaled = stated.of == Of::original ? w * factor : w;
    const Grain big = scaled(original, map);
    AdhesionPrediction prediction{.invariant = invariant,
                                  .exponents = map.exponents("work_of_adhesion"),
                                  .original = adhesion_of(original, w_original),
                                  .scaled = adhesion_of(big, w_scaled),
                                  .findings = adhesion_findings(big, w_scaled),
                                  .physically_usable = true};
    for (Finding& f : original_findings(original, w_original))
        prediction.findings.push_back(std::move(f));
    prediction.physically_usable =
        std::none_of(prediction.findings.begin(), prediction.findings.end(),
                     [](const Finding& f) { return f.judgement == Judgement::unusable; });
    prediction.findings.push_back(usability_finding(original, open_map, prediction, stated.of));
    return prediction;
}

}  // namespace scaling
