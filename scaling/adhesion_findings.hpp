// SPDX-License-Identifier: MIT
// Whether a predicted adhesion makes a grain that still is one.
//
// Thresholds: JKR and Hertz replace spheres by paraboloids and need a << R. At a/R = 0.1 a sphere's
// depth differs from the paraboloid's by 0.25 %, at 0.3 by 2.3 %; contacts 60 degrees apart, as in
// a dense packing, run into each other at 0.5. An overlap of 1 % of R is the habit of the field; 6
// % is the zero-load overlap, and 5 % the tear-off gap, at a0/R = 0.3.
#pragma once

#include "scaling/adhesion.hpp"

namespace scaling {

// zero_load_contact_radius_over_radius, overlap_over_radius (under own weight),
// tear_off_gap_over_radius, tabor_number (z0 = 0.165 nm), pull_off_in_grain_weights; with a drop
// height impact_overlap_over_radius and impact_over_sticking_speed.
std::vector<Finding> adhesion_findings(const Grain&, EnergyPerArea work_of_adhesion);

// tabor_number_original and original_surface_energy_over_lowest, about the powder itself.
std::vector<Finding> original_findings(const Grain& original, EnergyPerArea work_of_adhesion);

// physically_usable: 1 or 0, and for 0 what to do instead: the largest h that this choice allows,
// the other invariants that stay usable, and the modulus that would carry the prediction. The map
// is the one before adhesion was chosen.
Finding usability_finding(const Grain& original, const ScaleMap&, const AdhesionPrediction&,
                          Of stated);

// a0 / R of two such grains, the number that decides.
double neck_ratio(const Grain&, EnergyPerArea work_of_adhesion);

}  // namespace scaling
