// SPDX-License-Identifier: MIT
// The step as one would explain it at a blackboard. It shares with step.cpp the laws, the motion of one contact, the order of
// memory (`reorder`) and the arrays in which contacts stand, but no cell, no list of candidates, no outbox, no thread.
#include "dem_min/forces.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace dem_min {
namespace {

using Pairs = std::set<std::pair<int, int>>;

Pairs in_contact(const Simulation& s, bool at_walls) {
    Pairs pairs;
    for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
        if (s.at_wall(group) != at_walls) return;
        const int i = c.i[slot], j = c.j[slot];
        pairs.emplace(at_walls || i < j ? std::pair{i, j} : std::pair{j, i});
    });
    return pairs;
}

void begin_all(Simulation& s) {
    const Particles& p = s.grains;
    const Pairs pairs = in_contact(s, false), walls = in_contact(s, true);
    for (std::size_t i = 0; i < p.count(); ++i) {
        for (std::size_t j = i + 1; j < p.count(); ++j) {
            if ((p.fixed(i) && p.fixed(j)) || p.of_one_body(i, j) ||
                pairs.count({static_cast<int>(i), static_cast<int>(j)}) != 0)
                continue;
            const Vec3 way = apart(s, i, j);
            const double reach = p.radius[i] + p.radius[j];
            if (contact::dot(way, way) <= reach * reach) begin_pair(s, i, j);
        }
        for (std::size_t w = 0; w < s.walls.size(); ++w) {
            if (p.fixed(i) || walls.count({static_cast<int>(i), static_cast<int>(w)}) != 0)
                continue;
            if (distance(s.walls[w], p.position(i)).distance <= p.radius[i])
                begin_wall_contact(s, i, w);
        }
    }
}

void add_load(Simulation& s, int grain, Vec3 force, Vec3 torque) {
    const auto t = static_cast<std::size_t>(tile_of(grain));
    Load& sum = s.tiles[t].loads[static_cast<std::size_t>(grain % tile_size)];
    sum.force += Four{force.x, force.y, force.z, 0.0};
    sum.torque += Four{torque.x, torque.y, torque.z, 0.0};
}

}  // namespace

void reference_step(Simulation& s) {
    keep_books_from_afar(s);
    if (time_to_reorder(s)) reorder(s);
    fit_tiles(s);
    begin_bodies(s);
    for (std::size_t t = 0; t < s.tiles.size(); ++t) begin_step(s, t);
    place_members(s);
    move_walls(s, moving_walls(s));
    check_finite(s);
    remove_lost(s);
    begin_all(s);
    ++s.steps;

    for (std::size_t t = 0; t < s.tiles.size(); ++t)
        s.tiles[t].loads.assign(static_cast<std::size_t>(grains_of(s, t)), Load{});
    struct Outgoing {
        int j;
        Vec3 force, torque;
    };
    std::vector<Outgoing> to_other_tiles;  // added last
    for (Tile& tile : s.tiles)
        for (std::size_t group = 0; group < s.groups(); ++group) {
            Contacts& c = tile.groups[group];
            const bool at_wall = s.at_wall(group), books_of_walls = at_wall && s.settings.ledger;
            if (books_of_walls) tile.wall_work += half_step_work_of_walls(s, c);
            std::vector<std::size_t> torn;
            for (std::size_t slot = 0; slot < c.count(); ++slot) {
                Block b;
                at_wall ? gather_walls(s, c, slot, 1, b) : gather_pairs(s, c, slot, 1, b);
                load_block(s.laws(group), c, slot, 1, b, s.settings);
                if (b.hold[0] < 0.0) {
                    torn.push_back(slot);
                    continue;
                }
                const Vec3 on_j{b.fx[0], b.fy[0], b.fz[0]};
                const Vec3 turning_j{b.tjx[0], b.tjy[0], b.tjz[0]};
                add_load(s, c.i[slot], -on_j, {b.tix[0], b.tiy[0], b.tiz[0]});
                if (at_wall) continue;
                if (tile_of(c.i[slot]) == tile_of(c.j[slot]))
                    add_load(s, c.j[slot], on_j, turning_j);
                else
                    to_other_tiles.push_back({c.j[slot], on_j, turning_j});
            }
            for (auto slot = torn.rbegin(); slot != torn.rend(); ++slot) {
                if (s.settings.ledger) tile.ended += heat_of_end(s.laws(group), c, *slot);
                c.remove(*slot);
            }
            if (books_of_walls) tile.wall_work += half_step_work_of_walls(s, c);
        }
    for (const Outgoing& load : to_other_tiles) add_load(s, load.j, load.force, load.torque);
    for (std::size_t t = 0; t < s.tiles.size(); ++t) {
        s.tiles[t].inbox.clear();  // its entries have just been added
        end_step(s, t);
        s.tiles[t].loads.clear();
    }
    end_bodies(s);
    s.list_is_stale = true;  // `step` may follow
    keep_books_from_afar(s);
}

}  // namespace dem_min
