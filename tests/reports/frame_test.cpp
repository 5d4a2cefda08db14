// SPDX-License-Identifier: MIT
// Frames as the programs see them that users open them with: VTK's own reader, LAMMPS' own read_dump.
// A program that is missing fails the test.
#include "reports/frame.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using reports::Frame;

// Numbers that need all their digits, of every size that a powder has, and an id that is no place.
Frame sample() {
    Frame f;
    f.step = 123456789012;
    f.time = 1.0 / 3.0;
    f.low = {-1e-3, -2e-3, -3e-3};
    f.high = {1e-3, 2e-3, 1.0 / 300.0};
    f.id = {2, 1, 40};
    f.position = {
        {1e-4 / 3.0, -2e-3 / 7.0, 1e-3 / 9.0}, {0.0, 0.0, -1.2e-6}, {-1e-3 / 3.0, 1e-21, 3e-3}};
    f.velocity = {{0.1 / 3.0, -2.0, 1e-300}, {0.0, 0.0, 0.0}, {3.0, 1.0 / 7.0, -1e-9}};
    f.spin = {{1e4 / 3.0, -1.0, 0.5}, {0.0, 0.0, 0.0}, {-1.0 / 9.0, 2.0, 3.0}};
    f.radius = {6e-7, 5e-4 / 3.0, 1e-4};
    f.mass = {5.5e-15 / 7.0, 1e-6 / 3.0, 1e-8};
    f.fixed = {0, 1, 0};
    return f;
}

class File {
  public:
    explicit File(const std::string& name) {
        std::string folder =
            (std::filesystem::temp_directory_path() / "similitude-XXXXXX").string();
        REQUIRE(mkdtemp(folder.data()) != nullptr);
        folder_ = folder;
        path = (folder_ / name).string();
    }
    ~File() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    template <class Write>
    void write(Write&& make) const {
        std::ofstream out(path, std::ios::binary);
        make(out);
    }
    std::string path;

  private:
    std::filesystem::path folder_;
};

struct Said {
    int code;
    std::string text;
};

Said said_by(const std::string& command) {
    Said said{-1, ""};
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 4096> buffer{};
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
        said.text.append(buffer.data(), n);
    said.code = pclose(pipe);
    return said;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

// strtod takes the denormal that a stream may refuse.
std::vector<double> numbers(const std::string& line) {
    std::istringstream in(line);
    std::vector<double> values;
    for (std::string word; in >> word;) values.push_back(std::strtod(word.c_str(), nullptr));
    return values;
}

std::vector<std::string> as_vtk_reads(const Frame& frame) {
    const File file("frame.vtp");
    file.write([&](std::ostream& out) { reports::write_vtp(out, frame); });
    const Said vtk = said_by("/usr/bin/python3 tests/reports/read_vtp.py " + file.path);
    if (vtk.text.find("python3-vtk9 is missing") != std::string::npos)
        FAIL("this test reads frames with VTK: install the Debian package python3-vtk9");
    INFO(vtk.text);
    REQUIRE(vtk.code == 0);
    return lines_of(vtk.text);
}

std::vector<double> in_order_of_vtk(const Frame& f, std::size_t k) {
    const auto &x = f.position[k], &v = f.velocity[k], &w = f.spin[k];
    return {x.x,
            x.y,
            x.z,
            static_cast<double>(f.id[k]),
            f.radius[k],
            2.0 * f.radius[k],
            v.x,
            v.y,
            v.z,
            w.x,
            w.y,
            w.z,
            static_cast<double>(f.fixed[k])};
}

// The grain with this id as read_dump of LAMMPS reads it from the frame of this step.
std::vector<std::string> as_lammps_reads(const std::string& dump, std::int64_t step) {
    const File deck("in.lmp");
    const std::string out = deck.path + ".out";
    deck.write([&](std::ostream& text) {
        text << "units si\natom_style hybrid sphere charge\nboundary f f f\n"
                "region all block -1 1 -1 1 -1 1\ncreate_box 2 all\nmass * 1\n"
             << "read_dump " << dump << " " << step
             << " x y z vx vy vz q box yes add keep label q radius\n"
             << "variable d atom 2*q\nset group all diameter v_d\n"
             << "write_dump all custom " << out
             << " id type x y z vx vy vz radius modify format float %.17g sort id\n";
    });
    if (said_by("command -v lmp").code != 0)
        FAIL("this test reads frames with LAMMPS: install the Debian package lammps");
    const Said lammps = said_by("lmp -log none -in " + deck.path);
    INFO(lammps.text);
    REQUIRE(lammps.code == 0);
    std::ifstream file(out);
    std::ostringstream text;
    text << file.rdbuf();
    return lines_of(text.str());
}

std::vector<double> in_order_of_lammps(const Frame& f, std::size_t k) {
    const auto &x = f.position[k], &v = f.velocity[k];
    return {static_cast<double>(f.id[k]),
            f.fixed[k] ? 2.0 : 1.0,
            x.x,
            x.y,
            x.z,
            v.x,
            v.y,
            v.z,
            f.radius[k]};
}

}  // namespace

TEST_CASE("frame: VTK's own reader sees every number of a VTP file to the last bit",
          "[reports][frame]") {
    const Frame f = sample();
    const std::vector<std::string> lines = as_vtk_reads(f);
    REQUIRE(lines.size() == 5);
    CHECK(numbers(lines[0]) == std::vector{f.time});
    for (std::size_t k = 0; k < f.count(); ++k)
        CHECK(numbers(lines[1 + k]) == in_order_of_vtk(f, k));
    CHECK(lines[4] == "0 1 2");  // one vertex a grain
}

TEST_CASE("frame: VTK reads a frame without a grain", "[reports][frame]") {
    Frame empty;
    empty.time = 0.25;
    const std::vector<std::string> lines = as_vtk_reads(empty);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0] == "0.25");
    CHECK(lines[1].empty());
}

TEST_CASE("frame: read_dump of LAMMPS finds each frame of a file and every number to the last bit",
          "[reports][frame]") {
    const Frame early = sample();
    Frame late = sample();
    late.step += 10;
    late.position[0].x *= 2.0;
    const File file("pile.lammpstrj");
    file.write([&](std::ostream& out) {
        reports::write_lammps(out, early, true);
        reports::write_lammps(out, late, false);
    });
    const std::array<std::size_t, 3> by_id = {1, 0, 2};  // ids 1, 2, 40
    for (const Frame* f : std::array<const Frame*, 2>{&early, &late}) {
        const std::vector<std::string> lines = as_lammps_reads(file.path, f->step);
        REQUIRE(lines.size() == 9 + 3);  // nine lines of heading
        for (std::size_t k = 0; k < 3; ++k)
            CHECK(numbers(lines[9 + k]) == in_order_of_lammps(*f, by_id[k]));
        CHECK(numbers(lines[5]) == std::vector{f->low.x, f->high.x});
        CHECK(numbers(lines[7]) == std::vector{f->low.z, f->high.z});
    }
}

TEST_CASE("frame: the LAMMPS dump says units, time and what each column is", "[reports][frame]") {
    std::ostringstream out;
    reports::write_lammps(out, sample(), true);
    const std::vector<std::string> lines = lines_of(out.str());
    REQUIRE(lines.size() == 13 + 3);
    CHECK(lines[0] == "ITEM: UNITS");
    CHECK(lines[1] == "si");
    CHECK(lines[2] == "ITEM: TIME");
    CHECK(numbers(lines[3]) == std::vector{1.0 / 3.0});
    CHECK(lines[12] ==
          "ITEM: ATOMS id type x y z vx vy vz omegax omegay omegaz radius mass diameter");
    const std::vector<double> grain = numbers(lines[13]);
    REQUIRE(grain.size() == 14);
    CHECK(grain[8] == 1e4 / 3.0);
    CHECK(grain[11] == 6e-7);
    CHECK(grain[12] == 5.5e-15 / 7.0);
    CHECK(grain[13] == 2.0 * 6e-7);
}

// The grammar of github.com/libAtoms/extxyz: count; key=value pairs, of which Properties names, types and counts the
// columns; a line an atom.
TEST_CASE("frame: an extended XYZ has as many columns as it declares, its cell holds the grains",
          "[reports][frame]") {
    const Frame f = sample();
    std::ostringstream out;
    reports::write_extxyz(out, f);
    const std::vector<std::string> lines = lines_of(out.str());
    REQUIRE(lines.size() == 2 + 3);
    CHECK(lines[0] == "3");
    for (const char* part :
         {"pbc=\"F F F\"", " Time=0.3333333333333333 ", "Step=123456789012", "units=\"m kg s rad\"",
          "Origin=\"-0.001 -0.002 -0.003\"", "Lattice=\"0.002 0 0 0 0.004 0 0 0 "})
        CHECK(lines[1].find(part) != std::string::npos);
    const std::size_t at = lines[1].find("Properties=") + 11;
    std::istringstream properties(lines[1].substr(at, lines[1].find(' ', at) - at));
    std::size_t columns = 0, radius_at = 0;
    for (std::string name, type, count; std::getline(properties, name, ':') &&
                                        std::getline(properties, type, ':') &&
                                        std::getline(properties, count, ':');) {
        if (name == "radius") radius_at = columns;
        columns += std::stoul(count);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<double> grain = numbers(lines[2 + k]);  // the species X counts as 0
        REQUIRE(grain.size() == columns);
        CHECK(grain[1] == f.position[k].x);
        CHECK(grain[3] == f.position[k].z);
        CHECK(grain[radius_at] == f.radius[k]);
    }
}

TEST_CASE("frame: a ParaView collection carries times and names, escaped", "[reports][frame]") {
    std::ostringstream out;
    reports::write_pvd(
        out, {{0.0, "a&b-vtp/frame-000000.vtp"}, {1.0 / 3.0, "a&b-vtp/frame-000001.vtp"}});
    CHECK(out.str().find(
              "<DataSet timestep=\"0\" part=\"0\" file=\"a&amp;b-vtp/frame-000000.vtp\"/>") !=
          std::string::npos);
    CHECK(out.str().find("timestep=\"0.3333333333333333\"") != std::string::npos);
}
