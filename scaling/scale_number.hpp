// SPDX-License-Identifier: MIT
// Scale number S_n = D / R of a problem, apparatus over grain radius; Feng & Owen (2014),
// doi:10.1007/s40571-014-0010-y. The class says how hard the problem is to compute with all its
// grains, not how faithful a scaled one is.
#pragma once

#include "scaling/quantities.hpp"
#include "scaling/scale_map.hpp"

namespace scaling {

enum class SizeClass { micro, meso, macro };  // S_n < 1e2, between, > 1e3

const char* to_string(SizeClass);

struct ScaleNumber {
    double value;
    SizeClass size_class;
};

// apparatus: the characteristic length D, an outlet for flow, a base for a heap without one. Throws
// InvalidParameter unless both are > 0.
ScaleNumber scale_number(Length apparatus, Length grain_diameter);
ScaleNumber scaled_scale_number(Length apparatus, Length grain_diameter, const ScaleMap&);

}  // namespace scaling
