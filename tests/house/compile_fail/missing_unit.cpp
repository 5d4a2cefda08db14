// SPDX-License-Identifier: MIT
// BROKEN: a naked number is no diameter.
#include "scaling/scale_number.hpp"

using namespace scaling;

double size_number() { return scale_number(6e-3 * si::meters, 1e-6).value; }
