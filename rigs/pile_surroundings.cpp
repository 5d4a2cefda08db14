// SPDX-License-Identifier: MIT
// What acts on a pile from afar, from the model of a case: a fluid, a base that is tilted or shakes.
#include "rigs/forward.hpp"
#include "rigs/pile.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigs {
namespace {

using scaling::InvalidInput;
using scaling::mistake;

double free_fall_speed(const PileSetup& s) {
    const PileConditions& c = s.conditions;
    return std::sqrt(2.0 * s.gravity * (c.funnel ? c.funnel->outlet_height : c.drop_height));
}

// The reader has seen to it that the fluid is there.
void take_fluid(PileSetup& s, const cases::Model& model, const cases::Experiment& e) {
    const scaling::Density density = e.surroundings.fluid_density;
    if (model.includes("air_drag")) {
        double factor = 1.0;
        if (const cases::Parameter* told = model.find("drag_coefficient"))
            factor = told->value / drag_curve(e, free_fall_speed(s));
        s.fluid.drag =
            contact::DragSchiller1935::from(factor, density, e.surroundings.fluid_viscosity);
    }
    if (!model.includes("buoyancy")) return;
    double lightest = s.density;
    for (const double of_material : s.materials.density) lightest = std::min(lightest, of_material);
    if (density.value() >= lightest)
        throw InvalidInput(mistake("experiment " + e.id + ": surroundings.fluid_density",
                                   fmt::format("{:g} kg/m^3", density.value()),
                                   fmt::format("must be below the grains' {:g} kg/m^3", lightest),
                                   "grains that float make no heap"));
    s.fluid.lifting_density = density.value();
}

}  // namespace

void choose_surroundings(PileSetup& s, const cases::Case& c, const cases::Experiment& e) {
    const cases::Model& model = c.model;
    take_fluid(s, model, e);
    if (model.includes("tilt")) {
        s.stand.tilt_angle = model.value_or("tilt_angle", 0.0);
        s.stand.tilt_azimuth = model.value_or("tilt_azimuth", 0.0);
    }
    if (!model.includes("vibration")) return;
    if (s.conditions.funnel)
        throw InvalidInput(mistake(
            c.path + ": model.physics", "\"vibration\"",
            "must not stand with a funnel, which would have to stay where it is",
            "feed from a disc, or give the funnel as a mesh: it then shakes with the base"));
    s.stand.shaking = {model.value_or("amplitude", 0.0),
                       2.0 * std::numbers::pi * model.value_or("frequency", 0.0),
                       model.value_or("phase", 0.0)};
}

double shaking_strength(const PileSetup& s) {
    const dem_min::Shaking& base = s.stand.shaking;
    return base.amplitude * base.omega * base.omega / s.gravity;
}

}  // namespace rigs
