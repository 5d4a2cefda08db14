// SPDX-License-Identifier: MIT
#include "dem_min/surroundings.hpp"

#include "dem_min/forces.hpp"

namespace dem_min {

Field field_at(const Settings& s, double t) {
    Field field{s.gravity, -s.fluid.lifting_density * s.gravity, {}};
    if (!s.shaking.acts()) return field;
    field.per_mass.z -= s.shaking.acceleration(t);
    field.wind.z = -s.shaking.velocity(t);
    return field;
}

Vec3 from_afar(const Simulation& s, std::size_t k) {
    const Particles& p = s.grains;
    const Field field = field_at(s.settings, s.time());
    Vec3 force = p.mass[k] * field.per_mass;
    if (!s.settings.fluid.acts()) return force;
    const Vec3 u = p.velocity(k) - field.wind;
    const double r = s.settings.fluid.drag.at(2.0 * p.radius[k], contact::norm(u)).value;
    return force + volume_of(p.radius[k]) * field.per_volume - r * u;
}

void keep_books_from_afar(Simulation& s) {
    if (!has_books_from_afar(s)) return;
    const double half = 0.5 * s.settings.time_step;
    const Particles& p = s.grains;
    const Field field = field_at(s.settings, s.time());
    const Vec3 inertia = field.per_mass - s.settings.gravity;
    for (std::size_t k = 0; k < p.count(); ++k) {
        if (p.fixed(k)) continue;
        const Vec3 v = p.velocity(k), u = v - field.wind;
        const double r = s.settings.fluid.drag.at(2.0 * p.radius[k], contact::norm(u)).value;
        s.past.heat.drag += half * r * contact::dot(u, u);
        s.past.shaking_work +=
            half * (p.mass[k] * contact::dot(inertia, v) - r * contact::dot(u, field.wind));
    }
}

bool has_books_from_afar(const Simulation& s) {
    return s.settings.ledger && (s.settings.fluid.drag.factor > 0.0 || s.settings.shaking.acts());
}

}  // namespace dem_min
