// SPDX-License-Identifier: MIT
#include "cases/materials.hpp"

#include "cases/domain.hpp"
#include "cases/messages.hpp"
#include "cases/read_powder.hpp"

#include <algorithm>

namespace cases {
namespace {

void require_physics(const Value& given, const std::vector<std::string>& physics,
                     const std::vector<std::string>& one_of) {
    const auto included = [&](const std::string& name) {
        return std::find(physics.begin(), physics.end(), name) != physics.end();
    };
    if (std::any_of(one_of.begin(), one_of.end(), included)) return;
    refuse(given, "must belong to " + one_of.front() + " in physics",
           "add \"" + one_of.front() + "\" to model.physics, or remove it");
}

std::array<int, 2> read_between(const Value& between, const MaterialNames& names) {
    if (between.kind != Value::Kind::list || between.items.size() != 2)
        refuse(between, "must be two names", "write [\"grain\", \"steel\"]");
    const std::array<int, 2> pair{names.number_of(between.items[0]),
                                  names.number_of(between.items[1])};
    const int low = std::min(pair[0], pair[1]), high = std::max(pair[0], pair[1]);
    if (low == material_of_grain && high == material_of_grain)
        refuse(between, "must not be grain with grain",
               "that is what restitution, sliding_friction, ... of model.parameters say");
    if (low == material_of_grain && high == material_of_plate)
        refuse(between, "must not be grain with plate",
               "that is what wall_restitution, wall_sliding_friction, ... of model.parameters say");
    return {low, high};
}

MaterialPair read_pair(const Value& given, const MaterialNames& names,
                       const std::vector<std::string>& physics) {
    check_keys(given, {"between", "restitution", "sliding_friction", "rolling_friction",
                       "work_of_adhesion"});
    MaterialPair pair{read_between(given.at("between"), names), {}, {}, {}, {}};
    const auto read = [&](const char* key, const char* unit, Domain domain) {
        return given.has(key) ? std::optional(checked(given.at(key), unit, domain)) : std::nullopt;
    };
    pair.restitution = read("restitution", "1", Domain::unit_interval);
    pair.sliding_friction = read("sliding_friction", "1", Domain::not_negative);
    pair.rolling_friction = read("rolling_friction", "1", Domain::not_negative);
    pair.work_of_adhesion = read("work_of_adhesion", "J/m^2", Domain::not_negative);
    if (given.members.size() < 2)
        refuse(given, "must say something of the pair", "add restitution, sliding_friction, ...");
    if (pair.rolling_friction)
        require_physics(given.at("rolling_friction"), physics, {"rolling_resistance"});
    if (pair.work_of_adhesion)
        require_physics(given.at("work_of_adhesion"), physics, {"adhesion", "wall_adhesion"});
    return pair;
}

}  // namespace

MaterialNames::MaterialNames(const std::vector<Material>& materials) {
    for (const Material& m : materials) names_.push_back(m.name);
}

int MaterialNames::number_of(const Value& name) const {
    const std::string& known = checked_word(name, names_);
    return static_cast<int>(std::find(names_.begin(), names_.end(), known) - names_.begin());
}

std::string MaterialNames::name_of(int number) const {
    return names_.at(static_cast<std::size_t>(number));
}

std::vector<Material> read_materials(const Value& materials) {
    if (materials.kind != Value::Kind::object)
        refuse(materials, "must be an object",
               "write {\"steel\": {\"youngs_modulus\": \"200 GPa\", \"poisson_ratio\": 0.28}}");
    std::vector<Material> read;
    for (const auto& [name, given] : materials.members) {
        if (name == "grain" || name == "plate" || name.empty())
            refuse(given, "must have a name of its own",
                   "\"grain\" and \"plate\" stand for the materials of those");
        check_keys(given, {"youngs_modulus", "shear_modulus", "poisson_ratio", "density"});
        Value elastic = given;
        std::erase_if(elastic.members,
                      [](const auto& member) { return member.first == "density"; });
        const Plate solid = read_plate(elastic);
        read.push_back({name, solid.youngs_modulus, solid.poisson_ratio, std::nullopt});
        if (given.has("density"))
            read.back().density = scaling::Density::from_value(
                checked(given.at("density"), "kg/m^3", Domain::positive));
    }
    return read;
}

std::vector<MaterialPair> read_pairs(const Value& pairs, const MaterialNames& names,
                                     const std::vector<std::string>& physics) {
    if (pairs.kind != Value::Kind::list)
        refuse(pairs, "must be a list",
               "write [{\"between\": [\"grain\", \"steel\"], \"sliding_friction\": 0.2}]");
    std::vector<MaterialPair> read;
    for (const Value& given : pairs.items) {
        const MaterialPair pair = read_pair(given, names, physics);
        for (const MaterialPair& before : read)
            if (before.between == pair.between)
                refuse(given.at("between"), "must stand once", "join the two");
        read.push_back(pair);
    }
    return read;
}

}  // namespace cases
