// SPDX-License-Identifier: MIT
#include "scaling/quantity_table.hpp"

#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"
#include "scaling/quantities.hpp"

#include <algorithm>

namespace scaling {

namespace {

template <class Quantity>
NamedQuantity of_grain(const char* name) {
    return {name, dimension_of<Quantity>(), Side::grain, {}};
}

template <class Quantity>
NamedQuantity of_surroundings(const char* name) {
    return {name, dimension_of<Quantity>(), Side::surroundings, {}};
}

template <class Quantity>
NamedQuantity of_both(const char* name, std::vector<Power> product) {
    return {name, dimension_of<Quantity>(), Side::both, std::move(product)};
}

std::vector<NamedQuantity> make_table() {
    return {
        of_grain<Length>("length"),
        of_surroundings<Length>("apparatus_length"),
        of_grain<Density>("density"),
        of_surroundings<Time>("time"),
        of_grain<Time>("contact_time"),
        of_surroundings<Velocity>("velocity"),
        of_surroundings<Acceleration>("acceleration"),
        of_surroundings<Acceleration>("gravity"),
        of_grain<Mass>("mass"),
        of_grain<Force>("force"),
        of_grain<Pressure>("stress"),
        of_surroundings<Pressure>("pressure"),
        of_grain<Dimensionless>("strain"),
        of_grain<Pressure>("youngs_modulus"),
        of_grain<Pressure>("shear_modulus"),
        of_grain<Dimensionless>("poisson_ratio"),
        of_grain<Energy>("energy"),
        of_grain<EnergyPerArea>("surface_energy"),
        of_grain<EnergyPerArea>("work_of_adhesion"),
        of_grain<EnergyPerArea>("surface_tension"),
        of_grain<Energy>("hamaker_constant"),
        of_grain<Stiffness>("stiffness"),
        of_grain<Damping>("damping"),
        of_grain<Viscosity>("viscosity"),
        of_grain<Area>("area"),
        of_grain<Volume>("volume"),
        of_grain<Volume>("liquid_volume"),
        of_surroundings<Frequency>("frequency"),
        of_both<Frequency>("spin", {{"velocity", 1}, {"length", -1}}),
        of_surroundings<MassRate>("mass_rate"),
        of_both<Frequency>("number_rate", {{"mass_rate", 1}, {"mass", -1}}),
    };
}

}  // namespace

const std::vector<NamedQuantity>& quantity_table() {
    static const std::vector<NamedQuantity> table = make_table();
    return table;
}

const NamedQuantity& named_quantity(const std::string& name) {
    const auto& table = quantity_table();
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const NamedQuantity& q) { return q.name == name; });
    if (found != table.end()) return *found;
    std::vector<std::string> names;
    for (const NamedQuantity& q : table) names.push_back(q.name);
    throw InvalidParameter(mistake("quantity", '"' + name + '"',
                                   "must be a quantity with a scale factor",
                                   "did you mean " + nearest_name(name, names) + "?"));
}

}  // namespace scaling
