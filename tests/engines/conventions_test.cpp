// SPDX-License-Identifier: MIT
// What other engines' numbers mean: their laws written down here and searched for the deepest tension; LAMMPS and Yade run.
#include "engines/conventions.hpp"

#include "engines/lammps_run.hpp"
#include "engines/lammps_two_grains.hpp"
#include "engines/process.hpp"
#include "tests/engines/scratch.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

using engines::AdhesionConvention;
using engines::Pair;
using std::numbers::pi;

namespace {

const AdhesionConvention& adhesion(const std::string& name) {
    for (const AdhesionConvention& c : engines::adhesion_conventions())
        if (c.name == name) return c;
    throw std::runtime_error("no convention " + name);
}

// Grains of 100 um, E = 10 MPa, nu = 0.3 as E* and R* by hand.
constexpr double modulus = 10e6, nu = 0.3, radius = 50e-6, gamma_of_one = 0.05;
const Pair two{.r_star = radius / 2,
               .e_star = modulus / (2.0 * (1.0 - nu * nu)),
               .radius = radius,
               .weight = 1e-8,
               .wall = false};

// The least of f over a dense grid, which is fine enough for 1e-6 of a parabola's depth.
template <class F>
double least(const F& f, double from, double to) {
    double best = 0.0;
    for (int k = 0; k <= 200000; ++k) best = std::min(best, f(from + (to - from) * k / 200000));
    return best;
}

engines::TwoGrains drawn_apart() {
    engines::TwoGrains t{};
    constexpr double overlap = 3e-7, speed = 0.0625;
    const double at = radius - 0.5 * overlap;
    t.grains = {dem_min::Grain{{-at, 0.0, 0.0}, {-speed, 0.0, 0.0}, {}, radius, 2500.0},
                dem_min::Grain{{at, 0.0, 0.0}, {speed, 0.0, 0.0}, {}, radius, 2500.0}};
    t.contact = {.youngs_modulus = modulus, .poisson_ratio = nu, .surface_energy = gamma_of_one};
    t.time_step = 1e-9, t.steps = 4000, t.skin = 1e-5;
    return t;
}

double deepest(const engines::PairStates& states) {
    double tension = 0.0;
    for (const auto& pair : states) tension = std::max(tension, -pair[1].force.x);
    return tension;
}

}  // namespace

// Force over contact radius as each code writes it (sources in engines/conventions.cpp).
TEST_CASE("conventions: the pull-off force is the deepest tension of the law itself",
          "[engines][convert]") {
    const double e = two.e_star, r = two.r_star, v = 0.05;
    const double far = 6.0 * std::cbrt(9.0 * pi * v * r * r / (2.0 * e));
    const auto by_surface = [&](double a) {
        return 4.0 * e * a * a * a / (3.0 * r) - 4.0 * std::sqrt(pi * v * e) * std::pow(a, 1.5);
    };
    const auto by_work = [&](double a) {
        return 4.0 * e * a * a * a / (3.0 * r) - std::sqrt(8.0 * pi * v * e * a * a * a);
    };
    for (const char* name : {"surface_energy", "lammps_jkr", "edem_v1_equations", "lethe_jkr"})
        CHECK(adhesion(name).pull_off(v, two) ==
              Approx(-least(by_surface, 0.0, far)).epsilon(1e-6));
    for (const char* name : {"work_of_adhesion", "musen_jkr", "kratos_jkr"})
        CHECK(adhesion(name).pull_off(v, two) == Approx(-least(by_work, 0.0, far)).epsilon(1e-6));
    // LIGGGHTS: an energy density times the circle where two spheres cut, from its distance formula.
    const double k = 1e5, big = radius;
    const auto sjkr = [&](double d) {
        const double dist = 2.0 * big - d;
        const double area = -pi / 4.0 * (dist - 2.0 * big) * (dist + 2.0 * big);
        return 4.0 / 3.0 * e * std::sqrt(r) * std::pow(d, 1.5) - k * area;
    };
    const double span = 4.0 * std::pow(k * 2.0 * pi * r, 2) / (4.0 * e * e * r);
    // The circle is 2 pi R* overlap but for overlap/(4 R).
    CHECK(adhesion("liggghts_sjkr").pull_off(k, two) ==
          Approx(-least(sjkr, 0.0, span)).epsilon(span / big));
    const auto sjkr2 = [&](double d) {
        return 4.0 / 3.0 * e * std::sqrt(r) * std::pow(d, 1.5) - k * 2.0 * pi * d * 2.0 * r;
    };
    CHECK(adhesion("liggghts_sjkr2").pull_off(k, two) ==
          Approx(-least(sjkr2, 0.0, 4.0 * span)).epsilon(1e-6));
}

TEST_CASE("conventions: there and back is the same number, at walls, too", "[engines][convert]") {
    Pair wall = two;
    wall.r_star = radius, wall.wall = true;
    for (const AdhesionConvention& c : engines::adhesion_conventions())
        for (const Pair& p : {two, wall}) {
            INFO(c.name);
            CHECK(c.value(c.pull_off(0.37, p), p) == Approx(0.37).epsilon(1e-12));
        }
    // Equal works of adhesion, unlike forces: JKR 3/2 pi w R*, DMT 2 pi w R*.
    const double w = 0.1;
    CHECK(adhesion("yade_dmt").pull_off(0.5 * w, two) /
              adhesion("lammps_jkr").pull_off(0.5 * w, two) ==
          Approx(4.0 / 3.0).epsilon(1e-12));
    CHECK(adhesion("yade_dmt").work_of_adhesion(2.0 * pi * w * two.r_star, two) == Approx(w));
    CHECK(std::isnan(adhesion("liggghts_sjkr").work_of_adhesion(1.0, two)));
}

TEST_CASE("conventions: equal spheres roll against R/2 or R, as each engine has its lever",
          "[engines][convert]") {
    for (const engines::RollingConvention& c : engines::rolling_conventions()) {
        INFO(c.name);
        const bool whole = c.name == "edem_standard" || c.name == "musen" || c.name == "mercurydpm";
        CHECK(c.lever(two) == Approx(whole ? radius : radius / 2.0));
    }
    for (const engines::DampingConvention& c : engines::damping_conventions())
        if (c.name == "yade_betan")  // ln(1/e)/sqrt(pi^2 + ln^2 e) at e = 1/e'
            CHECK(c.value(std::exp(-1.0)) == Approx(1.0 / std::sqrt(1.0 + pi * pi)));
}

TEST_CASE("conventions: LAMMPS pulls as hard as it is said to", "[engines][convert][lammps]") {
    const auto lmp = engines::find_program("lmp");
    if (!lmp) {
        WARN("lmp is not installed: its conventions were not measured");
        return;
    }
    const engines::TwoGrains t = drawn_apart();
    const std::string jkr = engines::led_deck(t);
    const Scratch folder("conventions");
    CHECK(deepest(engines::run_two_grains(*lmp, t, jkr, folder.path)) ==
          Approx(adhesion("lammps_jkr").pull_off(gamma_of_one, two)).epsilon(1e-5));
    std::string dmt = jkr;
    dmt.replace(dmt.find(" jkr "), 5, " dmt ");
    CHECK(deepest(engines::run_two_grains(*lmp, t, dmt, folder.path)) ==
          Approx(adhesion("lammps_dmt").pull_off(gamma_of_one, two)).epsilon(1e-5));
}

TEST_CASE("conventions: Yade pulls as hard as it is said to", "[engines][convert][yade]") {
    if (!engines::find_program("yade")) {
        WARN("yade is not installed: its convention was not measured");
        return;
    }
    const Scratch folder("conventions-yade");
    engines::write_text(folder.path / "pull.py",
                        fmt::format(R"(from yade import *
m = FrictMat(young={}, poisson={}, density=2500, frictionAngle=0)
O.materials.append(m)
at = {} - 1.5e-7
for x, v in ((-at, -1), (at, 1)):
    i = O.bodies.append(utils.sphere((x, 0, 0), {}, material=m))
    O.bodies[i].state.blockedDOFs = 'xyzXYZ'
    O.bodies[i].state.vel = (0.0625 * v, 0, 0)
O.engines = [ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=1e-6),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(gamma={})],
                    [Law2_ScGeom_MindlinPhys_Mindlin(includeAdhesion=True)]),
    NewtonIntegrator(damping=0)]
O.dt = 1e-9
least = 0.0
for k in range(4000):
    O.step()
    least = min(least, O.forces.f(1)[0])
print('pull-off %.17g' % -least)
)",
                                    modulus, nu, radius, radius, gamma_of_one));
    const engines::Finished done =
        engines::run({"yade", "-j1", "-n", "-x", "pull.py"}, folder.path, 120.0);
    INFO(done.out);
    const std::size_t at = done.out.find("pull-off ");
    REQUIRE(at != std::string::npos);
    CHECK(std::stod(done.out.substr(at + 9)) ==
          Approx(adhesion("yade_dmt").pull_off(gamma_of_one, two)).epsilon(1e-5));
}
