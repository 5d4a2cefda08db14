// SPDX-License-Identifier: MIT
// Which pairs of materials meet in a pile, and the laws between them.
#include "rigs/pile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rigs {
namespace {

contact::Material material(int number, const cases::Case& c, const cases::Experiment& e) {
    if (number == cases::material_of_grain) return grain_material(e);
    if (number == cases::material_of_plate) return plate_material(e);
    const cases::Material& m =
        c.materials[static_cast<std::size_t>(number - cases::first_named_material)];
    return {m.youngs_modulus, m.poisson_ratio.value(), m.density.value_or(e.grain.density.value)};
}

// The case's own word on the pair; nullptr where it has none.
const cases::MaterialPair* find(const cases::Model& model, int a, int b) {
    for (const cases::MaterialPair& pair : model.pairs)
        if (pair.between == std::array{std::min(a, b), std::max(a, b)}) return &pair;
    return nullptr;
}

// `usual` between all grains, or between all grains and walls, with what the pair has for itself.
PairParameters parameters(const cases::Case& c, const cases::Experiment& e, int grain, int partner,
                          bool at_wall, const ContactParameters& usual) {
    PairParameters pair{grain, partner, at_wall, usual};
    const ContactParameters elastic =
        elastic_parameters(material(grain, c, e), material(partner, c, e));
    pair.laws.e_star = elastic.e_star, pair.laws.g_star = elastic.g_star;
    const cases::MaterialPair* own = find(c.model, grain, partner);
    if (own == nullptr) return pair;
    pair.laws.restitution = own->restitution.value_or(usual.restitution);
    pair.laws.sliding_friction = own->sliding_friction.value_or(usual.sliding_friction);
    pair.laws.rolling_friction = own->rolling_friction.value_or(usual.rolling_friction);
    if (c.model.includes(at_wall ? "wall_adhesion" : "adhesion"))
        pair.laws.work_of_adhesion = own->work_of_adhesion.value_or(usual.work_of_adhesion);
    return pair;
}

std::vector<int> without_doubles(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

std::vector<int> materials_of_walls(const PileConditions& c, const cases::WallMaterials& walls) {
    std::vector<int> numbers = walls.meshes;
    if (c.base != Base::glued_grains) numbers.push_back(walls.base);
    if (c.funnel) numbers.push_back(walls.funnel);
    return without_doubles(std::move(numbers));
}

}  // namespace

void choose_materials(PileSetup& s, const cases::Case& c, const cases::Experiment& e) {
    Materials& m = s.materials;
    m.of_wall = e.wall_material;
    std::vector<int> fed = m.of_grain;
    if (s.conditions.base == Base::glued_grains) fed.push_back(cases::material_of_grain);
    const std::vector<int> grains = without_doubles(std::move(fed));
    const std::vector<int> walls = materials_of_walls(s.conditions, m.of_wall);
    for (const int a : grains) {
        for (const int b : grains)
            if (a <= b && !(a == cases::material_of_grain && b == a))
                m.pairs.push_back(parameters(c, e, a, b, false, s.grains));
        for (const int b : walls)
            if (!(a == cases::material_of_grain && b == cases::material_of_plate))
                m.pairs.push_back(parameters(c, e, a, b, true, s.walls));
    }
    const int all = cases::first_named_material + static_cast<int>(c.materials.size());
    for (int number = 0; number < all; ++number)
        m.density.push_back(material(number, c, e).density.value());
    const cases::MaterialNames names(c.materials);
    for (const cases::MaterialPair& pair : c.model.pairs) {
        const auto meets = [&](const PairParameters& p) {
            return pair.between ==
                   std::array{std::min(p.grain, p.partner), std::max(p.grain, p.partner)};
        };
        if (std::none_of(m.pairs.begin(), m.pairs.end(), meets))
            s.notes.push_back(fmt::format("the pair {}, {} of the model meets nowhere in this pile",
                                          names.name_of(pair.between[0]),
                                          names.name_of(pair.between[1])));
    }
}

}  // namespace rigs
