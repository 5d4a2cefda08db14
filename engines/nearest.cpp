// SPDX-License-Identifier: MIT
#include "engines/nearest.hpp"

#include "contact/jkr.hpp"
#include "engines/lammps_dump.hpp"
#include "engines/lammps_files.hpp"
#include "engines/lammps_run.hpp"
#include "engines/liggghts_decks.hpp"
#include "engines/process.hpp"
#include "engines/yade_decks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace engines {
namespace {

using dem_min::Grain;
using rigs::PileSetup;

constexpr int rows = 2000;           // of a separation: its work to 1e-3
constexpr double time_limit = 60.0;  // s

double r_star(const PileSetup& s) { return 0.25 * s.d; }

rigs::ContactParameters undamped(const PileSetup& s) {
    rigs::ContactParameters c = s.grains;
    c.restitution = 1.0, c.sliding_friction = 0.0, c.rolling_friction = 0.0;
    return c;
}

// Of rows of overlap and force > 0 in compression; the overlap falls.
Separation separation_of(const std::vector<double>& overlap, const std::vector<double>& force) {
    Separation s{};
    for (std::size_t k = 0; k < force.size(); ++k) {
        s.pull_off = std::max(s.pull_off, -force[k]);
        if (overlap[k] >= 0.0) s.at_touch = -force[k];
        if (force[k] >= 0.0 && overlap[k] > 0.0 && s.pull_off == 0.0) s.overlap = overlap[k];
        if (force[k] < 0.0) s.gap = std::max(0.0, -overlap[k]);
        if (k > 0 && overlap[k - 1] <= s.overlap)
            s.work -= 0.5 * (force[k] + force[k - 1]) * (overlap[k - 1] - overlap[k]);
    }
    return s;
}

}  // namespace

Separation jkr_separation(double work_of_adhesion, double r, double e_star) {
    const contact::Jkr jkr{e_star, work_of_adhesion};
    const double length = jkr.length_scale(r), unit = length * length / r;
    // F = 0 at a = 9^(1/3) L, where the overlap is 1.44225 L^2/R* (Johnson, Kendall & Roberts 1971).
    const double a = std::cbrt(9.0), balance = unit * (a * a - 2.0 * std::sqrt(a));
    const double end = jkr.tear_off_overlap(r, length);
    return {jkr.pull_off_force(r), -jkr.at(r, length, 0.0).force, balance, -end,
            jkr.energy(r, length, end) - jkr.energy(r, length, balance)};
}

DrawnApart drawn_apart(const PileSetup& s) {
    const Separation jkr = jkr_separation(s.grains.work_of_adhesion, r_star(s), s.grains.e_star);
    // Sjkr of the same pull-off balances at less than seven times JKR's overlap.
    return {8.0 * jkr.overlap, -2.0 * jkr.gap, rows};
}

Deck liggghts_apart(const PileSetup& s) {
    const DrawnApart way = drawn_apart(s);
    const double step = 1e-6, speed = 0.5 * (way.first - way.last) / (way.steps * step);
    const double half = 0.5 * (s.d - way.first);
    const std::vector<Grain> grains{
        {{0.0, 0.0, -half}, {0.0, 0.0, -speed}, {}, 0.5 * s.d, s.density},
        {{0.0, 0.0, half}, {0.0, 0.0, speed}, {}, 0.5 * s.d, s.density}};
    const rigs::ContactParameters contact = undamped(s);
    const LiggghtsRules rules = liggghts_rules(contact, contact, s.d);
    std::string deck = "# Two grains drawn apart, whatever the forces.\n" +
                       liggghts_opening(rules) + "read_data start.data\n" +
                       liggghts_model(rules, 0.4 * s.d, step) +
                       "neigh_modify delay 0 every 1 check yes\nfix motion all nve/noforce\n"
                       "dump rows all custom 1 rows.dump id z fz\n"
                       "dump_modify rows sort id format \"%d %.17g %.17g\"\n";
    deck += fmt::format("run {}\n", way.steps);
    const double far = 10.0 * s.d;
    return {"deck.in",
            deck,
            {{"start.data", liggghts_data(grains, {{-far, -far, -far}, {far, far, far}}, 1, 1)}}};
}

Deck yade_apart(const PileSetup& s) {
    const DrawnApart way = drawn_apart(s);
    const rigs::ContactParameters contact = undamped(s);
    std::string deck = "# Two grains drawn apart, whatever the forces.\n" +
                       yade_material(yade_laws(contact, s.density));
    deck += fmt::format("d, first, last, steps, gamma = {:.17g}, {:.17g}, {:.17g}, {}, {:.17g}\n",
                        s.d, way.first, way.last, way.steps, dmt_gamma(s.grains.work_of_adhesion));
    deck += R"py(
for k in (-1, 1):
    O.bodies.append(utils.sphere((0, 0, k * 0.5 * (d - first)), 0.5 * d, material=material))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(gamma=gamma)], [Law2_ScGeom_MindlinPhys_Mindlin(includeAdhesion=True)]),
]
O.dt = 1e-9
with open('rows.dump', 'w') as out:
    for row in range(steps + 1):
        overlap = first + (last - first) * row / steps
        for k in (0, 1):
            O.bodies[k].state.pos = (0, 0, (2 * k - 1) * 0.5 * (d - overlap))
        O.step()
        out.write('ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n' % row)
        out.write('0 0\n' * 3 + 'ITEM: ATOMS id z fz\n')
        # The contact's own: nothing but an integrator sets the sums of forces back.
        force = sum(i.phys.normalForce[2] for i in O.interactions if i.isReal)
        for k in (0, 1):
            out.write('%d %.17g %.17g\n' % (k + 1, O.bodies[k].state.pos[2], (2 * k - 1) * force))
)py";
    return {"deck.py", deck};
}

Separation measured_separation(const Peer& peer, const std::filesystem::path& program,
                               const PileSetup& s, const std::filesystem::path& folder) {
    write_deck(peer.apart(s), folder);
    const Finished f = run(peer.command(program.string(), 1), folder, time_limit);
    keep_output(peer, folder, f.out);
    if (f.exit_code != 0)
        throw std::runtime_error(fmt::format("{}: {} ended with {}: {}", folder.string(),
                                             peer.title, f.exit_code, peer.complaint(f.out)));
    const std::string dump = (folder / "rows.dump").string();
    std::vector<double> overlap, force;
    for (const LammpsFrame& frame : read_lammps_frames(dump)) {
        const std::size_t z = frame.column("z"), fz = frame.column("fz");
        overlap.push_back(s.d - (frame.rows.at(1)[z] - frame.rows.at(0)[z]));
        force.push_back(frame.rows[1][fz]);
    }
    return separation_of(overlap, force);
}

std::vector<std::string> how_far_off(const Peer& peer, const std::filesystem::path& program,
                                     const PileSetup& s, const std::filesystem::path& folder) {
    std::vector<std::string> said;
    if (s.grains.work_of_adhesion > 0.0) {
        const Separation jkr =
            jkr_separation(s.grains.work_of_adhesion, r_star(s), s.grains.e_star);
        const Separation its = measured_separation(peer, program, s, folder);
        const double weight = s.density * std::numbers::pi / 6.0 * s.d * s.d * s.d * s.gravity;
        said.push_back(fmt::format(
            "nearest to JKR in {}, two nominal grains drawn apart: pull-off {:.3g} N (JKR {:.3g}), "
            "{:.3g} grain weights; at touch {:.3g} of it (JKR 0.889); pull ends at a gap of {:.3g} "
            "m (JKR {:.3g}); overlap without load {:.3g} m (JKR {:.3g}); work to part them "
            "{:.3g} J (JKR {:.3g})",
            peer.title, its.pull_off, jkr.pull_off, its.pull_off / weight,
            its.at_touch / its.pull_off, its.gap, jkr.gap, its.overlap, jkr.overlap, its.work,
            jkr.work));
    }
    if (peer.name == "yade" && s.grains.rolling_friction > 0.0)
        said.emplace_back(
            "nearest to EPSD rolling in Yade: the same largest torque between grains of one size, "
            "a spring of one stiffness, and no dashpot");
    return said;
}

}  // namespace engines
