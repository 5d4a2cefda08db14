// SPDX-License-Identifier: MIT
// STL files written here byte by byte, after the format as its makers published it (3D Systems, 1989): 80 bytes of title, a 32-bit
// count, then per triangle 12 floats and 2 bytes, little-endian; or the text of solid, facet, outer loop, vertex.
#include "cases/stl.hpp"

#include "cases/read_case.hpp"
#include "sample_case.hpp"
#include "scaling/errors.hpp"
#include "temporary_case.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace {

using Triangle = std::array<float, 9>;
using scaling::InvalidInput;

void put(std::string& bytes, std::uint32_t value) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> (8 * k) & 255U);
}

void put(std::string& bytes, float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    put(bytes, bits);
}

std::string binary(const std::vector<Triangle>& triangles, std::string title = "solid of nobody") {
    title.resize(80, ' ');
    std::string bytes = title;
    put(bytes, static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& t : triangles) {
        for (int k = 0; k < 3; ++k) put(bytes, std::numeric_limits<float>::quiet_NaN());  // normal
        for (const float x : t) put(bytes, x);
        bytes += std::string(2, '\0');
    }
    return bytes;
}

// Two triangles of a square of side 2 at z = 3, and one that stands on a side of it.
const std::vector<Triangle> corner{
    {0, 0, 3, 2, 0, 3, 2, 2, 3}, {0, 0, 3, 2, 2, 3, 0, 2, 3}, {0, 0, 3, 2, 0, 3, 1, 0, 5}};

const std::string text_corner = R"(solid funnel of Mr. facet
  facet normal 0 0 1
    outer loop
      vertex 0 0 3
      vertex 2.0 0 3e0
      vertex +2 2 3
    endloop
  endfacet
  FACET NORMAL nan nan nan OUTER LOOP VERTEX 0 0 3 VERTEX 2 2 3 VERTEX 0 2 3 ENDLOOP ENDFACET
endsolid funnel of Mr. facet
solid
  facet normal 0 0 1 outer loop vertex 0 0 3 vertex 2 0 3 vertex 1 0 5 endloop endfacet
endsolid
)";

cases::Mesh read(const std::string& bytes, double unit = 1.0) {
    const TemporaryFolder folder;
    return cases::read_stl(folder.write("m.stl", bytes), unit);
}

// The message behind the folder's name.
std::string mistake_in(const std::string& bytes) {
    const TemporaryFolder folder;
    const std::string path = folder.write("m.stl", bytes);
    const std::string message = message_of<InvalidInput>([&] { (void)cases::read_stl(path, 1.0); });
    CHECK(std::count(message.begin(), message.end(), '\n') == 0);
    REQUIRE(message.starts_with(folder.path() + "/"));
    return message.substr(folder.path().size() + 1);
}

// A case with a pile whose conditions hold `more`, beside m.stl.
cases::Case pile_with(const TemporaryFolder& folder, const std::string& more) {
    const std::string drop =
        "\"rig\": \"drop\", \"conditions\": {\"height\": \"600 mm\"}, \"recording\": "
        "\"drop-1.csv\",\n     \"noise\": {\"z\": \"1.5 mm\"}";
    folder.write("m.stl", binary(corner));
    return cases::read_case(folder.write(
        "case.json", replaced(sample_case, drop,
                              "\"rig\": \"pile\", \"conditions\": {\"base\": \"glued_grains\", "
                              "\"base_diameter\": \"50 mm\", \"grains\": 100, " +
                                  more + "}")));
}

std::string mistake_with(const std::string& more) {
    const TemporaryFolder folder;
    const std::string message = message_of<InvalidInput>([&] { (void)pile_with(folder, more); });
    const std::string start = folder.path() + "/case.json: experiments[0].conditions";
    REQUIRE(message.starts_with(start));
    return message.substr(start.size());
}

const std::string feed = "\"drop_height\": \"9 mm\", \"feed_diameter\": \"20 mm\", ";

}  // namespace

TEST_CASE("binary and text hold the same mesh", "[cases][stl]") {
    const cases::Mesh mesh = GENERATE(read(binary(corner), 1e-3), read(text_corner, 1e-3));
    REQUIRE(mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}});
    const std::vector<std::array<double, 3>> expected{
        {0, 0, 3e-3}, {2e-3, 0, 3e-3}, {2e-3, 2e-3, 3e-3}, {0, 2e-3, 3e-3}, {1e-3, 0, 5e-3}};
    REQUIRE(mesh.vertices.size() == expected.size());
    for (std::size_t v = 0; v < expected.size(); ++v)
        for (std::size_t k = 0; k < 3; ++k)  // 1e-15: one product
            CHECK(mesh.vertices[v][k] == Approx(expected[v][k]).epsilon(1e-15));
    // Of seven edges the diagonal and the side at y = 0 have two triangles.
    REQUIRE(mesh.notes.size() == 1);
    CHECK(mesh.notes[0].ends_with("m.stl: 5 open edges; fine for a funnel, not for a closed body"));
}

TEST_CASE("a text that begins like a binary file's title is told apart by its size",
          "[cases][stl]") {
    REQUIRE(read(binary(corner, "solid")).triangles.size() == 3);
    REQUIRE(read(binary(corner, "facet normal")).triangles.size() == 3);
}

// Coordinates of a mesh 100 wide are written to 7.6e-6 (half of the last bit of 100): corners so far apart are one.
TEST_CASE("corners are welded within the digits of a float, and no farther", "[cases][stl]") {
    const float near = 100.0F + 1.5e-5F, far = 100.0F + 1e-3F;
    const auto strip = [](float x) {
        return binary({{0, 0, 0, 100, 0, 0, 100, 100, 0}, {x, 0, 0, 200, 0, 0, x, 100, 0}});
    };
    CHECK(read(strip(near)).vertices.size() == 4);
    CHECK(read(strip(far)).vertices.size() == 6);
    // The same, a thousandth of the size: the tolerance is the mesh's own.
    const float s = 1.0F / 1024.0F;
    CHECK(read(binary({{0, 0, 0, 100 * s, 0, 0, 100 * s, 100 * s, 0},
                       {far * s, 0, 0, 200 * s, 0, 0, far * s, 100 * s, 0}}))
              .vertices.size() == 6);
    // A triangle that is a line after welding is left out, and said to be.
    const cases::Mesh mesh =
        read(binary({{0, 0, 0, 100, 0, 0, 100, 100, 0}, {100, 0, 0, near, 0, 0, 100, 100, 0}}));
    CHECK(mesh.triangles.size() == 1);
    CHECK(mesh.notes.at(0).ends_with("1 triangles with two corners in one place were left out"));
}

TEST_CASE("edges of more than two triangles are noted", "[cases][stl]") {
    std::vector<Triangle> fan = corner;
    fan.push_back({0, 0, 3, 2, 0, 3, 1, 0, 1});
    const cases::Mesh mesh = read(binary(fan));
    REQUIRE(mesh.notes.size() == 2);
    CHECK(mesh.notes[1].ends_with(
        "1 edges with more than two triangles; the surface is parted there"));
    // A closed body has nothing to be noted.
    CHECK(read(binary({{0, 0, 0, 1, 0, 0, 0, 1, 0},
                       {0, 0, 0, 1, 0, 0, 0, 0, 1},
                       {0, 0, 0, 0, 1, 0, 0, 0, 1},
                       {1, 0, 0, 0, 1, 0, 0, 0, 1}}))
              .notes.empty());
}

TEST_CASE("a bad STL file is refused in one line", "[cases][stl][bad]") {
    const std::string whole = binary(corner);
    CHECK(mistake_in(whole.substr(0, whole.size() - 7)) ==
          "m.stl: got 227 bytes, must be 234 bytes for the 3 triangles it states (the file is cut "
          "off; export the mesh again)");
    CHECK(mistake_in(whole + '\0') ==
          "m.stl: got 235 bytes, must be 234 bytes for the 3 triangles it states (there is more "
          "behind them; export the mesh again)");
    CHECK(mistake_in(std::string("\0\1", 2)) ==
          "m.stl: got 2 bytes, must be an STL file, 84 bytes at least (export the mesh again)");
    CHECK(mistake_in(binary({})) ==
          "m.stl: got no triangle, must hold a surface of triangles (export the mesh again)");
    CHECK(mistake_in("solid\nendsolid\n") ==
          "m.stl: got no triangle, must hold a surface of triangles (export the mesh again)");
    CHECK(mistake_in(binary({{0, 0, 0, 1, 1, 1, 2, 2, 2}, {1, 1, 1, 1, 1, 1, 0, 0, 0}})) ==
          "m.stl: got 2 triangles without area, must hold a surface of triangles (export the mesh "
          "again)");
    CHECK(mistake_in(binary({corner[0], {0, 0, 0, 1, NAN, 0, 1, 1, 0}})) ==
          "m.stl: triangle 2: got nan, must be a finite number (export the mesh again)");
    CHECK(mistake_in(replaced(text_corner, "vertex 2.0 0 3e0", "vertex inf 0 3")) ==
          "m.stl: triangle 1: got inf, must be a finite number (export the mesh again)");
    CHECK(mistake_in(replaced(text_corner, "vertex 2.0 0 3e0", "vertex 2.0 0 3,5")) ==
          "m.stl: line 5: got \"3,5\", must be a number (export the mesh again)");
    CHECK(mistake_in(text_corner.substr(0, text_corner.find("    endloop"))) ==
          "m.stl: line 7: got the end of the file, must be \"endloop\" (the file is cut off; "
          "export the mesh again)");
    CHECK(mistake_in(text_corner.substr(0, text_corner.rfind("endsolid"))) ==
          "m.stl: line 13: got the end of the file, must be \"facet\" or \"endsolid\" (the file is "
          "cut off; export the mesh again)");
    CHECK(mistake_in("\n{\"no\": \"stl\"}") ==
          "m.stl: line 2: got \"{\"no\":\", must be \"solid\" (export the mesh again)");
    CHECK(mistake_in("") ==
          "m.stl: line 1: got the end of the file, must be \"solid\" (the file is "
          "cut off; export the mesh again)");
}

TEST_CASE("a case has its meshes in metres, shifted", "[cases][stl][read]") {
    const TemporaryFolder folder;
    const cases::Case c = pile_with(
        folder, feed +
                    "\"mesh\": [{\"file\": \"m.stl\", \"unit\": \"cm\"}, {\"file\": \"m.stl\", "
                    "\"unit\": \"mm\", \"shift\": [\"1 mm\", \"-2 um\", \"0 m\"]}]");
    const std::vector<cases::Mesh>& meshes = c.experiments.at(0).meshes;
    REQUIRE(meshes.size() == 2);
    CHECK(meshes[0].vertices[2][2] == Approx(0.03).epsilon(1e-15));
    CHECK(meshes[1].vertices[2][0] == Approx(0.003).epsilon(1e-15));
    CHECK(meshes[1].vertices[2][1] == Approx(0.001998).epsilon(1e-15));
    CHECK(meshes[1].vertices[2][2] == Approx(0.003).epsilon(1e-15));
}

TEST_CASE("a mesh of a case that cannot be read is refused in one line", "[cases][stl][bad]") {
    const std::string good = "{\"file\": \"m.stl\", \"unit\": \"mm\"}";
    CHECK(mistake_with(feed + "\"mesh\": {\"file\": \"m.stl\"}") ==
          ".mesh.unit: got nothing, must be given (STL has no unit of its own; write \"unit\": "
          "\"mm\")");
    CHECK(mistake_with(feed + "\"mesh\": " + replaced(good, "\"mm\"", "\"ms\""))
              .starts_with(".mesh.unit: got \"1 ms\" [T], must be a length [L]"));
    CHECK(mistake_with(feed + "\"mesh\": [" + replaced(good, "m.stl", "n.stl") + "]")
              .starts_with(
                  ".mesh[0].file: got \"n.stl\", must be a file beside case.json (no file "));
    CHECK(mistake_with(feed + "\"mesh\": []") ==
          ".mesh: got a list of 0, must be a list of one or more (write [ ] around them, commas "
          "between)");
    CHECK(mistake_with(feed + "\"mesh\": \"m.stl\"").starts_with(".mesh: got \"m.stl\", must be"));
    CHECK(mistake_with(feed + "\"mesh\": " + replaced(good, "}", ", \"shift\": \"1 mm\"}")) ==
          ".mesh.shift: got \"1 mm\", must be a list of 3 (write [ ] around them, commas between)");
    CHECK(mistake_with("\"drop_height\": \"9 mm\", \"mesh\": " + good) ==
          ".feed_diameter: got nothing, must be given beside a mesh (say where the grains appear)");
}
