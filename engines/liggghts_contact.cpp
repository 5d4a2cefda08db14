// SPDX-License-Identifier: MIT
#include "engines/liggghts_contact.hpp"

#include "engines/conventions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace engines {
namespace {

constexpr double softest = 5e6,
                 hardest = 1e9;  // Pa, between which LIGGGHTS takes a modulus unasked
constexpr double least_restitution = 0.05;

// A symmetric matrix over grains, glued grains and walls: `grains` among the first two, `walls` with the third.
std::string of_pairs(const std::string& property, double grains, double walls) {
    std::string line = fmt::format("fix {0} all property/global {0} peratomtypepair 3", property);
    for (int a = 1; a <= 3; ++a)
        for (int b = 1; b <= 3; ++b)
            line += fmt::format(" {:.17g}", a == 3 || b == 3 ? walls : grains);
    return line;
}

}  // namespace

// 1/E* = 2 (1 - nu^2)/E and 1/G* = 4 (2 - nu)(1 + nu)/E, so that G*/E* = (1 - nu)/(2 (2 - nu)).
Elastic material_of_pair(double e_star, double g_star) {
    const double ratio = g_star / e_star;
    const double nu = (1.0 - 4.0 * ratio) / (1.0 - 2.0 * ratio);
    return {2.0 * e_star * (1.0 - nu * nu), nu};
}

// The other's shares q = (1 - nu^2)/E and p = 2 (2 - nu)(1 + nu)/E are what is left of 1/E* and 1/G*; p/q = 2 (2 - nu)/(1 - nu).
Elastic material_against(const Elastic& grain, double e_star, double g_star) {
    const double nu_1 = grain.poisson_ratio, e_1 = grain.youngs_modulus;
    const double q = 1.0 / e_star - (1.0 - nu_1 * nu_1) / e_1;
    const double p = 1.0 / g_star - 2.0 * (2.0 - nu_1) * (1.0 + nu_1) / e_1;
    const double nu = (p / q - 4.0) / (p / q - 2.0);
    return {(1.0 - nu * nu) / q, nu};
}

double sjkr_density(double work_of_adhesion, double r_star, double e_star) {
    const auto& table = adhesion_conventions();
    const auto sjkr = std::find_if(table.begin(), table.end(), [](const AdhesionConvention& c) {
        return c.name == "liggghts_sjkr";
    });
    const Pair pair{r_star, e_star, 0.0, 0.0, false};
    return sjkr->value(1.5 * std::numbers::pi * work_of_adhesion * r_star, pair);
}

LiggghtsRules liggghts_rules(const rigs::ContactParameters& grains,
                             const rigs::ContactParameters& walls, double d) {
    const Elastic grain = material_of_pair(grains.e_star, grains.g_star);
    const Elastic wall = material_against(grain, walls.e_star, walls.g_star);
    LiggghtsRules r;
    r.properties = {
        fmt::format("fix youngsModulus all property/global youngsModulus peratomtype {0:.17g} "
                    "{0:.17g} {1:.17g}",
                    grain.youngs_modulus, wall.youngs_modulus),
        fmt::format("fix poissonsRatio all property/global poissonsRatio peratomtype {0:.17g} "
                    "{0:.17g} {1:.17g}",
                    grain.poisson_ratio, wall.poisson_ratio),
        of_pairs("coefficientRestitution", grains.restitution, walls.restitution),
        of_pairs("coefficientFriction", grains.sliding_friction, walls.sliding_friction)};
    r.model = "model hertz tangential history";
    if (grains.work_of_adhesion > 0.0 || walls.work_of_adhesion > 0.0) {
        r.properties.push_back(of_pairs(
            "cohesionEnergyDensity", sjkr_density(grains.work_of_adhesion, 0.25 * d, grains.e_star),
            sjkr_density(walls.work_of_adhesion, 0.5 * d, walls.e_star)));
        r.model += " cohesion sjkr";
    }
    if (grains.rolling_friction > 0.0 || walls.rolling_friction > 0.0) {
        r.properties.push_back(of_pairs("coefficientRollingFriction", grains.rolling_friction,
                                        walls.rolling_friction));
        r.properties.push_back(of_pairs("coefficientRollingViscousDamping", 1.0, 1.0));
        r.model += " rolling_friction epsd";
    }
    if (std::min(grain.youngs_modulus, wall.youngs_modulus) < softest)
        r.moduli += "soft_particles yes\n";
    if (std::max(grain.youngs_modulus, wall.youngs_modulus) > hardest)
        r.moduli += "hard_particles yes\n";
    return r;
}

void refuse_liggghts_restitution(double restitution, const DeckOptions& o) {
    if (restitution <= least_restitution)
        refuse(o, "liggghts", "takes no restitution of 0.05 or less",
               "take a higher restitution, or leave the option out");
}

}  // namespace engines
