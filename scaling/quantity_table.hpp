// SPDX-License-Identifier: MIT
// The named quantities that have a scale factor. A name's dimension is that of its Boost.Units
// type.
//
// Each name also has a side, which matters only in a distorted map, where grain and surroundings
// have a ruler and a clock each (scale_map.hpp):
//   grain         grain lengths and contact times: force, stress, stiffness, ... of a contact
//   surroundings  apparatus lengths and times of the flow: gravity, velocity, mass rate, ...
// A few quantities belong to both and say by which product: spin = velocity / grain length, number
// rate = mass rate / grain mass.
#pragma once

#include "scaling/dimension.hpp"

#include <string>
#include <vector>

namespace scaling {

enum class Side { grain, surroundings, both };

// One factor of a product of named quantities or variables.
struct Power {
    std::string name;
    Rational exponent;
};

struct NamedQuantity {
    std::string name;
    Dimension dimension;
    Side side;
    std::vector<Power> product;  // of other names; only where side is `both`
};

// All names, in the order in which reports list them.
const std::vector<NamedQuantity>& quantity_table();

// Throws InvalidParameter with the nearest known name.
const NamedQuantity& named_quantity(const std::string& name);

}  // namespace scaling
