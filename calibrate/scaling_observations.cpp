// SPDX-License-Identifier: MIT
#include "calibrate/observations.hpp"
#include "scaling/adhesion.hpp"
#include "scaling/jkr_estimates.hpp"
#include "scaling/numbers.hpp"
#include "scaling/schemes.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

namespace calibrate {

namespace {

using scaling::EnergyPerArea;
using scaling::Judgement;
using scaling::Length;

// A finding of the scale study in the words of an observation.
void add_findings(std::vector<Observation>& all, const std::vector<scaling::Finding>& findings,
                  const std::string& topic, const std::string& where,
                  const std::vector<std::string>& names) {
    for (const scaling::Finding& f : findings)
        if (std::find(names.begin(), names.end(), f.name) != names.end())
            all.push_back({topic, f.name, f.value, "1", where, f.judgement, f.text});
}

void add_numerics(std::vector<Observation>& all, const Published& p,
                  const scaling::ScaleInput& input, const scaling::ScaleStudy& study) {
    const std::string& where = p.simulation_table;
    add_findings(all, study.findings, "numerics", where,
                 {"stated_time_step_over_computed", "stated_grain_counts_apart",
                  "stated_originals_over_represented", "stated_time_over_feed_and_settling",
                  "packing_to_cover_base_over_measured"});
    all.push_back(
        {"numerics", "rayleigh_time_over_original",
         scaling::Dimensionless(study.scaled_cost.rayleigh_time / study.original_cost.rayleigh_time)
             .value(),
         "1", where, Judgement::fine,
         fmt::format("the Rayleigh time grows from {:.3g} s to {:.4g} s: scaling saves "
                     "steps as well as grains",
                     study.original_cost.rayleigh_time.value(),
                     study.scaled_cost.rayleigh_time.value())});
    if (input.stated.grains.empty()) return;
    const double grains = input.stated.grains.front();
    const Length d = study.h * input.grain.diameter;
    const scaling::Mass mass = grains * scaling::grain_mass(d, input.grain.density);
    const scaling::Volume solid = mass / input.grain.density;
    all.push_back({"numerics", "mass_of_the_simulated_grains", mass.value(), "kg", where,
                   Judgement::fine,
                   fmt::format("{:.3g} grains of {:.3g} um weigh {:.3g} g and are {:.3g} cm^3 of "
                               "solid",
                               grains, 1e6 * d.value(), 1e3 * mass.value(), 1e6 * solid.value())});
    if (!input.stated.wall_time || !input.stated.time_step || !input.stated.simulated_time) return;
    const double steps =
        scaling::Dimensionless(*input.stated.simulated_time / *input.stated.time_step).value();
    const double speed = grains * steps / input.stated.wall_time->value();
    all.push_back(
        {"numerics", "implied_grain_steps_per_second", speed, "1/s", where, Judgement::caution,
         fmt::format("{:.3g} steps of up to {:.3g} grains in the wall time stated are up "
                     "to {:.3g} grain steps per second (half of it, where the heap is fed "
                     "at a steady rate); similitude scale says what your machine does",
                     steps, grains, speed)});
}

// What length h, density 1 and time h give, and what kept gravity gives.
void add_schemes(std::vector<Observation>& all, const scaling::ScaleStudy& study) {
    const scaling::ScaleMap exact =
        scaling::ScaleMap::solve(scaling::named_scheme("exact"), study.h);
    const scaling::ScaleMap kept =
        scaling::ScaleMap::solve(scaling::named_scheme("kept_gravity"), study.h);
    const auto law = [](const scaling::ScaleMap& map, const char* quantity) {
        return scaling::to_string(map.exponents(quantity));
    };
    add_findings(all, study.findings, "similarity", "", {"broken_groups"});
    all.push_back({"similarity", "factor_of_surface_energy_under_exact_scaling",
                   exact.factor("surface_energy"), "1", "", Judgement::caution,
                   fmt::format("with length h, density 1 and time h a surface energy goes as {}",
                               law(exact, "surface_energy"))});
    all.push_back({"similarity", "factor_of_gravity_under_exact_scaling", exact.factor("gravity"),
                   "1", "", Judgement::caution,
                   fmt::format("the same factors ask for gravity {}, which was kept instead. Kept "
                               "gravity and density ask for time {}, modulus {} "
                               "and surface energy {}, so that what was simulated is neither",
                               law(exact, "gravity"), law(kept, "time"),
                               law(kept, "youngs_modulus"), law(kept, "surface_energy"))});
}

void add_apparatus(std::vector<Observation>& all, const Published& p,
                   const scaling::ScaleInput& input, const scaling::ScaleStudy& study) {
    const double base = p.simulated_base / p.experiment.base_diameter;
    all.push_back(
        {"similarity", "simulated_base_over_real", base, "1", "", Judgement::caution,
         fmt::format("the grain is scaled by {:g}, the base by {:.3g} and the funnel by 1: "
                     "a coarse-grained model, not a geometrically similar one",
                     study.h, base)});
    const double before = p.experiment.outlet_diameter / input.grain.diameter.value();
    all.push_back({"similarity", "outlet_over_scaled_grain", before / study.h, "1",
                   p.simulation_table, Judgement::caution,
                   fmt::format("the outlet falls from {:.0f} to {:.0f} grain diameters, so that "
                               "arching in it is not similar. S_n = {:.0f} "
                               "says how hard a problem is to compute, not how faithful",
                               before, before / study.h, study.scaled_scale_number.value)});
}

// rho g L^2 / gamma, with L the radius or the diameter.
void add_bond(std::vector<Observation>& all, const scaling::ScaleInput& input,
              const scaling::ScaleStudy& study) {
    if (!study.adhesion) return;
    const double gamma = study.adhesion->scaled.surface_energy.value();
    const double r = 0.5 * input.grain.diameter.value();
    const double bo = input.grain.density.value() * input.grain.gravity.value() * r * r / gamma;
    all.push_back({"similarity", "weight_over_adhesion_scaled_over_original", study.h * study.h,
                   "1", "", Judgement::caution,
                   fmt::format("with L the radius it is {:.3g} and {:.3g}, with the diameter four "
                               "times that: small where adhesion is strong, the inverse of the "
                               "Bond number of powders",
                               bo, bo * study.h * study.h)});
    const double twice = study.adhesion->scaled.pull_off_in_grain_weights;
    all.push_back(
        {"similarity", "pull_off_in_grain_weights", twice, "1", "", Judgement::caution,
         fmt::format(
             "{:.0f} where {:g} J/m^2 belongs to one surface (w = 2 gamma), {:.0f} "
             "where it is the work of adhesion of the pair; codes differ in what they ask for",
             twice, gamma, 0.5 * twice)});
    add_findings(all, study.adhesion->findings, "similarity", "",
                 {"impact_overlap_over_radius", "impact_over_sticking_speed",
                  "original_surface_energy_over_lowest"});
}

void add_invariants(std::vector<Observation>& all, const Published& p,
                    const scaling::ScaleStudy& study) {
    if (!study.adhesion) return;
    std::vector<scaling::AdhesionPrediction> every = study.other_invariants;
    every.insert(every.begin(), *study.adhesion);
    std::string list;
    double least = every.front().original.surface_energy.value(), most = least;
    for (const scaling::AdhesionPrediction& a : every) {
        const double gamma = a.original.surface_energy.value();
        least = std::min(least, gamma);
        most = std::max(most, gamma);
        list += fmt::format("{}{:.3g} J/m^2 ({})", list.empty() ? "" : ", ", gamma,
                            a.invariant ? scaling::to_string(*a.invariant) : "scheme");
    }
    all.push_back({"similarity", "original_surface_energies_apart", most / least, "1", "",
                   Judgement::caution,
                   fmt::format("what the calibrated value means for the powder hangs on what is to "
                               "be kept: {}",
                               list)});
    const std::string& letter = p.orthogonal.factors[1];
    const double top = p.factor(letter).range_high;
    all.push_back({"similarity", "highest_original_surface_energy_in_range", top / study.h, "J/m^2",
                   "", Judgement::caution,
                   fmt::format("with the stress Bond number kept the range searched, up to {:g} "
                               "J/m^2, stands for at most {:.3g} J/m^2 on a powder grain, with the "
                               "weight Bond number for {:.3g}. Smooth solids have some hundredths "
                               "and more; the calibrated value lumps roughness, shape, sizes and "
                               "softening",
                               top, top / study.h, top / (study.h * study.h))});
}

void add_powder(std::vector<Observation>& all, const cases::Case& c,
                const scaling::ScaleInput& input) {
    // A dense zirconia has about 80 GPa: E of some 205 GPa and nu 0.3. Order of magnitude only.
    constexpr double dense = 80e9;  // Pa
    const double soft =
        scaling::shear_modulus(input.grain.youngs_modulus, input.grain.poisson_ratio).value();
    const double carried = scaling::power_of(
        soft / dense, scaling::modulus_exponent(scaling::Invariant::sticking_velocity));
    all.push_back(
        {"similarity", "adhesion_for_the_softened_modulus", carried, "1", "", Judgement::caution,
         fmt::format("the shear modulus is softened from about {:.0f} GPa to {:.0f} MPa; to "
                     "keep the sticking speed the adhesion would go down to {:.3g} of its "
                     "value, to keep the pull-off force it stays: one of the two is lost",
                     1e-9 * dense, 1e-6 * soft, carried)});
    if (c.stated.bulk_density)
        all.push_back({"similarity", "packing_fraction_measured",
                       scaling::Dimensionless(*c.stated.bulk_density / input.grain.density).value(),
                       "1", "", Judgement::fine,
                       "follows from the bulk density and was not used: a second target that costs "
                       "no further run"});
    const auto& sizes = c.grain.size_distribution;
    if (sizes.size() < 3) return;
    double zz = 0.0, zx = 0.0, d10 = 0.0, d90 = 0.0, d50 = 0.0;
    for (const auto& [fraction, diameter] : sizes) {
        const double z = gsl_cdf_ugaussian_Pinv(fraction);
        zz += z * z;
        zx += z * std::log(diameter.value() / input.grain.diameter.value());
        if (std::abs(fraction - 0.1) < 1e-9) d10 = diameter.value();
        if (std::abs(fraction - 0.5) < 1e-9) d50 = diameter.value();
        if (std::abs(fraction - 0.9) < 1e-9) d90 = diameter.value();
    }
    const double sigma = zx / zz, sauter = d50 * std::exp(-0.5 * sigma * sigma);
    all.push_back({"similarity", "span_of_the_sizes", (d90 - d10) / d50, "1", "",
                   Judgement::caution,
                   fmt::format("one size stands for D10 to D90 of {:.3g} to {:.3g} um (log-normal "
                               "with sigma {:.2f}); the mean by surface is {:.2g} um, half of the "
                               "median that was scaled",
                               1e6 * d10, 1e6 * d90, sigma, 1e6 * sauter)});
}

}  // namespace

std::vector<Observation> scaling_observations(const Published& p, const cases::Case& c,
                                              const scaling::ScaleInput& input,
                                              const scaling::ScaleStudy& study) {
    std::vector<Observation> all;
    add_numerics(all, p, input, study);
    add_schemes(all, study);
    add_apparatus(all, p, input, study);
    add_bond(all, input, study);
    add_invariants(all, p, study);
    add_powder(all, c, input);
    return all;
}

}  // namespace calibrate
