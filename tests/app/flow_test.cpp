// SPDX-License-Identifier: MIT
// The rigs `discharge`, `column` and `drum` as a user runs them.
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr const char* soft_beads = R"({
  "format": "similitude-case/1",
  "grain": {"diameter": "1 mm", "density": "2500 kg/m^3", "youngs_modulus": "0.1 MPa", "poisson_ratio": 0.3},
  "plate": {"youngs_modulus": "0.1 MPa", "poisson_ratio": 0.3},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin"],
    "parameters": {"restitution": {"value": 0.5}, "sliding_friction": {"value": 0.5}}},
  "experiments": [
    {"id": "silo", "rig": "discharge", "conditions": {"silo_shape": "box", "width": "8 mm", "depth": "5 mm",
      "outlet_width": "5 mm", "outlet_depth": "4.5 mm", "grains": 120}},
    {"id": "drum", "rig": "drum", "conditions": {"drum_diameter": "8 mm", "drum_length": "3 mm",
      "rotation_speed": "60 rpm", "fill_fraction": "40 %"}}
  ]
})";

std::vector<std::string> command(const std::string& path, const std::string& out) {
    return {"simulate",     path,    "--out", out,         "--dump", "lammps",
            "--dump-every", "20 ms", "--yes", "--threads", "1"};
}

}  // namespace

TEST_CASE("simulate: a silo and a drum leave their channels, and an interrupt changes nothing",
          "[app][simulate][resume]") {
    const Folder f;
    const std::string path = f.write("case.json", soft_beads);
    const Outcome whole = similitude(command(path, f / "whole"));
    INFO(whole.err);
    REQUIRE(whole.code == 0);
    CHECK(contents(f / "whole/silo.csv").starts_with("t [s],m [kg]\n0,0\n"));
    CHECK(contents(f / "whole/drum.csv").starts_with("t [s],angle [rad]\n0,"));
    CHECK(contents(f / "whole/drum-velocity.csv").starts_with("depth [m],velocity [m/s]\n"));
    const auto runs = nlohmann::json::parse(contents(f / "whole/run.json")).at("runs");
    const std::string ending = runs.at(0).at("result").at("ending");
    CHECK((ending == "drained" || ending == "jammed"));
    CHECK(runs.at(1).at("result").at("quantities").at("dynamic_angle").at("unit") == "rad");
    CHECK(whole.out.find("dynamic angle") != std::string::npos);

    std::vector<std::string> words = command(path, f / "part");
    const double first = runs.at(0).at("wall_time"), second = runs.at(1).at("wall_time");
    const double stops[] = {0.8 * first, 0.3 * first + 0.5 * second};  // s, of each part
    for (const double after : stops) {
        similitude(words, {{static_cast<int>(1000.0 * after), SIGTERM}});
        if (words.back() != "--resume") words.push_back("--resume");
    }
    REQUIRE(similitude(words).code == 0);
    for (const char* file : {"silo.csv", "silo-grains.csv", "silo.lammpstrj", "drum.csv",
                             "drum-velocity.csv", "drum-grains.csv"}) {
        INFO(file);
        CHECK((contents(f / (std::string("part/") + file)) ==
               contents(f / (std::string("whole/") + file))));
    }
}

TEST_CASE("simulate: a silo is refused where another engine has no deck or no region for it",
          "[app][simulate][input]") {
    const Folder f;
    const std::string path = f.write("case.json", soft_beads);
    for (const auto& [engine, rule] : std::vector<std::pair<std::string, std::string>>{
             {"liggghts", "has no deck for the rig discharge (take lammps"},
             {"yade", "has no deck for the rig discharge (take lammps"},
             {"lammps", "has no region for a slot with ends"}}) {
        const Outcome o = similitude({"simulate", path, "--out", f / "out", "--engine", engine});
        CHECK(o.code == 2);
        CHECK(o.err.find("--engine: got " + engine + ", " + rule) != std::string::npos);
    }
}

TEST_CASE("simulate: a drum in LAMMPS leaves the files that our own leaves",
          "[app][simulate][lammps]") {
    if (std::system("command -v lmp > /dev/null") != 0) return;
    const Folder f;
    const std::string path = f.write("case.json", soft_beads);
    const Outcome o = similitude({"simulate", path, "--experiment", "drum", "--out", f / "out",
                                  "--engine", "lammps", "--quiet"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    CHECK(contents(f / "out/drum.csv").starts_with("t [s],angle [rad]\n0,"));
    CHECK(contents(f / "out/drum-velocity.csv").starts_with("depth [m],velocity [m/s]\n"));
    CHECK(contents(f / "out/drum-grains.csv").starts_with("x [m],y [m],z [m],radius [m]\n"));
    CHECK(contents(f / "out/run.json").find("\"name\": \"LAMMPS\"") != std::string::npos);
}

TEST_CASE("simulate: --sleep is of piles, and says so where there is none",
          "[app][simulate][input]") {
    const Folder f;
    const std::string path = f.write("case.json", soft_beads);
    const Outcome o = similitude({"simulate", path, "--out", f / "out", "--sleep"});
    CHECK(o.code == 2);
    CHECK(o.err.find("--sleep") != std::string::npos);
    CHECK(o.err.find("no pile") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(f / "out"));
}
