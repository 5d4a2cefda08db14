// SPDX-License-Identifier: MIT
// `diagnose --engine lammps`: bounces of a bead, recorded with 0.2 mm of noise, judged on a base that LAMMPS runs.
#include "command_line.hpp"
#include "engines/process.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <random>
#include <sstream>
#include <string>

namespace {

// A resolved bounce of tests/diagnose/data/lammps-bounce with the noise that the case states.
std::string recording(const std::string& height, unsigned seed) {
    std::ifstream in("tests/diagnose/data/lammps-bounce/fine-" + height + ".csv");
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.0, 2e-4);
    std::ostringstream out;
    std::string line;
    std::getline(in, line);
    out << line << '\n';
    while (std::getline(in, line)) {
        const std::size_t comma = line.find(',');
        out << line.substr(0, comma + 1) << std::stod(line.substr(comma + 1)) + noise(random)
            << '\n';
    }
    return out.str();
}

// `numerics`: further members of the model.
std::string bounces(const std::string& numerics) {
    return R"({
 "format": "similitude-case/1", "title": "a bounce",
 "grain": {"diameter": "4 mm", "density": "2500 kg/m^3", "youngs_modulus": "5 GPa", "poisson_ratio": 0.25},
 "plate": {"youngs_modulus": "5 GPa", "poisson_ratio": 0.25},
 "surroundings": {"gravity": "9.81 m/s^2"},
 "model": {"physics": ["gravity", "hertz_mindlin"],
  "parameters": {"restitution": {"value": 0.5728}, "sliding_friction": {"value": 0.3}})" +
           numerics + R"(},
 "experiments": [
  {"id": "bounce-30", "rig": "drop", "conditions": {"height": "30 mm"}, "recording": "r30.csv", "noise": {"z": "0.2 mm"}, "role": "fit"},
  {"id": "bounce-60", "rig": "drop", "conditions": {"height": "60 mm"}, "recording": "r60.csv", "noise": {"z": "0.2 mm"}, "role": "fit"}]})";
}

Outcome judged(const Folder& f, const std::string& numerics, const std::string& engine) {
    f.write("case.json", bounces(numerics));
    f.write("r30.csv", recording("30", 5)), f.write("r60.csv", recording("60", 6));
    return similitude({"diagnose", f / "case.json", "--engine", engine, "--out", f / "out",
                       "--json", "-", "--threads", "2"});
}

const std::string too_long = R"(, "numerics": {"time_step": "8 us"})";  // a fifth of the contact

}  // namespace

TEST_CASE("diagnose: on a resolved run of LAMMPS the verdict is that of this tool's own model",
          "[app][diagnose][lammps]") {
    if (!engines::find_program("lmp")) return;
    const Folder f;
    const Outcome here = judged(f, "", "dem_min"), there = judged(f, "", "lammps");
    INFO(there.err);
    CHECK(here.code == 0);
    CHECK(there.code == 0);
    CHECK(there.json().at("verdict") == "consistent");
    const auto said = there.json().at("warnings");
    CHECK(said.at(0).get<std::string>().find("made here by LAMMPS") != std::string::npos);
    CHECK(said.at(1).get<std::string>().find("cannot show") != std::string::npos);
    CHECK(contents(f / "out/bounce-30-lammps/deck.in").find("\nrun ") != std::string::npos);
}

TEST_CASE("diagnose: steps that are too long in LAMMPS are named as what they are",
          "[app][diagnose][lammps]") {
    if (!engines::find_program("lmp")) return;
    const Folder f;
    const Outcome o = judged(f, too_long, "lammps");
    INFO(o.err);
    CHECK(o.code == 3);
    CHECK(o.json().at("verdict") == "explained");
    REQUIRE(o.json().at("effects").size() == 1);
    CHECK(o.json().at("effects").at(0).at("name") == "numerical_artefact");
}

TEST_CASE("diagnose: what LAMMPS cannot run for it is refused by name",
          "[app][diagnose][lammps][input]") {
    const Folder f;
    f.write("r30.csv", recording("30", 5)), f.write("r60.csv", recording("60", 6));
    const auto said = [&](std::string text) {
        f.write("case.json", text);
        const Outcome o = similitude(
            {"diagnose", f / "case.json", "--engine", "lammps", "--out", f / "out", "--quiet"});
        CHECK(o.code == 2);
        return o.err;
    };
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = bounces("");
        text.replace(text.find(from), from.size(), to);
        return text;
    };
    CHECK(said(with(R"("hertz_mindlin")", R"("hertz_coulomb")"))
              .find("is told of no hertz_coulomb") != std::string::npos);
    CHECK(
        said(with(R"("recording": "r30.csv")", R"("recording": "r30.csv", "simulated": "r30.csv")"))
            .find("your own run of bounce-30") != std::string::npos);
    f.write("curve.csv", "separation [nm],force [nN],branch\n0,1,approach\n-10,5,approach\n-9,4,retract\n");
    const std::string pull = R"({"id": "curve", "rig": "pull_off", "conditions":
  {"counterpart": "plate", "preload": "20 nN"}, "recording": "curve.csv", "role": "fit"})";
    const std::string both = bounces("");
    const std::size_t list = both.find("\"experiments\": [") + 16;
    CHECK(said(both.substr(0, list) + pull + "]}").find("runs drops, inclines and impacts") !=
          std::string::npos);
    CHECK(said(bounces(R"(, "numerics": {"integrator": "euler"})")).find("Euler") !=
          std::string::npos);
}
