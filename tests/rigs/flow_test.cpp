// SPDX-License-Identifier: MIT
// What the rigs that let a bed go have in common: the bed, the rows, the promises about bits.
#include "dem_min/checkpoint.hpp"
#include "scaling/errors.hpp"
#include "scaling/schemes.hpp"
#include "tests/dem_min/temporary_file.hpp"
#include "tests/rigs/flow_case.hpp"

#include <cmath>

using rigs::FlowRun;
using rigs::FlowSetup;
using samples::flow_setup;
using samples::run_of;

namespace {

FlowSetup small_silo() {
    return flow_setup("discharge",
                      R"("silo_shape": "box", "width": "6 mm", "depth": "5 mm",
                         "outlet_width": "4.5 mm", "grains": 100)");
}
FlowSetup small_column() {
    return flow_setup(
        "column", R"("column_radius": "3 mm", "column_height": "4 mm", "lift_speed": "0.2 m/s")");
}
FlowSetup small_drum() {
    return flow_setup("drum",
                      R"("drum_diameter": "10 mm", "drum_length": "4 mm",
                         "rotation_speed": "10 rad/s", "fill_fraction": 0.35)",
                      "t [s],angle [deg]\n0,0\n0.2,20\n0.4,20\n");
}

void check_same(const FlowRun& a, const FlowRun& b) {
    CHECK(dem_min::state_hash(a.simulation) == dem_min::state_hash(b.simulation));
    CHECK(a.state.rows == b.state.rows);
    CHECK(a.state.noted == b.state.noted);
    CHECK(a.state.ending == b.state.ending);
}

std::string refusal(const std::string& rig, const std::string& conditions) {
    return message_of<scaling::InvalidInput>([&] { flow_setup(rig, conditions); });
}

}  // namespace

TEST_CASE("grains begin loosely, inside the vessel, touching nobody", "[rigs][flow]") {
    const FlowSetup s = GENERATE(small_silo(), small_column(), small_drum());
    REQUIRE(s.place.size() > 60);
    for (std::size_t i = 0; i < s.place.size(); ++i)
        for (std::size_t j = i + 1; j < s.place.size(); ++j)
            REQUIRE(contact::norm(s.place[i] - s.place[j]) > s.radius[i] + s.radius[j]);
    const FlowRun run = rigs::begin_flow(s, 1);
    for (std::size_t k = 0; k < s.place.size(); ++k)
        for (const dem_min::Wall& wall : run.simulation.walls)
            REQUIRE(dem_min::distance(wall, s.place[k]).distance > s.radius[k]);
}

TEST_CASE("threads and steps at a time change no bit of a flow", "[rigs][flow][golden]") {
    const FlowSetup s = GENERATE(small_silo(), small_column(), small_drum());
    FlowRun one = rigs::begin_flow(s, 1);
    while (one.state.released < 0) rigs::advance(one, s, 500);
    FlowRun two = one;
    two.simulation.settings.threads = 2;
    two.simulation.settings.grains_per_thread = 1;
    rigs::advance(one, s, 1001);
    for (int k = 0; k < 13; ++k) rigs::advance(two, s, 77);
    REQUIRE(two.simulation.team() == 2);
    CHECK(!one.state.rows.empty());
    check_same(two, one);
}

TEST_CASE("scaled by a power of two, a flow keeps every bit", "[rigs][flow][similarity]") {
    const FlowSetup s = GENERATE(small_silo(), small_column(), small_drum());
    const scaling::ScaleMap map = scaling::ScaleMap::solve(scaling::named_scheme("exact"), 4.0);
    const FlowRun small = run_of(s), large = run_of(rigs::scaled(s, map));
    CHECK(dem_min::state_hash(large.simulation, map.factor("length"), map.factor("time")) ==
          dem_min::state_hash(small.simulation));
    REQUIRE(large.state.rows.size() == small.state.rows.size());
    CHECK(large.state.rows.back().front() == map.factor("time") * small.state.rows.back().front());
    CHECK(large.state.ending == small.state.ending);
}

TEST_CASE("a flow resumed from a checkpoint gives the bits of one never interrupted",
          "[rigs][flow][checkpoint]") {
    const FlowSetup s = GENERATE(small_silo(), small_column(), small_drum());
    FlowRun whole = rigs::begin_flow(s, 1);
    while (whole.state.released < 0) rigs::advance(whole, s, 500);
    rigs::advance(whole, s, 900);
    REQUIRE(!whole.state.finished);
    const samples::TemporaryFile file;
    dem_min::write_checkpoint(whole.simulation, file.path);
    FlowRun resumed = rigs::begin_flow(s, 1);
    rigs::restore(resumed, s, whole.state);
    dem_min::read_checkpoint(resumed.simulation, file.path);
    while (!whole.state.finished) rigs::advance(whole, s, 5000);
    while (!resumed.state.finished) rigs::advance(resumed, s, 777);
    check_same(resumed, whole);
}

TEST_CASE("rows stand at the recording's instants, and after the end all is as at the end",
          "[rigs][flow]") {
    const FlowSetup s = flow_setup("discharge",
                                   R"("silo_shape": "cylinder", "silo_diameter": "6 mm",
                                      "outlet_diameter": "5 mm", "grains": 60)",
                                   "m [%],t [s]\n50,0.05\n0,0\n100,20\n100,30\n");
    const rigs::FlowRecord r = rigs::record(run_of(s), s);
    CHECK(r.channels.at(0).values == std::vector<double>{0.0, 0.05, 20.0, 30.0});
    const std::vector<double>& m = r.channels.at(1).values;
    CHECK(m[0] == 0.0);
    CHECK(m[1] > 0.0);
    CHECK(m[2] > m[1]);
    CHECK(m[3] == m[2]);
    CHECK(samples::quantity(r, "time") < 20.0);  // it does not wait for them
}

TEST_CASE("conditions that cannot be simulated are refused with a remedy", "[rigs][flow][domain]") {
    const std::string box =
        R"("silo_shape": "box", "width": "6 mm", "depth": "5 mm", "grains": 9, )";
    CHECK_THAT(refusal("discharge", box + R"("outlet_diameter": "5.5 mm")"),
               Catch::Contains("conditions.outlet_diameter") &&
                   Catch::Contains("must fit into the silo's bottom"));
    CHECK_THAT(refusal("discharge", R"("silo_shape": "cylinder", "silo_diameter": "6 mm",
                                       "outlet_width": "2 mm", "grains": 9)"),
               Catch::Contains("state outlet_depth"));
    const std::string drum = R"("drum_diameter": "10 mm", "drum_length": "4 mm", )";
    CHECK_THAT(refusal("drum", drum + R"("rotation_speed": "0 rad/s", "fill_fraction": 0.3)"),
               Catch::Contains("must not be 0"));
    CHECK_THAT(refusal("drum", drum + R"("rotation_speed": "1 rad/s", "fill_fraction": 0.6)"),
               Catch::Contains("at most 0.5"));
    const cases::Case mixed = samples::flow_case(
        "column", R"("column_radius": "3 mm", "column_height": "4 mm")", "",
        R"(, "sizes": [["1 mm", 0.5], ["1 mm", 0.5, "clay"]])",
        R"(}, "materials": {"clay": {"density": "2000 kg/m^3", "youngs_modulus": "1 MPa", "poisson_ratio": 0.3})");
    CHECK_THAT(message_of<scaling::InvalidInput>(
                   [&] { rigs::flow_setup(mixed, mixed.experiments.at(0), 1); }),
               Catch::Contains("grain.sizes") && Catch::Contains("must be of the rig pile"));
}
