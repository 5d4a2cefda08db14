// SPDX-License-Identifier: MIT
// BROKEN: a cohesion energy density, J/m^3, is no work of adhesion, J/m^2.
#include "scaling/numbers.hpp"

using namespace scaling;

double adhesion(Pressure energy_density, Pressure modulus, Length radius) {
    return elastic_adhesion_number(energy_density, modulus, radius);
}
