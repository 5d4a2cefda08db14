// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

namespace {

using Json = nlohmann::ordered_json;

Json manifest(const Folder& f, const std::string& folder) {
    return Json::parse(contents(f / (folder + "/run.json")));
}

std::string hash_of(const Json& run) { return run.at("runs").at(0).at("result").at("hash"); }

}  // namespace

TEST_CASE("simulate: an interrupted heap goes on to the same bits as one that never stopped",
          "[app][simulate]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case());
    const Outcome whole = similitude({"simulate", path, "--out", f / "whole", "--threads", "1"});
    INFO(whole.err);
    REQUIRE(whole.code == 0);

    // A third of the whole run's time, so that the signal comes well inside the second one.
    const double seconds = manifest(f, "whole").at("runs").at(0).at("wall_time");
    const int soon = static_cast<int>(300.0 * seconds);
    const Outcome part =
        similitude({"simulate", path, "--out", f / "part", "--threads", "1", "--yes"}, soon);
    REQUIRE(part.code == 130);
    CHECK_FALSE(manifest(f, "part").at("runs").at(0).at("finished").get<bool>());

    const Outcome other =
        similitude({"simulate", path, "--out", f / "part", "--seed", "2", "--resume"});
    CHECK(other.code == 2);
    CHECK(other.err.find("must belong to this case, seed and version") != std::string::npos);

    const Outcome rest =
        similitude({"simulate", path, "--out", f / "part", "--threads", "1", "--resume"});
    REQUIRE(rest.code == 0);
    CHECK(hash_of(manifest(f, "part")) == hash_of(manifest(f, "whole")));
    CHECK(contents(f / "part/pile.csv") == contents(f / "whole/pile.csv"));
    CHECK(contents(f / "part/pile-grains.csv") == contents(f / "whole/pile-grains.csv"));
    CHECK_FALSE(std::filesystem::exists(f / "part/pile.state.json"));
}

TEST_CASE("simulate: the manifest says what, with which seed, from which input",
          "[app][simulate]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 60"));
    const Outcome o = similitude(
        {"simulate", path, "--out", f / "out", "--seed", "7", "--report", f / "page.html"});
    REQUIRE(o.code == 0);
    CHECK(o.out.find("flank_20_80") != std::string::npos);
    const Json j = manifest(f, "out");
    for (const char* key : {"tool", "case", "inputs", "seed", "runs"}) CHECK(j.contains(key));
    CHECK(j.at("seed") == 7);
    CHECK(j.at("inputs").at(0).at("fnv1a64").get<std::string>().size() == 16);
    CHECK(contents(f / "out/pile.csv").find("azimuth [rad],r [m],z [m]\n") == 0);
    CHECK(contents(f / "page.html").find("id=\"runs\"") != std::string::npos);
}

TEST_CASE("simulate: a drop writes its channels at the recording's own times", "[app][simulate]") {
    // Free fall from 100 mm under 9.81 m/s^2: z(0.1 s) = 0.1 - 9.81 * 0.01 / 2 = 0.05095 m.
    const Folder f;
    f.write("drop.csv", "t [s],z [mm]\n0,100\n0.1,51\n");
    std::string text = tiny_case(
        R"([{"id": "pile", "rig": "pile",
    "conditions": {"base": "glued_grains", "base_diameter": "10 mm", "grains": 300}}])",
        R"([{"id": "drop", "rig": "drop", "conditions": {"height": "100 mm"}, "recording": "drop.csv"}])");
    const std::string with_plate =
        "\"plate\": {\"youngs_modulus\": \"70 GPa\", \"poisson_ratio\": 0.3},\n  ";
    text.insert(text.find("\"model\""), with_plate);
    const Outcome o = similitude({"simulate", f.write("case.json", text), "--out", f / "out"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    double t = 0, z = 0, x = 0;
    const std::string csv = contents(f / "out/drop.csv");
    REQUIRE(std::sscanf(csv.c_str() + csv.rfind("\n0.1,") + 1, "%lf,%lf,%lf", &t, &z, &x) == 3);
    CHECK(z == Approx(0.05095).epsilon(1e-9));  // a parabola carried in one go: round-off
}

TEST_CASE("simulate: the other rigs with a single grain write their channels", "[app][simulate]") {
    const Folder f;
    std::string text = tiny_case(
        R"([{"id": "pile", "rig": "pile",
    "conditions": {"base": "glued_grains", "base_diameter": "10 mm", "grains": 300}}])",
        R"([{"id": "plane", "rig": "incline", "conditions": {"angle": "10 deg"}},
            {"id": "thrown", "rig": "impact", "conditions": {"speed": "1 m/s"}},
            {"id": "curve", "rig": "pull_off", "conditions": {"counterpart": "plate", "preload": "1 mN"}}])");
    const std::string with_plate =
        "\"plate\": {\"youngs_modulus\": \"70 GPa\", \"poisson_ratio\": 0.3},\n  ";
    text.insert(text.find("\"model\""), with_plate);
    const std::string more = R"(, "adhesion", "rolling_resistance")";  // it would stay where it is
    text.erase(text.find(more), more.size());
    const Outcome o = similitude(
        {"simulate", f.write("case.json", text), "--out", f / "out", "--report", f / "page.html"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    // 5/7 g sin(10 degrees), two seconds.
    double t = 0, s = 0;
    const std::string csv = contents(f / "out/plane.csv");
    REQUIRE(std::sscanf(csv.c_str() + csv.rfind("\n2,") + 1, "%lf,%lf", &t, &s) == 2);
    CHECK(s == Approx(0.5 * 4.0 * 5.0 / 7.0 * 9.81 * 0.17364817766693).epsilon(1e-9));
    CHECK(contents(f / "out/thrown.csv")
              .find("angle [rad],normal_restitution,rebound_angle [rad],"
                    "rebound_spin [rad/s],tangential_restitution\n") == 0);
    CHECK(contents(f / "out/curve.csv").find("separation [m],force [N],branch\n") == 0);
    CHECK(contents(f / "page.html").find("force against separation") != std::string::npos);
}

TEST_CASE("simulate: LAMMPS runs a pile only by rules that it has", "[app][simulate][lammps]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 30"));
    const auto says = [&](std::vector<std::string> more, const std::string& words) {
        std::vector<std::string> all = {"simulate", path, "--out", f / "out"};
        all.insert(all.end(), more.begin(), more.end());
        const Outcome o = similitude(all);
        INFO(o.err);
        CHECK(o.code == 2);
        CHECK(o.err.find(words) != std::string::npos);
    };
    says({"--engine", "lamps"}, "must be dem_min, lammps, liggghts or yade");
    says({"--ranks", "2"}, "must go with --engine lammps");
    says({"--engine", "lammps"},
         std::filesystem::exists("/usr/bin/lmp") ? "--contact lammps" : "apt-get install lammps");
}

TEST_CASE("simulate: a heap of LAMMPS has the files and the manifest of one of ours",
          "[app][simulate][lammps]") {
    if (!std::filesystem::exists("/usr/bin/lmp")) return;
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 30"));
    const Outcome o = similitude(
        {"simulate", path, "--out", f / "out", "--engine", "lammps", "--contact", "lammps"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const Json run = manifest(f, "out").at("runs").at(0).at("result");
    CHECK(run.at("grains_fed") == 30);
    CHECK(run.at("engine").at("name") == "LAMMPS");
    CHECK(run.at("engine").at("version").get<std::string>() != "unknown");
    CHECK(contents(f / "out/pile.csv").starts_with("azimuth [rad],r [m],z [m]"));
    CHECK(contents(f / "out/pile-grains.csv").starts_with("x [m],y [m],z [m],radius [m]"));
    CHECK(std::filesystem::exists(f / "out/pile-lammps/deck.in"));
}

TEST_CASE("simulate: Ctrl-C ends LAMMPS too", "[app][simulate][lammps]") {
    if (!std::filesystem::exists("/usr/bin/lmp")) return;
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 9000"));
    const Outcome o = similitude({"simulate", path, "--out", f / "out", "--engine", "lammps",
                                  "--contact", "lammps", "--yes"},
                                 2000);
    INFO(o.err);
    CHECK(o.code == 130);
    CHECK_FALSE(manifest(f, "out").at("runs").at(0).at("finished").get<bool>());
    CHECK(std::filesystem::exists(f / "out/pile-lammps/log.lammps"));
}

TEST_CASE("simulate: LAMMPS drops a bead and throws it, in the channels of our own rigs",
          "[app][simulate][lammps]") {
    if (!std::filesystem::exists("/usr/bin/lmp")) return;
    const Folder f;
    const std::string path = f.write("case.json", R"({"format": "similitude-case/1", "title": "t",
  "grain": {"diameter": "2 mm", "density": "2500 kg/m^3", "youngs_modulus": "5 MPa", "poisson_ratio": 0.3},
  "plate": {"youngs_modulus": "8 MPa", "poisson_ratio": 0.25}, "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin"], "parameters": {"restitution": {"value": 0.7}}},
  "experiments": [{"id": "drop", "rig": "drop", "conditions": {"height": "50 mm"}},
                  {"id": "shots", "rig": "impact", "conditions": {"speed": "1 m/s"}}]})");
    const Outcome o = similitude({"simulate", path, "--out", f / "out", "--engine", "lammps"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const Json runs = manifest(f, "out").at("runs");
    CHECK(runs.at(0).at("result").at("engine").at("name") == "LAMMPS");
    CHECK(contents(f / "out/drop.csv").starts_with("t [s],x [m],z [m]\n0,0,0.05"));
    CHECK(contents(f / "out/shots.csv").starts_with("angle [rad],normal_restitution"));
    const Outcome many =
        similitude({"simulate", path, "--out", f / "out", "--engine", "lammps", "--ranks", "2"});
    CHECK(many.code == 2);
    CHECK(many.err.find("must be 1 for a single grain") != std::string::npos);
}

TEST_CASE("export: a deck and a script for SLURM, the deck that simulate runs", "[app][export]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 30"));
    const Outcome o = similitude({"export", path, "--engine", "lammps", "--out", f / "deck",
                                  "--submit", "slurm", "--ranks", "32"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const std::string script = contents(f / "deck/pile-lammps/job.sh");
    CHECK(script.starts_with("#!/bin/sh\n"));
    CHECK(script.find("#SBATCH --ntasks=32\n") != std::string::npos);
    CHECK(script.find("srun lmp -in deck.in") != std::string::npos);
    CHECK(contents(f / "deck/pile-lammps/deck.in").find("pair_style granular") !=
          std::string::npos);
    CHECK(std::filesystem::exists(f / "deck/pile-lammps/feed/1.data"));
    CHECK(o.err.find("estimate: 30 grains") != std::string::npos);
    CHECK(script.find("#SBATCH --time=1:00:00\n") != std::string::npos);  // seconds: the least
    // A thousand times the grains, fed a thousand times as long.
    const std::string large =
        f.write("large.json", tiny_case("\"grains\": 300", "\"grains\": 30000"));
    const Outcome more = similitude({"export", large, "--engine", "lammps", "--out", f / "large",
                                     "--submit", "slurm", "--ranks", "2"});
    REQUIRE(more.code == 0);
    CHECK(contents(f / "large/pile-lammps/job.sh").find("--time=1:00:00\n") == std::string::npos);
    const Outcome other = similitude({"export", path, "--engine", "yade"});
    CHECK(other.code == 2);
    CHECK(other.err.find("no JKR") != std::string::npos);
}

TEST_CASE("export: the syntax of later LAMMPS releases is asked for, and said to be untested",
          "[app][export]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 30"));
    const auto exported = [&](const std::string& engine, const std::string& release) {
        return similitude({"export", path, "--engine", engine, "--lammps-release", release, "--out",
                           f / release});
    };
    const Outcome later = exported("lammps", "later");
    REQUIRE(later.code == 0);
    CHECK(later.err.find("untested") != std::string::npos);
    CHECK(later.err.find("viscoelastic") != std::string::npos);  // the case adheres
    CHECK(contents(f / "later/pile-lammps/deck.in").find("UNTESTED") != std::string::npos);
    CHECK(exported("lammps", "2021").err.find("untested") == std::string::npos);
    const Outcome unknown = exported("lammps", "2024");
    CHECK(unknown.code == 2);
    CHECK(unknown.err.find("must be 2021 or later") != std::string::npos);
    const Outcome wrong = exported("liggghts", "later");
    CHECK(wrong.code == 2);
    CHECK(wrong.err.find("must go with --engine lammps") != std::string::npos);
}
