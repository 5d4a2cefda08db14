// SPDX-License-Identifier: MIT
#include "engines/pile_feed.hpp"
#include "engines/yade_decks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace engines {
namespace {

using rigs::PileSetup;

constexpr const char* script = R"py(
# Grains of one mask meet; glued ones leave each other out.
LOOSE, GLUED = 1, 3
for line in open('base.txt'):
    x, y, z, radius = (float(word) for word in line.split())
    O.bodies.append(utils.sphere((x, y, z), radius, fixed=True, mask=GLUED, material=material))
loose = []
feed = [[float(word) for word in line.split()] for line in open('feed.txt')]
fed = 0

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=margin, avoidSelfInteractionMask=2),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(IP2)], [Law2_ScGeom_MindlinPhys_Mindlin(LAW2)]),
    NewtonIntegrator(damping=0, gravity=(0, 0, -gravity)),
]


def touching():
    """Contacts: for each body the others that it touches."""
    others = {}
    for i in O.interactions:
        if i.isReal:
            others.setdefault(i.id1, []).append(i.id2)
            others.setdefault(i.id2, []).append(i.id1)
    return others


def heap_top(others):
    """Top of the highest loose grain that is joined by contacts to a glued one."""
    seen = set(b.id for b in O.bodies if b is not None and b.mask == GLUED)
    front, top = list(seen), 0.0
    while front:
        for k in others.get(front.pop(), []):
            if k not in seen:
                seen.add(k)
                front.append(k)
                top = max(top, O.bodies[k].state.pos[2] + O.bodies[k].shape.radius)
    return top


def free_height(x, y, radius, lowest):
    """The lowest height at or above `lowest` at which a sphere is clear of all others."""
    z, moved = lowest, True
    while moved:
        moved = False
        for k in loose:
            place = O.bodies[k].state.pos
            reach = 1.001 * (O.bodies[k].shape.radius + radius)
            level = reach**2 - (place[0] - x)**2 - (place[1] - y)**2
            if level > 0 and (z - place[2])**2 < level:
                z, moved = place[2] + 1.001 * math.sqrt(level), True
    return z


def feed_due():
    global fed
    while fed < len(feed) and feed[fed][0] <= O.time:
        _, x, y, radius = feed[fed]
        lowest = max(mouth, heap_top(touching()) + 2 * d)
        z = free_height(x, y, radius, lowest + radius)
        loose.append(O.bodies.append(utils.sphere((x, y, z), radius, mask=LOOSE, material=material)))
        fed += 1


def drop_lost():
    for k in [k for k in loose if O.bodies[k].state.pos[2] < lost_below]:
        O.bodies.erase(k)
        loose.remove(k)


def kinetic():
    return sum(0.5 * O.bodies[k].state.mass * O.bodies[k].state.vel.squaredNorm() for k in loose)


def run():
    """The step at which the heap has been at rest for long enough; None where it never is."""
    calm = None
    while O.time < longest:
        feed_due()
        O.step()
        if O.iter % 2000 == 0:
            print(O.iter, len(O.bodies), kinetic(), 0, 0, flush=True)
        if O.iter % check != 0:
            continue
        drop_lost()
        if fed < len(feed):
            continue
        if loose and kinetic() / len(loose) >= limit * unit:
            calm = None
        elif calm is None:
            calm = O.iter
        if calm is not None and (O.iter - calm) * O.dt >= rest_duration:
            return True
    return False


at_rest = run()
print('similitude: %s at step %d' % ('at rest' if at_rest else 'given up', O.iter))
others = touching()
with open('final.dump', 'w') as out:
    bodies = [b for b in O.bodies if b is not None]
    out.write('ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n%d\nITEM: BOX BOUNDS ff ff ff\n' % (O.iter, len(bodies)))
    out.write('0 0\n' * 3 + 'ITEM: ATOMS id type x y z vx vy vz omegax omegay omegaz radius c_touching\n')
    for b in bodies:
        numbers = list(b.state.pos) + list(b.state.vel) + list(b.state.angVel) + [b.shape.radius]
        out.write('%d %d %s %d\n' % (b.id + 1, 2 if b.mask == GLUED else 1,
                                     ' '.join('%.17g' % number for number in numbers), len(others.get(b.id, []))))
)py";

void refuse_what_yade_has_not(const PileSetup& s, const DeckOptions& o) {
    if (!o.nearest && s.grains.work_of_adhesion > 0.0)
        refuse(o, "yade", "has no JKR: its DMT pulls by a constant force that ends at touch",
               "say --contact nearest for DMT of the same pull-off force, or leave the option "
               "out: dem_min runs it");
    if (!o.nearest && s.grains.rolling_friction > 0.0)
        refuse(o, "yade",
               "has no EPSD and no SDS rolling: its spring of one stiffness has a slider and no "
               "dashpot",
               "say --contact nearest for that spring with the same largest torque, or leave the "
               "option out: dem_min runs it");
    if (s.conditions.base != rigs::Base::glued_grains)
        refuse(o, "yade", "has no round plate: of facets, a grain over an edge meets two",
               "take glued_grains for the base, or leave the option out");
    refuse_rig_of_our_own(s, o, "yade");
    refuse_surroundings(s, o, "yade");
}

void put(std::string& text, const std::string& place, const std::string& words) {
    text.replace(text.find(place), place.size(), words);
}

// Yade's lever is the mean radius, 2 R* of equal grains: half the coefficient has the same largest torque. The stiffness is that of
// SDS under take_lammps_rules: the torque is full after rolling mu_r d/100 where a contact carries m g + 2 F_po.
void add_nearest(YadeLaws& laws, const PileSetup& s) {
    const double r_star = 0.25 * s.d;
    if (s.grains.work_of_adhesion > 0.0) {
        laws.ip2 += fmt::format(", gamma={:.17g}", dmt_gamma(s.grains.work_of_adhesion));
        laws.law2 = "includeAdhesion=True";
    }
    if (s.grains.rolling_friction <= 0.0) return;
    const double pull_off = 1.5 * std::acos(-1.0) * s.grains.work_of_adhesion * r_star;
    const double stiffness = 100.0 * (energy_unit(s) / s.d + 2.0 * pull_off) / s.d;
    laws.ip2 += fmt::format(", eta={:.17g}, krot={:.17g}", 0.5 * s.grains.rolling_friction,
                            stiffness * r_star * r_star);
    laws.law2 += laws.law2.empty() ? "includeMoment=True" : ", includeMoment=True";
}

}  // namespace

double dmt_gamma(double work_of_adhesion) { return 0.375 * work_of_adhesion; }

Deck yade_pile(const PileSetup& s, const DeckOptions& options) {
    refuse_what_yade_has_not(s, options);
    YadeLaws laws = yade_laws(s.grains, loose_density(s));
    if (options.nearest) add_nearest(laws, s);
    std::string deck =
        "# The rig pile of similitude in Yade 2023.02a: yade -n -x deck.py. SI units; the base's "
        "top is z = 0.\n" +
        yade_material(laws);
    deck += fmt::format(
        "O.dt = {:.17g}\nd, gravity = {:.17g}, {:.17g}\nmargin, mouth, lost_below = {:.17g}, "
        "{:.17g}, {:.17g}\n# Rest: below `limit` m g d a grain, looked at each `check` steps.\n"
        "check, limit, unit = {}, {}, {:.17g}\nrest_duration, longest = {:.17g}, {:.17g}\n",
        s.time_step, s.d, s.gravity, 0.2 * s.d, s.conditions.drop_height, s.lost_below,
        rest_check_interval, at_rest_below, energy_unit(s), s.rest_duration, s.longest);
    std::string rest = script;
    put(rest, "IP2", laws.ip2);
    put(rest, "LAW2", laws.law2);
    Deck result{"deck.py", deck + rest};
    std::string base, feed;
    for (const dem_min::Grain& g : glued_grains(s))
        base += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", g.position.x, g.position.y,
                            g.position.z, g.radius);
    for (std::size_t k = 0; k < s.feed_time.size(); ++k)
        feed += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", s.feed_time[k], s.feed_x[k],
                            s.feed_y[k], s.radius[k]);
    result.files.emplace_back("base.txt", base);
    result.files.emplace_back("feed.txt", feed);
    return result;
}

}  // namespace engines
