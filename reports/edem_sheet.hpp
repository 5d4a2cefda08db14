// SPDX-License-Identifier: MIT
// What one types into EDEM for a case, in the order in which its dialogs ask for it (docs/formats.md, EDEM parameter sheet).
#pragma once

#include "reports/workbook.hpp"

#include <string>
#include <utility>
#include <vector>

namespace reports {

struct EdemMaterial {
    std::string name;
    double poisson_ratio, youngs_modulus;  // Pa
    double density;                        // kg/m^3; NaN where nothing depends on it
};

// Of grains with each other, or with the plate; NaN where the case does not say.
struct EdemPair {
    double restitution, static_friction, rolling_friction;  // as EDEM takes them
    double pull_off_force;  // N, of two grains or of a grain at the plate; 0: no adhesion
    double surface_energy;  // J/m^2; NaN where it cannot be told from the force
};

struct EdemInput {
    EdemMaterial grains, plate;
    EdemPair grain_grain, grain_plate;
    double diameter;  // m
    std::vector<std::pair<double, double>>
        sizes;       // share below in per cent by volume, diameter in m; may be empty
    double gravity;  // m/s^2, downward
    std::string contact_model, rolling_model,
        convention;                     // names and what the surface energy means
    std::vector<std::string> left_out;  // physics of the case that has no place here
};

Sheet edem_sheet(const EdemInput&);

}  // namespace reports
