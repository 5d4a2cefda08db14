// SPDX-License-Identifier: MIT
#include "dem_min/neighbours.hpp"

#include "dem_min/forces.hpp"
#include "dem_min/vector_clones.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dem_min {
namespace {

// Ways are sums of thousands of roundings; what is left of a gap is taken this much shorter than it is.
constexpr double caution = 0.999;

// Steps that a list should last. More of them widen the margins, and with them the list; measured on the bed of `bench`.
constexpr double steps_of_a_list = 100.0;

struct Axis {
    double origin = 0.0, width = 1.0;  // m
    int cells = 1;
    double period = 0.0;  // m, 0: open

    int cell(double x) const {
        const double from = x - origin;
        const double folded = period > 0.0 ? from - period * std::floor(from / period) : from;
        return std::min(static_cast<int>(folded / width), cells - 1);
    }
    // Cells around cell c, each once: {first, how many}; where the axis is periodic they are to be wrapped.
    std::pair<int, int> around(int c) const {
        if (period > 0.0) return cells < 3 ? std::pair{0, cells} : std::pair{c - 1 + cells, 3};
        const int first = std::max(0, c - 1);
        return {first, std::min(cells - 1, c + 1) - first + 1};
    }
};

Axis make_axis(const Array& x, double width, double period) {
    if (period > 0.0) {
        const int cells = std::max(1, static_cast<int>(period / width));
        return {0.0, period / cells, cells, period};
    }
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    return {*low, width, static_cast<int>(std::min((*high - *low) / width, 1e9)) + 1, 0.0};
}

// The grains of one class of sizes in a dense grid. Cells are at least as wide as the longest reach, so that 27 suffice.
struct Grid {
    Axis x, y, z;
    std::vector<int> begin, grain;  // grains of cell c: grain[begin[c] .. begin[c + 1])

    std::size_t cell(int cx, int cy, int cz) const {
        return (static_cast<std::size_t>(cz) * static_cast<std::size_t>(y.cells) +
                static_cast<std::size_t>(cy)) *
                   static_cast<std::size_t>(x.cells) +
               static_cast<std::size_t>(cx);
    }
    std::size_t cell_at(const Particles& p, std::size_t k) const {
        return cell(x.cell(p.x[k]), y.cell(p.y[k]), z.cell(p.z[k]));
    }
};

Grid make_grid(const Simulation& s, const std::vector<int>& members, double width) {
    const Particles& p = s.grains;
    Grid grid;
    // A few far grains must not cost memory: cells grow until they are not many more than the grains.
    const double most = 8.0 * static_cast<double>(members.size()) + 64.0;
    do {
        grid.x = make_axis(p.x, width, s.settings.period_x);
        grid.y = make_axis(p.y, width, s.settings.period_y);
        grid.z = make_axis(p.z, width, 0.0);
        width *= 2.0;
    } while (static_cast<double>(grid.x.cells) * grid.y.cells * grid.z.cells > most &&
             grid.x.cells + grid.y.cells + grid.z.cells > 3);
    const std::size_t cells = grid.cell(grid.x.cells - 1, grid.y.cells - 1, grid.z.cells - 1) + 1;
    grid.begin.assign(cells + 1, 0);
    std::vector<std::size_t> cell_of(members.size());
    for (std::size_t m = 0; m < members.size(); ++m) {
        cell_of[m] = grid.cell_at(p, static_cast<std::size_t>(members[m]));
        ++grid.begin[cell_of[m] + 1];
    }
    for (std::size_t c = 0; c < cells; ++c) grid.begin[c + 1] += grid.begin[c];
    grid.grain.resize(members.size());
    std::vector<int> next(grid.begin.begin(), grid.begin.end() - 1);
    for (std::size_t m = 0; m < members.size(); ++m)
        grid.grain[static_cast<std::size_t>(next[cell_of[m]]++)] = members[m];
    return grid;
}

// Calls visit(j) for each grain in the cells around grain i.
template <class Visit>
void visit_near(const Grid& grid, const Particles& p, std::size_t i, Visit&& visit) {
    const auto [x, nx] = grid.x.around(grid.x.cell(p.x[i]));
    const auto [y, ny] = grid.y.around(grid.y.cell(p.y[i]));
    const auto [z, nz] = grid.z.around(grid.z.cell(p.z[i]));
    for (int cz = z; cz < z + nz; ++cz)
        for (int cy = y; cy < y + ny; ++cy)
            for (int cx = x; cx < x + nx; ++cx) {
                const std::size_t c =
                    grid.cell(cx % grid.x.cells, cy % grid.y.cells, cz % grid.z.cells);
                for (int at = grid.begin[c]; at < grid.begin[c + 1]; ++at)
                    visit(grid.grain[static_cast<std::size_t>(at)]);
            }
}

// Classes of sizes, each half as wide as the one before: a small grain among large ones then looks at few of them, and a large
// one never looks for small ones.
struct Classes {
    std::vector<Grid> grids;
    std::vector<int> of;  // [grains]
};

Classes make_classes(const Simulation& s, double widest_margin) {
    const Particles& p = s.grains;
    const double largest = *std::max_element(p.radius.begin(), p.radius.end());
    constexpr int most = 8;
    std::vector<std::vector<int>> members(most);
    Classes classes;
    classes.of.resize(p.count());
    for (std::size_t k = 0; k < p.count(); ++k) {
        int size = 0;
        for (double r = 0.5 * largest; size < most - 1 && p.radius[k] <= r; r *= 0.5) ++size;
        classes.of[k] = size;
        members[static_cast<std::size_t>(size)].push_back(static_cast<int>(k));
    }
    double r = largest;
    for (const std::vector<int>& grains : members) {
        classes.grids.push_back(grains.empty() ? Grid{}
                                               : make_grid(s, grains, 2.0 * (r + widest_margin)));
        r *= 0.5;
    }
    return classes;
}

// All contact partners of each grain: partner[begin[k] .. begin[k + 1]).
struct Partners {
    std::vector<int> begin, partner;
    bool has(std::size_t k, int other) const {
        for (int at = begin[k]; at < begin[k + 1]; ++at)
            if (partner[static_cast<std::size_t>(at)] == other) return true;
        return false;
    }
};

template <class EachContact>
Partners partners(std::size_t grains, EachContact&& each_contact) {
    Partners result;
    result.begin.assign(grains + 1, 0);
    each_contact([&](int k, int) { ++result.begin[static_cast<std::size_t>(k) + 1]; });
    for (std::size_t k = 0; k < grains; ++k) result.begin[k + 1] += result.begin[k];
    result.partner.resize(static_cast<std::size_t>(result.begin[grains]));
    std::vector<int> next(result.begin.begin(), result.begin.end() - 1);
    each_contact([&](int k, int other) {
        result.partner[static_cast<std::size_t>(next[static_cast<std::size_t>(k)]++)] = other;
    });
    return result;
}

void choose_margins(Simulation& s) {
    const Particles& p = s.grains;
    const double dt = s.settings.time_step, skin = s.settings.skin;
    for (std::size_t t = 0; t < s.tiles.size(); ++t) {
        const std::size_t first = t * tile_size, last = std::min(first + tile_size, p.count());
        double v2 = 0.0, farthest = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            const Vec3 v = p.velocity(k) - s.frame;
            v2 = std::max(v2, contact::dot(v, v));
            for (const double x : {p.x[k], p.y[k], p.z[k]})
                farthest = std::max(farthest, std::abs(x));
        }
        const double way = std::sqrt(v2) * dt * steps_of_a_list;
        s.tiles[t].margin = std::clamp(way, 0.25 * skin, 2.0 * skin);
        s.tiles[t].margin_to_walls =
            4.0 * skin;  // few grains are near, so that a wide one costs little
        s.tiles[t].way = s.tiles[t].way_from_walls = 0.0;
        s.tiles[t].rounding = 0x1p-51 * farthest;  // two units in the last place
    }
}

constexpr double contact_cost =
    1.2;  // of a contact over that of a grain, measured on the bed of `bench`

// Runs of tiles that cost about the same, one for each thread.
void share_out(Simulation& s) {
    std::vector<double> cost;  // of all tiles up to this one
    double sum = 0.0;
    for (std::size_t t = 0; t < s.tiles.size(); ++t)
        cost.push_back(sum +=
                       grains_of(s, t) + contact_cost * static_cast<double>(s.tiles[t].contacts()));
    s.shares.assign(1, 0);
    for (int share = 1; share < s.team(); ++share) {
        const auto cut = std::lower_bound(cost.begin(), cost.end(), sum * share / s.team());
        s.shares.push_back(std::max(s.shares.back(), static_cast<int>(cut - cost.begin()) + 1));
    }
    s.shares.push_back(static_cast<int>(s.tiles.size()));
}

struct Found {
    int i, j;
    double gap;  // m, between the surfaces
};

void search(const Simulation& s, const Classes& classes, const Partners& touching, std::size_t t,
            std::vector<Found>& found) {
    const Particles& p = s.grains;
    const std::size_t first = t * tile_size, last = std::min(first + tile_size, p.count());
    for (std::size_t i = first; i < last; ++i) {
        const int size = classes.of[i];
        const double own = p.radius[i] + s.tiles[t].margin;
        for (int larger = 0; larger <= size; ++larger) {
            if (classes.grids[static_cast<std::size_t>(larger)].grain.empty()) continue;
            visit_near(classes.grids[static_cast<std::size_t>(larger)], p, i, [&](int other) {
                const auto j = static_cast<std::size_t>(other);
                if (larger == size && j <= i) return;
                const Vec3 way = apart(s, i, j);
                const double d2 = contact::dot(way, way);
                const double reach = own + p.radius[j] + s.tiles[j / tile_size].margin;
                if (d2 > reach * reach || (p.fixed(i) && p.fixed(j)) || p.of_one_body(i, j) ||
                    touching.has(i, other))
                    return;
                const double gap = std::sqrt(d2) - (p.radius[i] + p.radius[j]);
                found.push_back(
                    {static_cast<int>(std::min(i, j)), static_cast<int>(std::max(i, j)), gap});
            });
        }
    }
}

void search_walls(Simulation& s, const Partners& touching, std::size_t t) {
    const Particles& p = s.grains;
    Tile& tile = s.tiles[t];
    const std::size_t first = t * tile_size, last = std::min(first + tile_size, p.count());
    for (std::size_t i = first; i < last; ++i) {
        if (p.fixed(i)) continue;
        for (std::size_t w = 0; w < s.walls.size(); ++w) {
            const double gap = clearance(s.walls[w], p.position(i)) - p.radius[i];
            if (gap > tile.margin_to_walls || touching.has(i, static_cast<int>(w))) continue;
            tile.near_walls.add(static_cast<int>(i), static_cast<int>(w), caution * gap);
        }
    }
}

void find_partner_tiles(Simulation& s) {
    std::vector<std::vector<int>> of(s.tiles.size());
    const auto join = [&](int i, int j) {
        const int a = tile_of(i), b = tile_of(j);
        if (a == b) return;
        auto &at_a = of[static_cast<std::size_t>(a)], &at_b = of[static_cast<std::size_t>(b)];
        if (std::find(at_a.begin(), at_a.end(), b) != at_a.end()) return;
        at_a.push_back(b), at_b.push_back(a);
    };
    for (const Tile& tile : s.tiles)
        for (std::size_t c = 0; c < tile.near_grains.count(); ++c)
            join(tile.near_grains.i[c], tile.near_grains.j[c]);
    for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
        if (!s.at_wall(group)) join(c.i[slot], c.j[slot]);
    });
    for (std::size_t t = 0; t < s.tiles.size(); ++t) {
        std::sort(of[t].begin(), of[t].end());
        s.tiles[t].partners = of[t];
        s.tiles[t].inbox_of.assign(of[t].size(), 0);
        ++s.tiles[t].outbox_changes;
    }
}

// Indices of the candidates that must be looked at. Most need not be: they are passed over many at a time, and what is left is
// listed without a branch.
SIMILITUDE_VECTOR_CLONES int list_due(const double* due, int count, double way, int* listed) {
    constexpr int many = 32;
    int n = 0;
    for (int first = 0; first < count; first += many) {
        const int last = std::min(first + many, count);
        int found = 0;
        for (int c = first; c < last; ++c) found += due[c] <= way;
        if (found == 0) continue;
        for (int c = first; c < last; ++c) {
            listed[n] = c;
            n += due[c] <= way;
        }
    }
    return n;
}

}  // namespace

void find_neighbours(Simulation& s) {
    fit_tiles(s);
    s.list_is_stale = false;
    if (s.grains.count() == 0) return;
    choose_margins(s);
    double widest = 0.0;
    for (const Tile& tile : s.tiles) widest = std::max(widest, tile.margin);
    const Classes classes = make_classes(s, widest);
    const Partners touching = partners(s.grains.count(), [&](auto&& visit) {
        for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
            if (s.at_wall(group)) return;
            visit(c.i[slot], c.j[slot]);
            visit(c.j[slot], c.i[slot]);
        });
    });
    const Partners at_walls = partners(s.grains.count(), [&](auto&& visit) {
        for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
            if (s.at_wall(group)) visit(c.i[slot], c.j[slot]);
        });
    });
    const int tiles = static_cast<int>(s.tiles.size()), team = s.team();
    std::vector<std::vector<Found>> found(s.tiles.size());
#pragma omp parallel for schedule(dynamic) num_threads(team) if (team > 1)
    for (int index = 0; index < tiles; ++index) {
        const auto t = static_cast<std::size_t>(index);
        s.tiles[t].near_grains.clear(), s.tiles[t].near_walls.clear();
        search(s, classes, touching, t, found[t]);
        search_walls(s, at_walls, t);
    }
    for (const std::vector<Found>& part : found)
        for (const Found& pair : part)
            s.tiles[static_cast<std::size_t>(tile_of(pair.i))].near_grains.add(pair.i, pair.j,
                                                                               caution * pair.gap);
    find_partner_tiles(s);
    share_out(s);
}

bool outdated(const Simulation& s) {
    if (s.list_is_stale) return true;
    for (const Tile& tile : s.tiles) {
        if (!(tile.way <= caution * tile.margin)) return true;
        if (!s.walls.empty() && !(tile.way_from_walls <= caution * tile.margin_to_walls))
            return true;
    }
    return false;
}

void begin_contacts(Simulation& s, std::size_t t) {
    Tile& tile = s.tiles[t];
    const Particles& p = s.grains;
    double others = tile.way;
    for (const int partner : tile.partners)
        others = std::max(others, s.tiles[static_cast<std::size_t>(partner)].way);
    std::vector<std::pair<int, int>> born;
    const double way = tile.way + others;
    Candidates& near = tile.near_grains;
    std::vector<int>& due = tile.due;
    due.resize(near.count() + 1);
    due.resize(static_cast<std::size_t>(
        list_due(near.due.data(), static_cast<int>(near.count()), way, due.data())));
    std::size_t touching = 0;
    for (const int index : due) {
        const auto c = static_cast<std::size_t>(index);
        const auto i = static_cast<std::size_t>(near.i[c]), j = static_cast<std::size_t>(near.j[c]);
        const Vec3 between = apart(s, i, j);
        const double d2 = contact::dot(between, between), reach = p.radius[i] + p.radius[j];
        near.due[c] = way + caution * (std::sqrt(d2) - reach);
        due[touching] = index;
        touching += d2 <= reach * reach;
    }
    while (touching-- > 0) {
        const auto c = static_cast<std::size_t>(due[touching]);
        born.emplace_back(near.i[c], near.j[c]);
        near.remove(c);
    }
    std::sort(born.begin(), born.end());
    for (const auto& [i, j] : born)
        begin_pair(s, static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    born.clear();
    Candidates& walls = tile.near_walls;
    for (std::size_t c = walls.count(); c-- > 0;) {
        if (walls.due[c] > tile.way_from_walls) continue;
        const auto i = static_cast<std::size_t>(walls.i[c]);
        const Wall& wall = s.walls[static_cast<std::size_t>(walls.j[c])];
        if (distance(wall, p.position(i)).distance <= p.radius[i]) {
            born.emplace_back(walls.i[c], walls.j[c]);
            walls.remove(c);
        } else {  // not the distance, which is infinite where another patch of a mesh answers for this one
            walls.due[c] =
                tile.way_from_walls + caution * (clearance(wall, p.position(i)) - p.radius[i]);
        }
    }
    std::sort(born.begin(), born.end());
    for (const auto& [i, wall] : born)
        begin_wall_contact(s, static_cast<std::size_t>(i), static_cast<std::size_t>(wall));
}

}  // namespace dem_min
