// SPDX-License-Identifier: MIT
// The step as one would explain it at a blackboard. It shares with step.cpp the laws, the motion of one contact and the
// sums of gather_and_kick, but no cell, no candidate list, no thread.
#include "dem_min/forces.hpp"

#include <cstddef>
#include <map>
#include <utility>

namespace dem_min {
namespace {

using Slots = std::map<std::pair<int, int>, int>;

Slots slots_of(const Contacts& contacts, bool wall_major) {
    Slots slots;
    for (std::size_t c = 0; c < contacts.count(); ++c) {
        const std::pair key{contacts.i[c], contacts.j[c]};
        slots[wall_major ? std::pair{key.second, key.first} : key] = static_cast<int>(c);
    }
    return slots;
}

// All contacts as a candidate list in canonical order, for `incidence`.
CandidateList in_order(const Slots& slots, bool wall_major) {
    CandidateList list;
    for (const auto& [key, slot] : slots) {
        list.i.push_back(wall_major ? key.second : key.first);
        list.j.push_back(wall_major ? key.first : key.second);
        list.slot.push_back(slot);
    }
    return list;
}

template <class MotionOf>
void load_all(Simulation& s, Contacts& contacts, const Laws& laws, MotionOf&& motion_of) {
    for (std::size_t slot = contacts.count(); slot-- > 0;) {
        MotionBlock motion;
        motion.set(0, motion_of(slot));
        load_block(laws, contacts, slot, 1, motion, s.settings);
        if (contacts.overlap[slot] < contacts.tear_off_overlap[slot])
            end_contact(s.past, laws, contacts, slot, nullptr, s.settings.ledger);
    }
}

}  // namespace

void reference_step(Simulation& s) {
    kick_and_drift(s);
    check_finite(s);
    remove_lost(s);
    const Particles& p = s.grains;
    Slots pairs = slots_of(s.pairs, false), walls = slots_of(s.wall_contacts, true);
    for (std::size_t i = 0; i < p.count(); ++i)
        for (std::size_t j = i + 1; j < p.count(); ++j) {
            if ((p.fixed(i) && p.fixed(j)) ||
                pairs.count({static_cast<int>(i), static_cast<int>(j)}) != 0)
                continue;
            const double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i], dz = p.z[j] - p.z[i];
            const double reach = p.radius[i] + p.radius[j];
            if (dx * dx + dy * dy + dz * dz <= reach * reach)
                s.pairs.add(static_cast<int>(i), static_cast<int>(j), 0, pair_constants(s, i, j));
        }
    for (std::size_t w = 0; w < s.walls.size(); ++w)
        for (std::size_t i = 0; i < p.count(); ++i) {
            if (p.fixed(i) || walls.count({static_cast<int>(w), static_cast<int>(i)}) != 0)
                continue;
            if (distance(s.walls[w], p.position(i)).distance <= p.radius[i])
                s.wall_contacts.add(static_cast<int>(i), static_cast<int>(w), 0,
                                    wall_constants(s, i));
        }
    load_all(s, s.pairs, s.between_grains, [&](std::size_t slot) {
        return pair_motion(p, static_cast<std::size_t>(s.pairs.i[slot]),
                           static_cast<std::size_t>(s.pairs.j[slot]));
    });
    load_all(s, s.wall_contacts, s.at_walls, [&](std::size_t slot) {
        const auto i = static_cast<std::size_t>(s.wall_contacts.i[slot]);
        return wall_motion(
            p, i,
            distance(s.walls[static_cast<std::size_t>(s.wall_contacts.j[slot])], p.position(i)));
    });
    s.neighbours.of_pairs = incidence(in_order(slots_of(s.pairs, false), false), p.count(), true);
    s.neighbours.of_walls =
        incidence(in_order(slots_of(s.wall_contacts, true), true), p.count(), false);
    gather_and_kick(s);
    s.neighbours.stale = true;  // `step` may follow
    ++s.steps;
}

}  // namespace dem_min
