// SPDX-License-Identifier: MIT
// Materials by name, and the laws of pairs of them where they differ from those of `model.parameters`.
// A material is known by its number: that of `grain` and of `plate` as each experiment has them, then those of `materials`.
#pragma once

#include "cases/value.hpp"
#include "scaling/quantities.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace cases {

constexpr int material_of_grain = 0, material_of_plate = 1, first_named_material = 2;

struct Material {
    std::string name;
    scaling::Pressure youngs_modulus;
    scaling::Dimensionless poisson_ratio;
    std::optional<scaling::Density> density;  // which a wall does not need
};

// What is not given is as without this pair.
struct MaterialPair {
    std::array<int, 2> between;                                             // in any order
    std::optional<double> restitution, sliding_friction, rolling_friction;  // 1
    std::optional<double> work_of_adhesion;                                 // J/m^2
};

// Those of a case, by number from first_named_material on.
class MaterialNames {
  public:
    MaterialNames() = default;
    explicit MaterialNames(const std::vector<Material>&);

    int number_of(const Value& name) const;  // refuses an unknown one and suggests another
    std::string name_of(int number) const;

  private:
    std::vector<std::string> names_{"grain", "plate"};
};

// `materials` of a case: name -> {youngs_modulus or shear_modulus, poisson_ratio, density}. Throws scaling::InvalidInput.
std::vector<Material> read_materials(const Value& materials);

// `model.pairs`. Refused: the pairs grain-grain and grain-plate, whose laws stand in `model.parameters`; a pair twice; one that
// says nothing; and what `physics` leaves out.
std::vector<MaterialPair> read_pairs(const Value& pairs, const MaterialNames&,
                                     const std::vector<std::string>& physics);

}  // namespace cases
