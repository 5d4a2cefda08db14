// SPDX-License-Identifier: MIT
#include "rigs/measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace rigs {
namespace {

// Grains in cells as wide as the largest grain and the gap, in the order of their cells.
struct Cells {
    contact::Vec3 low{};
    double edge = 1.0;
    std::vector<std::array<std::int64_t, 3>> of;  // [grains]
    std::vector<std::size_t> order;               // [grains]
};

Cells cells_of(const Frame& f, double gap) {
    Cells c;
    double widest = 0.0;
    for (const double r : f.radius) widest = std::max(widest, 2.0 * r);
    c.edge = widest + gap;
    c.low = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    for (const contact::Vec3& x : f.position)
        c.low = {std::min(c.low.x, x.x), std::min(c.low.y, x.y), std::min(c.low.z, x.z)};
    for (const contact::Vec3& x : f.position) {
        const contact::Vec3 d = (1.0 / c.edge) * (x - c.low);
        c.of.push_back({static_cast<std::int64_t>(d.x), static_cast<std::int64_t>(d.y),
                        static_cast<std::int64_t>(d.z)});
    }
    c.order.resize(f.count());
    std::iota(c.order.begin(), c.order.end(), std::size_t{0});
    std::sort(c.order.begin(), c.order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(c.of[a], a) < std::pair(c.of[b], b);
    });
    return c;
}

// Calls `pair(i, j)` once for each two grains in one cell or in two that meet.
template <class Pair>
void for_each_near(const Cells& c, Pair&& pair) {
    for (std::size_t at = 0; at < c.order.size(); ++at) {
        const std::size_t i = c.order[at];
        for (std::int64_t dx = 0; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                if (dx == 0 && dy < 0) continue;
                const bool own = dx == 0 && dy == 0;  // the three cells along z follow each other
                const std::array<std::int64_t, 3> first = {c.of[i][0] + dx, c.of[i][1] + dy,
                                                           c.of[i][2] - (own ? 0 : 1)};
                auto next = own ? c.order.begin() + static_cast<std::ptrdiff_t>(at) + 1
                                : std::lower_bound(c.order.begin(), c.order.end(), first,
                                                   [&](std::size_t k, const auto& cell) {
                                                       return c.of[k] < cell;
                                                   });
                for (; next != c.order.end(); ++next) {
                    const auto& cell = c.of[*next];
                    if (cell[0] != first[0] || cell[1] != first[1] || cell[2] > c.of[i][2] + 1)
                        break;
                    pair(i, *next);
                }
            }
    }
}

void push(Frame& to, const Frame& from, std::size_t k, contact::Vec3 base) {
    to.id.push_back(from.id[k]);
    to.position.push_back(from.position[k] - base);
    to.velocity.push_back(from.velocity[k]);
    to.radius.push_back(from.radius[k]);
    to.mass.push_back(from.mass[k]);
    to.fixed.push_back(from.fixed[k]);
}

// Grains of the heap and fixed ones, seen from the centre of the base's top; counts the others.
Frame heap_of(const Frame& f, const MeasureSettings& s, Measured& m) {
    Frame heap;
    for (std::size_t k = 0; k < f.count(); ++k) {
        const contact::Vec3 x = f.position[k] - s.base;
        const double r = f.radius[k];
        if (f.fixed[k])
            ++m.fixed;
        else if (s.base_diameter && x.z + r < 0.0) {
            ++m.below_base;
            continue;
        } else if (s.base_diameter && std::hypot(x.x, x.y) > 0.5 * *s.base_diameter + r) {
            ++m.beyond_rim;
            continue;
        } else
            ++m.loose;
        push(heap, f, k, s.base);
    }
    return heap;
}

void take_sizes(const Frame& heap, Measured& m) {
    double sum = 0.0;
    m.smallest = m.loose > 0 ? HUGE_VAL : 0.0;
    for (std::size_t k = 0; k < heap.count(); ++k) {
        if (heap.fixed[k]) continue;
        const double d = 2.0 * heap.radius[k];
        m.smallest = std::min(m.smallest, d), m.largest = std::max(m.largest, d), sum += d;
    }
    if (m.loose > 0) m.mean = sum / static_cast<double>(m.loose);
}

// Kinetic energy of translation per loose grain over m g d of the mean grain; grains of one density where masses are not known.
double restlessness(const Frame& heap, const Measured& m, double gravity) {
    double energy = 0.0, mass = 0.0;
    for (std::size_t k = 0; k < heap.count(); ++k) {
        if (heap.fixed[k]) continue;
        const double weight = std::isnan(heap.mass[k]) ? std::pow(heap.radius[k], 3) : heap.mass[k];
        energy += 0.5 * weight * contact::dot(heap.velocity[k], heap.velocity[k]);
        mass += weight;
    }
    return mass > 0.0 ? energy / (mass * gravity * m.mean) : 0.0;
}

MeasuredHeap read_heap(const Frame& frame, const MeasureSettings& s, const Measured& m) {
    Heap heap{{}, {}, 0.5 * *s.base_diameter};
    for (std::size_t k = 0; k < frame.count(); ++k) {
        if (frame.fixed[k]) continue;
        heap.centre.push_back(frame.position[k]);
        heap.radius.push_back(frame.radius[k]);
    }
    const HeightMap map = scan(heap);
    MeasuredHeap result{formed(map, {m.below_base + m.beyond_rim,
                                     s.moving_known ? restlessness(frame, m, s.gravity) : 0.0}),
                        {},
                        radial_profile(map),
                        packing_fraction(heap, map)};
    if (!s.moving_known) {
        auto& criteria = result.formed.criteria;
        std::erase_if(criteria, [](const Criterion& c) { return c.name == "at_rest"; });
        result.formed.formed = std::all_of(criteria.begin(), criteria.end(),
                                           [](const Criterion& c) { return c.pass; });
    }
    for (const Estimator estimator : computed_estimators)
        result.angles.emplace_back(estimator, angle_of_repose(map, estimator));
    return result;
}

}  // namespace

GrainContacts contacts_of(const Frame& f, bool flat_base, double gap) {
    GrainContacts result{};
    std::size_t ends = 0, loose = 0;
    for (std::size_t k = 0; k < f.count(); ++k) {
        if (f.fixed[k]) continue;
        ++loose;
        const double apart = f.position[k].z - f.radius[k];
        if (!flat_base || apart > gap) continue;
        ++ends, ++result.at_base;
        result.largest_overlap = std::max(result.largest_overlap, -apart / f.radius[k]);
    }
    const Cells cells = cells_of(f, gap);
    for_each_near(cells, [&](std::size_t i, std::size_t j) {
        if (f.fixed[i] && f.fixed[j]) return;
        const double sum = f.radius[i] + f.radius[j];
        const double apart = contact::norm(f.position[i] - f.position[j]) - sum;
        if (apart > gap) return;
        ++result.pairs;
        ends += static_cast<std::size_t>(!f.fixed[i]) + static_cast<std::size_t>(!f.fixed[j]);
        const double r_star = f.radius[i] * f.radius[j] / sum;
        result.largest_overlap = std::max(result.largest_overlap, -apart / r_star);
    });
    result.coordination = loose > 0 ? static_cast<double>(ends) / static_cast<double>(loose) : 0.0;
    return result;
}

Measured measure(const Frame& f, const MeasureSettings& s) {
    Measured m;
    const Frame heap = heap_of(f, s, m);
    take_sizes(heap, m);
    m.contacts = contacts_of(heap, s.base_diameter && m.fixed == 0, s.contact_gap);
    if (s.base_diameter) m.heap = read_heap(heap, s, m);
    return m;
}

}  // namespace rigs
