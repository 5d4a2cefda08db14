// SPDX-License-Identifier: MIT
#include "dem_min/forces.hpp"

#include "contact/effective.hpp"

#include <cstdint>

namespace dem_min {
namespace {

ContactConstants constants(const Laws& laws, double r_star, ContactConstants c) {
    std::visit(
        [&](const auto& law) {
            c.r_star = r_star;
            c.length_scale = law.length_scale(r_star);
            c.tear_off_overlap = law.tear_off_overlap(r_star, c.length_scale);
        },
        laws.normal);
    return c;
}

}  // namespace

double potential_of_gravity(const Simulation& s, std::size_t k) {
    return -s.grains.mass[k] * contact::dot(s.settings.gravity, s.grains.position(k));
}

double kinetic_energy(const Particles& p, std::size_t k) {
    if (p.fixed(k)) return 0.0;
    const Vec3 v = p.velocity(k), w = p.spin(k);
    return 0.5 * p.mass[k] * contact::dot(v, v) + 0.5 / p.inverse_inertia[k] * contact::dot(w, w);
}

double stored_energy(const Laws& laws, const Contacts& c, std::size_t slot) {
    return std::visit(
               [&](const auto& law) {
                   return law.energy(c.r_star[slot], c.length_scale[slot], c.overlap[slot]);
               },
               laws.normal) +
           c.stored_tangential[slot] + c.stored_rolling[slot];
}

Dissipation heat_so_far(const Contacts& c, std::size_t slot) {
    return {c.heat_normal[slot], c.heat_tangential[slot], c.heat_rolling[slot], 0.0};
}

ContactConstants pair_constants(const Simulation& s, std::size_t i, std::size_t j) {
    const Particles& p = s.grains;
    const auto heaviness = [&](std::size_t k) {
        return p.fixed(k) ? contact::wall_mass : p.mass[k];
    };
    const double m_star = contact::m_star(heaviness(i), heaviness(j));
    return constants(s.between_grains, contact::r_star(p.radius[i], p.radius[j]),
                     {.r_i = p.radius[i],
                      .r_j = p.radius[j],
                      .r_star = 0.0,
                      .m_star = m_star,
                      .length_scale = 0.0,
                      .inverse_inertia_i = p.inverse_inertia[i],
                      .inverse_inertia_j = p.inverse_inertia[j],
                      .tear_off_overlap = 0.0});
}

ContactConstants wall_constants(const Simulation& s, std::size_t i) {
    const Particles& p = s.grains;
    return constants(s.at_walls, p.radius[i],
                     {.r_i = p.radius[i],
                      .r_j = contact::wall_radius,
                      .r_star = 0.0,
                      .m_star = p.mass[i],
                      .length_scale = 0.0,
                      .inverse_inertia_i = p.inverse_inertia[i],
                      .inverse_inertia_j = 0.0,
                      .tear_off_overlap = 0.0});
}

void insert(Simulation& s, const Grain& grain) {
    Particles& p = s.grains;
    p.add(grain, s.births++);
    const std::size_t k = p.count() - 1;
    if (!grain.fixed) {
        const Vec3 weight = p.mass[k] * s.settings.gravity;
        p.fx[k] = weight.x, p.fy[k] = weight.y, p.fz[k] = weight.z;
        s.past.kinetic_in += kinetic_energy(p, k);
        s.past.potential_in += potential_of_gravity(s, k);
    }
    s.neighbours.stale = true;
}

void kick_and_drift(Simulation& s) {
    Particles& p = s.grains;
    const double dt = s.settings.time_step, half = 0.5 * dt;
    const int n = static_cast<int>(p.count()), team = s.team();
#pragma omp parallel for simd schedule(static) num_threads(team) if (team > 1)
    for (int index = 0; index < n; ++index) {
        const auto k = static_cast<std::size_t>(index);
        const double a = half * p.inverse_mass[k], b = half * p.inverse_inertia[k];
        p.vx[k] += a * p.fx[k], p.vy[k] += a * p.fy[k], p.vz[k] += a * p.fz[k];
        p.wx[k] += b * p.tx[k], p.wy[k] += b * p.ty[k], p.wz[k] += b * p.tz[k];
        p.x[k] += dt * p.vx[k], p.y[k] += dt * p.vy[k], p.z[k] += dt * p.vz[k];
    }
}

void gather_and_kick(Simulation& s) {
    Particles& p = s.grains;
    const double half = 0.5 * s.settings.time_step;
    const int n = static_cast<int>(p.count()), team = s.team();
    const Contacts &pairs = s.pairs, &walls = s.wall_contacts;
    const Incidence &of_pairs = s.neighbours.of_pairs, &of_walls = s.neighbours.of_walls;
#pragma omp parallel for schedule(static) num_threads(team) if (team > 1)
    for (int index = 0; index < n; ++index) {
        const auto k = static_cast<std::size_t>(index);
        if (p.fixed(k)) continue;
        Vec3 f, t;
        for (int at = of_pairs.begin[k]; at < of_pairs.begin[k + 1]; ++at) {
            const int entry = of_pairs.entry[static_cast<std::size_t>(at)];
            const auto c = static_cast<std::size_t>(entry / 2);
            const Vec3 force{pairs.fx[c], pairs.fy[c], pairs.fz[c]};
            f = entry % 2 ? f + force : f - force;
            t = t + (entry % 2 ? Vec3{pairs.tjx[c], pairs.tjy[c], pairs.tjz[c]}
                               : Vec3{pairs.tix[c], pairs.tiy[c], pairs.tiz[c]});
        }
        for (int at = of_walls.begin[k]; at < of_walls.begin[k + 1]; ++at) {
            const auto c =
                static_cast<std::size_t>(of_walls.entry[static_cast<std::size_t>(at)] / 2);
            f = f - Vec3{walls.fx[c], walls.fy[c], walls.fz[c]};
            t = t + Vec3{walls.tix[c], walls.tiy[c], walls.tiz[c]};
        }
        f = f + p.mass[k] * s.settings.gravity;
        p.fx[k] = f.x, p.fy[k] = f.y, p.fz[k] = f.z;
        p.tx[k] = t.x, p.ty[k] = t.y, p.tz[k] = t.z;
        const double a = half * p.inverse_mass[k], b = half * p.inverse_inertia[k];
        p.vx[k] += a * f.x, p.vy[k] += a * f.y, p.vz[k] += a * f.z;
        p.wx[k] += b * t.x, p.wy[k] += b * t.y, p.wz[k] += b * t.z;
    }
}

void end_contact(Past& past, const Laws& laws, Contacts& c, std::size_t slot, CandidateList* list,
                 bool with_ledger) {
    if (with_ledger) {
        past.heat += heat_so_far(c, slot);
        past.heat.tangential += c.stored_tangential[slot];
        past.heat.rolling += c.stored_rolling[slot];
        // The work that the pair did against adhesion between touch and tear-off, never given back.
        past.heat.tear_off += std::visit(
            [&](const auto& law) {
                return law.energy(c.r_star[slot], c.length_scale[slot], c.tear_off_overlap[slot]);
            },
            laws.normal);
    }
    if (list != nullptr) {
        const int own = c.candidate[slot], of_last = c.candidate.back();
        if (own >= 0) list->slot[static_cast<std::size_t>(own)] = -1;
        if (of_last >= 0 && of_last != own)
            list->slot[static_cast<std::size_t>(of_last)] = static_cast<int>(slot);
    }
    c.remove(slot);
}

void remove_lost(Simulation& s) {
    Particles& p = s.grains;
    std::vector<std::uint8_t> keep;
    for (std::size_t k = 0; k < p.count(); ++k) {
        if (p.fixed(k) || p.z[k] >= s.settings.lost_below) continue;
        if (keep.empty()) keep.assign(p.count(), 1);
        keep[k] = 0;
    }
    if (keep.empty()) return;
    std::vector<int> new_index(p.count());
    int kept = 0;
    for (std::size_t k = 0; k < p.count(); ++k) new_index[k] = kept, kept += keep[k];
    for (Contacts* contacts : {&s.pairs, &s.wall_contacts}) {
        const bool grains_only = contacts == &s.pairs;
        const Laws& laws = grains_only ? s.between_grains : s.at_walls;
        for (std::size_t slot = contacts->count(); slot-- > 0;) {
            const auto i = static_cast<std::size_t>(contacts->i[slot]),
                       j = static_cast<std::size_t>(contacts->j[slot]);
            if (!keep[i] || (grains_only && !keep[j])) {
                if (s.settings.ledger) {
                    s.past.carried_away += stored_energy(laws, *contacts, slot);
                    s.past.heat += heat_so_far(*contacts, slot);
                }
                contacts->remove(slot);
            } else {
                contacts->i[slot] = new_index[i];
                if (grains_only) contacts->j[slot] = new_index[j];
            }
        }
    }
    for (std::size_t k = 0; k < p.count(); ++k) {
        if (keep[k]) continue;
        ++s.past.grains_lost;
        s.past.carried_away += kinetic_energy(p, k);
        s.past.potential_out += potential_of_gravity(s, k);
    }
    p.compact(keep);
    s.neighbours.stale = true;
}

}  // namespace dem_min
