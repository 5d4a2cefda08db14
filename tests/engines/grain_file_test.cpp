// SPDX-License-Identifier: MIT
// Files as other programs write them, a few lines each, written by hand from the formats' descriptions (docs/formats.md).
#include "engines/grain_file.hpp"

#include "scaling/errors.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

using Catch::Matchers::Contains;
using engines::GrainFormat;
using engines::GrainFrame;
using engines::GrainOptions;

namespace {

class Text {
  public:
    explicit Text(const std::string& text) : path((folder_.path / "grains").string()) {
        std::ofstream(path, std::ios::binary) << text;
    }

  private:
    Scratch folder_{"grains"};

  public:
    std::string path;
};

std::vector<GrainFrame> frames_of(const std::string& text, const GrainOptions& options) {
    const Text file(text);
    const auto reader = engines::open_grains(file.path, options);
    std::vector<GrainFrame> frames;
    for (GrainFrame f; reader->next(f);) frames.push_back(f);
    return frames;
}

std::string complaint(const std::string& text, const GrainOptions& options) {
    try {
        frames_of(text, options);
    } catch (const scaling::InvalidInput& error) {
        return error.what();
    }
    return "no complaint";
}

GrainOptions with(const std::string& units) {
    GrainOptions o;
    o.units = engines::units_named(units, "--units");
    return o;
}

std::string changed(std::string text, const std::string& old, const std::string& by) {
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), by);
}

// As LIGGGHTS 3.8 writes `dump custom`: no units, no time, a blank behind the column names. Lengths in units of the deck.
const std::string two_frames = R"(ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS ff ff ff
-4 4
-4 4
0 8
ITEM: ATOMS id type x y z ix iy iz vx vy vz fx fy fz omegax omegay omegaz radius 
7 2 1.5 -2 3 0 0 0 10 20 30 0 0 -1 1 2 3 0.25
3 1 -1.5 2 0.5 0 0 0 0 0 0 0 0 0 0 0 0 0.5
ITEM: TIMESTEP
1000
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS ff ff ff
-4 4
-4 4
0 8
ITEM: ATOMS id type x y z ix iy iz vx vy vz fx fy fz omegax omegay omegaz radius 
7 2 1.25 -2 1e0 0 0 0 0 0 0 0 0 0 0 0 0 0.25
)";

const std::string scaled_coordinates = R"(ITEM: UNITS
si
ITEM: TIME
0.125
ITEM: TIMESTEP
50
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS pp pp ff
-1 3
0 2
0 8
ITEM: ATOMS id type xs ys zs diameter mass
1 1 0.25 0.5 0.75 0.5 2
)";

const std::string data =
    R"(LAMMPS data file via write_data, version 2 Aug 2023, timestep = 0, units = cgs

2 atoms
1 atom types

-5 5 xlo xhi
-5 5 ylo yhi
0 10 zlo zhi

Pair Coeffs # gran/hooke/history

1

Atoms # sphere

2 1 0.2 2.5 1 2 3 0 0 0
1 1 0.4 2.5 -1 -2 4 0 0 0

Velocities

1 1 2 3 4 5 6
2 0 0 0 0 0 0
)";

const std::string mercury = R"(2 0.5 0 0 0 10 10 10
1 2 3 0.1 0.2 0.3 0.5 0 0 0 7 8 9 0
4 5 6 0 0 0 0.25 0 0 0 0 0 0 1
1 0.75 0 0 0 10 10 10
1 2 2 0 0 0 0.5 0 0 0 0 0 0 0
)";

const std::string edem = R"(EDEM export of a heap
a title

TIME:,0.4
Q01 : Total Number of Particles:,2
Q02 : Particle Position X:,12,-3
Q03 : Particle Position Y:,0,4
Q04 : Particle Position Z:,5,6
Q05 : Particle Velocity X (m/s):,1,0
Q06 : Particle Velocity Y (m/s):,2,0
Q07 : Particle Velocity Z (m/s):,3,0
Q08 : Particle Volume (mm^3):,4.1887902047863905,33.510321638291124
Q09 : Particle Mass:,1,1
TIME:,0.5
Q02 : Particle Position X:
,7
Q03 : Particle Position Y:
,8
Q04 : Particle Position Z:
,9
Q08 : Particle Volume (mm^3):
,4.1887902047863905
)";

GrainOptions millimetres() {
    GrainOptions o;
    o.format = GrainFormat::edem_csv;
    o.length_unit = 1e-3;
    return o;
}

}  // namespace

TEST_CASE("grain file: a dump of LIGGGHTS gives its frames, columns by name, in the stated units",
          "[engines][formats]") {
    const auto frames = frames_of(two_frames, with("cgs"));
    REQUIRE(frames.size() == 2);
    const rigs::Frame& f = frames[0].frame;
    CHECK(f.step == 0);
    CHECK_FALSE(frames[0].has_time);
    CHECK_FALSE(frames[0].has_mass);
    REQUIRE(f.count() == 2);
    CHECK(f.id == std::vector<std::int64_t>{7, 3});
    CHECK(f.type == std::vector<int>{2, 1});
    CHECK(f.position[0].x == Approx(0.015).epsilon(1e-15));
    CHECK(f.position[0].y == Approx(-0.02).epsilon(1e-15));
    CHECK(f.position[1].z == Approx(0.005).epsilon(1e-15));
    CHECK(f.velocity[0].z == Approx(0.3).epsilon(1e-15));  // cm/s
    CHECK(f.spin[0] == contact::Vec3{1.0, 2.0, 3.0});
    CHECK(f.radius[1] == Approx(0.005).epsilon(1e-15));
    CHECK(std::isnan(f.mass[0]));
    CHECK(frames[0].unused == std::vector<std::string>{"ix", "iy", "iz", "fx", "fy", "fz"});
    CHECK(frames[1].frame.step == 1000);
    CHECK(frames[1].frame.position.at(0).z == Approx(0.01).epsilon(1e-15));
}

TEST_CASE("grain file: types that never move are those that are named", "[engines][formats]") {
    GrainOptions o = with("si");
    o.fixed_types = {2};
    CHECK(frames_of(two_frames, o)[0].frame.fixed == std::vector<std::uint8_t>{1, 0});
}

TEST_CASE("grain file: a dump's own units and time hold, scaled coordinates are shares of the box",
          "[engines][formats]") {
    const auto frames = frames_of(scaled_coordinates, {});
    REQUIRE(frames.size() == 1);
    CHECK(frames[0].has_time);
    CHECK(frames[0].frame.time == 0.125);
    CHECK(frames[0].frame.position[0] == contact::Vec3{0.0, 1.0, 6.0});  // -1 + 4/4, 2/2, 8 3/4
    CHECK(frames[0].frame.radius[0] == 0.25);
    CHECK(frames[0].frame.mass[0] == 2.0);
    CHECK_FALSE(frames[0].has_velocity);
}

// LAMMPS manual, "units": micro has micrometres, microseconds and picograms; densities pg/um^3 = 1000 kg/m^3.
TEST_CASE("grain file: LAMMPS' styles of units come out in SI", "[engines][formats]") {
    const auto micro = frames_of(changed(data, "cgs", "micro"), {}).at(0).frame;
    CHECK(micro.position[0].z == Approx(3e-6).epsilon(1e-15));
    CHECK(micro.radius[0] == Approx(1e-7).epsilon(1e-15));
    CHECK(micro.velocity[1].y == Approx(2.0).epsilon(1e-14));  // um/us
    const double volume = 4.0 / 3.0 * 3.14159265358979 * 1e-21;
    CHECK(micro.mass[0] == Approx(2500.0 * volume).epsilon(1e-13));
    CHECK_THAT(complaint(changed(data, "cgs", "lj"), {}), Contains("--length-unit"));
    CHECK_THAT(complaint(changed(data, "cgs", "real"), {}), Contains("must be si, cgs, micro"));
    GrainOptions scales;
    scales.units = engines::FileUnits{"stated", 2e-3, 1.0, 1.0};
    const auto lj = frames_of(changed(data, "cgs", "lj"), scales).at(0).frame;
    CHECK(lj.position[0].x == 2e-3);
}

TEST_CASE("grain file: LAMMPS data holds diameters, and velocities by id", "[engines][formats]") {
    const auto frames = frames_of(data, {});
    REQUIRE(frames.size() == 1);
    const rigs::Frame& f = frames[0].frame;
    REQUIRE(f.count() == 2);
    CHECK(f.radius[0] == Approx(0.001).epsilon(1e-15));  // 0.2 cm across
    CHECK(f.velocity[0] == contact::Vec3{});
    CHECK(f.velocity[1].x == Approx(0.01).epsilon(1e-15));
    CHECK(f.spin[1] == contact::Vec3{4.0, 5.0, 6.0});
    CHECK(f.high.z == Approx(0.1).epsilon(1e-15));
    CHECK(frames[0].unused ==
          std::vector<std::string>{"image flags", "section Pair Coeffs # gran/hooke/history"});
}

TEST_CASE("grain file: MercuryDPM's columns and frames", "[engines][formats]") {
    const auto frames = frames_of(mercury, with("si"));
    REQUIRE(frames.size() == 2);
    const rigs::Frame& f = frames[0].frame;
    CHECK(f.time == 0.5);
    CHECK(f.position[1] == contact::Vec3{4.0, 5.0, 6.0});
    CHECK(f.velocity[0] == contact::Vec3{0.1, 0.2, 0.3});
    CHECK(f.radius == std::vector<double>{0.5, 0.25});
    CHECK(f.spin[0] == contact::Vec3{7.0, 8.0, 9.0});
    CHECK(f.type == std::vector<int>{1, 2});  // species 0 and 1
    CHECK(frames[1].frame.position[0].z == 2.0);
    CHECK_THAT(complaint(mercury, {}), Contains("--units si"));
    CHECK_THAT(complaint("2 0.5 0 0 10 10\n", with("si")), Contains("two dimensions"));
    CHECK_THAT(complaint(changed(mercury, " 7 8 9 0\n", " 7 8 9\n"), with("si")),
               Contains(":2:") && Contains("13 values"));
}

// Volumes of spheres of 1 and 2 mm radius: 4/3 pi r^3.
TEST_CASE("grain file: EDEM's export, values beside a query or below it", "[engines][formats]") {
    const auto frames = frames_of(edem, millimetres());
    REQUIRE(frames.size() == 2);
    const rigs::Frame& f = frames[0].frame;
    CHECK(f.time == 0.4);
    REQUIRE(f.count() == 2);
    CHECK(f.position[1].x == Approx(-0.003).epsilon(1e-15));
    CHECK(f.position[1].z == Approx(0.006).epsilon(1e-15));
    CHECK(f.velocity[0] == contact::Vec3{1.0, 2.0, 3.0});
    CHECK(f.radius[0] == Approx(1e-3).epsilon(1e-14));
    CHECK(f.radius[1] == Approx(2e-3).epsilon(1e-14));
    CHECK_FALSE(frames[0].has_mass);  // no unit
    REQUIRE(frames[0].unused.size() == 1);
    CHECK_THAT(frames[0].unused[0], Contains("Particle Mass (no unit"));
    CHECK(frames[1].frame.time == 0.5);
    CHECK(frames[1].frame.position.at(0).y == Approx(0.008).epsilon(1e-15));
}

TEST_CASE("grain file: EDEM's export is refused where it would be guessed", "[engines][formats]") {
    GrainOptions none;
    none.format = GrainFormat::edem_csv;
    CHECK_THAT(complaint(edem, none), Contains(":6:") && Contains("--length-unit"));
    CHECK_THAT(complaint(changed(edem, "Particles:,2", "Particles:,3"), millimetres()),
               Contains("must be 3"));
    CHECK_THAT(complaint(changed(edem, "Y:,0,4", "Y:,0"), millimetres()),
               Contains("1 values, must be 2"));
    CHECK_THAT(complaint(changed(edem, "X:,12,-3", "X:,12,-3 mm"), millimetres()),
               Contains(":6:") && Contains("\"-3 mm\""));
    CHECK_THAT(complaint("TIME:,0\nQ01 : Particle Position X:,Q02 : Particle Position Y:\n1,2\n",
                         millimetres()),
               Contains("one query at a time"));
}

TEST_CASE("grain file: CSV carries its units in the header", "[engines][formats]") {
    const auto frames = frames_of(
        "id,x [mm],y (mm),\"z [cm]\",diameter [um],vx [mm/s],vy [m/s],vz [m/s],colour\r\n"
        "5,1,2,3,500,4,0,0,red\r\n",
        {});
    REQUIRE(frames.size() == 1);
    const rigs::Frame& f = frames[0].frame;
    CHECK(f.id[0] == 5);
    CHECK(f.position[0].y == Approx(0.002).epsilon(1e-15));
    CHECK(f.position[0].z == Approx(0.03).epsilon(1e-15));
    CHECK(f.radius[0] == Approx(250e-6).epsilon(1e-15));
    CHECK(f.velocity[0].x == Approx(0.004).epsilon(1e-15));
    CHECK(frames[0].unused == std::vector<std::string>{"colour"});
    CHECK_THAT(complaint("x,y [m],z [m],radius [m]\n", {}),
               Contains("write the header as \"x [m]\""));
    CHECK_THAT(complaint("x [s],y [m],z [m],radius [m]\n", {}), Contains(":1: column"));
    CHECK_THAT(complaint("x [m],y [m],z [m],radius [m]\n1,2,3,0.1\n1,2,3\n", {}),
               Contains(":3: got 3 cells"));
}

TEST_CASE("grain file: Yade's four columns, comments passed over", "[engines][formats]") {
    const auto frames = frames_of("#format x_y_z_r\n1 2 3 0.5\n# a comment\n4\t5\t6\t0.25\n", {});
    REQUIRE(frames.size() == 1);
    CHECK(frames[0].frame.position[1] == contact::Vec3{4.0, 5.0, 6.0});
    CHECK(frames[0].frame.radius == std::vector<double>{0.5, 0.25});
}

TEST_CASE("grain file: what a dump does not say is asked for, what is wrong is shown in its line",
          "[engines][formats][input]") {
    CHECK_THAT(complaint(two_frames, {}), Contains("no ITEM: UNITS") && Contains("--units"));
    CHECK_THAT(complaint(scaled_coordinates, with("cgs")), Contains("leave --units out"));
    CHECK_THAT(complaint(changed(scaled_coordinates, "BOUNDS pp", "BOUNDS xy xz yz pp"), {}),
               Contains(":9:") && Contains("right angles"));
    CHECK_THAT(complaint(changed(data, "0 10 zlo zhi", "0 10 zlo zhi\n0 0 0 xy xz yz"), {}),
               Contains("right angles"));
    CHECK_THAT(complaint(changed(two_frames, "3 1 -1.5", "3 1 oops"), with("si")),
               Contains("grains:11: x: got \"oops\", must be a finite number"));
    CHECK_THAT(complaint(changed(two_frames, "0 0 0 0.5\n", "0 0 0 -0.5\n"), with("si")),
               Contains(":11: got a grain of radius -0.5 m, must be > 0"));
    CHECK_THAT(complaint(two_frames.substr(0, two_frames.find("3 1 -1.5")), with("si")),
               Contains("the end of the file") && Contains("--frame"));
    CHECK_THAT(complaint(changed(scaled_coordinates, "diameter mass", "q mass"), {}),
               Contains("--diameter"));
    CHECK_THAT(complaint(changed(data, "Atoms # sphere", "Atoms # full"), {}),
               Contains("must be \"Atoms # sphere\""));
    CHECK_THAT(complaint(changed(data, "1 1 2 3 4 5 6", "9 1 2 3 4 5 6"), {}), Contains("id 9"));
    CHECK_THAT(complaint("what is this\n", {}), Contains("--format"));
    CHECK_THAT(complaint("\n\n", {}), Contains("an empty file"));
    GrainOptions o = with("si");
    o.diameter = 1.0;
    CHECK_THAT(complaint(two_frames, o), Contains("--diameter") && Contains("leave it out"));
}
