// SPDX-License-Identifier: MIT
// Our core against LAMMPS (package GRANULAR) on the same rules. Three rounds, from what must agree
// to the last digits that are meant to agree, to what can only agree on average:
//   led       two grains on prescribed ways, together and apart: force over separation, pull-off
//   thrown    two grains at one another, at several angles: force, velocity, spin over time
//   heaps     a column that slumps into a heap: angle of repose over seeds
// The conditions are chosen such that the rules coincide; where they do not, the difference is
// measured and listed, never taken up by a tolerance. docs/verify.md says which and how large.
#pragma once

#include "statistics/equivalence.hpp"
#include "verify/check.hpp"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace verify {

// Two codes, one law, two rules. `size` is what it amounts to under the conditions stated.
struct RuleDifference {
    std::string rule, ours, theirs;
    std::string conditions, measure{};  // measure: what `size` is a share of
    double size = 0.0;                  // 1; infinite where LAMMPS' force is not a number
};

// Stated before any heap was run, as in verify/similarity.hpp.
struct HeapMargin {
    double angle_deg = 2.5, alpha = 0.05;
};

struct HeapAngle {
    std::uint64_t seed;
    std::optional<double> ours_deg, lammps_deg;  // nothing where no flank could be read
    std::optional<double> control_deg;           // ours, friction 80 % too low
    double ours_moving, lammps_moving;           // kinetic energy per grain over m g d, at the end
    double ours_on_base, lammps_on_base;         // loose grains
    double ours_seconds, lammps_seconds;         // wall time
};

struct HeapRound {
    std::vector<HeapAngle> heaps;
    HeapMargin margin;
    statistics::Summary ours, lammps, control;
    statistics::Equivalence test;          // ours minus LAMMPS
    statistics::Equivalence control_test;  // must not pass, or the test sees nothing
    std::size_t seeds_for_power;           // a side, for 95 % power at the pooled spread
    double bond_number, elasticity;        // F_po/(m g), E/(rho g d)
};

struct AgainstLammps {
    std::string release;        // "29 Sep 2021 - Update 2"
    std::vector<Check> checks;  // the heaps' among them
    std::vector<RuleDifference> differences;
    std::optional<HeapRound> heaps;
    double seconds = 0.0;
};

struct LammpsCampaign {
    std::filesystem::path folder;  // where decks, data and dumps stay
    int heaps = 10;                // seeds; 0: no heaps
    std::uint64_t first_seed = 1;
    int threads = 1;      // with two, ours and LAMMPS run side by side
    bool resume = false;  // heaps whose files are in the folder are not run again
    const std::atomic<bool>* stop = nullptr;
    std::function<void(double done, double of, const std::string& what)> progress;
};

// Throws scaling::InvalidInput where LAMMPS is not installed, Interrupted (verify/pile_runs.hpp) when
// told to stop.
AgainstLammps against_lammps(const LammpsCampaign&);

// The rounds one by one.
std::vector<Check> led_checks(const std::filesystem::path& lmp,
                              const std::filesystem::path& folder);
std::vector<Check> thrown_checks(const std::filesystem::path& lmp,
                                 const std::filesystem::path& folder);
std::vector<RuleDifference> rule_differences(const std::filesystem::path& lmp,
                                             const std::filesystem::path& folder);
HeapRound heap_round(const std::filesystem::path& lmp, const LammpsCampaign&);
std::vector<Check> heap_checks(const HeapRound&);

}  // namespace verify
