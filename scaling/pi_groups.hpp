// SPDX-License-Identifier: MIT
// Dimensionless groups of a case: a readable basis, names where the field has them, and what a
// scale map does to each.
#pragma once

#include "scaling/scale_map.hpp"

#include <string>
#include <vector>

namespace scaling {

// A dimensional variable of the case. Its quantity (quantity_table.hpp) gives the dimension and how
// it scales: an outlet diameter is an `apparatus_length`, a grain diameter a `length`.
struct Variable {
    std::string name;
    std::string quantity;
    double value;  // SI, > 0
};

// prefactor * product of variable^exponent.
struct PiGroup {
    std::string name;     // "weight_bond"; the formula where the field has no name
    std::string formula;  // "F_po / (m g)"
    double prefactor = 1.0;
    std::vector<Power> powers;
};

struct GroupChange {
    PiGroup group;
    double original, scaled, ratio;  // ratio = scaled / original, from exact exponents
    Exponents change;                // ratio = h^a (E'/E)^b
    bool kept;
};

// The groups that the field names, over the variable names grain_diameter, apparatus_length,
// density, gravity, youngs_modulus, work_of_adhesion, velocity, equilibrium_separation,
// fluid_density, fluid_viscosity, surface_tension, liquid_volume. Grains are alike; the same values
// as numbers.hpp. poisson_ratio enters through E*.
std::vector<PiGroup> named_groups(double poisson_ratio);

// A basis of all groups of the variables. The first independent variables repeat in every group, so
// their order is the order of preference; each other variable has one group, with the smallest
// whole exponents and its own positive. A group that the field names (up to a power) is given as
// that one.
std::vector<PiGroup> pi_basis(const std::vector<Variable>&, const std::vector<PiGroup>& named);

// Every named group whose variables are all there, then what a basis still needs: complete, not
// independent.
std::vector<PiGroup> groups_of(const std::vector<Variable>&, const std::vector<PiGroup>& named);

// Throws InvalidParameter where the group names a variable that is not there.
double value_of(const PiGroup&, const std::vector<Variable>&);
Dimension dimension_of(const PiGroup&, const std::vector<Variable>&);
Exponents change_of(const PiGroup&, const std::vector<Variable>&, const ScaleMap&);

// "[M T^-2] [M L^-3]^-1 [L T^-2]^-1 [L]^-2 = 1": the product of the dimensions, written out.
std::string dimension_proof(const PiGroup&, const std::vector<Variable>&);

std::vector<GroupChange> compare_groups(const std::vector<PiGroup>&, const std::vector<Variable>&,
                                        const ScaleMap&);

}  // namespace scaling
