// SPDX-License-Identifier: MIT
#include "dem_min/mesh_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace dem_min {
namespace {

constexpr double thinnest = 1e-6;  // height over longest edge; mesh_edges.hpp
constexpr int most_rounds = 20;    // of mending: what one leaves or makes is for the next

using Corners = std::array<int, 3>;
using Vertices = std::vector<Vec3>;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

double length(const Vertices& vertices, int a, int b) {
    return contact::norm(vertices[at(b)] - vertices[at(a)]);
}

// Corners by rising index, each triangle once, none with two corners in one place.
std::vector<Corners> proper(const Vertices& vertices, const std::vector<Corners>& triangles) {
    const auto together = [&](int a, int b) { return vertices[at(a)] == vertices[at(b)]; };
    std::vector<Corners> result;
    std::set<Corners> known;
    for (Corners corners : triangles) {
        std::sort(corners.begin(), corners.end());
        const auto [i, j, k] = corners;
        const bool flat = together(i, j) || together(i, k) || together(j, k);
        if (!flat && known.insert(corners).second) result.push_back(corners);
    }
    return result;
}

// The ends of the longest edge, then the corner between them.
Corners longest_first(const Vertices& vertices, const Corners& corners) {
    const auto [i, j, k] = corners;
    const double ij = length(vertices, i, j), ik = length(vertices, i, k),
                 jk = length(vertices, j, k);
    if (ij >= ik && ij >= jk) return {i, j, k};
    return ik >= jk ? Corners{i, k, j} : Corners{j, k, i};
}

// Makes one vertex of two that are nearly one, in all thin triangles that have such a pair.
bool join_corners(const Vertices& vertices, std::vector<Corners>& triangles) {
    std::vector<int> stands_for(vertices.size());
    std::iota(stands_for.begin(), stands_for.end(), 0);
    const auto of = [&](int v) {
        while (stands_for[at(v)] != v) v = stands_for[at(v)];
        return v;
    };
    bool any = false;
    for (const Corners& corners : triangles) {
        if (unit_normal(vertices, corners) != Vec3{}) continue;
        const auto [a, b, between] = longest_first(vertices, corners);
        const double to_a = length(vertices, a, between), to_b = length(vertices, b, between);
        if (std::min(to_a, to_b) > thinnest * length(vertices, a, b)) continue;
        const auto [low, high] = std::minmax({of(to_a < to_b ? a : b), of(between)});
        stands_for[at(high)] = low;
        any = true;
    }
    for (Corners& corners : triangles)
        for (int& v : corners) v = of(v);
    return any;
}

// Cuts the triangle beyond the longest edge of a thin one in two, at the corner that lies on that edge.
bool cut_neighbours(const Vertices& vertices, std::vector<Corners>& triangles) {
    const std::vector<Edge> edges = sorted_edges(triangles);
    std::vector<bool> touched(triangles.size(), false), gone(triangles.size(), false);
    std::vector<Corners> added;
    bool any = false;
    for (std::size_t t = 0; t < touched.size(); ++t) {
        if (touched[t] || unit_normal(vertices, triangles[t]) != Vec3{}) continue;
        const auto [a, b, between] = longest_first(vertices, triangles[t]);
        const Edge longest{std::min(a, b), std::max(a, b), 0};
        auto edge =
            std::lower_bound(edges.begin(), edges.end(), longest, [](const Edge& x, const Edge& y) {
                return std::tie(x.first, x.second) < std::tie(y.first, y.second);
            });
        touched[t] = true;
        bool beyond = false;
        for (; edge != edges.end() && same_edge(*edge, longest); ++edge) {
            const auto n = at(edge->triangle);
            if (n == t || touched[n]) continue;
            const int tip = opposite(triangles[n], longest);
            touched[n] = gone[n] = beyond = true;
            added.push_back({a, between, tip});
            added.push_back({between, b, tip});
        }
        gone[t] = beyond;
        any = any || beyond;
    }
    std::vector<Corners> kept;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (!gone[t]) kept.push_back(triangles[t]);
    kept.insert(kept.end(), added.begin(), added.end());
    triangles = std::move(kept);
    return any;
}

}  // namespace

std::vector<Edge> sorted_edges(const std::vector<Corners>& triangles) {
    std::vector<Edge> edges;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto [i, j, k] = triangles[t];
        for (const auto& [first, second] : {std::pair{i, j}, std::pair{i, k}, std::pair{j, k}})
            edges.push_back({first, second, static_cast<int>(t)});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.first, a.second, a.triangle) < std::tie(b.first, b.second, b.triangle);
    });
    return edges;
}

bool same_edge(const Edge& a, const Edge& b) { return a.first == b.first && a.second == b.second; }

int opposite(const Corners& corners, const Edge& edge) {
    return *std::find_if(corners.begin(), corners.end(),
                         [&](int v) { return v != edge.first && v != edge.second; });
}

Vec3 unit_normal(const Vertices& vertices, const Corners& corners) {
    const auto [i, j, k] = corners;
    const Vec3 u = vertices[at(j)] - vertices[at(i)], v = vertices[at(k)] - vertices[at(i)],
               w = v - u, n = contact::cross(u, v);
    const double longest = std::max({contact::dot(u, u), contact::dot(v, v), contact::dot(w, w)});
    const double twice_area = contact::norm(n);
    if (twice_area < thinnest * longest) return {};
    return {n.x / twice_area, n.y / twice_area, n.z / twice_area};
}

std::vector<Corners> clean_triangles(const Surface& surface) {
    std::vector<Corners> triangles = proper(surface.vertices, surface.triangles);
    for (int round = 0; round < most_rounds; ++round) {
        const bool joined = join_corners(surface.vertices, triangles);
        if (joined) triangles = proper(surface.vertices, triangles);
        const bool cut = cut_neighbours(surface.vertices, triangles);
        if (cut) triangles = proper(surface.vertices, triangles);
        if (!joined && !cut) break;
    }
    return triangles;
}

}  // namespace dem_min
