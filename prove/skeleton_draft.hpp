// SPDX-License-Identifier: MIT
// What the skeletons of all rigs share: materials, what varies between experiments, parameters and uncertain conditions.
#pragma once

#include "prove/skeleton.hpp"

#include <vector>

namespace prove {

struct Material {
    double density, youngs_modulus, poisson_ratio;
};

// One experiment's condition out of a range that the case spans; broad cases use all of it.
struct Span {
    double low, high;
    double draw(Dice& dice) const { return rounded(dice.log_uniform(low, high), 3); }
};

Span span_of(Dice&, double low, double high, bool broad);
// Rounded to three digits per step, some rows lost or shifted.
std::vector<double> sampling_times(Dice&, double duration, int rows, bool uneven, bool gaps);

struct SkeletonDraft {
    Skeleton sk;
    Dice& dice;
    bool broad, other_sizes, other_materials, uneven, gaps;
    int fits, held_out;
    Setup common;
    std::vector<Material> materials;

    bool last(int k) const { return k >= fits; }
    // Diameter and material of experiment k.
    Setup grain_of(int k);
    int count() const { return fits + held_out; }
    void state(const char* name, double World::*place, double truth, double free_chance, double low,
               double high);
    void uncertain(const char* name, double Setup::*place, double deviation_share, double absolute,
                   bool not_negative);
};

SkeletonDraft begin_skeleton(Rig, Dice&);
void name_law(Skeleton&);

}  // namespace prove
