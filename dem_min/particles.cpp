// SPDX-License-Identifier: MIT
#include "dem_min/particles.hpp"

#include <numbers>

namespace dem_min {

std::array<std::vector<double>*, 19> Particles::arrays() {
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
    for (std::vector<double>* array : arrays()) array->push_back(0.0);
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
}

void Particles::compact(const std::vector<std::uint8_t>& keep) {
    std::size_t to = 0;
    for (std::size_t from = 0; from < keep.size(); ++from) {
        if (!keep[from]) continue;
        for (std::vector<double>* array : arrays()) (*array)[to] = (*array)[from];
        id[to] = id[from];
        ++to;
    }
    for (std::vector<double>* array : arrays()) array->resize(to);
    id.resize(to);
}

}  // namespace dem_min
