// SPDX-License-Identifier: MIT
// The rigs `discharge`, `column` and `drum` in LAMMPS: single grains against what is known of them or against our core, beds against our
// core over seeds.
#include "engines/lammps_flow.hpp"

#include "engines/flow_run.hpp"
#include "engines/lammps_files.hpp"
#include "engines/process.hpp"
#include "scaling/errors.hpp"
#include "statistics/equivalence.hpp"
#include "tests/engines/scratch.hpp"
#include "tests/rigs/flow_case.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

using Catch::Matchers::Contains;
using rigs::FlowSetup;
using samples::quantity;

namespace {

const char* const some_drum =
    R"("drum_diameter": "10 mm", "drum_length": "4 mm", "rotation_speed": "6 rad/s", "fill_fraction": 0.4)";
const char* const some_column = R"("column_radius": "2.5 mm", "column_height": "3 mm")";
const char* const some_silo =
    R"("silo_shape": "box", "width": "8 mm", "depth": "5 mm", "outlet_width": "4.5 mm", "grains": 160)";

FlowSetup setup_of(const std::string& rig, const std::string& conditions, std::uint64_t seed = 1,
                   const std::string& recording = "") {
    const cases::Case c = samples::flow_case(rig, conditions, recording);
    FlowSetup s = rigs::flow_setup(c, c.experiments.at(0), seed);
    rigs::take_lammps_rules(s);
    return s;
}

bool installed() {
    if (engines::find_program("lmp") && engines::find_program("mpirun")) return true;
    WARN("left out: no program lmp or mpirun");
    return false;
}

rigs::FlowRun in_lammps(const FlowSetup& s, int ranks = 1) {
    const Scratch folder("lammps-flow");
    engines::write_deck(engines::lammps_flow(s), folder.path);
    std::int64_t shown = 0;
    const auto run = engines::run_flow(*engines::find_peer("lammps"), "lmp", s, folder.path, ranks,
                                       [&](const engines::DeckProgress& p) { shown = p.step; });
    CHECK(shown > 0);
    REQUIRE(run.end);
    return *run.end;
}

// Of one grain that begins there.
FlowSetup with_one_grain(FlowSetup s, contact::Vec3 place) {
    s.place = {place}, s.radius = {0.5 * s.d};
    return s;
}

std::string refusal(const FlowSetup& s, const engines::DeckOptions& o = {}) {
    try {
        engines::lammps_flow(s, o);
    } catch (const scaling::InvalidInput& e) {
        return e.what();
    }
    return "";
}

// Of the same setup over seeds that differ, a quantity of either engine.
struct Both {
    std::vector<double> here, there;
};
void check_equivalent(const Both& both, double margin) {
    const auto found = statistics::two_one_sided_tests(statistics::summary(both.here),
                                                       statistics::summary(both.there), margin);
    INFO("difference " << found.difference << " [" << found.interval.low << ", "
                       << found.interval.high << "], margin " << margin);
    CHECK(found.equivalent);
}

}  // namespace

TEST_CASE("lammps flow: what LAMMPS has not is refused by name", "[engines][lammps][flow]") {
    const FlowSetup silo = setup_of("discharge", some_silo);
    CHECK(refusal(silo) == "");
    CHECK(refusal(setup_of("column", some_column)) == "");
    CHECK(refusal(setup_of("drum", some_drum)) == "");
    FlowSetup s = silo;
    s.grains.as_lammps.reset();
    CHECK_THAT(refusal(s), Contains("EPSD") && Contains("--contact lammps"));
    s = silo, s.walls.work_of_adhesion = 0.01;
    CHECK_THAT(refusal(s), Contains("adhesive contact with a wall") && Contains("wall_adhesion"));
    s = silo, s.walls.restitution = 0.1;
    CHECK_THAT(refusal(s), Contains("0.12"));
    s = silo, s.grains.rigid_tangential = true;
    CHECK_THAT(refusal(s), Contains("hertz_coulomb"));
    CHECK_THAT(refusal(silo, {.nearest = true}), Contains("--contact lammps"));
    s = silo, std::get<rigs::Silo>(s.vessel).outlet_depth = 3e-3;
    CHECK_THAT(refusal(s), Contains("slot with ends") && Contains("outlet_diameter"));
    s = silo, std::get<rigs::Silo>(s.vessel).round = true;
    CHECK_THAT(refusal(s), Contains("slot with ends"));
    std::get<rigs::Silo>(s.vessel).round_outlet = true;
    CHECK(refusal(s) == "");
    std::get<rigs::Silo>(s.vessel).outlet_width = 0.9e-3;
    CHECK_THAT(refusal(s), Contains("narrower than a grain"));
    for (const char* other : {"liggghts", "yade"})
        CHECK(engines::find_peer(other)->flow == nullptr);
}

// A run that is set up anew puts the number of a wall's dashpot through the polynomial of `tsuji` again (docs/export.md).
TEST_CASE("lammps flow: one run is set up, and no file is read after it",
          "[engines][lammps][flow]") {
    for (const FlowSetup& s : {setup_of("discharge", some_silo), setup_of("column", some_column),
                               setup_of("drum", some_drum)}) {
        std::istringstream deck(engines::lammps_flow(s).deck);
        int set_up = 0;
        for (std::string line; std::getline(deck, line);) {
            if (line.starts_with("run ") && line.find("pre no") == std::string::npos) ++set_up;
            if (set_up > 0) CHECK(!line.starts_with("read_"));
            if (set_up > 0) CHECK(!line.starts_with("fix "));
        }
        CHECK(set_up == 1);
    }
}

// At the bottom it swings and rolls for ever, and does not slip: v + omega_g r = omega R where they touch. No rolling resistance at the
// wall, which LAMMPS takes from the grain's own spin. 1 %: the overlap is 2e-3 r.
TEST_CASE("lammps flow: a grain rolls at the bottom of a drum as the mantle drives it",
          "[engines][lammps][flow]") {
    if (!installed()) return;
    FlowSetup s = with_one_grain(setup_of("drum", some_drum, 1, "t [s],angle [deg]\n0,0\n1.5,0\n"),
                                 {0.0, -4.4e-3, 2e-3});
    s.walls.rolling_friction = 0.0;
    const auto last = in_lammps(s).simulation.grains;
    REQUIRE(last.count() == 1);
    const auto& drum = std::get<rigs::Drum>(s.vessel);
    const double from_axis = std::hypot(last.x[0], last.y[0]);
    const double along = (last.vy[0] * last.x[0] - last.vx[0] * last.y[0]) / from_axis;
    CHECK(along + last.wz[0] * 0.5 * s.d == Approx(drum.speed * 0.5 * drum.diameter).epsilon(0.01));
    CHECK(std::abs(last.x[0]) < s.d);
}

// Pinched between the end plates, which hold it by eight weights of friction at least, it goes round with them: by 1.2 rad in 0.2 s, from
// one rank's half of the drum to the other's. 2e-3 d: its weight bends the springs by 6e-4 d, and the wall begins to turn within a step.
TEST_CASE("lammps flow: the end plates of a drum carry a grain round", "[engines][lammps][flow]") {
    if (!installed()) return;
    const double angle = 1.2, away = 2e-3;  // rad, m from the axis
    FlowSetup s = setup_of("drum", some_drum, 1, "t [s],angle [deg]\n0,0\n0.2,0\n");
    auto& drum = std::get<rigs::Drum>(s.vessel);
    drum.length = 0.96 * s.d;
    s = with_one_grain(
        s, {-away * std::sin(0.5 * angle), -away * std::cos(0.5 * angle), 0.5 * drum.length});
    const int ranks = GENERATE(1, 2);
    const rigs::FlowRun run = in_lammps(s, ranks);
    const double turned = drum.speed * rigs::record(run, s).quantities.at(2).value;
    CHECK(turned == Approx(angle).epsilon(0.02));  // up to 100 steps later
    const double at = turned - 0.5 * angle;
    const auto& last = run.simulation.grains;
    REQUIRE(last.count() == 1);
    CHECK(last.x[0] == Approx(away * std::sin(at)).margin(2e-3 * s.d));
    CHECK(last.y[0] == Approx(-away * std::cos(at)).margin(2e-3 * s.d));
}

// On the lid, 0.2 d inside of the rim, it rolls over the rim when the lid goes: later than it would fall freely. As long as in our core to
// 3 %: a hundredth of the way is looked at, and the lid's seam carries it by another overlap before.
TEST_CASE("lammps flow: a grain on the rim of an outlet rolls over it as it does here",
          "[engines][lammps][flow]") {
    if (!installed()) return;
    const std::string round =
        R"("silo_shape": "cylinder", "silo_diameter": "8 mm", "outlet_diameter": "4.5 mm", "grains": 1)";
    const std::string slot =
        R"("silo_shape": "box", "width": "8 mm", "depth": "5 mm", "outlet_width": "4.5 mm", "grains": 1)";
    const std::string conditions = GENERATE_COPY(round, slot);
    FlowSetup s = with_one_grain(setup_of("discharge", conditions), {2.05e-3, 0.0, 0.6e-3});
    const rigs::FlowRun here = samples::run_of(s), there = in_lammps(s);
    CHECK(there.state.ending == "drained");
    CHECK(here.state.ending == "drained");
    const double free_fall = std::sqrt(2.0 * s.d / s.gravity);  // s
    const double out = quantity(rigs::record(here, s), "last_out");
    CHECK(out > 1.3 * free_fall);
    CHECK(quantity(rigs::record(there, s), "last_out") ==
          Approx(out).margin(0.03 * out + 100.0 * s.time_step));
}

// Two grains lean on one another and on the wall, which drags at them until its rim has passed: 20 ms after t = 0 the upper one rolls off,
// and a wall of half that speed, or one at rest, would still hold it. The two engines agree to 0.02 d: R* at the curved wall is a third
// larger in LAMMPS, overlaps differ by 1e-3 d. A third grain begins 0.03 d deep in the wall's outer side, which pushes it away: a wall
// that is told twice, or not at all outside, pushes it by a fifth further or nowhere.
TEST_CASE("lammps flow: a wall that is lifted drags two grains as it does here",
          "[engines][lammps][flow]") {
    if (!installed()) return;
    const std::string lifted =
        R"("column_radius": "0.9 mm", "column_height": "3 mm", "lift_speed": "0.1 m/s")";
    FlowSetup s = setup_of("column", lifted, 1, "t [s],r [mm],z [mm]\n0,0,0\n0.02,0,0\n");
    s.place = {{-0.38e-3, 0.0, 0.52e-3}, {0.38e-3, 0.0, 1.3e-3}, {0.0, 1.37e-3, 0.5e-3}};
    s.radius = {0.5e-3, 0.5e-3, 0.5e-3};
    const rigs::FlowRun here = samples::run_of(s), there = in_lammps(s);
    CHECK(there.state.ending == "recorded");
    REQUIRE(there.simulation.grains.count() == 3);
    CHECK(here.simulation.grains.y[2] > 2e-3);
    CHECK(there.simulation.grains.y[2] == Approx(here.simulation.grains.y[2]).epsilon(0.1));
    REQUIRE(here.simulation.steps - here.state.released ==
            there.simulation.steps - there.state.released);
    for (std::size_t k = 0; k < 2; ++k) {
        const contact::Vec3 a = here.simulation.grains.position(k),
                            b = there.simulation.grains.position(k);
        INFO("grain " << k << ": " << a.x << ' ' << a.y << ' ' << a.z << " here, " << b.x << ' '
                      << b.y << ' ' << b.z << " there");
        CHECK(contact::norm(a - b) < 0.02 * s.d);
    }
}

// Struck off at the level; what is left spreads, and none is lost. The last one on two ranks.
TEST_CASE("lammps flow: columns are struck off, spread and come to rest as ours do",
          "[engines][lammps][flow]") {
    if (!installed()) return;
    Both grains, foot;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const FlowSetup a = setup_of("column", some_column, seed),
                        b = setup_of("column", some_column, 100 + seed);
        const rigs::FlowRecord here = rigs::record(samples::run_of(a), a);
        const rigs::FlowRun run = in_lammps(b, seed == 4 ? 2 : 1);
        const rigs::FlowRecord there = rigs::record(run, b);
        CHECK(there.ending == "at_rest");
        CHECK(quantity(there, "grains") < static_cast<double>(b.place.size()));
        CHECK(quantity(there, "grains") == static_cast<double>(there.grains.centre.size()));
        for (const contact::Vec3 p : there.grains.centre) CHECK(p.z > 0.45 * b.d);
        grains.here.push_back(quantity(here, "grains"));
        grains.there.push_back(quantity(there, "grains"));
        foot.here.push_back(quantity(here, "foot_radius"));
        foot.there.push_back(quantity(there, "foot_radius"));
    }
    // Margins: half of a layer's grains, and half of a grain in the foot.
    check_equivalent(grains, 10.0);
    check_equivalent(foot, 0.5e-3);
}

// The angle scatters by 0.02 rad over seeds. Margin 5 deg: a drum that turned the other way, or whose wall slipped, would be beyond.
TEST_CASE("lammps flow: a drum's surface leans as ours does", "[engines][lammps][flow]") {
    if (!installed()) return;
    std::string times = "t [s],angle [deg]\n";
    for (int k = 0; k <= 40; ++k) times += std::to_string(0.02 * k) + ",0\n";
    Both angle;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const FlowSetup a = setup_of("drum", some_drum, seed, times),
                        b = setup_of("drum", some_drum, 100 + seed, times);
        const rigs::FlowRecord there = rigs::record(in_lammps(b), b);
        CHECK(there.ending == "recorded");
        CHECK(there.channels.at(0).values.size() == 41);
        CHECK(there.channels.at(1).values.front() < 0.2);  // it begins level
        CHECK(!there.profile.empty());
        angle.here.push_back(quantity(rigs::record(samples::run_of(a), a), "dynamic_angle"));
        angle.there.push_back(quantity(there, "dynamic_angle"));
    }
    check_equivalent(angle, 0.087);
}

// What has come out by 0.1 s, some half of 160 grains, scatters by 5 %; margin 10 %. The last one on two ranks.
TEST_CASE("lammps flow: as much comes out of a silo in a time as of ours",
          "[engines][lammps][flow]") {
    if (!installed()) return;
    const std::string times = "t [s],m [kg]\n0,0\n0.05,1e-4\n0.1,1e-4\n";
    Both out;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const FlowSetup a = setup_of("discharge", some_silo, seed, times),
                        b = setup_of("discharge", some_silo, 100 + seed, times);
        const rigs::FlowRecord here = rigs::record(samples::run_of(a), a),
                               there = rigs::record(in_lammps(b, seed == 6 ? 2 : 1), b);
        CHECK(there.ending == "recorded");
        CHECK(quantity(there, "grains") == 160.0);
        const std::vector<double>& m = there.channels.at(1).values;
        CHECK(m.at(0) == 0.0);
        CHECK(m.at(1) < m.at(2));
        out.here.push_back(here.channels.at(1).values.at(2));
        out.there.push_back(m.at(2));
    }
    const double half = 80.0 * 2500.0 * std::acos(-1.0) / 6.0 * 1e-9;  // kg
    check_equivalent(out, 0.1 * half);
}
