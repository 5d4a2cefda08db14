// SPDX-License-Identifier: MIT
// The rig `column` against what is known of columns that collapse.
#include "tests/rigs/flow_case.hpp"

#include <cmath>

using samples::flow_setup;
using samples::quantity;
using samples::run_of;

namespace {

rigs::FlowRecord column(const std::string& height, const std::string& lift = "",
                        const std::string& recording = "") {
    const rigs::FlowSetup s = flow_setup(
        "column", R"("column_radius": "4 mm", "column_height": ")" + height + "\"" + lift,
        recording);
    return rigs::record(run_of(s), s);
}

}  // namespace

// A scanner sees the tops of a bed that was struck off at grain centres: within a diameter of the level, and nothing outside.
TEST_CASE("at t = 0 a scanner sees the column, later a heap", "[rigs][column]") {
    const rigs::FlowRecord r =
        column("5 mm", "", "t [s],r [mm],z [mm]\n0,1,5\n0,2.5,5\n0,6,0\n9,1,3\n9,5,1\n");
    REQUIRE(r.channels.at(0).values == std::vector<double>{0.0, 0.0, 0.0, 9.0, 9.0});
    const std::vector<double>& z = r.channels.at(2).values;
    CHECK(std::abs(z[0] - 5e-3) < 1e-3);
    CHECK(std::abs(z[1] - 5e-3) < 1e-3);
    CHECK(z[2] == 0.0);
    CHECK(z[3] < z[0]);
    CHECK(z[3] > z[4]);
    CHECK(z[4] > 0.0);
    CHECK(r.ending == "at_rest");
    CHECK(quantity(r, "grains") == static_cast<double>(r.grains.centre.size()));
}
