// SPDX-License-Identifier: MIT
// Heaps of one kind against heaps of another, over seeds: angle, packing and coordination by two one-sided tests each
// (docs/equivalence.md).
#pragma once

#include "rigs/pile.hpp"
#include "statistics/equivalence.hpp"
#include "verify/pile_runs.hpp"

#include <functional>
#include <string>
#include <vector>

namespace verify {

// Margins, stated before any pile was run: half of the 5 deg by which readings of one heap differ in the paper (50, 55, 56 deg);
// 3 % of the packing fraction and 5 % of the contacts of a loose sticky heap.
struct Margins {
    double angle_deg = 2.5, packing_fraction = 0.01, coordination = 0.15;
    double alpha = 0.05;
};

struct Side {
    std::string label;               // "reference, d = 1.2 um"
    double diameter;                 // m
    double gravity, youngs_modulus;  // m/s^2, Pa
    double work_of_adhesion;         // J/m^2
    double bond_number;              // F_po/(m g)
    double elasticity;               // E/(rho g d)
    std::vector<PileSample> samples;
};

struct Quantity {
    std::string name, unit;
    statistics::Summary reference, scaled;
    statistics::Equivalence test;
    std::size_t
        seeds_for_power;  // a side, for 95 % power at the pooled spread; 0: no number of seeds is enough
};

enum class Answer { equivalent, different, not_decided };

struct Comparison {
    std::string name;          // "kept_gravity, h = 200"
    std::string what_differs;  // in words
    Side reference, scaled;
    std::vector<Quantity> quantities;  // angle_of_repose, packing_fraction, coordination
    // equivalent: all three inside their margins; different: some interval wholly outside its margin.
    Answer answer;
    bool
        must_differ;  // a control, made wrong on purpose: passing as equivalent would show that the test sees nothing
    bool
        claims;  // enough seeds for 95 % power: otherwise intervals are shown and nothing is claimed
};

// What stands on a side beside its samples. Poisson's ratio as E* does not show it.
Side side_of(const std::string& label, const PileJob&, double poisson_ratio);

double youngs_modulus(const rigs::PileSetup&,
                      double poisson_ratio);  // Pa, of like grains with that E*

Comparison compare(const std::string& name, const std::string& what_differs, Side reference,
                   Side scaled, const Margins&);

// One job a seed, `first` and on.
std::vector<PileJob> jobs(int seeds, std::uint64_t first,
                          const std::function<PileJob(std::uint64_t)>& make);

// Groups of jobs that differ in the seed alone, run together so that no thread waits for the end of a group.
class Plan {
  public:
    std::size_t add(std::vector<PileJob> jobs);
    void run(const Campaign& campaign) { samples_ = run_piles(all_, campaign); }
    const PileJob& job(std::size_t group) const { return all_[groups_[group].first]; }
    std::vector<PileSample> samples(std::size_t group) const;

  private:
    struct Group {
        std::size_t first, count;
    };
    std::vector<Group> groups_;
    std::vector<PileJob> all_;
    std::vector<PileSample> samples_;
};

const char* to_string(Answer);

}  // namespace verify
