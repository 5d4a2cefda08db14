// SPDX-License-Identifier: MIT
#include "engines/yade_decks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace engines {
namespace {

constexpr const char* script = R"py(
O.bodies.append(utils.wall(0, axis=2, material=material))
for line in open('start.txt'):
    x, y, z, vx, vy, vz, spin, radius = (float(word) for word in line.split())
    body = O.bodies[O.bodies.append(utils.sphere((x, y, z), radius, material=material))]
    # Leapfrog: a velocity belongs to half a step before its place.
    body.state.vel = Vector3(vx, vy, vz) - 0.5 * O.dt * gravity
    body.state.angVel = (0, spin, 0)
grains = [body for body in O.bodies if isinstance(body.shape, Sphere)]
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=margin),
    # hertzian: a wall has R* = R, not that of a second grain.
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(hertzian=True)],
        [Ip2_FrictMat_FrictMat_MindlinPhys(IP2)], [Law2_ScGeom_MindlinPhys_Mindlin(LAW2)]),
    NewtonIntegrator(damping=0, gravity=gravity),
]


def write_row(out):
    out.write('ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n%d\nITEM: BOX BOUNDS ff ff ff\n' % (O.iter, len(grains)))
    out.write('0 0\n' * 3 + 'ITEM: ATOMS id x y z vx vy vz omegax omegay omegaz\n')
    for k, body in enumerate(grains):
        state = body.state
        numbers = list(state.pos) + list(state.vel) + list(state.angVel)
        out.write('%d %s\n' % (k + 1, ' '.join('%.17g' % number for number in numbers)))


with open('rows.dump', 'w') as out:
    for row in open('rows.txt'):
        while O.iter < int(row):
            O.step()
        write_row(out)
print('similitude: done at step', O.iter)
)py";

void put(std::string& text, const std::string& place, const std::string& words) {
    text.replace(text.find(place), place.size(), words);
}

}  // namespace

// Tsuji's normal dashpot has its ratio at both springs in ours: es is en.
YadeLaws yade_laws(const rigs::ContactParameters& c, double density) {
    return {material_of_pair(c.e_star, c.g_star), c.sliding_friction, density,
            fmt::format("en={0:.17g}, es={0:.17g}", c.restitution), ""};
}

std::string yade_material(const YadeLaws& laws) {
    return fmt::format(
        "from yade import *\nimport math\nimport yade.config\n\nprint('similitude: Yade', "
        "yade.config.version)\nmaterial = FrictMat(young={:.17g}, poisson={:.17g}, "
        "density={:.17g}, frictionAngle=math.atan({:.17g}))\nO.materials.append(material)\n",
        laws.material.youngs_modulus, laws.material.poisson_ratio, laws.density,
        laws.sliding_friction);
}

Deck yade_one_grain(const cases::Case& c, const cases::Experiment& e, const rigs::Ordinates& at,
                    const DeckOptions& options) {
    const Throw t(c, e, at, options, "yade");
    const std::vector<dem_min::Grain> grains = t.grains();
    const YadeLaws laws = yade_laws(t.contact(), grains.front().density);
    std::string deck = fmt::format(
        "# The rig {} of similitude in Yade 2023.02a: yade -n -x deck.py. SI units; the plate is z "
        "= 0.\n",
        t.rig());
    deck += yade_material(laws);
    deck += fmt::format(
        "O.dt = {:.17g}\nmargin = {:.17g}\ngravity = Vector3({:.17g}, 0, {:.17g})\n", t.time_step(),
        0.2 * t.radius(), t.gravity() * std::sin(t.angle()), -t.gravity() * std::cos(t.angle()));
    std::string rest = script;
    put(rest, "IP2", laws.ip2);
    put(rest, "LAW2", laws.law2);
    Deck result{"deck.py", deck + rest};
    std::string start;
    for (const dem_min::Grain& g : grains)
        start += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n",
                             g.position.x, g.position.y, g.position.z, g.velocity.x, g.velocity.y,
                             g.velocity.z, g.spin.y, g.radius);
    result.files.emplace_back("start.txt", start);
    std::string rows;
    for (const std::int64_t step :
         t.over_time() ? t.row_steps() : std::vector<std::int64_t>{t.steps()})
        rows += fmt::format("{}\n", step);
    result.files.emplace_back("rows.txt", rows);
    return result;
}

// No OpenMP: the sums of several threads differ from run to run.
std::vector<std::string> yade_command(const std::string& program, int) {
    return {program, "-j1", "-n", "-x", "deck.py"};
}

std::string yade_release(const std::string& output) {
    const std::string start = "similitude: Yade ";
    const std::size_t begin = output.find(start);
    if (begin == std::string::npos) return "unknown";
    const std::size_t at = begin + start.size();
    return output.substr(at, output.find('\n', at) - at);
}

std::string yade_complaint(const std::string& output) {
    std::istringstream in(output);
    std::string error, last;
    for (std::string line; std::getline(in, line);) {
        if (line.find("Error") != std::string::npos) error = line;
        if (!line.empty()) last = line;
    }
    return error.empty() ? last : error;
}

}  // namespace engines
