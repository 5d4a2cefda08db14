// SPDX-License-Identifier: MIT
#include "cases/read_powder.hpp"

#include "cases/domain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cases {
namespace {

template <class Q>
Measured<Q> measured(const CheckedPair& pair) {
    return {Q::from_value(pair.value), Q::from_value(pair.uncertainty)};
}

// E as given, or 2 G (1 + nu).
CheckedPair youngs_modulus(const Value& material, double poisson_ratio) {
    if (!material.has("shear_modulus"))
        return checked_pair(material.at("youngs_modulus"), "Pa", Domain::positive);
    const double e_over_g = 2.0 * (1.0 + poisson_ratio);
    const CheckedPair g = checked_pair(material.at("shear_modulus"), "Pa", Domain::positive);
    if (!material.has("youngs_modulus")) return {e_over_g * g.value, e_over_g * g.uncertainty};
    const CheckedPair e = checked_pair(material.at("youngs_modulus"), "Pa", Domain::positive);
    // 1 %: both are printed with two or three digits.
    if (std::abs(e.value - e_over_g * g.value) > 0.01 * e.value) {
        refuse(material.at("shear_modulus"),
               fmt::format("must be {} beside this youngs_modulus: E = 2 G (1 + nu)",
                           format_si(e.value / e_over_g, "Pa")),
               "give one of the two");
    }
    return e;
}

const Value& pair_of(const Value& list, std::size_t i, const char* example, std::size_t most = 2) {
    const Value& entry = list.items[i];
    if (entry.kind != Value::Kind::list || entry.items.size() < 2 || entry.items.size() > most)
        refuse(entry, "must be a pair", example);
    return entry;
}

void require_list(const Value& list, const char* example) {
    if (list.kind != Value::Kind::list || list.items.empty())
        refuse(list, "must be a list of pairs", example);
}

void read_sizes(const Value& list, const MaterialNames& names, Grain& grain) {
    const char* example =
        "write [[\"1.9 mm\", 0.5], [\"2.1 mm\", 0.5]]: diameter, number fraction, and a material "
        "where it is not the grain's";
    require_list(list, example);
    double sum = 0.0;
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        const Value& entry = pair_of(list, i, example, 3);
        const double diameter = checked(entry.items[0], "m", Domain::positive);
        const double fraction = checked(entry.items[1], "1", Domain::positive);
        const bool other = entry.items.size() == 3;
        grain.size_material.push_back(other ? names.number_of(entry.items[2]) : material_of_grain);
        if (grain.size_material.back() == material_of_plate)
            refuse(entry.items[2], "must be of a material of grains", "name one of \"materials\"");
        grain.sizes.emplace_back(scaling::Length::from_value(diameter), fraction);
        sum += fraction;
    }
    // 2 %: three fractions of 0.33 are meant to be 1.
    if (std::abs(sum - 1.0) > 0.02) {
        refuse(list, fmt::format("must have fractions that sum to 1, not to {:.6g}", sum),
               "correct the number fractions");
    }
    for (auto& [diameter, fraction] : grain.sizes) fraction /= sum;
}

void read_distribution(const Value& list, Grain& grain) {
    const char* example =
        "write [[\"10 %\", \"0.272 um\"], [\"50 %\", \"1.2 um\"]]: cumulative volume fraction, "
        "diameter";
    require_list(list, example);
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        const Value& entry = pair_of(list, i, example);
        const double fraction = checked(entry.items[0], "1", Domain::unit_interval);
        const double diameter = checked(entry.items[1], "m", Domain::positive);
        if (i > 0) {
            const auto& [fraction_before, diameter_before] = grain.size_distribution.back();
            if (fraction <= fraction_before) {
                refuse(entry.items[0],
                       fmt::format("must be above the {:.6g} % before it", 100.0 * fraction_before),
                       "a cumulative distribution rises; sort it");
            }
            if (diameter <= diameter_before.value()) {
                refuse(
                    entry.items[1],
                    "must be above the " + format_si(diameter_before.value(), "m") + " before it",
                    "a cumulative distribution rises; sort it");
            }
        }
        grain.size_distribution.emplace_back(fraction, scaling::Length::from_value(diameter));
    }
}

}  // namespace

Value overridden(const Value& object, const Value& overriding) {
    if (overriding.kind != Value::Kind::object)
        refuse(overriding, "must be an object", "write { } with the keys to override");
    const bool sized = overriding.has("diameter") || overriding.has("sizes") ||
                       overriding.has("size_distribution");
    const auto dropped = [&](const std::string& key) {
        return overriding.has(key) || (sized && (key == "sizes" || key == "size_distribution")) ||
               (key == "youngs_modulus" && overriding.has("shear_modulus")) ||
               (key == "shear_modulus" && overriding.has("youngs_modulus"));
    };
    Value result = object;
    std::erase_if(result.members, [&](const auto& member) { return dropped(member.first); });
    result.members.insert(result.members.end(), overriding.members.begin(),
                          overriding.members.end());
    return result;
}

Grain read_grain(const Value& grain, const MaterialNames& names) {
    check_keys(grain, {"diameter", "density", "youngs_modulus", "shear_modulus", "poisson_ratio",
                       "sizes", "size_distribution", "surface_energy"});
    Grain result;
    result.diameter =
        measured<scaling::Length>(checked_pair(grain.at("diameter"), "m", Domain::positive));
    result.density =
        measured<scaling::Density>(checked_pair(grain.at("density"), "kg/m^3", Domain::positive));
    const CheckedPair nu = checked_pair(grain.at("poisson_ratio"), "1", Domain::poisson_ratio);
    result.poisson_ratio = measured<scaling::Dimensionless>(nu);
    result.youngs_modulus = measured<scaling::Pressure>(youngs_modulus(grain, nu.value));
    if (grain.has("sizes") && grain.has("size_distribution")) {
        refuse(grain.at("sizes"), "must not stand beside size_distribution", "give one of the two");
    }
    if (grain.has("sizes")) read_sizes(grain.at("sizes"), names, result);
    if (grain.has("size_distribution")) read_distribution(grain.at("size_distribution"), result);
    return result;
}

Plate read_plate(const Value& plate) {
    check_keys(plate, {"youngs_modulus", "shear_modulus", "poisson_ratio"});
    const double nu = checked(plate.at("poisson_ratio"), "1", Domain::poisson_ratio);
    const CheckedPair e = youngs_modulus(plate, nu);
    if (e.uncertainty > 0.0)
        refuse(plate, "must have plain values", "give an uncertainty to the grain instead");
    return {scaling::Pressure::from_value(e.value), scaling::Dimensionless(nu)};
}

Surroundings read_surroundings(const Value& surroundings) {
    check_keys(surroundings, {"gravity", "fluid_density", "fluid_viscosity"});
    const auto read = [&](const char* key, const char* unit) {
        return surroundings.has(key) ? checked(surroundings.at(key), unit, Domain::not_negative)
                                     : 0.0;
    };
    return {scaling::Acceleration::from_value(read("gravity", "m/s^2")),
            scaling::Density::from_value(read("fluid_density", "kg/m^3")),
            scaling::Viscosity::from_value(read("fluid_viscosity", "Pa*s"))};
}

}  // namespace cases
