// SPDX-License-Identifier: MIT
// A case without its secret: grains, plates, conditions, sampling, noise, and the user's model, drawn from one law per rig
// whatever will be concealed.
#pragma once

#include "prove/dice.hpp"
#include "prove/fit.hpp"

#include <string>
#include <vector>

namespace prove {

// A parameter of the user's model.
struct Stated {
    std::string name;
    double World::*place;
    double truth;
    bool free;
    double low, high, start;  // of a free one
};

struct Skeleton {
    Rig rig;
    std::vector<std::string> physics;  // as in model.physics
    std::vector<Stated> parameters;
    World world;                     // what truly acts, so far without a secret
    std::vector<Setup> truth;        // with the true values of what is uncertain
    std::vector<Setup> stated;       // as written in the case
    std::vector<Unknown> nuisances;  // of `stated`; fit and held-out experiments
    Noise noise;
    bool states_noise = true;
    bool states_numerics = false, hands_over_run = false;  // harmless ones
};

Skeleton draw(Rig, Dice&);

// Free parameters and the nuisances of the experiments asked for; `experiments` are the indices into stated.
std::vector<Unknown> base_unknowns(const Skeleton&, const std::vector<std::size_t>& experiments);
std::vector<std::size_t> with_role(const Skeleton&, bool held_out);
std::vector<std::size_t> all_experiments(const Skeleton&);
std::vector<Setup> chosen(const std::vector<Setup>&, const std::vector<std::size_t>&);

}  // namespace prove
