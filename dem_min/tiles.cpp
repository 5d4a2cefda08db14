// SPDX-License-Identifier: MIT
#include "dem_min/tiles.hpp"

#include "dem_min/simulation.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

namespace dem_min {
namespace {

// Where a grain stands in memory: layer by layer along the longest side of the heap, row by row in a layer. A tile then meets
// few others, all of them near it in memory, and its grains are still in the cache when the last of these has been loaded.
// Where quiet tiles sleep, layers lie one above the other: a heap is quiet below and flows on top.
std::vector<std::uint64_t> places(const Particles& p, bool from_below) {
    const double width = 2.0 * *std::max_element(p.radius.begin(), p.radius.end());
    struct Side {
        const Array* x;
        double low, length;
    };
    std::array<Side, 3> sides;
    for (int axis = 0; axis < 3; ++axis) {
        const Array& x = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
        const auto [low, high] = std::minmax_element(x.begin(), x.end());
        sides[static_cast<std::size_t>(axis)] = {&x, *low, *high - *low};
    }
    if (from_below) std::swap(sides[0], sides[2]);
    std::stable_sort(sides.begin() + (from_below ? 1 : 0), sides.end(),
                     [](const Side& a, const Side& b) { return a.length > b.length; });
    std::vector<std::uint64_t> codes(p.count(), 0);
    for (const Side& side : sides)
        for (std::size_t k = 0; k < p.count(); ++k) {
            const double cell = std::min(((*side.x)[k] - side.low) / width, 2097151.0);  // 21 bits
            codes[k] = codes[k] << 21 | static_cast<std::uint64_t>(cell);
        }
    return codes;
}

}  // namespace

void Candidates::add(int grain_i, int partner_j, double when) {
    i.push_back(grain_i), j.push_back(partner_j), due.push_back(when);
}

void Candidates::remove(std::size_t index) {
    i[index] = i.back(), i.pop_back();
    j[index] = j.back(), j.pop_back();
    due[index] = due.back(), due.pop_back();
}

void Candidates::clear() { i.clear(), j.clear(), due.clear(); }

std::size_t Tile::contacts() const {
    std::size_t sum = 0;
    for (const Contacts& group : groups) sum += group.count();
    return sum;
}

void fit_tiles(Simulation& s) {
    const std::size_t needed = (s.grains.count() + tile_size - 1) / tile_size;
    if (s.tiles.size() < needed) s.tiles.resize(needed);
    for (Tile& tile : s.tiles) tile.groups.resize(s.groups());
}

void renumber(Simulation& s, const std::vector<int>& new_index, bool by_grain) {
    s.grains.renumber(new_index);
    renumber_bodies(s, new_index);
    std::vector<Tile> old = std::move(s.tiles);
    s.tiles.clear();
    fit_tiles(s);
    // A tile that was quiet is looked at once more, with the grains that it has now, and may sleep again.
    for (std::size_t t = 0; t < s.tiles.size() && t < old.size(); ++t)
        s.tiles[t].quiet_steps = std::min(old[t].quiet_steps, steps_to_sleep - 1);
    std::vector<std::vector<std::vector<Contacts::Copy>>> copies(s.tiles.size());  // [tile][group]
    for (auto& of_tile : copies) of_tile.resize(s.groups());
    for (const Tile& tile : old) {
        s.past.heat += tile.ended;
        s.past.wall_work += tile.wall_work;
        for (std::size_t g = 0; g < tile.groups.size(); ++g) {
            const Contacts& from = tile.groups[g];
            for (std::size_t slot = 0; slot < from.count(); ++slot) {
                const int i = new_index[static_cast<std::size_t>(from.i[slot])];
                const int j =
                    s.at_wall(g) ? from.j[slot] : new_index[static_cast<std::size_t>(from.j[slot])];
                if (i < 0 || j < 0) continue;
                copies[static_cast<std::size_t>(tile_of(i))][g].push_back({i, j, &from, slot});
            }
        }
    }
    const int tiles = static_cast<int>(s.tiles.size()), team = s.team();
#pragma omp parallel for schedule(static) num_threads(team) if (team > 1)
    for (int index = 0; index < tiles; ++index) {
        const auto t = static_cast<std::size_t>(index);
        for (std::size_t g = 0; g < s.groups(); ++g) {
            std::vector<Contacts::Copy>& group = copies[t][g];
            if (by_grain)
                std::sort(group.begin(), group.end(), [](const auto& a, const auto& b) {
                    return std::pair{a.i, a.j} < std::pair{b.i, b.j};
                });
            s.tiles[t].groups[g].append(group);
        }
    }
    s.list_is_stale = true;
}

void reorder(Simulation& s) {
    const std::size_t n = s.grains.count();
    if (n <= tile_size) return;
    const std::vector<std::uint64_t> codes = places(s.grains, s.settings.sleep_speed > 0.0);
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return codes[static_cast<std::size_t>(a)] < codes[static_cast<std::size_t>(b)];
    });
    std::vector<int> new_index(n);
    for (std::size_t k = 0; k < n; ++k)
        new_index[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    renumber(s, new_index, true);
}

}  // namespace dem_min
