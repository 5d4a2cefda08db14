// SPDX-License-Identifier: MIT
#include "engines/bed_yade.hpp"

#include "engines/output.hpp"

#include <fmt/format.h>

#include <sstream>

namespace engines {

namespace {

std::string deck(const Bed& b) {
    const contact::Vec3 g = b.acceleration();
    return fmt::format(
        R"(# The bed of similitude bench in Yade: Hertz, Mindlin, DMT adhesion, walls at the sides.
from yade import *
import math, time, yade.config
steel = FrictMat(young={E}, poisson={nu}, density={rho}, frictionAngle=math.atan({muw}))
grain = FrictMat(young={E}, poisson={nu}, density={rho}, frictionAngle=math.atan({mu}))
for material in (steel, grain):
    O.materials.append(material)
O.bodies.append(utils.wall(0, axis=2, material=steel))
for axis, length in ((0, {lx}), (1, {ly})):
    for place in (0, length):
        O.bodies.append(utils.wall(place, axis=axis, material=steel))
for line in open('bed.xyz'):
    O.bodies.append(utils.sphere([float(word) for word in line.split()], {R}, material=grain))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist={margin}),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(en={e}, es={e}, gamma={gamma})],
        [Law2_ScGeom_MindlinPhys_Mindlin(includeAdhesion=True)]),
    NewtonIntegrator(damping=0, gravity=({gx}, {gy}, {gz})),
]
O.dt = {dt}
O.run({warm_up}, True)
start = time.time()
O.run({steps}, True)
seconds = time.time() - start
spheres = [b for b in O.bodies if isinstance(b.shape, Sphere)]
def is_pair(i):
    return all(isinstance(O.bodies[k].shape, Sphere) for k in (i.id1, i.id2))
pairs = sum(1 for i in O.interactions if i.isReal and is_pair(i))
print('bed: version Yade', yade.config.version)
print('bed: grains %d neighbours %.9g kinetic %.9g seconds %.9g'
      % (len(spheres), 2.0 * pairs / len(spheres), utils.kineticEnergy(), seconds))
)",
        fmt::arg("E", b.youngs_modulus), fmt::arg("nu", b.poisson_ratio),
        fmt::arg("rho", b.density), fmt::arg("muw", b.wall_friction),
        fmt::arg("mu", b.sliding_friction), fmt::arg("lx", b.period_x()),
        fmt::arg("ly", b.period_y()), fmt::arg("R", b.radius), fmt::arg("margin", b.margin),
        fmt::arg("e", b.restitution), fmt::arg("gamma", b.surface_energy), fmt::arg("gx", g.x),
        fmt::arg("gy", g.y), fmt::arg("gz", g.z), fmt::arg("dt", b.time_step),
        fmt::arg("warm_up", b.warm_up), fmt::arg("steps", b.steps));
}

std::string positions_text(const Bed& b) {
    std::string text;
    for (const contact::Vec3& at : positions(b))
        text += fmt::format("{} {} {}\n", at.x, at.y, at.z);
    return text;
}

BedFigures read(const std::string& output) {
    const std::string version_at = "bed: version ";
    BedFigures f;
    bool counted = false;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        counted = read_bed_line(line, f) || counted;
        if (line.rfind(version_at, 0) == 0) f.version = line.substr(version_at.size());
    }
    if (!counted || f.seconds <= 0.0) throw_unreadable(output);
    return f;
}

}  // namespace

BedEngine yade() {
    return {
        .name = "yade",
        .title = "Yade",
        .program = "yade",
        .package = "yade",
        .laws = "Hertz, Mindlin with history, DMT, no rolling resistance",
        .differs =
            "walls at the sides in place of periods, DMT in place of JKR, no rolling "
            "resistance: the same grains, not the same physics",
        .deck =
            [](const Bed& b) {
                return std::vector<DeckFile>{{"bed.py", deck(b)}, {"bed.xyz", positions_text(b)}};
            },
        .command =
            [](int threads) {
                return std::vector<std::string>{"yade", fmt::format("-j{}", threads), "-n", "-x",
                                                "bed.py"};
            },
        .read = [](const Bed&, const std::string& output) { return read(output); }};
}

}  // namespace engines
