// SPDX-License-Identifier: MIT
#include "dem_min/forces.hpp"
#include "dem_min/neighbours.hpp"

#include <algorithm>
#include <cstddef>

namespace dem_min {
namespace {

// Calls each(first, last) for the tiles of each thread. A thread always has the same tiles, whose data stay in its cache: given to
// whoever comes first, two threads were no faster than one.
template <class Each>
void for_each_share(Simulation& s, Each&& each) {
    const int team = s.team(), tiles = static_cast<int>(s.tiles.size());
    if (team == 1 || static_cast<int>(s.shares.size()) != team + 1 || s.shares.back() != tiles) {
        each(std::size_t{0}, s.tiles.size());
        return;
    }
#pragma omp parallel for schedule(static, 1) num_threads(team)
    for (int share = 0; share < team; ++share)
        each(static_cast<std::size_t>(s.shares[static_cast<std::size_t>(share)]),
             static_cast<std::size_t>(s.shares[static_cast<std::size_t>(share) + 1]));
}

// Adds the loads of a block to its grains. A contact that has torn loads nobody; its slot goes to `torn`.
void scatter(Simulation& s, std::size_t t, const Contacts& c, bool at_wall, std::size_t first,
             int size, const Block& b, std::vector<std::size_t>& torn) {
    Particles& p = s.grains;
    double *fx = p.fx.data(), *fy = p.fy.data(), *fz = p.fz.data();
    double *tx = p.tx.data(), *ty = p.ty.data(), *tz = p.tz.data();
    const int begin = static_cast<int>(first_of(t)), end = begin + grains_of(s, t);
    for (int k = 0; k < size; ++k) {
        if (b.hold[k] < 0.0) {
            torn.push_back(first + static_cast<std::size_t>(k));
            continue;
        }
        const int i = c.i[first + static_cast<std::size_t>(k)];
        fx[i] -= b.fx[k], fy[i] -= b.fy[k], fz[i] -= b.fz[k];
        tx[i] += b.tix[k], ty[i] += b.tiy[k], tz[i] += b.tiz[k];
        if (at_wall) continue;
        const int j = c.j[first + static_cast<std::size_t>(k)];
        if (j >= begin && j < end) {
            fx[j] += b.fx[k], fy[j] += b.fy[k], fz[j] += b.fz[k];
            tx[j] += b.tjx[k], ty[j] += b.tjy[k], tz[j] += b.tjz[k];
        } else {
            s.tiles[t].outbox.push_back(
                {j, {b.fx[k], b.fy[k], b.fz[k]}, {b.tjx[k], b.tjy[k], b.tjz[k]}});
        }
    }
}

void end_contacts(Simulation& s, std::size_t t, std::size_t group, std::vector<std::size_t>& torn) {
    Tile& tile = s.tiles[t];
    Contacts& c = tile.groups[group];
    for (auto slot = torn.rbegin(); slot != torn.rend(); ++slot) {
        if (s.settings.ledger) tile.ended += heat_of_end(s.laws(group), c, *slot);
        const int i = c.i[*slot], j = c.j[*slot];
        if (s.at_wall(group))
            tile.near_walls.add(i, j, 0.0);
        else if (i < j)
            tile.near_grains.add(i, j, 0.0);
        else  // a pair turned round by `reorder`: it belongs to the tile of j now
            tile.handed_over.emplace_back(j, i);
        c.remove(*slot);
        ++tile.outbox_changes;
    }
    torn.clear();
}

void clear_loads(Simulation& s, std::size_t t) {
    Particles& p = s.grains;
    for (Array* array : {&p.fx, &p.fy, &p.fz, &p.tx, &p.ty, &p.tz})
        std::fill_n(array->begin() + static_cast<std::ptrdiff_t>(first_of(t)), grains_of(s, t),
                    0.0);
}

void load_tile(Simulation& s, std::size_t t) {
    begin_contacts(s, t);
    clear_loads(s, t);
    s.tiles[t].outbox.clear();
    Block block;
    std::vector<std::size_t> torn;
    for (std::size_t group = 0; group < s.groups(); ++group) {
        Contacts& c = s.tiles[t].groups[group];
        const bool at_wall = s.at_wall(group);
        for (std::size_t first = 0; first < c.count(); first += block_size) {
            const int size = static_cast<int>(std::min<std::size_t>(block_size, c.count() - first));
            at_wall ? gather_walls(s, c, first, size, block)
                    : gather_pairs(s, c, first, size, block);
            load_block(s.laws(group), c, first, size, block, s.settings);
            scatter(s, t, c, at_wall, first, size, block, torn);
        }
        if (!torn.empty()) end_contacts(s, t, group, torn);
    }
}

void hand_over(Simulation& s) {
    for (Tile& tile : s.tiles) {
        for (const auto& [i, j] : tile.handed_over)
            s.tiles[static_cast<std::size_t>(tile_of(i))].near_grains.add(i, j, 0.0);
        tile.handed_over.clear();
    }
}

// Finds the tile's entries in the outboxes of its partners, if any of these has begun or ended a contact.
void renew_inbox(Simulation& s, std::size_t t) {
    Tile& tile = s.tiles[t];
    bool changed = false;
    for (std::size_t k = 0; k < tile.partners.size(); ++k) {
        const std::uint64_t now =
            s.tiles[static_cast<std::size_t>(tile.partners[k])].outbox_changes;
        changed = changed || tile.inbox_of[k] != now;
        tile.inbox_of[k] = now;
    }
    if (!changed) return;
    tile.inbox.clear();
    for (const int partner : tile.partners) {
        const std::vector<Outgoing>& outbox = s.tiles[static_cast<std::size_t>(partner)].outbox;
        for (std::size_t k = 0; k < outbox.size(); ++k)
            if (tile_of(outbox[k].j) == static_cast<int>(t))
                tile.inbox.push_back({partner, static_cast<int>(k)});
    }
}

void note(const Simulation& s, Tile& tile, const Drift& drift) {
    tile.way += drift.fastest_in_frame * s.settings.time_step + tile.rounding;
    tile.way_from_walls += drift.fastest * s.settings.time_step + tile.rounding;
    tile.lost = drift.lost, tile.bad = drift.bad;
    tile.fastest = drift.fastest, tile.fastest_spin = drift.fastest_spin;
    tile.sum_of_velocities = drift.sum_of_velocities;
}

// Who sleeps in this step: tiles that have been quiet for long and have only quiet partners. The loads that they hold for others,
// and others for them, stay as they were.
void put_to_sleep(Simulation& s) {
    const Settings& settings = s.settings;
    if (settings.sleep_speed <= 0.0) return;
    for (Tile& tile : s.tiles) {
        if (tile.asleep) continue;
        const bool quiet =
            tile.fastest <= settings.sleep_speed && tile.fastest_spin <= settings.sleep_spin;
        tile.quiet_steps = quiet ? tile.quiet_steps + 1 : 0;
    }
    for (std::size_t t = 0; t < s.tiles.size(); ++t) {
        Tile& tile = s.tiles[t];
        tile.asleep = tile.quiet_steps >= steps_to_sleep &&
                      std::all_of(tile.partners.begin(), tile.partners.end(), [&](int partner) {
                          return s.tiles[static_cast<std::size_t>(partner)].quiet_steps > 0;
                      });
        if (tile.asleep) s.past.grain_steps_slept += grains_of(s, t);
    }
}

// Between the drift and the loads: grains leave, bad numbers are found, the list is renewed.
void look_after(Simulation& s) {
    bool lost = false, bad = false;
    Vec3 sum;
    for (const Tile& tile : s.tiles) {
        lost = lost || tile.lost, bad = bad || tile.bad;
        sum = sum + tile.sum_of_velocities;
    }
    if (bad) check_finite(s);
    s.frame = 1.0 / static_cast<double>(s.grains.count()) * sum;
    if (lost) remove_lost(s);
    s.past.grain_steps += static_cast<std::int64_t>(s.grains.count());
    if (outdated(s)) find_neighbours(s);
    put_to_sleep(s);
}

// The second half of a step for tile t, and the first of the next one if there is one.
void finish_tile(Simulation& s, std::size_t t, bool goes_on) {
    s.tiles[t].finished = true;
    if (s.tiles[t].asleep) return;
    renew_inbox(s, t);
    if (goes_on)
        note(s, s.tiles[t], end_and_begin_step(s, t));
    else
        end_step(s, t);
}

// True if tile t may be finished when [first, loaded) have been loaded, by the thread that has the tiles from `first` on: all that
// look at its grains or load them are among those.
bool ready(const Simulation& s, std::size_t t, std::size_t first, std::size_t loaded) {
    const std::vector<int>& partners = s.tiles[t].partners;
    return partners.empty() || (static_cast<std::size_t>(partners.front()) >= first &&
                                static_cast<std::size_t>(partners.back()) < loaded);
}

// Loads of the tiles [first, last), each of which is finished as soon as it may be, while its grains are still in the cache.
void load_share(Simulation& s, std::size_t first, std::size_t last, bool goes_on) {
    std::size_t next = first;
    for (std::size_t t = first; t < last; ++t) {
        if (!s.tiles[t].asleep) load_tile(s, t);
        s.tiles[t].finished = false;
        for (; next <= t && ready(s, next, first, t + 1); ++next) finish_tile(s, next, goes_on);
        while (next <= t && !s.tiles[next].partners.empty() &&
               (static_cast<std::size_t>(s.tiles[next].partners.front()) < first ||
                static_cast<std::size_t>(s.tiles[next].partners.back()) >= last))
            ++next;  // another thread's tiles must be loaded first
    }
}

}  // namespace

void advance(Simulation& s, std::int64_t steps) {
    bool begun =
        false;  // the end of one step and the beginning of the next are one walk over the grains
    for (std::int64_t done = 0; done < steps; ++done) {
        if (time_to_reorder(s)) reorder(s);
        fit_tiles(s);
        if (!begun)
            for_each_share(s, [&](std::size_t first, std::size_t last) {
                for (std::size_t t = first; t < last; ++t)
                    if (!s.tiles[t].asleep) note(s, s.tiles[t], begin_step(s, t));
            });
        look_after(s);
        ++s.steps;
        begun = done + 1 < steps && !time_to_reorder(s);
        for_each_share(
            s, [&](std::size_t first, std::size_t last) { load_share(s, first, last, begun); });
        hand_over(s);
        for_each_share(s, [&](std::size_t first, std::size_t last) {
            for (std::size_t t = first; t < last; ++t)
                if (!s.tiles[t].finished) finish_tile(s, t, begun);
        });
    }
}

void step(Simulation& s) { advance(s, 1); }

}  // namespace dem_min
