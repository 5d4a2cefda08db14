// SPDX-License-Identifier: MIT
#include "cases/csv.hpp"

#include "scaling/errors.hpp"
#include "temporary_case.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>

using cases::read_recording;

namespace {

std::string mistake_in(const std::string& csv, const std::string& rig) {
    const TemporaryFolder folder;
    const std::string path = folder.write("r.csv", csv);
    const std::string message =
        message_of<scaling::InvalidInput>([&] { read_recording(path, rig); });
    REQUIRE(message.starts_with(path));
    return "r.csv" + message.substr(path.size());
}

}  // namespace

TEST_CASE("a recording is in SI whatever its header says", "[cases][csv]") {
    const TemporaryFolder folder;
    const std::string csv = GENERATE(
        "t [ms],z [mm]\n0,600\n5,599.5\n", "\xEF\xBB\xBFt [ms],z [mm]\r\n0,600\r\n5,599.5\r\n",
        "\"z (cm)\" , t (ms)\n60,0\n59.95,5", "z [um],t [us]\n6e5,0\n\n599500,+5000\n,\n");
    const cases::Recording r = read_recording(folder.write("r.csv", csv), "drop");
    REQUIRE(r.rows() == 2);
    CHECK(r.column("z").unit == "m");
    CHECK(r.values("z")[0] == Approx(0.6).epsilon(1e-15));
    CHECK(r.values("z")[1] == Approx(0.5995).epsilon(1e-15));
    CHECK(r.values("t")[1] == Approx(0.005).epsilon(1e-15));
}

TEST_CASE("an empty cell is a value that was not measured", "[cases][csv]") {
    const TemporaryFolder folder;
    const std::string path = folder.write(
        "r.csv",
        "angle [deg],rebound_angle [deg],normal_restitution\n10,8,\n20,,0.9\n30,nan,0.8\n");
    const cases::Recording r = read_recording(path, "impact");
    REQUIRE(r.rows() == 3);
    CHECK(r.values("rebound_angle")[0] == Approx(8.0 * std::numbers::pi / 180.0).epsilon(1e-15));
    CHECK(std::isnan(r.values("rebound_angle")[1]));
    CHECK(std::isnan(r.values("rebound_angle")[2]));
    CHECK(std::isnan(r.values("normal_restitution")[0]));
    CHECK(r.values("normal_restitution")[1] == 0.9);
}

TEST_CASE("a discharged mass is in kilograms or a fraction of the fill", "[cases][csv]") {
    const TemporaryFolder folder;
    const cases::Recording mass =
        read_recording(folder.write("a.csv", "t [s],m [g]\n0,0\n1,250\n"), "discharge");
    CHECK(mass.column("m").unit == "kg");
    CHECK(mass.values("m")[1] == Approx(0.25).epsilon(1e-15));
    const cases::Recording part =
        read_recording(folder.write("b.csv", "t [s],m [%]\n0,0\n1,25\n"), "discharge");
    CHECK(part.column("m").unit == "1");
    CHECK(part.values("m")[1] == Approx(0.25).epsilon(1e-15));
}

TEST_CASE("the branch of a force curve is a word", "[cases][csv]") {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("r.csv", "separation [nm],force [nN],branch\n300,-1,approach\n-2,5,retract\n");
    const cases::Recording r = read_recording(path, "pull_off");
    CHECK(r.column("branch").words == std::vector<std::string>{"approach", "retract"});
    CHECK(r.values("force")[1] == Approx(5e-9).epsilon(1e-15));
    CHECK(mistake_in("separation [nm],force [nN],branch\n300,-1,aproach\n", "pull_off") ==
          "r.csv: row 2, branch: got \"aproach\", must be one of approach, retract (did you mean "
          "\"approach\"?)");
}

TEST_CASE("a recording that cannot be understood is refused with its place", "[cases][csv]") {
    CHECK(mistake_in("", "drop") ==
          "r.csv: got an empty file, must have a header and rows (export the recording again)");
    CHECK(mistake_in("\n\r\n", "drop") ==
          "r.csv: got an empty file, must have a header and rows (export the recording again)");
    CHECK(mistake_in("t [s],z [mm]\n", "drop") ==
          "r.csv: got a header only, must have rows (export the recording again)");
    CHECK(mistake_in("t [s],z\n0,1\n", "drop") ==
          "r.csv: column \"z\": got no unit, must carry its unit (write the header as \"z [m]\")");
    CHECK(
        mistake_in("t [s],z [N]\n0,1\n", "drop") ==
        "r.csv: column \"z [N]\": got \"N\" [M L T^-2], must have the dimension of m [L] (correct "
        "the unit in the header)");
    CHECK(mistake_in("t [s],hight [m]\n0,1\n", "drop") ==
          "r.csv: column \"hight [m]\": got \"hight\", must be a channel of the rig drop (known: "
          "t, z, x)");
    CHECK(mistake_in("t [s],z [m],z [mm]\n0,1,1\n", "drop") ==
          "r.csv: column \"z [mm]\": got the channel a second time, must stand once (remove one of "
          "the two)");
    CHECK(mistake_in("t [s],z [m]\n0,1\n1\n", "drop") ==
          "r.csv: row 3: got 1 cells, must have 2 (write one cell per column; leave a cell empty "
          "where nothing was measured)");
    CHECK(mistake_in("t [s],z [m]\n0,1 m\n", "drop") ==
          "r.csv: row 2, z: got \"1 m\", must be a finite number (use a decimal point; leave the "
          "cell empty where nothing was "
          "measured)");
    CHECK(mistake_in("t [s],x [m]\n0,1\n", "drop") ==
          "r.csv: got t, x, must hold t, z (add the missing columns)");
    CHECK(mistake_in("t [s],\"z [m]\n0,1\n", "drop").starts_with("r.csv: row 1: got "));
    CHECK(message_of<scaling::InvalidInput>([] { read_recording("/nowhere/r.csv", "drop"); }) ==
          "/nowhere/r.csv: got no readable file, must be a recording (check the name; it stands "
          "relative to case.json)");
}

TEST_CASE("what is written is read back bit for bit", "[cases][csv]") {
    const TemporaryFolder folder;
    const double third = 1.0 / 3.0;
    cases::write_csv(folder.path() + "/w.csv",
                     {{"t", "s", {0.0, third, 5e-324}}, {"z", "m", {0.1, std::nan(""), -1e300}}});
    const cases::Recording r = read_recording(folder.path() + "/w.csv", "drop");
    CHECK(r.values("t") == std::vector<double>{0.0, third, 5e-324});
    CHECK(r.values("z")[0] == 0.1);
    CHECK(std::isnan(r.values("z")[1]));
    CHECK(r.values("z")[2] == -1e300);
    CHECK_THROWS_AS(cases::write_csv("/nowhere/w.csv", {}), std::runtime_error);
}
