// SPDX-License-Identifier: MIT
// Families of blind heaps: cases of one family share powder, apparatus and places of the scanner, so that truth and judge can share
// what they have learnt. Everything follows from (seed, number). Shares and ranges: docs/prove-heaps.md.
#pragma once

#include "prove/heap_pour.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace prove {

// An arrangement: which grains are poured on which apparatus, and where the scanner looks.
struct Arrangement {
    std::string id;  // "fine", "coarse", "other"
    Powder grain;
    HeapRig rig;
    std::vector<Spot> spots;  // azimuth by azimuth, r rising
    double noise;             // m, of the instrument
};

struct HeapFamily {
    int number;                             // from 1
    std::vector<Arrangement> arrangements;  // the last one is held out
    double low = 0.15, high = 0.9;          // range of the user's sliding friction
    // Standard deviation over mean diameter, known to the user: of a sieve's cut in odd families; 0 in even ones.
    double size_spread = 0.0;
};

constexpr int family_size = 20;
constexpr int repeats = 2;  // of each arrangement that is fitted
constexpr std::size_t spot_azimuths = 12, spot_radii = 16;

HeapFamily heap_family(std::uint64_t seed, int family, double size = 1.0);

// What may be concealed: a name of docs/effects.md, its parameter, SI, and strengths between which it is drawn.
struct HeapEffect {
    std::string name, parameter, unit;
    double low, high;
};
// adhesion, rolling_resistance, polydispersity (where the user knows of one size), tilt, measurement_offset, measurement_scale (of
// which the strength is scale - 1).
std::vector<HeapEffect> heap_effects(const HeapFamily&);
bool acts_among_grains(
    const std::string& effect);  // else in the instrument, on either side of nothing

// The physics of an effect of a strength beside a friction; what the instrument does is none.
HeapPhysics with_effect(const HeapFamily&, const std::string& effect, double strength,
                        double friction, double azimuth = 0.0);

enum class HeapKind { null, single, cancelling };
struct HeapPlan {
    int number, family;
    HeapKind kind;
    std::string effect;  // empty: null
    double strength;     // of a single; of a cancelling one too
    double friction;     // of null and single; a cancelling one's is solved for
    double start;        // what the user's model says of the friction
    double azimuth;      // of a tilt
};
HeapPlan heap_plan(std::uint64_t seed, int number, const HeapFamily&);

}  // namespace prove
