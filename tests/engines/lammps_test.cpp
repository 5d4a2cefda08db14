// SPDX-License-Identifier: MIT
#include "engines/lammps_contact.hpp"
#include "engines/lammps_dump.hpp"
#include "engines/lammps_files.hpp"
#include "engines/lammps_run.hpp"
#include "engines/lammps_slump.hpp"
#include "engines/lammps_two_grains.hpp"
#include "scaling/errors.hpp"
#include "tests/engines/scratch.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using engines::LammpsContact;

namespace {

// Numbers that binary fractions hold exactly, so that their text is short.
const LammpsContact sticky{.youngs_modulus = 1e6,
                           .poisson_ratio = 0.25,
                           .surface_energy = 0.5,
                           .eta = 8.0,
                           .tangential_ratio = 0.75,
                           .sliding_friction = 0.5,
                           .rolling_stiffness = 500.0,
                           .rolling_damping = 0.125,
                           .rolling_friction = 0.25};

engines::TwoGrains two_grains() {
    engines::TwoGrains t{};
    t.grains = {dem_min::Grain{{-1.0, 0.0, 0.0}, {0.25, 0.5, 0.0}, {1.0, 2.0, 3.0}, 1.0, 4.0},
                dem_min::Grain{{1.5, 0.0, 0.0}, {-0.25, 0.0, 0.0}, {}, 1.0, 4.0}};
    t.contact = sticky;
    t.time_step = 0.125;
    t.steps = 20;
    t.steps_apart = 30;
    t.skin = 0.5;
    return t;
}

}  // namespace

// The order of the arguments is that of the manual's page pair_style granular.
TEST_CASE("lammps: the rules of a contact in the words of pair_style granular",
          "[engines][lammps]") {
    CHECK(engines::granular_arguments(sticky) ==
          "jkr 1000000 8 0.25 0.5 damping viscoelastic tangential mindlin_rescale NULL 0.75 0.5 "
          "rolling sds 500 0.125 0.25");
    LammpsContact dry{.youngs_modulus = 1e6, .poisson_ratio = 0.25};
    CHECK(engines::granular_arguments(dry) ==
          "hertz/material 1000000 0 0.25 damping viscoelastic tangential mindlin_rescale NULL 0 0");
    dry.twisting = true;
    CHECK_THAT(engines::granular_arguments(dry), Contains(" twisting marshall"));
    // 8 G* = 8 E/(4 (2 - nu)(1 + nu)) = 2e6/(1.75 * 1.25), by hand
    dry.stiffness_as_number = true;
    CHECK_THAT(engines::granular_arguments(dry), Contains("mindlin_rescale 914285.714285714"));
}

TEST_CASE("lammps: the same rules in our words", "[engines][lammps]") {
    const dem_min::Laws ours = engines::laws(sticky);
    const auto jkr = std::get<contact::Jkr>(ours.normal);
    CHECK(jkr.e_star == Approx(1e6 / (2.0 * (1.0 - 0.0625))).epsilon(1e-14));  // by hand; algebra
    CHECK(jkr.w == 1.0);  // twice the surface energy
    CHECK(jkr.tear_off == contact::TearOff::max_tension);
    CHECK(ours.friction_cap == contact::FrictionCap::elastic_plus_two_pull_off);
    CHECK(ours.damping.viscoelastic.eta == 8.0);
    CHECK(ours.damping.viscoelastic.tangential_ratio == 0.75);
    CHECK(ours.damping.tsuji.factor == 0.0);
    CHECK(std::get<contact::Mindlin>(ours.tangential).sliding_friction == 0.5);
    CHECK(std::get<contact::RollingSds>(ours.rolling).damping == 0.125);

    const dem_min::Laws dry = engines::laws({.youngs_modulus = 1e6, .poisson_ratio = 0.25});
    CHECK(std::holds_alternative<contact::Hertz>(dry.normal));
    CHECK(std::holds_alternative<contact::NoRolling>(dry.rolling));
    CHECK(dry.friction_cap == contact::FrictionCap::total_plus_two_pull_off);
}

TEST_CASE("lammps: a data file holds every digit of a grain, diameter for radius",
          "[engines][lammps]") {
    const std::string text = engines::lammps_data(
        {{{0.1, 0.0, -1.0}, {0.5, 0.0, 0.0}, {0.0, 0.0, 2.0}, 0.25, 3.0, true}},
        {{-2.0, -2.0, -2.0}, {2.0, 2.0, 2.0}}, 2);
    CHECK_THAT(text, Contains("\n1 atoms\n2 atom types\n"));
    CHECK_THAT(text, Contains("\n-2 2 zlo zhi\n"));
    CHECK_THAT(text, Contains("\n1 2 0.5 3 0.10000000000000001 0 -1\n"));  // id type d rho x y z
    CHECK_THAT(text, Contains("\n1 0.5 0 0 0 0 2\n"));                     // id v omega
}

TEST_CASE("lammps: decks of two grains, led and thrown", "[engines][lammps]") {
    const std::string led = engines::led_deck(two_grains());
    CHECK_THAT(led, Contains("\nneighbor 0.5 bin\n"));
    CHECK_THAT(led, Contains("\ntimestep 0.125\n"));
    CHECK_THAT(led, Contains("\nfix lead1 grain1 move linear 0.25 0.5 0\n"));
    CHECK_THAT(led, Contains("run 20\nfix lead1 grain1 move linear -0.25 -0.5 -0\n"));
    CHECK_THAT(led, Contains("\nrun 30\n"));
    CHECK_THAT(led, !Contains("nve"));
    const std::string thrown = engines::thrown_deck(two_grains());
    CHECK_THAT(thrown, Contains("\nfix motion all nve/sphere\nrun 20\n"));
    CHECK_THAT(engines::thrown_at_wall_deck(two_grains()),
               Contains("\nfix floor all wall/gran granular jkr 1000000 8 "));
}

TEST_CASE("lammps: a slump's deck freezes the base and lets grains be lost", "[engines][lammps]") {
    engines::Slump s{};
    s.grains = {{{0.0, 0.0, 0.0}, {}, {}, 0.5, 2.0, true}, {{0.0, 0.0, 2.0}, {}, {}, 0.5, 2.0}};
    s.contact = sticky;
    s.gravity = 8.0, s.time_step = 0.25, s.steps = 7, s.skin = 0.5;
    s.box = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 4.0}};
    const std::string deck = engines::slump_deck(s);
    for (const char* line : {"\nfix hold base freeze\n", "\nthermo_modify lost ignore\n",
                             "\nfix fall loose gravity 8 vector 0 0 -1\n", "\nrun 7\n"})
        CHECK_THAT(deck, Contains(line));
    CHECK_THAT(engines::slump_data(s), Contains("2 atom types"));
}

TEST_CASE("lammps: a dump is read frame by frame, and a torn one is refused", "[engines][lammps]") {
    const std::string frame =
        "ITEM: TIMESTEP\n12\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
        "ITEM: ATOMS id fx\n1 0.1\n2 -2.5e-3\n";
    const Scratch scratch("dump");
    const auto read = [&](const std::string& text) {
        engines::write_text(scratch.path / "x.dump", text);
        return engines::read_lammps_frames(scratch.path / "x.dump");
    };
    const auto frames = read(frame + frame);
    REQUIRE(frames.size() == 2);
    CHECK(frames[1].step == 12);
    CHECK(frames[1].rows[1][frames[1].column("fx")] == -2.5e-3);
    CHECK_THROWS_WITH(frames[0].column("fy"), Contains("no column fy"));
    CHECK_THROWS_WITH(read(frame.substr(0, 60)), Contains("x.dump") && Contains("cut off"));
    CHECK_THROWS_WITH(read(frame + frame.substr(0, frame.size() - 12)),
                      Contains("x.dump") && Contains("frame 1 (step 12)"));
    CHECK_THROWS_WITH(read("LAMMPS\n"), Contains("must be a heading of a dump"));
    CHECK(read("").empty());
    CHECK(std::isnan(read(frame.substr(0, frame.size() - 8) + "nan\n").front().rows[1][1]));
    CHECK_THROWS_AS(engines::read_lammps_frames(scratch.path / "none"), std::runtime_error);
}

// The first line that Debian 12's program prints.
TEST_CASE("lammps: the release is read from the first line", "[engines][lammps]") {
    CHECK(engines::lammps_release("LAMMPS (29 Sep 2021 - Update 2)\nTotal wall time\n") ==
          "29 Sep 2021 - Update 2");
    CHECK(engines::lammps_release("sh: lmp: not found") == "unknown");
    // Decks are checked with one release, and its updates; of any other a run says so.
    CHECK(engines::words_of_release("29 Sep 2021 - Update 2").empty());
    for (const char* other : {"2 Aug 2023", "29 Oct 2020", "unknown"})
        CHECK(engines::words_of_release(other).find(other) != std::string::npos);
}

TEST_CASE("lammps: where it is not installed the message names the package", "[engines][lammps]") {
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    CHECK_THROWS_AS(engines::lammps_program(), scaling::InvalidInput);
    CHECK_THROWS_WITH(engines::lammps_program(), Contains("apt-get install lammps"));
    setenv("PATH", path.c_str(), 1);
}

TEST_CASE("lammps: what it complains of is passed on", "[engines][lammps]") {
    const Scratch scratch("lammps");
    CHECK_THROWS_WITH(
        engines::run_lammps(engines::lammps_program(), scratch.path, "units nonsense\n", "", 60.0),
        Contains("ERROR") && Contains("units"));
}

// Two grains fly past one another without touching: after 20 steps of 0.125 s grain 1 is where
// 0.25 m/s and 0.5 m/s have taken it. Exact in binary.
TEST_CASE("lammps: the real program moves two grains as the deck says", "[engines][lammps]") {
    const Scratch scratch("lammps");
    engines::TwoGrains t = two_grains();
    t.grains[1].position = {0.0, 9.0, 0.0};
    const auto states = engines::run_two_grains(engines::lammps_program(), t,
                                                engines::thrown_deck(t), scratch.path);
    REQUIRE(states.size() == 21);
    CHECK(states.back()[0].position ==
          dem_min::Vec3{-1.0 + 20 * 0.125 * 0.25, 20 * 0.125 * 0.5, 0.0});
    CHECK(states.back()[0].spin == dem_min::Vec3{1.0, 2.0, 3.0});
    CHECK(states.back()[0].force == dem_min::Vec3{});
}
