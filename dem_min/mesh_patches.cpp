// SPDX-License-Identifier: MIT
// Makes a mesh ready: edges, smooth patches, a tree of boxes for each patch.
#include "dem_min/mesh.hpp"
#include "dem_min/mesh_edges.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

namespace dem_min {
namespace {

constexpr double smooth_cosine = 0.8191520442889918;  // of 35 degrees
constexpr int leaf_size = 4;                          // triangles

using Corners = std::array<int, 3>;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Whether the surface bends by less than the angle above, from the side of vertex `u` over the edge to that of `v`.
bool smooth(const std::vector<Vec3>& vertices, const Edge& edge, int u, int v) {
    const Vec3 a = vertices[at(edge.first)], along = vertices[at(edge.second)] - a;
    const auto away = [&](int vertex) {
        const Vec3 side = vertices[at(vertex)] - a;
        return side - (contact::dot(side, along) / contact::dot(along, along)) * along;
    };
    const Vec3 p = away(u), q = away(v);
    return -contact::dot(p, q) > smooth_cosine * contact::norm(p) * contact::norm(q);
}

// Groups of triangles; the lowest of a group stands for it.
struct Groups {
    std::vector<int> parent;
    explicit Groups(std::size_t count) : parent(count) {
        std::iota(parent.begin(), parent.end(), 0);
    }
    int of(int t) {
        while (parent[at(t)] != t) t = parent[at(t)] = parent[at(parent[at(t)])];
        return t;
    }
    void join(int a, int b) {
        const auto [low, high] = std::minmax({of(a), of(b)});
        parent[at(high)] = low;
    }
};

// The patch of each triangle. Two triangles without a crease between them are joined.
std::vector<int> patches(const Mesh& mesh) {
    Groups groups(mesh.triangles.size());
    const auto thin = [&](const Edge& e) { return mesh.normal[at(e.triangle)] == Vec3{}; };
    const auto beyond = [&](const Edge& e) { return opposite(mesh.triangles[at(e.triangle)], e); };
    const std::vector<Edge> edges = sorted_edges(mesh.triangles);
    for (std::size_t k = 0, end = 0; k < edges.size(); k = end) {
        while (end < edges.size() && same_edge(edges[k], edges[end])) ++end;
        if (end - k != 2) continue;  // a rim, or more than two surfaces meet
        const Edge &a = edges[k], &b = edges[k + 1];
        if (thin(a) || thin(b) || smooth(mesh.vertices, a, beyond(a), beyond(b)))
            groups.join(a.triangle, b.triangle);
    }
    std::vector<int> patch_of(mesh.triangles.size());
    int count = 0;
    for (std::size_t t = 0; t < patch_of.size(); ++t) {
        const int group = groups.of(static_cast<int>(t));
        patch_of[t] = group == static_cast<int>(t) ? count++ : patch_of[at(group)];
    }
    return patch_of;
}

Box around(const Mesh& mesh, const std::vector<int>& order, int begin, int end) {
    Box box{mesh.vertices[at(mesh.triangles[at(order[at(begin)])][0])], {}};
    box.high = box.low;
    for (int k = begin; k < end; ++k)
        for (const int v : mesh.triangles[at(order[at(k)])]) {
            const Vec3& x = mesh.vertices[at(v)];
            box.low = {std::min(box.low.x, x.x), std::min(box.low.y, x.y),
                       std::min(box.low.z, x.z)};
            box.high = {std::max(box.high.x, x.x), std::max(box.high.y, x.y),
                        std::max(box.high.z, x.z)};
        }
    return box;
}

// Halves the triangles order[begin..end) at the middle of the longest side of their box, until few are left.
void grow_tree(Mesh& mesh, std::vector<int>& order, int begin, int end) {
    const std::size_t node = mesh.nodes.size();
    const Box box = around(mesh, order, begin, end);
    mesh.nodes.push_back({box, begin, end, 0});
    if (end - begin <= leaf_size) return;
    const Vec3 side = box.high - box.low;
    double Vec3::*axis = side.y > side.x ? &Vec3::y : &Vec3::x;
    if (side.z > side.*axis) axis = &Vec3::z;
    const auto place = [&](int t) {  // three times the middle of the triangle
        const auto [i, j, k] = mesh.triangles[at(t)];
        return mesh.vertices[at(i)].*axis + mesh.vertices[at(j)].*axis + mesh.vertices[at(k)].*axis;
    };
    const int middle = begin + (end - begin) / 2;
    std::sort(order.begin() + begin, order.begin() + end, [&](int a, int b) {
        return std::pair{place(a), a} < std::pair{place(b), b};
    });
    grow_tree(mesh, order, begin, middle);
    mesh.nodes[node].second = static_cast<int>(mesh.nodes.size());
    grow_tree(mesh, order, middle, end);
}

template <class T>
std::vector<T> in_order(const std::vector<T>& values, const std::vector<int>& order) {
    std::vector<T> result;
    for (const int k : order) result.push_back(values[at(k)]);
    return result;
}

void find_stars(Mesh& mesh) {
    mesh.star_begin.assign(mesh.vertices.size() + 1, 0);
    for (const Corners& corners : mesh.triangles)
        for (const int v : corners) ++mesh.star_begin[at(v) + 1];
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.star_begin[v + 1] += mesh.star_begin[v];
    mesh.star.resize(3 * mesh.triangles.size());
    std::vector<int> next(mesh.star_begin.begin(), mesh.star_begin.end() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int v : mesh.triangles[t]) mesh.star[at(next[at(v)]++)] = static_cast<int>(t);
}

[[noreturn]] void refuse(const std::string& what, const std::string& got, const std::string& rule) {
    throw scaling::InvalidParameter(
        scaling::mistake("Surface." + what, got, rule, "correct the mesh"));
}

void check(const Surface& surface) {
    const auto finite = [](const Vec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
        if (!finite(surface.vertices[v]))
            refuse("vertices[" + std::to_string(v) + "]", "no number", "must be finite");
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (const int v : surface.triangles[t])
            if (v < 0 || at(v) >= surface.vertices.size())
                refuse("triangles[" + std::to_string(t) + "]", std::to_string(v),
                       "must be the index of a vertex");
}

// Puts the triangles patch by patch and gives each patch its tree.
void sort_into_trees(Mesh& mesh) {
    std::vector<int> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    const auto patch = [&](int place) { return mesh.patch_of[at(order[at(place)])]; };
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return mesh.patch_of[at(a)] < mesh.patch_of[at(b)]; });
    const int count = static_cast<int>(order.size());
    for (int begin = 0, end = 0; begin < count; begin = end) {
        while (end < count && patch(end) == patch(begin)) ++end;
        mesh.root.push_back(static_cast<int>(mesh.nodes.size()));
        grow_tree(mesh, order, begin, end);
    }
    mesh.triangles = in_order(mesh.triangles, order);
    mesh.normal = in_order(mesh.normal, order);
    mesh.patch_of = in_order(mesh.patch_of, order);
}

}  // namespace

std::vector<Wall> mesh_walls(const Surface& surface) {
    check(surface);
    Mesh mesh;
    mesh.vertices = surface.vertices;
    mesh.triangles = clean_triangles(surface);
    if (mesh.triangles.empty()) refuse("triangles", "none", "must hold one with three corners");
    for (const Corners& corners : mesh.triangles)
        mesh.normal.push_back(unit_normal(mesh.vertices, corners));
    mesh.patch_of = patches(mesh);
    sort_into_trees(mesh);
    find_stars(mesh);
    const auto shared = std::make_shared<const Mesh>(std::move(mesh));
    std::vector<Wall> walls;
    for (std::size_t p = 0; p < shared->root.size(); ++p)
        walls.push_back(MeshPatch{shared, static_cast<int>(p)});
    return walls;
}

}  // namespace dem_min
