// SPDX-License-Identifier: MIT
// The control: what the other files get wrong, right.
#include "scaling/numbers.hpp"
#include "scaling/scale_number.hpp"

using namespace scaling;

Mass mass(Length diameter, Density density) { return grain_mass(diameter, density); }

double adhesion(EnergyPerArea work_of_adhesion, Pressure modulus, Length radius) {
    return elastic_adhesion_number(work_of_adhesion, modulus, radius);
}

double size_number() { return scale_number(6e-3 * si::meters, 1e-6 * si::meters).value; }

Mass heavier(Mass m, Mass more) { return m + more; }
