// SPDX-License-Identifier: MIT
// Converted files as the programs see them that users open them with. A program that is missing fails the test, but for Yade, which
// is as large as a desktop.
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <sstream>

using Catch::Matchers::Contains;

namespace {

// Two frames of LIGGGHTS in cgs, with numbers that need all their digits.
const char* const dump = R"(ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS ff ff ff
-1 1
-1 1
0 2
ITEM: ATOMS id type x y z vx vy vz omegax omegay omegaz radius density
4 1 0 0 1 0 0 0 0 0 0 0.1 2.5
ITEM: TIMESTEP
20
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS ff ff ff
-1 1
-1 1
0 2
ITEM: ATOMS id type x y z vx vy vz omegax omegay omegaz radius density
4 1 0.3333333333333333 -0.25 0.7 -3 2 0.1 1 2 3 0.1 2.5
9 3 -0.5 0.125 0.15 0 0 0 0 0 0 0.142857142857142857 4
)";

void need(const std::string& check, const std::string& package) {
    if (std::system((check + " > /dev/null 2>&1").c_str()) != 0)
        FAIL("this test opens files with a program that is missing: install the Debian package "
             << package);
}

std::vector<std::vector<double>> numbers_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::vector<double>> rows;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        rows.emplace_back();
        for (double v = 0.0; words >> v;) rows.back().push_back(v);
    }
    return rows;
}

Outcome converted(const Folder& folder, const std::string& to, const std::string& out,
                  std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"convert", "grains", folder.write("heap.dump", dump), folder / out,
                               "--to", to, "--units", "cgs"});
    const Outcome o = similitude(more);
    INFO(o.err);
    REQUIRE(o.code == 0);
    return o;
}

}  // namespace

// 0.1 cm and 2.5 g/cm^3 are 1 mm and 2500 kg/m^3. LAMMPS computes masses of its own from what it reads.
TEST_CASE(
    "convert grains: LAMMPS reads the data file: places, diameters, masses, velocities, spins",
    "[app][formats]") {
    need("command -v lmp", "lammps");
    const Folder folder;
    converted(folder, "lammps_data", "heap.data");
    const std::string deck = folder.write(
        "in.lmp", "units si\natom_style sphere\nboundary f f f\nread_data " + folder / "heap.data" +
                      "\nwrite_dump all custom " + folder / "read.txt" +
                      " id type x y z vx vy vz omegax omegay omegaz radius mass"
                      " modify format float %.17g sort id\n");
    output_of("lmp -log none -in " + deck);
    const auto rows = numbers_of(contents(folder / "read.txt"));
    REQUIRE(rows.size() == 11);
    const std::vector<double> first = rows[9], second = rows[10];
    const double pi = 3.14159265358979323846;
    const std::vector<double> expected{
        4, 1,    0.3333333333333333e-2,         -0.25e-2, 0.7e-2, -3e-2, 2e-2, 0.1e-2, 1, 2,
        3, 1e-3, 2500.0 * 4.0 / 3.0 * pi * 1e-9};
    REQUIRE(first.size() == expected.size());
    for (std::size_t k = 0; k < first.size(); ++k)
        CHECK(first[k] == Approx(expected[k]).epsilon(1e-13));  // products of a few rounded factors
    CHECK(second[0] == 9.0);
    CHECK(second[1] == 3.0);
    CHECK(second[11] == Approx(1e-2 / 7.0).epsilon(1e-13));
}

TEST_CASE("convert grains: all frames of a dump as a ParaView collection, as VTK reads it",
          "[app][formats]") {
    need("/usr/bin/python3 -c 'import vtk'", "python3-vtk9");
    const Folder folder;
    converted(folder, "pvd", "heap.pvd", {"--frame", "all"});
    CHECK_THAT(contents(folder / "heap.pvd"), Contains("heap-vtp/frame-000001.vtp"));
    const auto rows = numbers_of(output_of("/usr/bin/python3 tests/reports/read_vtp.py " +
                                           folder / "heap-vtp/frame-000001.vtp"));
    REQUIRE(rows.size() == 4);
    CHECK(rows[1][0] == Approx(0.3333333333333333e-2).epsilon(1e-15));
    CHECK(rows[2][3] == 9.0);
    CHECK(rows[2][4] == Approx(1e-2 / 7.0).epsilon(1e-15));
}

TEST_CASE("convert grains: pandas reads the CSV, and so do we", "[app][formats]") {
    need("/usr/bin/python3 -c 'import pandas'", "python3-pandas");
    const Folder folder;
    converted(folder, "csv", "heap.csv");
    const auto rows = numbers_of(output_of(
        "/usr/bin/python3 -c \"import pandas; t = pandas.read_csv('" + folder / "heap.csv" +
        "', float_precision='round_trip'); print(*t['x [m]']); print(*t['radius [m]']); "
        "print(*t['vy [m/s]'])\""));
    REQUIRE(rows.size() == 3);
    CHECK(rows[0][0] == Approx(0.3333333333333333e-2).epsilon(1e-15));
    CHECK(rows[1][1] == Approx(1e-2 / 7.0).epsilon(1e-15));
    CHECK(rows[2][0] == Approx(2e-2).epsilon(1e-15));
    const Outcome again = similitude({"measure", folder / "heap.csv", "--json", "-"});
    CHECK(again.json()["diameter"]["largest"].get<double>() == Approx(2e-2 / 7.0).epsilon(1e-15));
}

TEST_CASE("convert grains: Yade's ymport.text reads the spheres", "[app][formats]") {
    const Folder folder;
    const Outcome o = converted(folder, "yade_text", "heap.txt");
    CHECK_THAT(o.err, Contains("left out: ") && Contains("velocity") && Contains("mass"));
    CHECK_THAT(contents(folder / "heap.txt"), Contains("\n-0.005 0.00125 0.0015 "));
    if (std::system("command -v yade > /dev/null 2>&1") != 0) {
        WARN("Yade is not installed: that it reads the file is not checked here");
        return;
    }
    const std::string script = folder.write(
        "read.py", "from yade import ymport\nfor b in ymport.text('" + folder / "heap.txt" +
                       "'):\n    print('SPHERE', *b.state.pos, b.shape.radius)\n");
    const std::string said = output_of("yade -n -x " + script);
    const std::size_t at = said.rfind("SPHERE");
    REQUIRE(at != std::string::npos);
    const auto last = numbers_of(said.substr(at + 6)).at(0);
    REQUIRE(last.size() == 4);
    CHECK(last[0] == Approx(-0.5e-2).epsilon(1e-15));
    CHECK(last[3] == Approx(1e-2 / 7.0).epsilon(1e-15));
}

TEST_CASE("convert grains: there and back through every format keeps places and sizes",
          "[app][formats]") {
    const std::string to = GENERATE("lammps_dump", "lammps_data", "csv", "yade_text");
    const Folder folder;
    converted(folder, to, "there");
    const Outcome back = similitude({"convert", "grains", folder / "there", folder / "back.csv",
                                     "--from", to, "--to", "csv", "--quiet"});
    INFO(back.err);
    REQUIRE(back.code == 0);
    const auto of = [](const nlohmann::ordered_json& j) {
        return std::vector<double>{j["diameter"]["smallest"], j["diameter"]["largest"],
                                   j["diameter"]["mean"]};
    };
    const auto first =
        similitude({"measure", folder / "heap.dump", "--units", "cgs", "--json", "-"}).json();
    const auto second = similitude({"measure", folder / "back.csv", "--json", "-"}).json();
    for (std::size_t k = 0; k < 3; ++k) CHECK(of(second)[k] == Approx(of(first)[k]).epsilon(1e-15));
    CHECK(second["grains"] == first["grains"]);
}

TEST_CASE("convert grains: what a format cannot hold is refused", "[app][formats][input]") {
    const Folder folder;
    const std::string text = folder.write("a.txt", "0 0 1 0.5\n");
    const auto complaint = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"convert", "grains", text});
        const Outcome o = similitude(more);
        CHECK(o.code == 2);
        return o.err;
    };
    CHECK_THAT(complaint({folder / "b", "--to", "lammps_data"}), Contains("--density"));
    CHECK_THAT(complaint({folder / "b", "--to", "csv", "--frame", "all"}), Contains("one frame"));
    CHECK_THAT(complaint({text, "--to", "csv"}), Contains("must not be the file that is read"));
    CHECK_FALSE(std::filesystem::exists(folder / "b"));
    CHECK(similitude({"convert", "grains", text, folder / "b", "--to", "lammps_data", "--density",
                      "2500 kg/m^3"})
              .code == 0);
}
