// SPDX-License-Identifier: MIT
// Scaling schemes: which quantities a scaled simulation keeps (or scales by a stated power of h),
// by name or by hand.
//
//   exact                      density, modulus kept; gravity 1/h. Feng & Owen (2014),
//                              doi:10.1007/s40571-014-0010-y
//   kept_gravity               density, gravity kept; modulus h, surface energy h^2
//   kept_gravity_kept_modulus  gravity, modulus kept; density 1/h
//   paper, coarse_grain        density, gravity, modulus and apparatus kept while the grain grows:
//                              distorted. `paper` is what Niu et al. (2026) simulated,
//                              `coarse_grain` the field's name for it.
#pragma once

#include "scaling/rational_system.hpp"

#include <string>
#include <vector>

namespace scaling {

// A quantity and the exponents that its factor must have; zero exponents keep it. Where the modulus
// is softened, Young's and shear modulus carry E'/E in addition, whatever is demanded of them.
struct Demand {
    std::string quantity;
    Exponents exponents;
};

// "gravity" -> kept; "gravity=-1", "velocity=1/2" -> that power of h. Throws InvalidParameter for
// an unknown quantity.
Demand demand_from(const std::string& text);

struct Scheme {
    std::string name;
    std::vector<Demand> demands;  // most important first: a distorted map gives way from the back
    bool distorted = false;       // grain and surroundings may have a ruler and a clock each
};

const std::vector<std::string>& scheme_names();

// Throws InvalidParameter with the nearest known name.
Scheme named_scheme(const std::string& name);

// The scheme as its authors argue it rather than run it: the apparatus grows with the grain.
Scheme with_scaled_apparatus(Scheme scheme);

// What the user keeps, under the name "own".
Scheme own_scheme(const std::vector<std::string>& kept, bool distorted);

}  // namespace scaling
