// SPDX-License-Identifier: MIT
// The parts of a case that say what the user simulates: model and scaling.
#pragma once

#include "cases/case.hpp"

namespace cases {

// Physics and parameters by their names, ranges in order and with their value inside, what an effect needs present.
// `known_elsewhere` is a parameter that need not be given here (the adhesion of the scaled grain), or "".
Model read_model(const Value& model, const std::string& known_elsewhere, const MaterialNames& = {});

Scaling read_scaling(const Value& scaling);

// The density of the grain turns the bulk density into a packing fraction.
Stated read_stated(const Value& stated, scaling::Density grain_density);

}  // namespace cases
