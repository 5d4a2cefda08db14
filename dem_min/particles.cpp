// SPDX-License-Identifier: MIT
#include "dem_min/particles.hpp"

#include <numbers>
#include <utility>

namespace dem_min {

std::array<Array*, 19> Particles::arrays() {
    return {&x,
            &y,
            &z,
            &vx,
            &vy,
            &vz,
            &wx,
            &wy,
            &wz,
            &fx,
            &fy,
            &fz,
            &tx,
            &ty,
            &tz,
            &radius,
            &mass,
            &inverse_mass,
            &inverse_inertia};
}

void Particles::add(const Grain& grain, std::int64_t new_id) {
    for (Array* array : arrays()) array->push_back(0.0);
    const std::size_t k = count() - 1;
    const double r = grain.radius;
    x[k] = grain.position.x, y[k] = grain.position.y, z[k] = grain.position.z;
    vx[k] = grain.velocity.x, vy[k] = grain.velocity.y, vz[k] = grain.velocity.z;
    wx[k] = grain.spin.x, wy[k] = grain.spin.y, wz[k] = grain.spin.z;
    radius[k] = r;
    mass[k] = grain.density * (4.0 / 3.0 * std::numbers::pi) * (r * r * r);
    inverse_mass[k] = grain.fixed ? 0.0 : 1.0 / mass[k];
    inverse_inertia[k] =
        grain.fixed ? 0.0 : 2.5 / (mass[k] * (r * r));  // solid sphere: I = 2/5 m R^2
    id.push_back(new_id);
    material.push_back(grain.material);
    body.push_back(-1);
}

namespace {

template <class T, class Allocator>
void renumber_array(std::vector<T, Allocator>& array, const std::vector<int>& new_index,
                    std::size_t kept) {
    std::vector<T, Allocator> moved(kept);
    for (std::size_t k = 0; k < array.size(); ++k)
        if (new_index[k] >= 0) moved[static_cast<std::size_t>(new_index[k])] = array[k];
    array = std::move(moved);
}

}  // namespace

void Particles::renumber(const std::vector<int>& new_index) {
    std::size_t kept = 0;
    for (const int index : new_index) kept += index >= 0;
    for (Array* array : arrays()) renumber_array(*array, new_index, kept);
    renumber_array(id, new_index, kept);
    renumber_array(material, new_index, kept);
    renumber_array(body, new_index, kept);
}

}  // namespace dem_min
