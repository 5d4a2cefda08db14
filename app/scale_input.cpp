// SPDX-License-Identifier: MIT
#include "app/scale_input.hpp"

#include "cases/messages.hpp"
#include "cases/units.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace app {

namespace {

using cases::Case;
using cases::Experiment;
using scaling::EnergyPerArea;
using scaling::InvalidInput;
using scaling::Length;
using scaling::mistake;
using scaling::ScaleInput;
using scaling::ScaleMap;
using scaling::Scheme;

// Where each rig's characteristic length stands: the outlet of funnel or silo, else the base or
// what holds the grains.
struct Apparatus {
    const char *rig, *condition;
    double times;
};
constexpr std::array<Apparatus, 6> apparatus_of{{{"pile", "base_diameter", 1.0},
                                                 {"discharge", "outlet_diameter", 1.0},
                                                 {"discharge", "outlet_width", 1.0},
                                                 {"column", "column_radius", 2.0},
                                                 {"drum", "drum_diameter", 1.0},
                                                 {"drop", "height", 1.0}}};

bool in_apparatus(const Experiment& e) {
    return std::any_of(apparatus_of.begin(), apparatus_of.end(),
                       [&](const Apparatus& a) { return e.rig == a.rig; });
}

std::optional<Length> apparatus_length(const Experiment& e) {
    if (e.conditions.has("funnel"))
        return e.conditions.at("funnel").at("outlet_diameter").quantity<Length>();
    for (const Apparatus& a : apparatus_of)
        if (e.rig == a.rig && e.conditions.has(a.condition))
            return a.times * e.conditions.at(a.condition).quantity<Length>();
    return std::nullopt;
}

std::optional<Length> drop_height(const Experiment& e) {
    const cases::Value& c = e.conditions;
    if (c.has("funnel")) return c.at("funnel").at("outlet_height").quantity<Length>();
    if (e.rig == "pile") return c.quantity_or<Length>("drop_height", 5.0 * e.grain.diameter.value);
    if (e.rig == "drop") return c.at("height").quantity<Length>();
    return std::nullopt;
}

Scheme scheme_of(const Case& c, const ScaleOverrides& o) {
    if (!o.scheme.empty() && !o.keep.empty())
        throw InvalidInput(mistake("--keep", "a list beside --scheme " + o.scheme,
                                   "must stand alone", "give one of the two"));
    if (!o.scheme.empty()) {
        Scheme scheme = scaling::named_scheme(o.scheme);
        scheme.distorted = scheme.distorted || o.distorted;
        return scheme;
    }
    if (!o.keep.empty()) return scaling::own_scheme(o.keep, o.distorted);
    if (c.scaling && !c.scaling->kept.empty())
        return scaling::own_scheme(c.scaling->kept, c.scaling->distorted);
    if (c.scaling && !c.scaling->scheme.empty()) return scaling::named_scheme(c.scaling->scheme);
    throw InvalidInput(mistake(c.path + ": scaling.scheme", "none",
                               "must be stated, here or as --scheme",
                               "exact, kept_gravity, kept_gravity_kept_modulus, paper, "
                               "coarse_grain, or --keep with a list"));
}

double h_of(const Case& c, const ScaleOverrides& o) {
    if (o.h) return *o.h;
    if (c.scaling) return c.scaling->h;
    throw InvalidInput(mistake(c.path + ": scaling.h", "none", "must be stated, here or as --h",
                               "the scaled grain's diameter over the real one's, such as --h 200"));
}

bool another_scaling(const ScaleOverrides& o) {
    return o.h || o.softening || !o.scheme.empty() || !o.keep.empty();
}

[[noreturn]] void ask_for_invariant(const Case& c) {
    throw InvalidInput(
        mistake(c.path + ": scaling.invariant", "none",
                "must be stated, here or as --invariant: this scheme leaves the adhesion open",
                "weight_bond keeps a grain's sticking against its weight; stress_bond keeps it "
                "against the stress in the bulk; "
                "cohesion_number keeps the energy to part two grains against lifting one; "
                "sticking_velocity keeps which impacts stick"));
}

// The one asked for; the case's own where its scaling holds or where this map needs one too.
std::optional<scaling::Invariant> invariant_of(const Case& c, const ScaleOverrides& o,
                                               const ScaleMap& map) {
    if (!o.invariant.empty()) return scaling::invariant_from(o.invariant);
    const bool stated = c.scaling && !c.scaling->invariant.empty();
    if (stated && (map.adhesion_is_open() || !another_scaling(o)))
        return scaling::invariant_from(c.scaling->invariant);
    if (map.adhesion_is_open()) ask_for_invariant(c);
    return std::nullopt;
}

scaling::StatedAdhesion typed_adhesion(const ScaleOverrides& o) {
    const bool gamma = !o.surface_energy.empty();
    const std::string option = gamma ? "--surface-energy" : "--work-of-adhesion";
    if (gamma && !o.work_of_adhesion.empty())
        throw InvalidInput(mistake(option, cases::in_quotes(o.surface_energy),
                                   "must not stand beside --work-of-adhesion",
                                   "give one of the two; w = 2 gamma for like solids"));
    const std::string& text = gamma ? o.surface_energy : o.work_of_adhesion;
    const auto value = cases::quantity<EnergyPerArea>(text, option);
    if (o.of.empty())
        throw InvalidInput(
            mistake(option, cases::in_quotes(text), "must say which grain it belongs to",
                    "add --of original for the real powder, --of scaled for the simulated grain"));
    return {gamma ? 2.0 * value : value,
            o.of == "original" ? scaling::Of::original : scaling::Of::scaled};
}

// The adhesion of the real grain that the case's own scaling makes of the stated scaled one.
EnergyPerArea carried_back(const Case& c, const scaling::Grain& grain, EnergyPerArea stated) {
    const ScaleOverrides none;
    const ScaleMap own = ScaleMap::solve(scheme_of(c, none), c.scaling->h, c.scaling->softening);
    return scaling::predict_adhesion(grain, own, invariant_of(c, none, own),
                                     {stated, scaling::Of::scaled})
        .original.work_of_adhesion;
}

std::optional<scaling::StatedAdhesion> adhesion_of(const Case& c, const ScaleOverrides& o,
                                                   const scaling::Grain& grain) {
    if (!o.work_of_adhesion.empty() || !o.surface_energy.empty()) return typed_adhesion(o);
    if (c.scaling && c.scaling->scaled_work_of_adhesion) {
        const EnergyPerArea w = *c.scaling->scaled_work_of_adhesion;
        if (another_scaling(o))
            return scaling::StatedAdhesion{carried_back(c, grain, w), scaling::Of::original};
        return scaling::StatedAdhesion{w, scaling::Of::scaled};
    }
    const double w = c.model.value_or("work_of_adhesion", 0.0);
    if (w > 0.0)
        return scaling::StatedAdhesion{EnergyPerArea::from_value(w), scaling::Of::original};
    return std::nullopt;
}

void add_materials(ScaleInput& in, const Case& c, const cases::Surroundings& around) {
    if (around.fluid_density.value() > 0.0 && around.fluid_viscosity.value() > 0.0)
        in.fluid = scaling::Fluid{around.fluid_density, around.fluid_viscosity};
    const cases::Parameter *tension = c.model.find("surface_tension"),
                           *volume = c.model.find("liquid_volume");
    if (tension != nullptr && volume != nullptr && tension->value > 0.0 && volume->value > 0.0)
        in.liquid = scaling::Liquid{EnergyPerArea::from_value(tension->value),
                                    scaling::Volume::from_value(volume->value)};
    for (const auto& [name, parameter] : c.model.parameters)
        if (parameter.unit == "1" && parameter.value > 0.0)
            in.coefficients.emplace_back(name, parameter.value);
}

void add_cost(ScaleInput& in, const Case& c, const Experiment* e, const ScaleOverrides& o) {
    in.stated = c.stated.counts;
    if (c.stated.rayleigh_fraction) in.rayleigh_fraction = *c.stated.rayleigh_fraction;
    if (in.stated.heap) {
        in.heap_angle = in.stated.heap->angle;
        in.packing_fraction = in.stated.heap->packing_fraction;
    }
    // What is said of a scaled run is timed on the scaled clock, which the case's own scaling turns
    // back.
    if (in.stated.simulated_time && c.scaling) {
        const ScaleOverrides none;
        const ScaleMap own =
            ScaleMap::solve(scheme_of(c, none), c.scaling->h, c.scaling->softening);
        in.duration = *in.stated.simulated_time / own.factor("time");
    }
    if (another_scaling(o)) in.stated = {};  // they are about the case's own scaled run
    if (e == nullptr || e->rig != "pile") return;
    in.base_diameter = e->conditions.at("base_diameter").quantity<Length>();
    const cases::Value& grains = e->conditions.at("grains");
    if (grains.kind == cases::Value::Kind::number) in.grains = static_cast<double>(grains.count());
}

Length apparatus_or_ask(const Case& c, const Experiment* e, const ScaleOverrides& o) {
    if (!o.apparatus.empty()) return cases::quantity<Length>(o.apparatus, "--apparatus");
    if (e != nullptr)
        if (const auto length = apparatus_length(*e)) return *length;
    throw InvalidInput(mistake(
        c.path + ": experiments", "none in an apparatus", "must hold one, or --apparatus a length",
        "write --apparatus \"6 mm\": the outlet of funnel or silo, else the base"));
}

}  // namespace

const Experiment* experiment_of(const Case& c, const std::string& id) {
    if (!id.empty()) {
        if (const Experiment* found = c.find(id)) return found;
        std::vector<std::string> ids;
        for (const Experiment& e : c.experiments) ids.push_back(e.id);
        throw InvalidInput(
            mistake("--experiment", cases::in_quotes(id), "must be one of the case's experiments",
                    ids.empty() ? "this case has none" : cases::suggestion(id, ids)));
    }
    const auto found = std::find_if(c.experiments.begin(), c.experiments.end(), in_apparatus);
    if (found != c.experiments.end()) return &*found;
    return c.experiments.empty() ? nullptr : &c.experiments.front();
}

ScaleInput scale_input(const Case& c, const ScaleOverrides& o) {
    const Experiment* e = experiment_of(c, o.experiment);
    const cases::Grain& grain = e != nullptr ? e->grain : c.grain;
    const cases::Surroundings& around = e != nullptr ? e->surroundings : c.surroundings;
    ScaleInput in{};
    in.grain = {.diameter = grain.diameter.value,
                .density = grain.density.value,
                .youngs_modulus = grain.youngs_modulus.value,
                .poisson_ratio = grain.poisson_ratio.value.value(),
                .gravity = around.gravity,
                .drop_height = e != nullptr ? drop_height(*e) : std::nullopt};
    scaling::check(in.grain);
    in.apparatus_length = apparatus_or_ask(c, e, o);
    in.h = h_of(c, o);
    in.scheme = scheme_of(c, o);
    in.softening = o.softening ? *o.softening : c.scaling ? c.scaling->softening : 1.0;
    in.invariant = invariant_of(c, o, ScaleMap::solve(in.scheme, in.h, in.softening));
    in.adhesion = adhesion_of(c, o, in.grain);
    add_materials(in, c, around);
    add_cost(in, c, e, o);
    return in;
}

scaling::ScaleStudy study_of(const Case& c, const ScaleOverrides& o,
                             double grain_steps_per_second) {
    ScaleInput in = scale_input(c, o);
    in.grain_steps_per_second = grain_steps_per_second;
    scaling::ScaleStudy study = scaling::study(in);
    const bool typed = !o.work_of_adhesion.empty() || !o.surface_energy.empty();
    if (!typed && c.scaling && c.scaling->scaled_work_of_adhesion && another_scaling(o))
        study.findings.push_back(
            {"adhesion_carried_over_from_h", c.scaling->h, "reported", scaling::Judgement::caution,
             fmt::format("the case states {} for its own scaled grain; undoing that scaling gives "
                         "{} for the original grain, "
                         "which this prediction starts from",
                         cases::format_si(c.scaling->scaled_work_of_adhesion->value(), "J/m^2"),
                         cases::format_si(in.adhesion->work_of_adhesion.value(), "J/m^2"))});
    return study;
}

}  // namespace app
