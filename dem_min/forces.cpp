// SPDX-License-Identifier: MIT
#include "dem_min/forces.hpp"

#include "contact/effective.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace dem_min {
namespace {

template <class Law>
Law aged(const Law& fresh, const contact::Ageing& ageing, const Contacts& c, std::size_t slot) {
    return ageing.acts() ? ageing.aged(fresh, c.age[slot]) : fresh;
}

ContactConstants with_law(const Laws& laws, double r_star, ContactConstants c) {
    c.r_star = r_star;
    c.length_scale =
        std::visit([&](const auto& law) { return law.length_scale(r_star); }, laws.normal);
    return c;
}

// kg: what a contact has behind it. Fixed grains have no contacts with walls.
double heaviness(const Simulation& s, std::size_t k) {
    const int body = s.grains.body[k];
    return body >= 0           ? s.bodies[static_cast<std::size_t>(body)].mass
           : s.grains.fixed(k) ? contact::wall_mass
                               : s.grains.mass[k];
}

}  // namespace

double potential_of_gravity(const Simulation& s, std::size_t k) {
    const double buoyed = s.settings.fluid.lifting_density > 0.0
                              ? s.settings.fluid.lifting_density * volume_of(s.grains.radius[k])
                              : 0.0;
    return -(s.grains.mass[k] - buoyed) * contact::dot(s.settings.gravity, s.grains.position(k));
}

double kinetic_energy(const Particles& p, std::size_t k) {
    if (p.inverse_mass[k] == 0.0) return 0.0;
    const Vec3 v = p.velocity(k), w = p.spin(k);
    return 0.5 * p.mass[k] * contact::dot(v, v) + 0.5 / p.inverse_inertia[k] * contact::dot(w, w);
}

double stored_energy(const Laws& laws, const Contacts& c, std::size_t slot) {
    const double r_star = c.r_star[slot], overlap = c.books.overlap[slot];
    const double springs = c.books.stored_tangential[slot] + c.books.stored_rolling[slot];
    const bool bridged = laws.bridge.acts();
    if (bridged && overlap < 0.0 && c.previous_radius[slot] == 0.0)
        return laws.bridge.work(r_star, -overlap);
    const double elastic = std::visit(
                               [&](const auto& fresh) {
                                   return aged(fresh, laws.ageing, c, slot)
                                       .energy(r_star, c.length_scale[slot], overlap);
                               },
                               laws.normal) +
                           springs;
    return bridged ? elastic - laws.bridge.closed(r_star) * overlap : elastic;
}

Dissipation heat_so_far(const Contacts& c, std::size_t slot) {
    return {.normal_dashpot = c.books.heat_normal[slot],
            .tangential = c.books.heat_tangential[slot],
            .rolling = c.books.heat_rolling[slot],
            .tear_off = c.books.heat_tear_off[slot]};
}

Dissipation heat_of_end(const Laws& laws, const Contacts& c, std::size_t slot) {
    Dissipation heat = heat_so_far(c, slot);
    heat.tangential += c.books.stored_tangential[slot];
    heat.rolling += c.books.stored_rolling[slot];
    if (c.books.overlap[slot] == handed_over) return heat;
    // The work that the pair did against adhesion between touch and tear-off, never given back.
    if (laws.bridge.acts())  // that of the solids has been booked when they parted
        heat.tear_off += laws.bridge.work(c.r_star[slot], laws.bridge.rupture_gap);
    else
        heat.tear_off += std::visit(
            [&](const auto& fresh) {
                const auto law = aged(fresh, laws.ageing, c, slot);
                const double r_star = c.r_star[slot], length_scale = c.length_scale[slot];
                return law.energy(r_star, length_scale, law.tear_off_overlap(r_star, length_scale));
            },
            laws.normal);
    return heat;
}

std::size_t group_of_pair(const Simulation& s, std::size_t i, std::size_t j) {
    if (s.particular.empty()) return 0;
    const int a = s.grains.material[i], b = s.grains.material[j];
    for (std::size_t k = 0; k < s.particular.size(); ++k) {
        const ParticularLaws& one = s.particular[k];
        if (!one.at_wall &&
            ((one.material == a && one.partner == b) || (one.material == b && one.partner == a)))
            return k + 2;
    }
    return 0;
}

std::size_t group_of_wall(const Simulation& s, std::size_t i, std::size_t wall) {
    if (s.particular.empty()) return 1;
    const int a = s.grains.material[i], b = s.wall_material.empty() ? 0 : s.wall_material[wall];
    for (std::size_t k = 0; k < s.particular.size(); ++k) {
        const ParticularLaws& one = s.particular[k];
        if (one.at_wall && one.material == a && one.partner == b) return k + 2;
    }
    return 1;
}

ContactConstants pair_constants(const Simulation& s, const Laws& laws, std::size_t i,
                                std::size_t j) {
    const Particles& p = s.grains;
    return with_law(laws, contact::r_star(p.radius[i], p.radius[j]),
                    {.r_i = p.radius[i],
                     .r_j = p.radius[j],
                     .r_star = 0.0,
                     .m_star = contact::m_star(heaviness(s, i), heaviness(s, j)),
                     .length_scale = 0.0,
                     .inverse_inertia_i = p.inverse_inertia[i],
                     .inverse_inertia_j = p.inverse_inertia[j]});
}

ContactConstants wall_constants(const Simulation& s, const Laws& laws, std::size_t i) {
    const Particles& p = s.grains;
    return with_law(laws, p.radius[i],
                    {.r_i = p.radius[i],
                     .r_j = 0.0,
                     .r_star = 0.0,
                     .m_star = heaviness(s, i),
                     .length_scale = 0.0,
                     .inverse_inertia_i = p.inverse_inertia[i],
                     .inverse_inertia_j = 0.0});
}

void insert(Simulation& s, const Grain& grain) {
    Particles& p = s.grains;
    p.add(grain, s.births++);
    const std::size_t k = p.count() - 1;
    if (!grain.fixed) {
        const Vec3 force = from_afar(s, k);
        p.fx[k] = force.x, p.fy[k] = force.y, p.fz[k] = force.z;
        s.past.kinetic_in += kinetic_energy(p, k);
        s.past.potential_in += potential_of_gravity(s, k);
    }
    s.list_is_stale = true;
}

void begin_pair(Simulation& s, std::size_t i, std::size_t j) {
    const std::size_t group = group_of_pair(s, i, j);
    Tile& tile = s.tiles[static_cast<std::size_t>(tile_of(static_cast<int>(i)))];
    const Laws& laws = s.laws(group);
    tile.groups[group].add(static_cast<int>(i), static_cast<int>(j), pair_constants(s, laws, i, j),
                           s.settings.ledger, laws.singly());
    ++tile.outbox_changes;
}

void begin_wall_contact(Simulation& s, std::size_t i, std::size_t wall) {
    const std::size_t group = group_of_wall(s, i, wall);
    Tile& tile = s.tiles[static_cast<std::size_t>(tile_of(static_cast<int>(i)))];
    const Laws& laws = s.laws(group);
    tile.groups[group].add(static_cast<int>(i), static_cast<int>(wall), wall_constants(s, laws, i),
                           s.settings.ledger, laws.singly());
}

void remove_lost(Simulation& s) {
    Particles& p = s.grains;
    std::vector<int> new_index(p.count());
    int kept = 0;
    const std::vector<bool> bodies = lost_bodies(s);
    for (std::size_t k = 0; k < p.count(); ++k) {
        const int body = p.body[k];
        const bool lost = body >= 0 ? bodies[static_cast<std::size_t>(body)]
                                    : !p.fixed(k) && p.z[k] < s.settings.lost_below;
        new_index[k] = lost ? -1 : kept;
        kept += !lost;
        if (!lost || body >= 0) continue;
        ++s.past.grains_lost;
        s.past.carried_away += kinetic_energy(p, k);
        s.past.potential_out += potential_of_gravity(s, k);
    }
    if (kept == static_cast<int>(p.count())) return;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b]) {
            ++s.past.grains_lost;
            s.past.carried_away += kinetic_energy(s.bodies[b]);
            s.past.potential_out += potential_of_gravity(s, s.bodies[b]);
        }
    if (s.settings.ledger)
        for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
            const bool stays =
                new_index[static_cast<std::size_t>(c.i[slot])] >= 0 &&
                (s.at_wall(group) || new_index[static_cast<std::size_t>(c.j[slot])] >= 0);
            if (stays) return;
            s.past.carried_away += stored_energy(s.laws(group), c, slot);
            s.past.heat += heat_so_far(c, slot);
        });
    renumber(s, new_index);
}

std::vector<Wall*> moving_walls(Simulation& s) {
    std::vector<Wall*> moving;
    for (Wall& wall : s.walls)
        if (moves(wall)) moving.push_back(&wall);
    return moving;
}

void move_walls(Simulation& s, const std::vector<Wall*>& moving) {
    double longest = 0.0;
    for (Wall* wall : moving) longest = std::max(longest, carry_on(*wall, s.settings.time_step));
    if (longest > 0.0)
        for (Tile& tile : s.tiles) tile.way_from_walls += longest + tile.rounding;
}

double half_step_work_of_walls(const Simulation& s, const Contacts& c) {
    double sum = 0.0;
    for (std::size_t k = 0; k < c.count(); ++k) {
        const Wall& wall = s.walls[static_cast<std::size_t>(c.j[k])];
        if (!moves(wall)) continue;
        const Vec3 place = s.grains.position(static_cast<std::size_t>(c.i[k]));
        const WallDistance way = distance(wall, place);
        const Vec3 on_wall{c.books.fx[k], c.books.fy[k], c.books.fz[k]};
        const Vec3 turning_wall{c.books.tjx[k], c.books.tjy[k], c.books.tjz[k]};
        sum -= contact::dot(on_wall, velocity(wall, place + way.distance * way.n)) +
               contact::dot(turning_wall, spin(wall));
    }
    return 0.5 * s.settings.time_step * sum;
}

bool time_to_reorder(const Simulation& s) { return s.steps % reorder_interval == 0; }

}  // namespace dem_min
