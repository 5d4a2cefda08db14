// SPDX-License-Identifier: MIT
#include "dem_min/forces.hpp"
#include "dem_min/neighbours.hpp"
#include "dem_min/shares.hpp"
#include "dem_min/vector_clones.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace dem_min {
namespace {

// Calls each(spare, take) in every thread; take() gives one tile after another to it, and -1 at the end.
template <class Each>
void share(Simulation& s, Each&& each) {
    const int team = s.team(), tiles = static_cast<int>(s.tiles.size());
    if (team == 1) {  // a few grains take less time than the words with other threads
        each(s.spare.front(), [next = 0, tiles]() mutable { return next < tiles ? next++ : -1; });
        return;
    }
    if (static_cast<int>(s.shares.size()) != team + 1 || s.shares.back() != tiles) {
        s.shares.assign(static_cast<std::size_t>(team) + 1,
                        tiles);  // all to the first, until the list is renewed
        s.shares.front() = 0;
    }
    Shares shares(s.shares);
#pragma omp parallel for schedule(static, 1) num_threads(team)
    for (int thread = 0; thread < team; ++thread)
        each(s.spare[static_cast<std::size_t>(thread)],
             [&shares, thread] { return shares.take(thread); });
}

// A step walks through the histories of the contacts once, along nine arrays: too many for the processor to follow by itself from
// one page to the next. Pairs are asked for a block earlier, since their grains are asked for through them.
inline void ask_for_histories(const Contacts& c, std::size_t slot) {
    if (slot >= c.count()) return;
    for (const Array* array : {&c.sx, &c.sy, &c.sz, &c.rx, &c.ry, &c.rz, &c.previous_radius})
        __builtin_prefetch(array->data() + slot, 1);
    if (slot + block_size >= c.count()) return;
    for (const std::vector<int>* pair : {&c.i, &c.j})
        __builtin_prefetch(pair->data() + slot + block_size);
}

// Adds the loads of a block to its grains. A contact that has torn loads nobody; its slot goes to `torn`.
SIMILITUDE_VECTOR_CLONES void scatter(Tile& tile, int begin, int grains, const Contacts& c,
                                      bool at_wall, std::size_t first, int size, const Block& b,
                                      std::vector<std::size_t>& torn) {
    Load* const sum = tile.loads.data();
    const int *from = c.i.data() + first, *to = c.j.data() + first;
    for (int k = 0; k < size; ++k) {
        if (k % asked_at_a_time == 0)
            ask_for_histories(c, first + static_cast<std::size_t>(k) + block_size);
        if (b.hold[k] < 0.0) {
            torn.push_back(first + static_cast<std::size_t>(k));
            continue;
        }
        const Four force{b.fx[k], b.fy[k], b.fz[k], 0.0};
        Load& on_i = sum[from[k] - begin];
        on_i.force -= force;
        on_i.torque += Four{b.tix[k], b.tiy[k], b.tiz[k], 0.0};
        if (at_wall) continue;
        const Four torque{b.tjx[k], b.tjy[k], b.tjz[k], 0.0};
        const int j = to[k] - begin;
        if (j >= 0 && j < grains) {
            sum[j].force += force;
            sum[j].torque += torque;
        } else {
            tile.outbox.loads.push_back({force, torque});
            tile.outbox.to.push_back(to[k]);
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
        tile.slots_have_moved = true;
    }
    torn.clear();
}

template <class T>
void take(std::vector<std::vector<T>>& spare, std::vector<T>& piece) {
    if (piece.capacity() > 0 || spare.empty()) return;
    piece = std::move(spare.back());
    spare.pop_back();
}

template <class T>
void give_back(std::vector<std::vector<T>>& spare, std::vector<T>& piece) {
    if (piece.capacity() > 0) spare.push_back(std::move(piece));
}

void load_tile(Simulation& s, std::size_t t, Spare& spare) {
    begin_contacts(s, t);
    Tile& tile = s.tiles[t];
    take(spare.loads, tile.loads);
    take(spare.outboxes, tile.outbox.loads);
    const int begin = static_cast<int>(first_of(t)), grains = grains_of(s, t);
    tile.loads.assign(static_cast<std::size_t>(grains), Load{});
    tile.outbox.loads.clear();
    tile.outbox.to.clear();
    tile.outbox_changes += tile.slots_have_moved;
    tile.slots_have_moved = false;
    Block block;
    std::vector<std::size_t> torn;
    for (std::size_t group = 0; group < s.groups(); ++group) {
        Contacts& c = tile.groups[group];
        const bool at_wall = s.at_wall(group), books_of_walls = at_wall && s.settings.ledger;
        if (books_of_walls) tile.wall_work += half_step_work_of_walls(s, c);
        for (std::size_t first = 0; first < c.count(); first += block_size) {
            const int size = static_cast<int>(std::min<std::size_t>(block_size, c.count() - first));
            at_wall ? gather_walls(s, c, first, size, block)
                    : gather_pairs(s, c, first, size, block);
            load_block(s.laws(group), c, first, size, block, s.settings);
            scatter(tile, begin, grains, c, at_wall, first, size, block, torn);
        }
        if (!torn.empty()) end_contacts(s, t, group, torn);
        if (books_of_walls) tile.wall_work += half_step_work_of_walls(s, c);
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
        const std::vector<int>& to = s.tiles[static_cast<std::size_t>(partner)].outbox.to;
        for (std::size_t k = 0; k < to.size(); ++k)
            if (tile_of(to[k]) == static_cast<int>(t))
                tile.inbox.push_back({partner, static_cast<int>(k), to[k] % tile_size});
    }
}

void note(const Simulation& s, Tile& tile, const Drift& drift) {
    tile.way += drift.fastest_in_frame * s.settings.time_step + tile.rounding;
    tile.way_from_walls += drift.fastest * s.settings.time_step + tile.rounding;
    tile.lost = drift.lost, tile.bad = drift.bad;
    tile.fastest = drift.fastest, tile.fastest_spin = drift.fastest_spin;
    tile.sum_of_velocities = drift.sum_of_velocities;
}

template <class Is>
bool all_partners(const Simulation& s, const Tile& tile, Is&& is) {
    return std::all_of(tile.partners.begin(), tile.partners.end(),
                       [&](int partner) { return is(s.tiles[static_cast<std::size_t>(partner)]); });
}

// Who falls asleep stops: a velocity without a way would stretch the springs of those that touch it, and rest would never be seen.
void stop(Simulation& s, std::size_t t) {
    Particles& p = s.grains;
    const std::size_t first = first_of(t), last = first + static_cast<std::size_t>(grains_of(s, t));
    for (std::size_t k = first; k < last; ++k) s.past.carried_away += kinetic_energy(p, k);
    for (Array* array : {&p.vx, &p.vy, &p.vz, &p.wx, &p.wy, &p.wz})
        std::fill(array->begin() + static_cast<std::ptrdiff_t>(first),
                  array->begin() + static_cast<std::ptrdiff_t>(last), 0.0);
    s.tiles[t].sum_of_velocities = {};
}

// Who sleeps in this step: tiles that have been quiet for long and have only quiet partners. Their grains are held; what pushes
// awake ones is evaluated as ever, and only a tile all of whose partners sleep is left out.
void put_to_sleep(Simulation& s, bool base_moves) {
    const Settings& settings = s.settings;
    if (settings.sleep_speed <= 0.0) return;
    if (base_moves) {  // into the heap, or away from under it: nobody is left out
        for (Tile& tile : s.tiles) tile.asleep = tile.left_out = false, tile.quiet_steps = 0;
        return;
    }
    for (Tile& tile : s.tiles) {
        if (tile.asleep) continue;
        const bool quiet =
            tile.fastest <= settings.sleep_speed && tile.fastest_spin <= settings.sleep_spin;
        tile.quiet_steps = quiet ? tile.quiet_steps + 1 : 0;
    }
    for (std::size_t t = 0; t < s.tiles.size(); ++t) {
        Tile& tile = s.tiles[t];
        const bool slept = tile.asleep;
        tile.asleep =
            tile.quiet_steps >= steps_to_sleep &&
            all_partners(s, tile, [](const Tile& other) { return other.quiet_steps > 0; });
        if (tile.asleep && !slept) stop(s, t);
        if (!tile.asleep && slept)
            tile.quiet_steps = 1;  // it has to be quiet for long again, and wakes nobody by that
    }
    for (std::size_t t = 0; t < s.tiles.size(); ++t) {
        Tile& tile = s.tiles[t];
        tile.left_out =
            tile.asleep && all_partners(s, tile, [](const Tile& other) { return other.asleep; });
        if (tile.left_out) s.past.grain_steps_slept += grains_of(s, t);
    }
}

// Between the drift and the loads: grains leave, bad numbers are found, the list is renewed.
void look_after(Simulation& s, bool base_moves) {
    bool lost = false, bad = false;
    Vec3 sum;
    for (const Tile& tile : s.tiles) {
        lost = lost || tile.lost, bad = bad || tile.bad;
        sum = sum + tile.sum_of_velocities;
    }
    if (bad) check_finite(s);
    s.frame = 1.0 / static_cast<double>(s.grains.count()) * sum;
    for (const Body& body : s.bodies) lost = lost || body.centre.z < s.settings.lost_below;
    if (lost) remove_lost(s);
    s.past.grain_steps += static_cast<std::int64_t>(s.grains.count());
    if (outdated(s)) find_neighbours(s);
    put_to_sleep(s, base_moves);
}

// The second half of a step for tile t, and the first of the next one if there is one.
void finish_tile(Simulation& s, std::size_t t, bool goes_on, Spare& spare) {
    s.tiles[t].finished = true;
    if (s.tiles[t].asleep) return give_back(spare.loads, s.tiles[t].loads);
    renew_inbox(s, t);
    if (goes_on)
        note(s, s.tiles[t], end_and_begin_step(s, t));
    else
        end_step(s, t);
    give_back(spare.loads, s.tiles[t].loads);
}

// The tiles [first, last) that one thread has loaded, and those of them that it has yet to finish, or whose outbox is in use.
struct Loaded {
    int first = 0, last = 0;
    std::vector<int> open, in_use;

    void add(int t) {
        if (first == last)
            first = t, last = t + 1;
        else if (t == last)
            ++last;
        else if (t == first - 1)
            --first;
        else
            return;  // taken from another thread, which has its partners
        open.push_back(t);
    }
    // All that look at the grains of a tile or load them are among the tiles loaded.
    bool has_partners(const Tile& tile) const {
        return tile.partners.empty() ||
               (tile.partners.front() >= first && tile.partners.back() < last);
    }
};

// Takes and loads tiles, each of which is finished as soon as it may be, while its grains are still in the cache.
template <class Take>
void load_tiles(Simulation& s, Spare& spare, Take&& take_tile, bool goes_on) {
    const bool tiles_may_sleep = s.settings.sleep_speed > 0.0;  // their outboxes are read for long
    const auto tile = [&](int t) -> Tile& { return s.tiles[static_cast<std::size_t>(t)]; };
    Loaded loaded;
    for (int t = take_tile(); t >= 0; t = take_tile()) {
        if (!tile(t).left_out) load_tile(s, static_cast<std::size_t>(t), spare);
        loaded.add(t);
        std::erase_if(loaded.open, [&](int k) {
            if (!loaded.has_partners(tile(k))) return false;
            finish_tile(s, static_cast<std::size_t>(k), goes_on, spare);
            loaded.in_use.push_back(k);
            return true;
        });
        if (tiles_may_sleep) continue;
        std::erase_if(loaded.in_use, [&](int k) {
            if (!all_partners(s, tile(k), [](const Tile& other) { return other.finished; }))
                return false;
            give_back(spare.outboxes, tile(k).outbox.loads);
            return true;
        });
    }
}

}  // namespace

void advance(Simulation& s, std::int64_t steps) {
    bool begun =
        false;  // the end of one step and the beginning of the next are one walk over the grains
    s.spare.resize(std::max(s.spare.size(), static_cast<std::size_t>(s.team())));
    const std::vector<Wall*> moving = moving_walls(s);
    const bool books = has_books_from_afar(s);  // they want the velocities between two steps
    refuse_sleep_of_bodies(s);
    for (std::int64_t done = 0; done < steps; ++done) {
        if (books) keep_books_from_afar(s);
        if (time_to_reorder(s)) reorder(s);
        fit_tiles(s);
        begin_bodies(s);
        if (!begun)
            share(s, [&](Spare&, auto&& take_tile) {
                for (int t = take_tile(); t >= 0; t = take_tile())
                    if (Tile& tile = s.tiles[static_cast<std::size_t>(t)]; !tile.asleep)
                        note(s, tile, begin_step(s, static_cast<std::size_t>(t)));
            });
        place_members(s);
        move_walls(s, moving);
        look_after(s, !moving.empty() || s.settings.shaking.acts());
        ++s.steps;
        // Members go on when all their loads are there.
        begun = done + 1 < steps && !time_to_reorder(s) && !books && s.bodies.empty();
        for (Tile& tile : s.tiles) tile.finished = false;
        share(s, [&](Spare& spare, auto&& take_tile) { load_tiles(s, spare, take_tile, begun); });
        hand_over(s);
        share(s, [&](Spare& spare, auto&& take_tile) {
            for (int t = take_tile(); t >= 0; t = take_tile())
                if (!s.tiles[static_cast<std::size_t>(t)].finished)
                    finish_tile(s, static_cast<std::size_t>(t), begun, spare);
        });
        end_bodies(s);
        if (books) keep_books_from_afar(s);
    }
}

void step(Simulation& s) { advance(s, 1); }

}  // namespace dem_min
