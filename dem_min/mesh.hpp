// SPDX-License-Identifier: MIT
// Walls of triangles. The triangles are grouped into smooth patches, and one patch is one wall: a grain that rolls from
// triangle to triangle within it keeps its contact and its tangential spring, and feels one contact, not one per triangle.
//
// Two triangles that share an edge belong to one patch where the surface bends there by less than 35 degrees (flat: 0). So a
// round made of 12 sides, 30 degrees each, is still round, and the edges of a cube or of an octagonal hopper are edges. Which
// side a triangle's corners turn about is not used: the surface is felt from both sides. An edge of one triangle is a
// rim; one of three or more parts all of them.
//
// Who answers at a sharp edge. A patch answers with its nearest point p. Where p lies on an edge or a corner that it shares with
// others, it answers only if no triangle there has a nearer point (else the others hold the grain, and this patch would
// push a second time), and, where others are nearest at the same p, only if it is the first among them. Seen from a
// ridge, one patch answers; in a groove, both do. Every edge and corner is evaluated in one way, with the same bits for each
// triangle that has it, so that round-off can neither silence all of them nor let two answer for one point.
//
// Limits: a patch has one contact with a grain, at its nearest point, so a grain that fills a round tube touches one side. Across
// a sharp edge the contact begins anew, at full overlap, without its spring. No length of the mesh's own: vertices
// times a power of two give the same digits.
#pragma once

#include "dem_min/walls.hpp"

#include <array>
#include <vector>

namespace dem_min {

// Triangles as a file gives them: corners shared by triangles are one vertex.
struct Surface {
    std::vector<Vec3> vertices;                 // m
    std::vector<std::array<int, 3>> triangles;  // of vertices
};

// One wall per smooth patch, in order of their first triangles. Throws scaling::InvalidParameter for a corner that is no
// vertex, a vertex that is not finite, or where no triangle has three corners that differ.
std::vector<Wall> mesh_walls(const Surface&);

// The same patch with every length times `factor`.
MeshPatch scaled(const MeshPatch&, double factor);

WallDistance distance(const MeshPatch&, Vec3 point);
double clearance(const MeshPatch&, Vec3 point);
Box bounds(const MeshPatch&);

// A mesh made ready. Triangles stand patch by patch, in the order of the leaves of the patches' trees.
struct Mesh {
    struct Node {
        Box box;
        int begin, end;  // its triangles
        int second;      // the second child; the first stands right behind its parent. 0: a leaf
    };
    std::vector<Vec3> vertices;                 // m
    std::vector<std::array<int, 3>> triangles;  // corners by rising index
    std::vector<Vec3> normal;     // unit, [triangles], either way; 0 where too thin to have one
    std::vector<int> patch_of;    // [triangles]
    std::vector<int> star_begin;  // [vertices + 1]
    std::vector<int> star;        // triangles at vertex v: star[star_begin[v] .. star_begin[v + 1])
    std::vector<int> root;        // [patches], of its tree in `nodes`
    std::vector<Node> nodes;
};

}  // namespace dem_min
