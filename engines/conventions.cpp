// SPDX-License-Identifier: MIT
#include "engines/conventions.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace engines {
namespace {

constexpr double pi = std::numbers::pi;

// 4/3 E* sqrt(R*) d^1.5 - k A with A = area d is deepest at d = (k area)^2/(4 E*^2 R*), by (k area)^3/(12 E*^2 R*).
double deepest(double k_area, const Pair& p) {
    return k_area * k_area * k_area / (12.0 * p.e_star * p.e_star * p.r_star);
}
double density_for(double pull_off, double area, const Pair& p) {
    return std::cbrt(12.0 * p.e_star * p.e_star * p.r_star * pull_off) / area;
}

double area_per_overlap(const AdhesionConvention& c, const Pair& p) {
    return (p.wall ? c.at_wall : 1.0) * c.factor * pi * p.r_star;
}

double as_it_is(double e) { return e; }
// Share of the critical damping, -ln e/sqrt(pi^2 + ln^2 e): Tsuji, Tanaka & Ishida (1992), Antypov & Elliott (2011).
double share_of_critical(double e) {
    const double l = std::log(e);
    return -l / std::sqrt(pi * pi + l * l);
}
double of_hertz(double e) { return std::sqrt(5.0) * share_of_critical(e); }
// The polynomial of LAMMPS' `damping tsuji`, with the sqrt(2) that later releases put there.
double polynomial(double e) {
    return 1.2728 +
           e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

}  // namespace

double AdhesionConvention::pull_off(double value, const Pair& p) const {
    if (pull == Pull::per_area) return deepest(value * area_per_overlap(*this, p), p);
    return factor * pi * p.r_star * value;
}

double AdhesionConvention::value(double force, const Pair& p) const {
    if (pull == Pull::per_area) return density_for(force, area_per_overlap(*this, p), p);
    return force / (factor * pi * p.r_star);
}

double AdhesionConvention::pull_off_of_work(double w, const Pair& p) const {
    if (pull == Pull::per_area) return std::numeric_limits<double>::quiet_NaN();
    return (pull == Pull::jkr ? 1.5 : 2.0) * pi * w * p.r_star;
}

double AdhesionConvention::work_of_adhesion(double force, const Pair& p) const {
    return force / pull_off_of_work(1.0, p);
}

const std::vector<AdhesionConvention>& adhesion_conventions() {
    static const std::vector<AdhesionConvention> table{
        {"work_of_adhesion", "JKR as in similitude's cases", "w", "J/m^2", Pull::jkr, 1.5, "",
         "Johnson, Kendall & Roberts (1971): 3/2 pi w R*"},
        {"surface_energy", "JKR told by the energy of one surface", "gamma", "J/m^2", Pull::jkr,
         3.0, "", "w = 2 gamma of like solids"},
        {"lammps_jkr", "LAMMPS, pair_style granular, jkr", "gamma", "J/m^2", Pull::jkr, 3.0,
         "ends at the deepest tension, not at the fold: half of the work of a tear-off",
         "gran_sub_mod_normal: 3 pi gamma R*; measured (tests/engines)"},
        {"lammps_dmt", "LAMMPS, pair_style granular, dmt", "gamma", "J/m^2", Pull::dmt, 4.0,
         "a constant pull that ends at touch", "gran_sub_mod_normal: 4 pi gamma R*; measured"},
        {"liggghts_sjkr", "LIGGGHTS, cohesion sjkr", "cohesionEnergyDensity", "J/m^3",
         Pull::per_area, 2.0,
         "no JKR: no pull at touch and none across a gap; the value holds for this grain, modulus "
         "and partner alone",
         "its manual: k times the circle where the spheres cut, 2 pi R* per overlap at small "
         "overlaps"},
        {"liggghts_sjkr2", "LIGGGHTS, cohesion sjkr2", "cohesionEnergyDensity", "J/m^3",
         Pull::per_area, 4.0,
         "no JKR: no pull at touch and none across a gap; the value holds for this grain, modulus "
         "and partner alone",
         "its manual: A = 2 pi overlap 2 R*; at a wall 2 pi overlap R", 0.5},
        {"yade_dmt", "Yade, MindlinPhys with includeAdhesion", "gamma", "J/m^2", Pull::dmt, 4.0,
         "a constant pull that ends at touch", "HertzMindlin.cpp: 4 pi gamma R*; measured"},
        {"mercurydpm_jkr", "MercuryDPM, JKRAdhesive", "surfaceEnergy", "J/m^2", Pull::jkr, 1.5,
         "no JKR: 3/2 pi w R* at touch, falling in a straight line over a gap that the user sets",
         "JKRAdhesiveInteraction.cc"},
        {"musen_jkr", "MUSEN, JKR", "surface energy", "J/m^2", Pull::jkr, 1.5,
         "contact radius of Hertz: deepest inside the contact, no pull at touch; sqrt(gamma1 "
         "gamma2) is taken for w, "
         "without the 2 of like solids",
         "source: sqrt(8 pi E* gamma a^3)"},
        {"kratos_jkr", "Kratos, DEM_D_JKR_Cohesion", "PARTICLE_COHESION", "J/m^2", Pull::jkr, 1.5,
         "contact radius of Hertz: deepest inside the contact, no pull at touch",
         "DEM_D_JKR_Cohesion"},
        {"kratos_dmt", "Kratos, DEM_D_DMT_Cohesion", "PARTICLE_COHESION", "J/m^2", Pull::dmt, 2.0,
         "a constant pull that ends at touch", "DEM_D_DMT_Cohesion: 2 pi c R*"},
        {"lethe_jkr", "Lethe, JKR", "surface energy", "J/m^2", Pull::jkr, 3.0,
         "ends at touch: 8/9 of the pull-off force is the most that acts",
         "particle_particle_contact_force.h: w = 2 sqrt(gamma1 gamma2)"},
        {"lethe_dmt", "Lethe, DMT", "surface energy", "J/m^2", Pull::dmt, 4.0,
         "with van der Waals' tail outside the contact", "particle_particle_contact_force.h"},
        {"exadem_dmt", "exaDEM, DMT", "gamma", "J/m^2", Pull::dmt, 2.0,
         "over Hooke's springs, not Hertz'", "source: 2 pi gamma R*"},
        {"cabanapd_jkr", "CabanaPD, HertzianJKR", "gamma", "J/m^2", Pull::jkr, 3.0,
         "in or out is told by the sign of the speed, not by history", "Gamma = 2 gamma, PR 204"},
        {"edem_v1_equations", "EDEM, JKR, by its equations of force and overlap", "surface energy",
         "J/m^2", Pull::jkr, 3.0,
         "the same curve both ways: it pulls before touch, and costs no work",
         "help.altair.com: 4 sqrt(pi gamma E*) a^1.5, whose deepest tension is 3 pi gamma R*"},
        {"edem_v1_text", "EDEM, JKR, by the pull-out force that its page states", "surface energy",
         "J/m^2", Pull::jkr, 1.5,
         "the page contradicts its own equations by a factor 2: measure one pull-off before "
         "relying on either",
         "help.altair.com: F_pullout = 3/2 pi gamma R*"},
    };
    return table;
}

const std::vector<Unpublished>& unpublished_adhesion() {
    static const std::vector<Unpublished> table{
        {"edem_v2", "EDEM, JKR Version 2",
         "its page names a pull-off force f_c and surface energies of both materials and their "
         "interface, but not the formula "
         "between them; set them so that a pull-off test gives the force above (of like materials "
         "without an interface energy "
         "3/2 pi 2 gamma R* would be JKR's)"},
        {"pfc_jkr", "PFC, jkr",
         "surf_adh is defined in no page that we could read; set it so that the read-only property "
         "pull_off_f is the force above"},
        {"rocky", "Rocky, adhesive force models",
         "constant, linear and Leeds forces, no JKR: give the constant force model the force "
         "above"},
    };
    return table;
}

double RollingConvention::lever(const Pair& p) const {
    return r_star * p.r_star + radius * p.radius;
}

const std::vector<RollingConvention>& rolling_conventions() {
    static const std::vector<RollingConvention> table{
        {"similitude", "similitude, rolling_sds", "rolling_friction", 1.0, 0.0,
         "a spring and slider; with adhesion the force is N + 2 F_po", "docs/laws/rolling_sds.md"},
        {"lammps_sds", "LAMMPS, rolling sds", "mu_roll", 1.0, 0.0,
         "a spring and slider; with jkr or dmt the force is N + 2 F_po",
         "Luding (2008); gran_sub_mod_rolling"},
        {"edem_standard", "EDEM, Standard Rolling Friction", "coefficient of rolling friction", 0.0,
         1.0,
         "against each grain's own spin, not the relative one: it also brakes grains that turn "
         "together",
         "help.altair.com"},
        {"edem_rvd", "EDEM, Relative Velocity Dependent", "coefficient of rolling friction", 1.0,
         0.0, "against the relative spin, without a spring", "Ai et al. (2011), type A"},
        {"liggghts_cdt", "LIGGGHTS, rolling_friction cdt", "coeffRollFrict", 1.0, 0.0,
         "of the elastic force of the overlap alone, without a spring", "its source"},
        {"liggghts_epsd", "LIGGGHTS, rolling_friction epsd, epsd2", "coeffRollFrict", 1.0, 0.0,
         "a spring whose stiffness follows from the contact's", "Ai et al. (2011), type C"},
        {"lethe", "Lethe, constant or EPSD", "rolling friction", 1.0, 0.0, "", "its source"},
        {"musen", "MUSEN", "rolling friction", 0.0, 1.0, "against each grain's own spin",
         "its source"},
        {"mercurydpm", "MercuryDPM", "rolling friction coefficient", 2.0, 0.0,
         "its lever is 2 R*, the radius of equal grains", "its source"},
    };
    return table;
}

const std::vector<DampingConvention>& damping_conventions() {
    static const std::vector<DampingConvention> table{
        {"similitude", "similitude, Tsuji's dashpot", "restitution", as_it_is,
         "e of a contact that ends at overlap 0", "docs/laws/damping_tsuji1992.md"},
        {"edem", "EDEM, Hertz-Mindlin (no slip)", "coefficient of restitution", as_it_is, "",
         "help.altair.com"},
        {"liggghts", "LIGGGHTS, hertz", "coefficientRestitution", as_it_is, "",
         "betaeff = ln e/sqrt(ln^2 e + pi^2)"},
        {"lammps_restitution", "LAMMPS, damping coeff_restitution", "e", as_it_is,
         "releases from 2024 on; refuses jkr and dmt",
         "its manual (untested: later than Debian's)"},
        {"lammps_tsuji", "LAMMPS, damping tsuji", "e", as_it_is,
         "approaches e by a polynomial; refuses jkr and dmt in later releases", "its manual"},
        {"lammps_tsuji_alpha", "the factor of that polynomial", "alpha", polynomial,
         "later releases multiply it by sqrt(2)", "its manual"},
        {"yade", "Yade, Ip2_FrictMat_FrictMat_MindlinPhys", "en", as_it_is, "", "its source"},
        {"yade_betan", "Yade, the same, told by the share of critical damping", "betan",
         share_of_critical, "", "its source"},
        {"mercurydpm", "MercuryDPM", "alpha", of_hertz,
         "c = alpha sqrt(m* k), k the secant 4/3 E* sqrt(R* overlap)", "its source"},
        {"musen", "MUSEN, Hertz-Mindlin", "restitution coefficient", as_it_is, "", "its source"},
    };
    return table;
}

}  // namespace engines
