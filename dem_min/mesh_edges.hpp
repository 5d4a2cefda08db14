// SPDX-License-Identifier: MIT
// What making a mesh ready takes: its edges, its normals, and triangles that are none taken out.
#pragma once

#include "dem_min/mesh.hpp"

#include <array>
#include <vector>

namespace dem_min {

struct Edge {
    int first, second;  // vertices, first < second
    int triangle;
};

// All edges of all triangles, those of one pair of vertices side by side, by rising triangle.
std::vector<Edge> sorted_edges(const std::vector<std::array<int, 3>>& triangles);
bool same_edge(const Edge&, const Edge&);
int opposite(const std::array<int, 3>& corners, const Edge&);  // the third corner

// 0 for a triangle less high than 1e-6 of its longest edge: files hold vertices as floats, to 6e-8 of the mesh's size, and the
// direction of such a triangle is noise.
Vec3 unit_normal(const std::vector<Vec3>& vertices, const std::array<int, 3>& corners);

// The triangles that are left when each stands once (a sheet given twice would push twice) and those without a normal are taken
// out, without opening the surface: two corners that are nearly one become one; a corner that lies on the longest edge
// becomes a corner of the triangle beyond that edge. Corners by rising index. What cannot be mended stays.
std::vector<std::array<int, 3>> clean_triangles(const Surface&);

}  // namespace dem_min
