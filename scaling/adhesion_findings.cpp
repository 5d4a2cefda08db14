// SPDX-License-Identifier: MIT
#include "scaling/adhesion_findings.hpp"

#include "scaling/jkr_estimates.hpp"
#include "scaling/numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace scaling {

namespace {

constexpr double neck_fine = 0.1, neck_limit = 0.3;          // a0 / R
constexpr double overlap_fine = 0.01, overlap_limit = 0.06;  // delta / R
constexpr double gap_fine = 0.01, gap_limit = 0.05;          // tear-off gap / R
constexpr double tabor_jkr = 5.0, tabor_dmt = 0.1;
// Surface energy of the least adhesive solid, A / (24 pi z0^2) with Hamaker's A = 3.8e-20 J (PTFE;
// Israelachvili, Intermolecular and Surface Forces).
constexpr double lowest_hamaker = 3.8e-20;  // J

Judgement three_way(double value, double fine, double limit) {
    if (value < fine) return Judgement::fine;
    return value < limit ? Judgement::caution : Judgement::unusable;
}

std::string below(double limit) { return fmt::format("< {:g}", limit); }

JkrPair pair_of(const Grain& grain, EnergyPerArea w) {
    return {w, effective_modulus(grain.youngs_modulus, grain.poisson_ratio), 0.25 * grain.diameter};
}

double over_radius(Length length, const Grain& grain) {
    return Dimensionless(2.0 * length / grain.diameter).value();
}

Finding tabor_finding(const char* name, const Grain& grain, EnergyPerArea w, const char* whose) {
    const JkrPair pair = pair_of(grain, w);
    const double tabor = tabor_number(w, pair.e_star, pair.r_star, equilibrium_separation);
    const bool jkr = tabor >= tabor_jkr;
    const char* law = jkr                 ? "JKR is the law"
                      : tabor > tabor_dmt ? "between JKR and DMT"
                                          : "DMT is the law";
    return {name, tabor, fmt::format(">= {:g}", tabor_jkr),
            jkr ? Judgement::fine : Judgement::caution,
            fmt::format("{} for {} with z0 = 0.165 nm{}", law, whose,
                        jkr ? ""
                            : ": numbers from JKR's energy or neck are doubtful, its pull-off is "
                              "3/4 of DMT's")};
}

std::vector<Finding> impact_findings(const Grain& grain, const JkrPair& pair) {
    const Velocity speed =
        in_si<Velocity>(std::sqrt(2.0 * grain.gravity.value() * grain.drop_height->value()));
    const Mass m_star = 0.5 * grain_mass(grain.diameter, grain.density);
    const double overlap =
        over_radius(hertz_impact_overlap(m_star, speed, pair.e_star, pair.r_star), grain);
    const double ratio = Dimensionless(speed / pair.sticking_speed(m_star)).value();
    return {
        {"impact_overlap_over_radius", overlap, below(overlap_fine),
         overlap < overlap_fine ? Judgement::fine : Judgement::caution,
         fmt::format("two grains meeting at {:.3g} m/s, the speed after the drop; a stiffer grain "
                     "or a lower drop "
                     "makes it less",
                     speed.value())},
        {"impact_over_sticking_speed", ratio, below(1.0),
         ratio < 1.0 ? Judgement::fine : Judgement::caution,
         ratio < 1.0
             ? "grains stick where they land"
             : "deposition is collisional: restitution and drop height matter, not only statics"}};
}

// What makes the neck small enough, a0 / R ~ (w / (E R))^(1/3): another h, another modulus; none
// where the map leaves neither.
std::vector<std::string> smaller_or_stiffer(const ScaleMap& map, const AdhesionPrediction& p,
                                            double neck, Of stated) {
    const auto times = [&](const Rational& exponent) {
        return std::pow(neck_limit / neck, 3.0 / boost::rational_cast<double>(exponent));
    };
    std::vector<std::string> remedies;
    const Rational in_h =
        (p.exponents - map.exponents("youngs_modulus") - map.exponents("length")).h;
    if (stated == Of::original && in_h.numerator() > 0) {
        const double h = map.h() * times(in_h);
        if (h > 1.0) remedies.push_back(fmt::format("use h <= {:.2g}", h));
    }
    if (p.invariant && map.adhesion_is_open()) {
        const Rational w_in_e =
            stated == Of::original ? modulus_exponent(*p.invariant) : Rational(0);
        remedies.push_back(
            fmt::format("use a modulus {:.2g} times stiffer", times(w_in_e - Rational(1))));
    }
    return remedies;
}

std::vector<std::string> other_invariants(const Grain& original, const ScaleMap& map,
                                          const AdhesionPrediction& p) {
    std::vector<std::string> usable;
    for (const Invariant invariant : all_invariants()) {
        if (!map.adhesion_is_open() || invariant == p.invariant) continue;
        const EnergyPerArea w =
            map.value(adhesion_exponents(map, invariant)) * p.original.work_of_adhesion;
        const double neck = neck_ratio(scaled(original, map), w);
        if (neck >= neck_limit) continue;
        usable.push_back(fmt::format("keep {} instead ({:.3g} J/m^2 per surface, a0/R {:.2g})",
                                     to_string(invariant), 0.5 * w.value(), neck));
    }
    return usable;
}

}  // namespace

double neck_ratio(const Grain& grain, EnergyPerArea w) {
    return over_radius(pair_of(grain, w).zero_load_contact_radius(), grain);
}

std::vector<Finding> adhesion_findings(const Grain& grain, EnergyPerArea w) {
    const JkrPair pair = pair_of(grain, w);
    const Mass mass = grain_mass(grain.diameter, grain.density);
    const double neck = neck_ratio(grain, w);
    const double overlap = over_radius(pair.overlap_under(mass * grain.gravity), grain);
    const double gap = over_radius(pair.tear_off_gap(), grain);
    const double weights = weight_bond_number(pair.pull_off_force(), mass, grain.gravity);
    std::vector<Finding> findings = {
        {"zero_load_contact_radius_over_radius", neck, below(neck_fine),
         three_way(neck, neck_fine, neck_limit),
         "JKR neck of two grains without load, a0^3 = 9 pi w R*^2 / (2 E*); the law takes a << R "
         "for granted"},
        {"overlap_over_radius", overlap, below(overlap_fine),
         three_way(overlap, overlap_fine, overlap_limit),
         "JKR overlap of two grains under the weight of one"},
        {"tear_off_gap_over_radius", gap, below(gap_fine), three_way(gap, gap_fine, gap_limit),
         "how far a contact stretches before it tears; neighbour lists must reach that far"},
        tabor_finding("tabor_number", grain, w, "the scaled grain"),
        {"pull_off_in_grain_weights", weights, "reported", Judgement::fine,
         weights > 1.0 ? "a grain hangs from another against its own weight"
                       : "a grain's weight tears it off: adhesion hardly matters"}};
    if (grain.drop_height) {
        for (Finding& f : impact_findings(grain, pair)) findings.push_back(std::move(f));
    }
    return findings;
}

std::vector<Finding> original_findings(const Grain& original, EnergyPerArea w) {
    const double z0 = equilibrium_separation.value();
    const double lowest = lowest_hamaker / (24.0 * std::numbers::pi * z0 * z0);
    const double ratio = 0.5 * w.value() / lowest;
    return {tabor_finding("tabor_number_original", original, w, "the original grain"),
            {"original_surface_energy_over_lowest", ratio, ">= 1",
             ratio < 1.0 ? Judgement::caution : Judgement::fine,
             fmt::format("{:.3g} J/m^2 per original surface; a smooth solid has {:.2g} or more{}",
                         0.5 * w.value(), lowest,
                         ratio < 1.0
                             ? ", so this number stands for roughness, shape or another invariant"
                             : "")}};
}

Finding usability_finding(const Grain& original, const ScaleMap& map, const AdhesionPrediction& p,
                          Of stated) {
    if (p.physically_usable) {
        return {"physically_usable", 1.0, "= 1", Judgement::fine,
                "the scaled grain's contacts stay small"};
    }
    const double neck = neck_ratio(scaled(original, map), p.scaled.work_of_adhesion);
    if (neck < neck_limit) {
        return {"physically_usable", 0.0, "= 1", Judgement::unusable,
                "the grain sinks too far into another under its own weight: use a stiffer modulus"};
    }
    const double original_neck = neck_ratio(original, p.original.work_of_adhesion);
    std::vector<std::string> remedies = smaller_or_stiffer(map, p, neck, stated);
    if (stated == Of::original) {
        for (std::string& other : other_invariants(original, map, p))
            remedies.push_back(std::move(other));
    }
    if (original_neck >= neck_limit) {
        remedies.push_back(fmt::format(
            "check modulus and work of adhesion, for the original has a0/R {:.2g} itself",
            original_neck));
    }
    return {"physically_usable", 0.0, "= 1", Judgement::unusable,
            fmt::format("{:.3g} J/m^2 per surface gives a0/R {:.2g} on the scaled grain: {}",
                        p.scaled.surface_energy.value(), neck, fmt::join(remedies, ", or "))};
}

}  // namespace scaling
