// SPDX-License-Identifier: MIT
// The heaps of one apparatus: which are poured first, how soft their grains may be, and the seeds they have.
#pragma once

#include "diagnose/bulk_effects.hpp"
#include "diagnose/diagnose.hpp"
#include "rigs/heap.hpp"
#include "rigs/pile.hpp"

#include <cstdint>
#include <vector>

namespace diagnose {

struct Apparatus {
    cases::Experiment experiment;  // with soft grains
    rigs::PileSetup stated;        // as it stands, to be recognised by
    double softening = 1.0;        // E'/E
    double moved = 0.0;            // by that, of the scatter between heaps
    std::vector<Axis> axes{};
    std::vector<rigs::World> worlds{};  // [heaps]
    std::vector<rigs::Heap> heaps{};
};

// Heaps of one case, by whoever the settings name.
class Pourer {
  public:
    Pourer(const cases::Case& c, const Settings& s) : given_(c), settings_(s) {}

    // `heaps` in the same world, with seeds from `from` on. A recording never has these seeds by chance.
    std::vector<rigs::Heap> pour(const cases::Experiment&, const rigs::World&, std::uint64_t from,
                                 int heaps) const;
    // One in each world, added to the apparatus.
    void pour_into(Apparatus&, const std::vector<rigs::World>&) const;

    // Softened as far as the check allows: by how much the grains move the profile from where those ten times as stiff have it,
    // rms over the rings; the part of overlaps (E^(-2/3), Hertz) that these ten times do not show is added. At most half of the
    // deviation of one heap.
    Apparatus apparatus(const cases::Experiment&) const;
    // Free parameters all over their ranges; of each effect alone fourteen strengths, of each two effects one.
    void pour_first(Apparatus&) const;

    int poured() const { return poured_; }

  private:
    std::vector<rigs::Heap> pour(const std::vector<rigs::PileSetup>&) const;
    double moved_by(const cases::Experiment&, double softening) const;

    const cases::Case& given_;
    const Settings& settings_;
    mutable int poured_ = 0;
};

bool alike(const rigs::PileSetup&, const rigs::PileSetup&);    // one apparatus, one grain
cases::Experiment softened(cases::Experiment, double factor);  // grains and walls

double base_radius(const cases::Experiment&);       // m
double noise_of_heights(const cases::Experiment&);  // m; 0 where not stated

}  // namespace diagnose
