// SPDX-License-Identifier: MIT
// The nearest point of a patch. How a mesh is made ready: mesh_patches.cpp.
#include "dem_min/mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <tuple>

namespace dem_min {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// What cannot be nearer is passed over. The margin covers round-off: a bound may exceed what it bounds by a few units in the last
// place.
constexpr double margin = 1.0 - 1e-9;

// The nearest point so far and what it lies on: the inside of a triangle (no vertex), an edge (two) or a corner (one, first).
struct Nearest {
    double square = infinity;  // m^2
    Vec3 way;                  // m, from the point asked about
    int first = -1, second = -1, triangle = -1;
};

// A strict order, so that what is found does not depend on the order of search, ties included.
bool nearer(const Nearest& a, const Nearest& b) {
    return std::tie(a.square, a.first, a.second, a.triangle) <
           std::tie(b.square, b.first, b.second, b.triangle);
}

bool same_place(const Nearest& a, const Nearest& b) {
    return a.first == b.first && a.second == b.second;
}

const Vec3& vertex(const Mesh& mesh, int index) {
    return mesh.vertices[static_cast<std::size_t>(index)];
}

// Always from the vertex of the lower index: the bits are those of the edge, whichever triangle asks.
Nearest on_edge(const Mesh& mesh, int triangle, int first, int second, Vec3 point) {
    const Vec3 a = vertex(mesh, first), b = vertex(mesh, second), edge = b - a;
    const double along = contact::dot(point - a, edge), whole = contact::dot(edge, edge);
    Nearest result{0.0, {}, first, second, triangle};
    if (along <= 0.0)
        result.way = a - point, result.second = -1;
    else if (along >= whole)
        result.way = b - point, result.first = second, result.second = -1;
    else
        result.way = (a - point) + (along / whole) * edge;
    result.square = contact::dot(result.way, result.way);
    return result;
}

// The nearest point of a triangle, if it is nearer than `best`.
void improve(Nearest& best, const Mesh& mesh, int triangle, Vec3 point) {
    const auto t = static_cast<std::size_t>(triangle);
    const auto [i, j, k] = mesh.triangles[t];
    const Vec3 a = vertex(mesh, i), b = vertex(mesh, j), c = vertex(mesh, k), n = mesh.normal[t];
    const double height = contact::dot(point - a, n);  // 0 where there is no normal
    if (height * height * margin > best.square) return;
    // The foot of the perpendicular is inside where it stands on the same side of all three edges.
    const double ab = contact::dot(contact::cross(b - a, point - a), n);
    const double bc = contact::dot(contact::cross(c - b, point - b), n);
    const double ca = contact::dot(contact::cross(a - c, point - c), n);
    if (n != Vec3{} && ab >= 0.0 && bc >= 0.0 && ca >= 0.0) {
        const Nearest inside{height * height, -height * n, -1, -1, triangle};
        if (nearer(inside, best)) best = inside;
    }
    for (const Nearest& edge :
         {on_edge(mesh, triangle, i, j, point), on_edge(mesh, triangle, i, k, point),
          on_edge(mesh, triangle, j, k, point)})
        if (nearer(edge, best)) best = edge;
}

double square_to(const Box& box, Vec3 p) {
    const auto outside = [](double low, double high, double x) {
        return std::max({low - x, x - high, 0.0});
    };
    const Vec3 way{outside(box.low.x, box.high.x, p.x), outside(box.low.y, box.high.y, p.y),
                   outside(box.low.z, box.high.z, p.z)};
    return contact::dot(way, way);
}

Nearest nearest_in_patch(const Mesh& mesh, int patch, Vec3 point) {
    struct Waiting {
        int node;
        double square;  // m^2, no triangle in there is nearer
    };
    std::array<Waiting, 64> waiting;  // a tree of 2^31 triangles, halved at each node, is 32 deep
    std::size_t count = 0;
    Nearest best;
    waiting[count++] = {mesh.root[static_cast<std::size_t>(patch)], 0.0};
    while (count > 0) {
        const Waiting next = waiting[--count];
        if (next.square * margin > best.square) continue;
        const Mesh::Node& node = mesh.nodes[static_cast<std::size_t>(next.node)];
        if (node.second == 0) {
            for (int t = node.begin; t < node.end; ++t) improve(best, mesh, t, point);
            continue;
        }
        const auto child = [&](int index) {
            return Waiting{index,
                           square_to(mesh.nodes[static_cast<std::size_t>(index)].box, point)};
        };
        Waiting near = child(next.node + 1), far = child(node.second);
        if (far.square < near.square) std::swap(near, far);
        waiting[count++] = far;
        waiting[count++] = near;
    }
    return best;
}

// Whether the patch answers for the edge or corner where it is nearest (mesh.hpp).
bool answers(const Mesh& mesh, int patch, const Nearest& found, Vec3 point) {
    const auto corner = static_cast<std::size_t>(found.first);
    for (int at = mesh.star_begin[corner]; at < mesh.star_begin[corner + 1]; ++at) {
        const int triangle = mesh.star[static_cast<std::size_t>(at)];
        const auto& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
        const int other = mesh.patch_of[static_cast<std::size_t>(triangle)];
        const bool shares = found.second < 0 || std::find(corners.begin(), corners.end(),
                                                          found.second) != corners.end();
        if (other == patch || !shares) continue;
        Nearest there;
        improve(there, mesh, triangle, point);
        if (!same_place(there, found)) return false;
        if (other < patch && same_place(nearest_in_patch(mesh, other, point), found)) return false;
    }
    return true;
}

Vec3 direction(const Mesh& mesh, const Nearest& found, double distance) {
    const Vec3 normal = mesh.normal[static_cast<std::size_t>(found.triangle)];
    const bool inside = found.first < 0;
    if (inside) return contact::dot(found.way, normal) < 0.0 ? -normal : normal;
    if (distance > 0.0)
        return {found.way.x / distance, found.way.y / distance, found.way.z / distance};
    return normal == Vec3{} ? Vec3{0.0, 0.0, -1.0} : normal;  // on the edge: any is as good
}

}  // namespace

WallDistance distance(const MeshPatch& wall, Vec3 point) {
    const Nearest found = nearest_in_patch(*wall.mesh, wall.patch, point);
    const double d = std::sqrt(found.square);
    const Vec3 n = direction(*wall.mesh, found, d);
    const bool shared = found.first >= 0;
    if (shared && !answers(*wall.mesh, wall.patch, found, point)) return {infinity, n};
    return {d, n};
}

double clearance(const MeshPatch& wall, Vec3 point) {
    return std::sqrt(nearest_in_patch(*wall.mesh, wall.patch, point).square);
}

Box bounds(const MeshPatch& wall) {
    const int root = wall.mesh->root[static_cast<std::size_t>(wall.patch)];
    return wall.mesh->nodes[static_cast<std::size_t>(root)].box;
}

MeshPatch scaled(const MeshPatch& wall, double factor) {
    Mesh mesh = *wall.mesh;
    for (Vec3& v : mesh.vertices) v = factor * v;
    for (Mesh::Node& node : mesh.nodes) node.box = {factor * node.box.low, factor * node.box.high};
    return {std::make_shared<const Mesh>(std::move(mesh)), wall.patch};
}

}  // namespace dem_min
