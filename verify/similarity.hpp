// SPDX-License-Identifier: MIT
// Does the scaled pile match the reference pile? Two questions, two kinds of answer:
//   bits          under a similarity transformation by powers of two the scaled run is the reference run to the last bit
//   equivalence   at h = 200 rounding differs and a pile is chaotic: then samples over seeds are compared, by two one-sided tests
// docs/verify.md says what was measured and with which command.
#pragma once

#include "cases/case.hpp"
#include "rigs/pile.hpp"
#include "scaling/adhesion.hpp"
#include "verify/comparison.hpp"

#include <string>
#include <vector>

namespace verify {

// The reference: a small heap of grains of real size on glued grains, fed as rain a little wider than the base, so
// that it spills. Lengths in grain
// diameters d. At the paper's adhesion (270 grain weights) a heap of this size stands as a cake with steep sides whatever its
// scale, and under a narrow stream as a rod: so its angle is read as 2h/D. Of the drop heights tried (5 to 1000 d) at 50 d
// packing and coordination answer most evenly to adhesion and to friction, so that an error in either is seen.
struct ReferenceHeap {
    double base = 20.0, drop_height = 50.0, feed_diameter = 22.0;
    int grains = 1500;
    double elasticity = 1e5;    // E/(rho g d), softened equally on both sides
    bool lammps_rules = false;  // rigs::take_lammps_rules
};

// d, density, Poisson ratio, frictions and restitution of the case; one size, as in the paper. The work of adhesion is such that
// the grain scaled by the case's h under kept gravity has the case's scaled_work_of_adhesion.
rigs::PileSetup reference_setup(const cases::Case&, const ReferenceHeap&, std::uint64_t seed);

struct BitsCheck {
    std::string scheme;
    double h;
    std::size_t grains;  // compared, with all their velocities, spins and contact springs
    std::uint64_t reference, scaled;  // hashes of the final states, each in its own units
    bool equal;
};

struct SimilarityResult {
    ReferenceHeap heap;
    Margins margins;
    std::vector<BitsCheck> bits;
    std::vector<Comparison> comparisons;
    std::vector<scaling::Finding> findings;  // of the softened grain on both sides
    double seconds = 0.0;
    std::string engine{};  // who ran the heaps; empty: our own core
};

enum class Extent { small, standard, full };

// small: the bits pairs (of our own core alone) and kept_gravity at the case's h with 3 seeds. standard: the same with the seeds that give 95 % power.
// full: also the other undistorted schemes, the two controls that must fail (w off by 30 %, friction off by 20 %) and the
// scheme `paper` under every invariant.
SimilarityResult similarity(const cases::Case&, Extent, std::uint64_t first_seed, const Campaign&,
                            const ReferenceHeap& = {});

}  // namespace verify
