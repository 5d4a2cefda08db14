// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <cmath>

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
                x += "," + std::to_string(i), z += "," + std::to_string(k);
                y += "," + std::to_string(100.5 + j);
                ++n;
            }
    return "TIME:,1.5\nQ01 : Total Number of Particles:," + std::to_string(n) +
           "\nQ02 : Particle Position X:" + x + "\nQ03 : Particle Position Y:" + y +
           "\nQ04 : Particle Position Z:" + z + "\n";
}

}  // namespace

// The lattice is stepped: half a grain of error over a flank of about six grains is some 3 degrees.
TEST_CASE("measure: a cone of 30 degrees in EDEM's export, y up, is read as one",
          "[app][measure]") {
    const Folder folder;
    const std::string file = folder.write("export.csv", edem_cone());
    const Outcome o =
        similitude({"measure", file, "--length-unit", "mm", "--diameter", "1 mm", "--up", "y",
                    "--base-diameter", "20 mm", "--base-height", "100 mm", "--json", "-"});
    const Json j = o.json();
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
