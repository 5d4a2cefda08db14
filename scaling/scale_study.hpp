// SPDX-License-Identifier: MIT
// Everything that the verb `scale` says, from plain typed inputs to one result. Nothing here prints
// or knows a file.
#pragma once

#include "scaling/adhesion.hpp"
#include "scaling/cost.hpp"
#include "scaling/pi_groups.hpp"
#include "scaling/scale_number.hpp"
#include "scaling/stated.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scaling {

struct Fluid {
    Density density;
    Viscosity viscosity;
};

struct Liquid {
    EnergyPerArea surface_tension;
    Volume volume;  // of one bridge
};

// The original problem and how it is to be scaled.
struct ScaleInput {
    Grain grain;
    Length apparatus_length;  // D of the scale number: outlet of funnel or silo, else the base
    std::optional<Length> base_diameter;
    std::optional<StatedAdhesion> adhesion;
    std::optional<Fluid> fluid;
    std::optional<Liquid> liquid;
    // Restitution, frictions, ...: without dimension, >= 0, kept by every map.
    std::vector<std::pair<std::string, double>> coefficients;

    Scheme scheme;
    double h;
    double softening = 1.0;  // E'/E
    std::optional<Invariant> invariant;

    // Grains of the original; without, a heap of the next two on base_diameter, if that is given:
    // an estimate of cost and of no physics, loose and steep as cohesive powders are.
    std::optional<double> grains;
    double heap_angle = 0.7853981633974483;  // rad (45 degrees)
    double packing_fraction = 0.4;
    std::optional<Time> duration;  // simulated, of the original
    double rayleigh_fraction = 0.2;
    std::optional<double> grain_steps_per_second;
    StatedCounts stated;
};

struct FactorRow {
    std::string quantity;
    Exponents exponents;
    double factor;
    bool imposed;  // demanded against the rest of the map, or set by the invariant
};

struct ScaleStudy {
    Scheme scheme;
    double h, softening;
    bool distorted;        // grain and surroundings are scaled differently: groups break
    bool exact_in_binary;  // all factors are powers of two: same bits after rescaling are possible
    // apparatus_length and contact_time stand among them only in a distorted map.
    std::vector<FactorRow> factors;
    std::vector<GroupChange> groups;
    std::optional<AdhesionPrediction> adhesion;  // none without a stated work of adhesion
    // The same stated adhesion under each of the other invariants, where the map leaves it open.
    std::vector<AdhesionPrediction> other_invariants;
    ScaleNumber original_scale_number, scaled_scale_number;
    double originals_per_grain;
    Cost original_cost, scaled_cost;
    std::vector<Finding> findings;  // of the scheme and of the stated counts; adhesion has its own
};

// Throws InvalidParameter for a value out of range, a scheme that cannot be solved, or an invariant
// that is missing.
ScaleStudy study(const ScaleInput&);

// The variables whose groups a study compares, most preferred first; w is the original grain's.
std::vector<Variable> study_variables(const ScaleInput&,
                                      std::optional<EnergyPerArea> work_of_adhesion);

}  // namespace scaling
