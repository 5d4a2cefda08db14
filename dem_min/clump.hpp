// SPDX-License-Identifier: MIT
// Straight clumps: equal spheres in a row, which may overlap.
#pragma once

#include "dem_min/bodies.hpp"

namespace dem_min {

// `balls` spheres of `radius`, `spacing` apart along z. Its body is the union of the spheres: what they share counts once. The plane half
// way between two neighbours is the border of their parts, and with u the distance from a sphere's centre along the row, rho^2 = R^2 - u^2,
//   V = pi S rho^2 du,   I_3 = rho_m pi/2 S rho^4 du,   I_1 = I_2 = I_3/2 + rho_m pi S rho^2 z^2 du
// are integrals of polynomials, exact for any number of spheres (rho_m density). A spacing above 2 R leaves gaps, which weigh nothing.
// Throws scaling::InvalidParameter.
Clump row_of_spheres(int balls, double radius, double spacing, double density);

// What stands in for a grain of diameter d that is `aspect_ratio` times as long as it is wide: a row of n = 1 + ceil(2 (a - 1)) spheres
// of radius R, 2 R (a - 1)/(n - 1) <= R apart, R such that the row has the volume, hence the mass, of the sphere of diameter d.
// aspect_ratio >= 1; at 1 it is that sphere. Throws scaling::InvalidParameter.
Clump elongated_grain(double d, double aspect_ratio, double density);

// Half of its length, m, from its centre to its tip.
double half_length(const Clump& row);

}  // namespace dem_min
