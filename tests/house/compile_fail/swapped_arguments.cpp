// SPDX-License-Identifier: MIT
// BROKEN: grain_mass takes the diameter first, then the density.
#include "scaling/numbers.hpp"

using namespace scaling;

Mass mass(Length diameter, Density density) { return grain_mass(density, diameter); }
