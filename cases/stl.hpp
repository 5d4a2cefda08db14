// SPDX-License-Identifier: MIT
// Walls from STL files, binary or ASCII. STL carries no unit: the case states it.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace cases {

struct Mesh {
    std::string path;
    std::vector<std::array<double, 3>> vertices;  // m
    std::vector<std::array<int, 3>> triangles;    // of vertices, three different ones each
    std::vector<std::string> notes;  // what a user should know of it: open edges and the like
};

// Corners closer than 5e-7 of the largest coordinate are one vertex: STL is written in floats, whose last digit is worth 1.2e-7
// of that, and four of those are let pass. Triangles that lose a corner by that are left out. A file is binary where its size
// is that of the number of triangles at byte 80, whatever it begins with, else text if it reads as text. Normals in the file
// are not used.
//
// `unit` is metres per unit of the file. Throws scaling::InvalidInput for a file that is not there, cut off, damaged, without
// a triangle of some area, or with a coordinate that is no finite number.
Mesh read_stl(const std::string& path, double unit);

}  // namespace cases
