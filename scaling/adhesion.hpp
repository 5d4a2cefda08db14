// SPDX-License-Identifier: MIT
// The adhesion that a scaled grain needs. A distorted map leaves it open: weight, stress, cohesion
// number and sticking speed ask for different powers of h, so that the caller must say which of
// them is to stay what it was. w is the work of adhesion of a pair, gamma = w / 2 the surface
// energy per surface of like grains.
#pragma once

#include "scaling/finding.hpp"
#include "scaling/pi_groups.hpp"
#include "scaling/quantities.hpp"

#include <optional>
#include <string>
#include <vector>

namespace scaling {

// The group of pi_groups.hpp that stays what it was.
//   weight_bond        F_po / (m g): a grain's own weight against its sticking; free surfaces
//   stress_bond        F_po / (sigma R^2), sigma = rho g D: strength of the bulk against its stress
//   cohesion_number    (w^5 / (E*^2 R^8))^(1/3) / (rho g): work to part over m g R; agitation
//   sticking_velocity  v_stick / v: which collisions stick; deposition
enum class Invariant { weight_bond, stress_bond, cohesion_number, sticking_velocity };

const char* to_string(Invariant);
Invariant invariant_from(
    const std::string& name);  // throws InvalidParameter with the nearest known name
const std::vector<Invariant>& all_invariants();

// The exponents that w must have for the invariant's group to be kept, solved from the definition
// of the group and the factors of all its other quantities. Under an undistorted map every
// invariant gives the map's own.
Exponents adhesion_exponents(const ScaleMap&, Invariant);

// The exponent with which w follows a change of E alone when the invariant's group is kept: 0, 0,
// 2/5, 2/5.
Rational modulus_exponent(Invariant);

// The original grain and what it falls through. E, not its plane-strain value.
struct Grain {
    Length diameter;
    Density density;
    Pressure youngs_modulus;
    double poisson_ratio;  // in (-1, 0.5)
    Acceleration gravity;
    std::optional<Length> drop_height;
};

// Throws InvalidParameter naming the member that is out of range.
void check(const Grain&);

// The same grain after scaling; drop height and gravity follow the surroundings.
Grain scaled(const Grain&, const ScaleMap&);

enum class Of { original, scaled };

// A work of adhesion, and whose it is.
struct StatedAdhesion {
    EnergyPerArea work_of_adhesion;  // > 0
    Of of;
};

// One grain's pull-off from a like one.
struct GrainAdhesion {
    EnergyPerArea work_of_adhesion, surface_energy;  // w, w/2
    Force pull_off_force;                            // 3/2 pi w R*, R* = R/2
    double pull_off_in_grain_weights;
};

struct AdhesionPrediction {
    std::optional<Invariant> invariant;  // none where the map itself settles w
    Exponents exponents;                 // of w
    GrainAdhesion original, scaled;
    std::vector<Finding> findings;  // about the scaled grain unless the name says original
    bool physically_usable;         // no finding is `unusable`
};

// From the original grain's w to the scaled one's, or the way back. With `invariant` empty the
// map's own factor is used. Throws InvalidParameter where w is not > 0, where an open map has no
// invariant, or where an invariant meets a demand.
AdhesionPrediction predict_adhesion(const Grain& original, const ScaleMap&,
                                    std::optional<Invariant>, const StatedAdhesion&);

// The map with surface_energy and work_of_adhesion as the invariant has them; same errors.
ScaleMap with_adhesion(const ScaleMap&, std::optional<Invariant>);

}  // namespace scaling
