// SPDX-License-Identifier: MIT
// The rig `drum` against what is known of drums.
#include "tests/rigs/flow_case.hpp"

#include <cmath>

using samples::flow_setup;
using samples::quantity;
using samples::run_of;

// 40 % full, Fr = 0.02: the surface flows down, what lies deep goes round with the wall, and somewhere between the bed stands still.
TEST_CASE("a drum turns its bed as one body under a surface that flows down", "[rigs][drum]") {
    const rigs::FlowSetup s = flow_setup("drum",
                                         R"("drum_diameter": "14 mm", "drum_length": "4 mm",
                                            "rotation_speed": "5.3 rad/s", "fill_fraction": 0.4)",
                                         "depth [mm],velocity [m/s]\n0.5,0\n1,0\n6,0\n40,0\n");
    const rigs::FlowRecord r = rigs::record(run_of(s), s);
    CHECK(r.ending == "recorded");
    CHECK(quantity(r, "froude_number") == Approx(5.3 * 5.3 * 7e-3 / 9.81));
    const double degree = std::acos(-1.0) / 180.0;
    CHECK(quantity(r, "dynamic_angle") > 15.0 * degree);
    CHECK(quantity(r, "dynamic_angle") < 45.0 * degree);
    CHECK(r.channels.at(1).values.front() < 10.0 * degree);  // it begins level
    const std::vector<double>&depth = r.profile.at(0).values, &velocity = r.profile.at(1).values;
    REQUIRE(depth == std::vector<double>{0.5e-3, 1e-3, 6e-3, 40e-3});  // as recorded
    CHECK(velocity[0] > velocity[1]);
    CHECK(velocity[1] > 0.0);
    CHECK(std::isnan(velocity[3]));
    // v = -omega times the distance under the axis. 20 %: at its ends the bed slips a little along the wall.
    const double under_axis = depth[2] - quantity(r, "surface_above_axis");
    CHECK(velocity[2] == Approx(-5.3 * under_axis).epsilon(0.2));
}
