// SPDX-License-Identifier: MIT
#pragma once

#include "cases/case.hpp"

#include <string>
#include <vector>

namespace cases {

// What experiments share, as written, for them to override.
struct Shared {
    Value grain, plate, surroundings;  // plate of kind null where the case has none
    std::string folder;                // recordings stand relative to it
    std::vector<Material> materials{};
    MaterialNames names{};
};

// One entry of `experiments`, without its recordings. Throws scaling::InvalidInput.
Experiment read_experiment(const Value& experiment, const Shared&, const Model&);

// The recordings that it names and that have not been read yet. Throws scaling::InvalidInput.
void read_recordings(Experiment&);

}  // namespace cases
