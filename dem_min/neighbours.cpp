// SPDX-License-Identifier: MIT
#include "dem_min/neighbours.hpp"

#include "contact/effective.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dem_min {
namespace {

// A dense grid over the bounding box; cells are at least as wide as the longest reach, so that 27 of them suffice.
struct Grid {
    double x0 = 0.0, y0 = 0.0, z0 = 0.0, width = 1.0;
    int nx = 1, ny = 1, nz = 1;
    std::vector<int> begin,
        grain;  // grains of cell c, by rising index: grain[begin[c] .. begin[c + 1])

    int cell(double x, double y, double z) const {
        const int cx = static_cast<int>((x - x0) / width), cy = static_cast<int>((y - y0) / width),
                  cz = static_cast<int>((z - z0) / width);
        return (cz * ny + cy) * nx + cx;
    }
};

Grid make_grid(const Particles& p, double width) {
    Grid grid;
    const std::size_t n = p.count();
    const auto [x_min, x_max] = std::minmax_element(p.x.begin(), p.x.end());
    const auto [y_min, y_max] = std::minmax_element(p.y.begin(), p.y.end());
    const auto [z_min, z_max] = std::minmax_element(p.z.begin(), p.z.end());
    grid.x0 = *x_min, grid.y0 = *y_min, grid.z0 = *z_min;
    const double lx = *x_max - *x_min, ly = *y_max - *y_min, lz = *z_max - *z_min;
    // A few far grains must not cost memory: cells grow until they are not many more than the grains.
    const double most = 8.0 * static_cast<double>(n) + 64.0;
    while ((lx / width + 1.0) * (ly / width + 1.0) * (lz / width + 1.0) > most) width *= 2.0;
    grid.width = width;
    grid.nx = static_cast<int>(lx / width) + 1;
    grid.ny = static_cast<int>(ly / width) + 1;
    grid.nz = static_cast<int>(lz / width) + 1;
    const std::size_t cells = static_cast<std::size_t>(grid.nx) *
                              static_cast<std::size_t>(grid.ny) * static_cast<std::size_t>(grid.nz);
    grid.begin.assign(cells + 1, 0);
    std::vector<int> cell_of(n);
    for (std::size_t k = 0; k < n; ++k) {
        cell_of[k] = grid.cell(p.x[k], p.y[k], p.z[k]);
        ++grid.begin[static_cast<std::size_t>(cell_of[k]) + 1];
    }
    for (std::size_t c = 0; c < cells; ++c) grid.begin[c + 1] += grid.begin[c];
    grid.grain.resize(n);
    std::vector<int> next(grid.begin.begin(), grid.begin.end() - 1);
    for (std::size_t k = 0; k < n; ++k)
        grid.grain[static_cast<std::size_t>(next[static_cast<std::size_t>(cell_of[k])]++)] =
            static_cast<int>(k);
    return grid;
}

// Calls `visit(j)` for each grain j > i in the 27 cells around grain i.
template <class Visit>
void visit_near(const Grid& grid, const Particles& p, int i, Visit&& visit) {
    const auto k = static_cast<std::size_t>(i);
    const int cx = static_cast<int>((p.x[k] - grid.x0) / grid.width);
    const int cy = static_cast<int>((p.y[k] - grid.y0) / grid.width);
    const int cz = static_cast<int>((p.z[k] - grid.z0) / grid.width);
    for (int z = std::max(0, cz - 1); z <= std::min(grid.nz - 1, cz + 1); ++z)
        for (int y = std::max(0, cy - 1); y <= std::min(grid.ny - 1, cy + 1); ++y)
            for (int x = std::max(0, cx - 1); x <= std::min(grid.nx - 1, cx + 1); ++x) {
                const auto c = static_cast<std::size_t>((z * grid.ny + y) * grid.nx + x);
                for (int at = grid.begin[c]; at < grid.begin[c + 1]; ++at) {
                    const int j = grid.grain[static_cast<std::size_t>(at)];
                    if (j > i) visit(j);
                }
            }
}

// Remembers the gap of the last R*: in a powder of one size, or of few, nearly every pair asks for the same.
class CachedGap {
  public:
    explicit CachedGap(const GapOf& gap) : gap_(gap) {}
    double operator()(double r_star) {
        if (r_star != r_star_) r_star_ = r_star, value_ = gap_(r_star);
        return value_;
    }

  private:
    const GapOf& gap_;
    double r_star_ = 0.0, value_ = 0.0;
};

void link_contacts(CandidateList& list, Contacts& contacts, bool wall_major) {
    list.slot.assign(list.count(), -1);
    // Candidates stand in order of (i, j), those of walls in order of (j, i).
    const auto key = [&](int i, int j) { return wall_major ? std::pair{j, i} : std::pair{i, j}; };
    for (std::size_t slot = 0; slot < contacts.count(); ++slot) {
        const auto wanted = key(contacts.i[slot], contacts.j[slot]);
        std::size_t low = 0, high = list.count();
        while (low < high) {
            const std::size_t middle = (low + high) / 2;
            if (key(list.i[middle], list.j[middle]) < wanted)
                low = middle + 1;
            else
                high = middle;
        }
        // Not in the list: the pair has jumped beyond gap and skin, and is about to be found torn.
        const bool found = low < list.count() && key(list.i[low], list.j[low]) == wanted;
        contacts.candidate[slot] = found ? static_cast<int>(low) : -1;
        if (found) list.slot[low] = static_cast<int>(slot);
    }
}

CandidateList near_pairs(const Particles& p, double skin, const GapOf& pair_gap, int threads) {
    const int n = static_cast<int>(p.count());
    const double r_max = *std::max_element(p.radius.begin(), p.radius.end());
    const Grid grid = make_grid(p, 2.0 * r_max + pair_gap(0.5 * r_max) + skin);
    std::vector<CandidateList> parts(static_cast<std::size_t>(threads));
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        CandidateList& part = parts[static_cast<std::size_t>(omp_get_thread_num())];
        CachedGap gap(pair_gap);
        std::vector<int> near;
#pragma omp for schedule(static)
        for (int i = 0; i < n; ++i) {
            const auto a = static_cast<std::size_t>(i);
            near.clear();
            visit_near(grid, p, i, [&](int j) {
                const auto b = static_cast<std::size_t>(j);
                if (p.fixed(a) && p.fixed(b)) return;
                const double dx = p.x[b] - p.x[a], dy = p.y[b] - p.y[a], dz = p.z[b] - p.z[a];
                const double r_i = p.radius[a], r_j = p.radius[b];
                const double reach = r_i + r_j + gap(contact::r_star(r_i, r_j)) + skin;
                if (dx * dx + dy * dy + dz * dz <= reach * reach) near.push_back(j);
            });
            std::sort(near.begin(), near.end());
            for (const int j : near) {
                part.i.push_back(i);
                part.j.push_back(j);
                part.reach.push_back(p.radius[a] + p.radius[static_cast<std::size_t>(j)]);
            }
        }
    }
    CandidateList list;
    for (const CandidateList& part :
         parts) {  // static chunks by rising i: joined, they are in order
        list.i.insert(list.i.end(), part.i.begin(), part.i.end());
        list.j.insert(list.j.end(), part.j.begin(), part.j.end());
        list.reach.insert(list.reach.end(), part.reach.begin(), part.reach.end());
    }
    return list;
}

CandidateList near_walls(const Particles& p, const std::vector<Wall>& walls, double skin,
                         const GapOf& wall_gap) {
    CandidateList list;
    CachedGap gap(wall_gap);
    for (std::size_t w = 0; w < walls.size(); ++w)
        for (std::size_t k = 0; k < p.count(); ++k) {
            if (p.fixed(k)) continue;
            const double r = p.radius[k];
            if (distance(walls[w], p.position(k)).distance > r + gap(r) + skin) continue;
            list.i.push_back(static_cast<int>(k));
            list.j.push_back(static_cast<int>(w));
            list.reach.push_back(r);
        }
    return list;
}

}  // namespace

void find_neighbours(Neighbours& neighbours, const Particles& p, const std::vector<Wall>& walls,
                     Contacts& pairs, Contacts& wall_contacts, double skin, const GapOf& pair_gap,
                     const GapOf& wall_gap, int threads) {
    neighbours.pairs = p.count() == 0 ? CandidateList{} : near_pairs(p, skin, pair_gap, threads);
    neighbours.walls = near_walls(p, walls, skin, wall_gap);
    link_contacts(neighbours.pairs, pairs, false);
    link_contacts(neighbours.walls, wall_contacts, true);
    neighbours.of_pairs = incidence(neighbours.pairs, p.count(), true);
    neighbours.of_walls = incidence(neighbours.walls, p.count(), false);
    neighbours.x0 = p.x, neighbours.y0 = p.y, neighbours.z0 = p.z;
    neighbours.stale = false;
}

bool outdated(const Neighbours& neighbours, const Particles& p, double skin, int threads) {
    if (neighbours.stale) return true;
    const double allowed = 0.25 * skin * skin;
    int far = 0;  // grains; one that is nowhere (NaN) counts too, and is then found by check_finite
    const int n = static_cast<int>(p.count());
#pragma omp parallel for simd reduction(+ : far) schedule(static) num_threads(threads) if (threads > 1)
    for (int k = 0; k < n; ++k) {
        const auto a = static_cast<std::size_t>(k);
        const double dx = p.x[a] - neighbours.x0[a], dy = p.y[a] - neighbours.y0[a],
                     dz = p.z[a] - neighbours.z0[a];
        far += !(dx * dx + dy * dy + dz * dz <= allowed);
    }
    return far > 0;
}

Incidence incidence(const CandidateList& list, std::size_t grains, bool both_sides) {
    Incidence result;
    result.begin.assign(grains + 1, 0);
    for (std::size_t c = 0; c < list.count(); ++c) {
        if (list.slot[c] < 0) continue;
        ++result.begin[static_cast<std::size_t>(list.i[c]) + 1];
        if (both_sides) ++result.begin[static_cast<std::size_t>(list.j[c]) + 1];
    }
    for (std::size_t k = 0; k < grains; ++k) result.begin[k + 1] += result.begin[k];
    result.entry.resize(static_cast<std::size_t>(result.begin[grains]));
    std::vector<int> next(result.begin.begin(), result.begin.end() - 1);
    // Swept in order of (i, j), grain k first meets its partners below k, by rising index, then those above.
    for (std::size_t c = 0; c < list.count(); ++c) {
        if (list.slot[c] < 0) continue;
        const auto i = static_cast<std::size_t>(list.i[c]), j = static_cast<std::size_t>(list.j[c]);
        result.entry[static_cast<std::size_t>(next[i]++)] = 2 * list.slot[c];
        if (both_sides) result.entry[static_cast<std::size_t>(next[j]++)] = 2 * list.slot[c] + 1;
    }
    return result;
}

}  // namespace dem_min
