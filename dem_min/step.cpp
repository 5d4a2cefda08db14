// SPDX-License-Identifier: MIT
#include "dem_min/forces.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dem_min {
namespace {

// Loads of all contacts in a list; `motion_of(slot)` gives the motion. A contact beyond its tear-off gets a load too, which
// nobody sees: `end_torn` takes it out before the loads are gathered.
template <class MotionOf>
void load_contacts(const Laws& laws, Contacts& contacts, const Settings& settings, int team,
                   MotionOf&& motion_of) {
    const int count = static_cast<int>(contacts.count());
    const int blocks = (count + block_size - 1) / block_size;
#pragma omp parallel for schedule(static) num_threads(team) if (team > 1)
    for (int b = 0; b < blocks; ++b) {
        MotionBlock motion;
        const int first = b * block_size, size = std::min(block_size, count - first);
        for (int k = 0; k < size; ++k)
            motion.set(k, motion_of(static_cast<std::size_t>(first + k)));
        load_block(laws, contacts, static_cast<std::size_t>(first), size, motion, settings);
    }
}

// New contacts among the candidates, in their order, whatever the number of threads.
template <class Touches>
std::vector<int> find_touching(const CandidateList& list, int threads, Touches&& touches) {
    std::vector<std::vector<int>> parts(static_cast<std::size_t>(threads));
    const int count = static_cast<int>(list.count());
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        std::vector<int>& part = parts[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
        for (int c = 0; c < count; ++c)
            if (list.slot[static_cast<std::size_t>(c)] < 0 && touches(static_cast<std::size_t>(c)))
                part.push_back(c);
    }
    for (std::size_t t = 1; t < parts.size(); ++t)
        parts[0].insert(parts[0].end(), parts[t].begin(), parts[t].end());
    return parts[0];
}

void begin_contact(CandidateList& list, int candidate, Contacts& contacts,
                   const ContactConstants& constants) {
    const auto c = static_cast<std::size_t>(candidate);
    list.slot[c] = static_cast<int>(contacts.count());
    contacts.add(list.i[c], list.j[c], candidate, constants);
}

bool begin_pairs(Simulation& s) {
    const Particles& p = s.grains;
    CandidateList& list = s.neighbours.pairs;
    const std::vector<int> born = find_touching(list, s.team(), [&](std::size_t c) {
        const auto i = static_cast<std::size_t>(list.i[c]), j = static_cast<std::size_t>(list.j[c]);
        const double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i], dz = p.z[j] - p.z[i];
        return dx * dx + dy * dy + dz * dz <= list.reach[c] * list.reach[c];
    });
    for (const int c : born) {
        const auto k = static_cast<std::size_t>(c);
        begin_contact(list, c, s.pairs,
                      pair_constants(s, static_cast<std::size_t>(list.i[k]),
                                     static_cast<std::size_t>(list.j[k])));
    }
    return !born.empty();
}

bool begin_wall_contacts(Simulation& s) {
    CandidateList& list = s.neighbours.walls;
    const std::vector<int> born = find_touching(list, s.team(), [&](std::size_t c) {
        const Vec3 x = s.grains.position(static_cast<std::size_t>(list.i[c]));
        return distance(s.walls[static_cast<std::size_t>(list.j[c])], x).distance <= list.reach[c];
    });
    for (const int c : born)
        begin_contact(
            list, c, s.wall_contacts,
            wall_constants(s, static_cast<std::size_t>(list.i[static_cast<std::size_t>(c)])));
    return !born.empty();
}

bool end_torn(Simulation& s, const Laws& laws, Contacts& contacts, CandidateList& list) {
    bool any = false;
    for (std::size_t slot = contacts.count(); slot-- > 0;) {
        if (contacts.overlap[slot] >= contacts.tear_off_overlap[slot]) continue;
        end_contact(s.past, laws, contacts, slot, &list, s.settings.ledger);
        any = true;
    }
    return any;
}

double gap(const Laws& laws, double r_star) {
    return std::visit(
        [&](const auto& law) { return -law.tear_off_overlap(r_star, law.length_scale(r_star)); },
        laws.normal);
}

void renew_neighbours(Simulation& s) {
    if (!outdated(s.neighbours, s.grains, s.settings.skin, s.team())) return;
    check_finite(s);
    find_neighbours(
        s.neighbours, s.grains, s.walls, s.pairs, s.wall_contacts, s.settings.skin,
        [&](double r_star) { return gap(s.between_grains, r_star); },
        [&](double r_star) { return gap(s.at_walls, r_star); }, s.team());
}

}  // namespace

void step(Simulation& s) {
    kick_and_drift(s);
    remove_lost(s);
    renew_neighbours(s);
    const bool pairs_born = begin_pairs(s), walls_born = begin_wall_contacts(s);
    load_contacts(s.between_grains, s.pairs, s.settings, s.team(), [&](std::size_t slot) {
        return pair_motion(s.grains, static_cast<std::size_t>(s.pairs.i[slot]),
                           static_cast<std::size_t>(s.pairs.j[slot]));
    });
    load_contacts(s.at_walls, s.wall_contacts, s.settings, s.team(), [&](std::size_t slot) {
        const auto i = static_cast<std::size_t>(s.wall_contacts.i[slot]);
        const Wall& wall = s.walls[static_cast<std::size_t>(s.wall_contacts.j[slot])];
        return wall_motion(s.grains, i, distance(wall, s.grains.position(i)));
    });
    if (end_torn(s, s.between_grains, s.pairs, s.neighbours.pairs) || pairs_born)
        s.neighbours.of_pairs = incidence(s.neighbours.pairs, s.grains.count(), true);
    if (end_torn(s, s.at_walls, s.wall_contacts, s.neighbours.walls) || walls_born)
        s.neighbours.of_walls = incidence(s.neighbours.walls, s.grains.count(), false);
    gather_and_kick(s);
    ++s.steps;
}

}  // namespace dem_min
