// SPDX-License-Identifier: MIT
// Does a powder of larger grains compress and fail like the powder it stands for? The cell, the piston and the consolidation
// stress are kept, the grains are h times as large, and the adhesive force follows one rule or another. Thakur, Ooi & Ahmadian
// (2016), Powder Technol. 293, 130, state the rule: stiffness of contacts as d, adhesive force as d^2 (docs/compression.md).
#pragma once

#include "verify/comparison.hpp"
#include "verify/compression_runs.hpp"
#include "verify/similarity.hpp"

#include <string>
#include <vector>

namespace verify {

// The powder at h = 1 and its cell; lengths in grain diameters d. Contacts of E = 3e7 Pa: 3000 times the consolidation stress, so
// that the deepest of them is pressed in by 4 % of d.
struct CompressionPlan {
    double width = 16.0, height = 62.0;        // of the cell as it is filled, to 28 %
    std::vector<double> h = {1.25, 1.5, 2.0};  // rising
    int seeds = 10;                            // a side
    // Without the powder at h = 1, whose samples take most of the time: each rule is compared with its own smallest h.
    bool among_larger = false;
    double speed = 0.05;  // m/s, of the piston
};
CompressionPlan small_plan();  // a cell half as wide, h = 2 alone, 3 seeds: a minute

struct CompressionPowder {
    double d, density;                     // m, kg/m^3
    double youngs_modulus, poisson_ratio;  // Pa, 1
    double work_of_adhesion;               // J/m^2, at h = 1
    double stress;                         // Pa, of consolidation
    double pull_off_over_stress;           // F_po/(stress d^2), 1
};
CompressionPowder compression_powder();

// How the work of adhesion follows h. A pull-off force is 3/2 pi w R* and R* ~ h: w ~ h^p gives a force ~ h^(p + 1). At one E a
// Hertz contact is h times as stiff at the same share of R pressed in, whatever the rule.
struct AdhesionRule {
    const char *name, *what;
    double exponent;  // p
    bool adhesive;
};
const std::vector<AdhesionRule>& adhesion_rules();  // force ~ d^2, ~ d, ~ d^3, and no adhesion

// Half of what a rule that is wrong by one power of h changes at the smallest h: 25 % of the strength, at h = 1.25. That of the
// packing fraction is the one of heaps (comparison.hpp), the strain's the same in its terms: the height goes as 1/(packing
// fraction). Coordination as of heaps.
struct CompressionMargins {
    double strength = 0.125;  // of the reference's mean
    double strain = 0.01, packing_fraction = 0.01, coordination = 0.15;
    double alpha = 0.05;
};

struct CompressionSide {
    double h, work_of_adhesion, d;  // 1, J/m^2, m
    std::vector<CompressionSample> samples;
};

// One cell of the map.
struct CompressionCellResult {
    CompressionSide side;
    std::vector<Quantity>
        quantities;  // strength (adhesive powders alone), strain, packing_fraction, coordination
    Answer
        answer;  // equivalent: all inside their margins; different: some interval wholly outside its margin
    bool claims;  // enough seeds for 95 % power in each
};

struct RuleResult {
    AdhesionRule rule;
    CompressionSide reference;  // h = 1, or the smallest
    std::vector<CompressionCellResult> cells;
    // strength ~ h^p over all samples of the rule, least squares of logarithms, and its 95 % interval; adhesive powders alone.
    double strength_exponent;
    statistics::Interval strength_exponent_interval;
};

struct CompressionStudy {
    CompressionPlan plan;
    CompressionPowder powder;
    CompressionMargins margins;
    std::vector<RuleResult> rules;
    CompressionCellResult
        half_speed;  // the first rule at the largest h, at half of the speed against the whole
    BitsCheck bits;  // the largest grains under `exact`, h = 2, cell and all
    double largest_inertial_number, largest_inertial_number_of_crush;  // of adhesive powders
    double seconds = 0.0;
};

rigs::CompressionSetup compression_setup(const CompressionPlan&, const AdhesionRule&, double h,
                                         std::uint64_t seed);

CompressionStudy compression_study(const CompressionPlan&, std::uint64_t first_seed,
                                   const Campaign&);

}  // namespace verify
