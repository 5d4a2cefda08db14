// SPDX-License-Identifier: MIT
// What the map (scaling_map.hpp) says of a grain that stands for a powder: how far a rule and a soft modulus move the angle of
// repose, and where the map does not reach. Groups only; costs and cases are others' work (docs/advise.md).
#pragma once

#include "verify/scaling_map.hpp"

#include <optional>
#include <string>
#include <vector>

namespace verify {

// Of the powder as it is: base over grain, E/(rho g d), F_po/(m g) (0: no adhesion). All 1.
struct PowderGroups {
    double size_ratio, elasticity, bond;
};

// The rules of coarse-graining, w ~ h^exponent at kept gravity and density.
struct CoarseRule {
    const char* name;
    double exponent;
};
const std::vector<CoarseRule>& coarse_rules();

enum class AngleSays { within, beyond, not_decided };  // of the tolerance
const char* to_string(AngleSays);

struct MapReading {
    AngleSays says = AngleSays::not_decided;
    double low = 0.0, high = 0.0;      // deg: 90 % interval of the change of the angle, the widest
    std::vector<std::string> cells;    // that were read, in words
    std::vector<std::string> outside;  // what the map does not hold, a sentence each
    std::vector<std::string> lost;     // quantities that break in these cells
    std::optional<double> spread;      // deg, of the angle from seed to seed, the largest
};

// Base over grain of the map's finest grain: the reference of its coarse-graining. Nothing where it has no such cell.
std::optional<double> finest_size_ratio(const ScalingMap&);

// Of a grain h times as large under a rule. The powder's Bond number is carried by the rule to the map's reference grain, from
// where the map goes on; cells on both sides of that number are read, and of factors the next larger one.
MapReading read_coarse(const ScalingMap&, const PowderGroups&, const std::string& rule, double h,
                       double tolerance);

// E/(rho g d) of that grain; nothing where it has no such cell.
std::optional<double> modulus_of_map(const ScalingMap&);

// Of a modulus taken down from E/(rho g d) = `from` to `to`, w kept; `bond`: F_po/(m g) of the grain it is for.
MapReading read_softening(const ScalingMap&, double from, double to, double bond, double tolerance);

// One grain that could be simulated instead of the powder's.
struct AdvisedGrain {
    std::string rule;                     // of coarse_rules(); none without adhesion
    double h, softening;                  // diameter, modulus over the powder's
    double size_ratio, elasticity, bond;  // as PowderGroups, of this grain
    double work_of_adhesion;              // J/m^2
    double grains, time_step, seconds;    // 1; s; s of this machine for one heap
    MapReading coarse, soft;              // `soft` has no cells where the modulus is kept
    std::string unusable;                 // why there can be no such grain; empty: there can
    bool affordable;                      // within the budget
    AngleSays says() const;               // of both
    bool outside() const { return !coarse.outside.empty() || !soft.outside.empty(); }
};

// The finest that is affordable, usable and within the tolerance; where there is none but the map leaves some open, the finest of those.
// Of several rules the one whose interval is narrowest about nothing, then the first of coarse_rules().
std::optional<std::size_t> choose(const std::vector<AdvisedGrain>&);

}  // namespace verify
