// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;

// Without adhesion: its necks hold over gaps that geometry does not count.
TEST_CASE("measure: the dump of a run gives the run's own angles, packing and contacts to the bit",
          "[app][measure]") {
    const Folder folder;
    std::string text = tiny_case("\"adhesion\", ", "");
    const std::string w = ", \"work_of_adhesion\": {\"value\": \"20 mJ/m^2\"}";
    text.erase(text.find(w), w.size());
    const std::string path = folder.write("case.json", text);
    REQUIRE(similitude({"simulate", path, "--out", folder / "out", "--dump", "lammps",
                        "--dump-every", "1 s", "--quiet"})
                .code == 0);
    const Json ran = Json::parse(contents(folder / "out/run.json"))["runs"][0]["result"];
    const Outcome o = similitude({"measure", folder / "out/pile.lammpstrj", "--fixed-type", "2",
                                  "--base-diameter", "10 mm", "--json", "-"});
    const Json measured = o.json();
    CHECK(measured["heap"]["angle_of_repose"] == ran["angle_of_repose"]);
    CHECK(measured["heap"]["packing_fraction"] == ran["packing_fraction"]);
    CHECK(measured["heap"]["formed"] == ran["formed"]);
    CHECK(o.code == (ran["formed"] == true ? 0 : 3));
    CHECK(measured["coordination"] == ran["coordination"]);
    CHECK(measured["grains"]["heap"].get<int>() ==
          300 - ran["grains_lost"].get<int>());  // the others fell off
    CHECK(measured["heap"]["criteria"].size() == ran["criteria"].size());
}

namespace {

// A cone of 30 deg on a disc of 20 mm: grains of 1 mm on a square lattice, piled to the height of the cone, y up, in mm.
std::string edem_cone() {
    std::string x, y, z;
    std::size_t n = 0;
    for (int i = -10; i <= 10; ++i)
        for (int k = -10; k <= 10; ++k)
            for (int j = 0; j < 12; ++j) {
                const double r = std::sqrt(double(i * i + k * k));
                if (r > 9.75 || j + 0.5 > (10.0 - r) * 0.57735026919) continue;
                x += fmt::format(",{}", i);
                y += fmt::format(",{}", 100.5 + j);
                z += fmt::format(",{}", k);
                ++n;
            }
    return fmt::format(
        "TIME:,1.5\nQ01 : Total Number of Particles:,{}\nQ02 : Particle Position X:{}\n"
        "Q03 : Particle Position Y:{}\nQ04 : Particle Position Z:{}\n",
        n, x, y, z);
}

}  // namespace

// The lattice is stepped: half a grain of error over a flank of about six grains is some 3 degrees.
TEST_CASE("measure: a cone of 30 degrees in EDEM's export, y up, is read as one",
          "[app][measure]") {
    const Folder folder;
    const std::string file = folder.write("export.csv", edem_cone());
    const Outcome o = similitude({"measure", file, "--length-unit", "mm", "--diameter", "1 mm",
                                  "--up", "y", "--base-diameter", "20 mm", "--base-height",
                                  "100 mm", "--json", "-", "--report", folder / "heap.html"});
    const Json j = o.json();
    const std::string page = contents(folder / "heap.html");
    CHECK(page.find("export.csv") != std::string::npos);
    CHECK(page.find("two_h_over_d") != std::string::npos);
    CHECK(page.find("whether the heap is at rest is not known") != std::string::npos);
    CHECK(j["file_format"] == "edem_csv");
    CHECK(j["time"] == 1.5);
    CHECK(j["velocities"] == false);
    CHECK(j["grains"]["below_base"] == 0);
    const double angle = j["heap"]["angle_of_repose"]["cone"]["angle"].get<double>() * 57.29578;
    CHECK(angle == Approx(30.0).margin(3.0));
    const Outcome wrong_up =
        similitude({"measure", file, "--length-unit", "mm", "--diameter", "1 mm", "--base-diameter",
                    "20 mm", "--base-height", "100 mm", "--json", "-"});
    CHECK(wrong_up.json()["grains"]["heap"] == 0);
}

// Two grains overlapping by 2 um and one alone, as LIGGGHTS itself writes them.
TEST_CASE("measure: LIGGGHTS' own dump and data are read", "[app][measure]") {
    if (std::system("command -v liggghts > /dev/null 2>&1") != 0) {
        WARN("LIGGGHTS is not installed: that its files are read is not checked here");
        return;
    }
    const Folder folder;
    const std::string deck =
        folder.write("in.liggghts",
                     "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\n"
                     "units si\ncommunicate single vel yes\n"
                     "region box block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\n"
                     "create_box 1 box\nneighbor 0.002 bin\nneigh_modify delay 0\n"
                     "fix 1 all property/global youngsModulus peratomtype 5.e6\n"
                     "fix 2 all property/global poissonsRatio peratomtype 0.45\n"
                     "fix 3 all property/global coefficientRestitution peratomtypepair 1 0.9\n"
                     "fix 4 all property/global coefficientFriction peratomtypepair 1 0.05\n"
                     "pair_style gran model hertz tangential history\npair_coeff * *\n"
                     "timestep 0.00001\n"
                     "create_atoms 1 single 0.001 0.002 0.003 units box\n"
                     "create_atoms 1 single 0.002998 0.002 0.003 units box\n"
                     "create_atoms 1 single -0.004 0.002 0.0035 units box\n"
                     "set group all diameter 0.002 density 2500\nfix 5 all nve/sphere\n"
                     "dump 1 all custom 1 " +
                         folder / "heap.dump" +
                         " id type x y z vx vy vz omegax omegay omegaz radius mass\n"
                         "run 0\nwrite_data " +
                         folder / "heap.data" + "\n");
    REQUIRE(std::system(("cd " + folder / "" + " && liggghts -in " + deck + " > liggghts.out 2>&1")
                            .c_str()) == 0);
    for (const char* name : {"heap.dump", "heap.data"}) {
        const Outcome o = similitude({"measure", folder / name, "--units", "si", "--json", "-"});
        INFO(name << ": " << o.err);
        REQUIRE(o.code == 0);
        CHECK(o.json()["grains"]["heap"] == 3);
        CHECK(o.json()["diameter"]["mean"].get<double>() == Approx(0.002).epsilon(1e-12));
        CHECK(o.json()["contacts"]["between_grains"] == 1);
        // 2 um over R* = 0.5 mm; six digits of the dump leave 1e-8 m
        CHECK(o.json()["largest_overlap_over_r_star"].get<double>() == Approx(0.004).margin(4e-5));
    }
}

TEST_CASE("measure: what is missing is said with its remedy", "[app][measure][input]") {
    const Folder folder;
    const std::string yade = folder.write("grains.txt", "0 0 0.5 0.5\n0 0 1.5 0.5\n");
    const auto complaint = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"measure", yade});
        const Outcome o = similitude(more);
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        return o.err;
    };
    CHECK_THAT(complaint({"--format", "lamps_dump"}), Contains("did you mean \"lammps_dump\"?"));
    CHECK_THAT(complaint({"--frame", "1"}), Contains("must be below 1"));
    CHECK_THAT(complaint({"--base-diameter", "-1 m"}), Contains("must be > 0"));
    CHECK_THAT(complaint({"--units", "lj"}), Contains("--length-unit"));
    CHECK_THAT(complaint({"--units", "si", "--length-unit", "mm"}),
               Contains("the one or the other"));
    CHECK_THAT(complaint({"--base-centre", "1 mm"}), Contains("two lengths"));
    const Outcome fine = similitude({"measure", yade, "--json", "-"});
    CHECK(fine.code == 0);
    CHECK(fine.json()["heap"].is_null());
    CHECK(fine.json()["coordination"] == 1.0);
}
