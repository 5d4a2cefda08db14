// SPDX-License-Identifier: MIT
#include "rigs/pile.hpp"

#include "contact/effective.hpp"
#include "dem_min/walls.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace rigs {
namespace {

using contact::Vec3;
using dem_min::Simulation;

constexpr std::int64_t rest_check_interval = 100;  // steps

// Walls of the base stand first among all: none, the disc, the disc and its rim. The funnel follows.
std::size_t walls_of_base(const PileConditions& c) {
    return c.base == Base::glued_grains ? 0 : c.base == Base::flat ? 1 : 2;
}

void put_walls(Simulation& s, const PileConditions& c, const cases::WallMaterials& material) {
    const auto put = [&](dem_min::Wall wall, int its_material) {
        s.walls.push_back(std::move(wall));
        s.wall_material.push_back(its_material);
    };
    const double radius = 0.5 * c.base_diameter;
    if (c.base != Base::glued_grains) put(dem_min::disc(radius, 0.0), material.base);
    if (c.base == Base::flat_with_rim) put(dem_min::tube(radius, 0.0, c.rim_height), material.base);
    if (c.funnel)
        put(dem_min::cone(0.5 * c.funnel->outlet_diameter, c.funnel->outlet_height,
                          0.5 * c.funnel->top_diameter, c.funnel->outlet_height + c.funnel->height),
            material.funnel);
    for (std::size_t k = 0; k < c.meshes.size(); ++k)
        for (dem_min::Wall& wall : dem_min::mesh_walls(c.meshes[k]))
            put(std::move(wall),
                k < material.meshes.size() ? material.meshes[k] : cases::material_of_plate);
}

// The glued grains: a square lattice, one d apart, tops at z = 0, no centre farther out than the base's radius.
void glue_base(Simulation& s, const PileSetup& setup) {
    const double d = setup.d, radius = 0.5 * setup.conditions.base_diameter;
    const int most = static_cast<int>(radius / d) + 1;
    for (int a = -most; a < most; ++a)
        for (int b = -most; b < most; ++b) {
            const double x = (a + 0.5) * d, y = (b + 0.5) * d;
            if (x * x + y * y > radius * radius) continue;
            dem_min::insert(s, {{x, y, -0.5 * d}, {}, {}, 0.5 * d, setup.density, true});
        }
}

// Who hangs together by contacts. The last index, one beyond the grains, is all that stands still.
class Clusters {
  public:
    explicit Clusters(std::size_t grains) : leader_(grains + 1) {
        std::iota(leader_.begin(), leader_.end(), std::size_t{0});
    }
    void join(std::size_t a, std::size_t b) { leader_[find(a)] = find(b); }
    bool on_the_ground(std::size_t k) { return find(k) == find(ground()); }
    std::size_t ground() const { return leader_.size() - 1; }

  private:
    std::size_t find(std::size_t k) {
        while (leader_[k] != k) k = leader_[k] = leader_[leader_[k]];
        return k;
    }
    std::vector<std::size_t> leader_;
};

std::size_t grain_of_member(const Simulation& s, std::int64_t member) {
    return static_cast<std::size_t>(s.members[static_cast<std::size_t>(member)].grain);
}

// Joined are the spheres of a clump and those whose contact `counts(group, contacts, slot)`; glued grains are ground.
template <class Counts>
Clusters clusters(const Simulation& s, Counts&& counts) {
    Clusters joined(s.grains.count());
    const auto member = [&](int grain) {
        const auto k = static_cast<std::size_t>(grain);
        return s.grains.fixed(k) ? joined.ground() : k;
    };
    dem_min::for_each_contact(
        s, [&](std::size_t group, const dem_min::Contacts& c, std::size_t slot) {
            if (!counts(group, c, slot)) return;
            joined.join(member(c.i[slot]), s.at_wall(group) ? joined.ground() : member(c.j[slot]));
        });
    for (const dem_min::Body& body : s.bodies)
        for (std::int64_t m = body.first; m < body.first + body.count; ++m)
            joined.join(grain_of_member(s, m), grain_of_member(s, body.first));
    return joined;
}

// Top of the heap: of the highest loose grain that is joined by contacts to a wall or to a glued grain. Grains that touch one
// another in flight are no heap: to feed above them would raise the feed without end where the stream is dense at its source.
double heap_top(const Simulation& s, const Stand& stand) {
    Clusters joined =
        clusters(s, [](std::size_t, const dem_min::Contacts&, std::size_t) { return true; });
    double top = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        if (!s.grains.fixed(k) && joined.on_the_ground(k))
            top = std::max(top,
                           in_room(stand, s.grains.position(k), s.time()).z + s.grains.radius[k]);
    return top;
}

bool inside_or_above(const Funnel& f, contact::Vec3 p) {
    if (p.z < f.outlet_height) return false;
    const double up = std::min(1.0, (p.z - f.outlet_height) / f.height);
    const double radius = 0.5 * (f.outlet_diameter + up * (f.top_diameter - f.outlet_diameter));
    return p.x * p.x + p.y * p.y < radius * radius;
}

// m, of the grain, or of the clump that it is a part of.
contact::Vec3 centre_of_whole(const Simulation& s, std::size_t k) {
    const int body = s.grains.body[k];
    return body < 0 ? s.grains.position(k) : s.bodies[static_cast<std::size_t>(body)].centre;
}

// [grains], true for those that the funnel still holds: inside or above it (of a clump its centre), or hanging from what is, with no other way
// to the ground by contacts. None without a funnel.
std::vector<bool> held_by_funnel(const Simulation& s, const PileConditions& conditions) {
    std::vector<bool> held(s.grains.count(), false);
    if (!conditions.funnel) return held;
    const int funnel = static_cast<int>(walls_of_base(conditions));
    for (std::size_t k = 0; k < held.size(); ++k)
        held[k] = !s.grains.fixed(k) && inside_or_above(*conditions.funnel, centre_of_whole(s, k));
    const auto is_held = [&](int grain) { return bool{held[static_cast<std::size_t>(grain)]}; };
    const auto outside = [&](std::size_t group, const dem_min::Contacts& c, std::size_t slot) {
        if (is_held(c.i[slot])) return false;
        return s.at_wall(group) ? c.j[slot] != funnel : !is_held(c.j[slot]);
    };
    // Joined to the ground, and joined to the ground or to what is held: who hangs is in the second alone.
    Clusters apart = clusters(s, outside);
    Clusters together =
        clusters(s, [](std::size_t, const dem_min::Contacts&, std::size_t) { return true; });
    for (std::size_t k = 0; k < held.size(); ++k)
        if (held[k]) together.join(k, together.ground());
    for (std::size_t k = 0; k < held.size(); ++k)
        held[k] =
            held[k] || (!s.grains.fixed(k) && together.on_the_ground(k) && !apart.on_the_ground(k));
    return held;
}

// The lowest height at or above `lowest` at which spheres around (x, y) are clear of all others, by a thousandth of their reach; in
// the room.
double free_height(const Simulation& s, const Stand& stand, double x, double y,
                   const std::vector<dem_min::Ball>& spheres, double lowest) {
    double z = lowest;
    for (bool moved = true; moved;) {
        moved = false;
        for (std::size_t k = 0; k < s.grains.count(); ++k)
            for (const auto& [place, radius] : spheres) {
                const double reach = 1.001 * (s.grains.radius[k] + radius);
                const Vec3 p = in_room(stand, s.grains.position(k), s.time());
                const double dx = p.x - (x + place.x), dy = p.y - (y + place.y),
                             dz = z + place.z - p.z;
                const double level = reach * reach - dx * dx - dy * dy;
                if (level <= 0.0 || dz * dz >= level) continue;
                z = p.z + std::sqrt(level) * 1.001 - place.z;
                moved = true;
            }
    }
    return z;
}

// A funnel, or a mesh that may be one, leans with the base: grains then appear where they do over a level one.
Stand stand_of_feed(const PileSetup& setup) {
    Stand stand = setup.stand;
    if (setup.conditions.funnel || !setup.conditions.meshes.empty()) stand.tilt_angle = 0.0;
    return stand;
}

// At rest in the room, over the centre of the base along the plumb line.
void feed(PileRun& run, const PileSetup& setup) {
    Simulation& s = run.simulation;
    const PileConditions& c = setup.conditions;
    const Stand stand = stand_of_feed(setup);
    while (run.fed < setup.feed_time.size() && setup.feed_time[run.fed] <= s.time()) {
        const double radius = setup.radius[run.fed], x = setup.feed_x[run.fed],
                     y = setup.feed_y[run.fed];
        const double mouth = c.funnel ? c.funnel->outlet_height + c.funnel->height : c.drop_height;
        const double lowest = std::max(mouth, heap_top(s, stand) + 2.0 * setup.d);
        const Vec3 velocity{0.0, 0.0,
                            stand.shaking.acts() ? -stand.shaking.velocity(s.time()) : 0.0};
        const Materials& m = setup.materials;
        const int material = m.of_grain.empty() ? cases::material_of_grain : m.of_grain[run.fed];
        const double density =
            m.density.empty() ? setup.density : m.density[static_cast<std::size_t>(material)];
        const dem_min::Clump grain = grain_of(setup, 2.0 * radius, density);
        const bool sphere = setup.feed_axis.empty();
        const dem_min::Quaternion turn =
            sphere ? dem_min::Quaternion{} : dem_min::turn_to(setup.feed_axis[run.fed]);
        std::vector<dem_min::Ball> spheres = grain.balls;
        double below = 0.0;  // m, from the centre to the lowest point
        for (dem_min::Ball& ball : spheres) {
            ball.place = dem_min::turned(turn, ball.place);
            below = std::max(below, ball.radius - ball.place.z);
        }
        const double z = free_height(s, stand, x, y, spheres, lowest + below);
        if (sphere)
            dem_min::insert(s, {on_base(stand, {x, y, z}, s.time()),
                                velocity,
                                {},
                                radius,
                                density,
                                false,
                                material});
        else  // the base stands level and still (pile_setup)
            dem_min::insert(s, grain, {{x, y, z}, turn, {}, {}, material});
        ++run.fed;
    }
}

// The step, after this one, at which the next grain is due; or, when all have been fed, at which rest is looked for.
std::int64_t next_event(const PileRun& run, const PileSetup& setup) {
    const std::int64_t now = run.simulation.steps;
    if (run.fed == setup.feed_time.size())
        return (now / rest_check_interval + 1) * rest_check_interval;
    const double due = setup.feed_time[run.fed];
    auto step = static_cast<std::int64_t>(due / setup.time_step);  // within one of the answer
    step += static_cast<double>(step) * setup.time_step < due;
    return std::max(now + 1, step);
}

// Kinetic energy of translation per loose grain over m g d, m and d nominal. Spin is left out: without adhesion nothing resists
// the twisting of a grain about the vertical normal on which it stands, and that moves nothing.
double restlessness(const Simulation& s, const PileSetup& setup) {
    const double mass = setup.density * (std::numbers::pi / 6.0) * (setup.d * setup.d * setup.d);
    const double unit = mass * setup.gravity * setup.d;
    const std::size_t loose = dem_min::loose_count(s);
    return loose == 0 ? 0.0 : dem_min::translational_energy(s) / static_cast<double>(loose) / unit;
}

void watch_rest(PileRun& run, const PileSetup& setup) {
    const Simulation& s = run.simulation;
    if (run.fed < setup.feed_time.size() || s.steps % rest_check_interval != 0) return;
    if (restlessness(s, setup) >= 1e-6)
        run.still_since = -1;
    else if (run.still_since < 0)
        run.still_since = s.steps;
    const double still = run.still_since < 0
                             ? 0.0
                             : static_cast<double>(s.steps - run.still_since) * setup.time_step;
    run.at_rest = run.still_since >= 0 && still >= setup.rest_duration;
    run.finished = run.at_rest || s.time() >= setup.longest;
}

}  // namespace

PileRun begin_pile(const PileSetup& setup, int threads, bool ledger) {
    if (setup.aspect_ratio > 1.0 && setup.sleep_speed > 0.0)
        throw scaling::InvalidInput(scaling::mistake("sleep", "with \"shape\" in model.physics",
                                                     "must be off where grains are clumps",
                                                     "leave --sleep out"));
    PileRun run;
    Simulation& s = run.simulation;
    s.settings = {.time_step = setup.time_step,
                  .skin = setup.skin,
                  .gravity = setup.gravity * down(setup.stand),
                  .fluid = setup.fluid,
                  .shaking = setup.stand.shaking,
                  .lost_below = setup.lost_below,
                  .threads = threads,
                  .ledger = ledger,
                  .sleep_speed = setup.sleep_speed,
                  .sleep_spin = setup.sleep_speed / (0.5 * setup.d)};
    s.between_grains = laws(setup.grains);
    s.at_walls = laws(setup.walls);
    put_walls(s, setup.conditions, setup.materials.of_wall);
    for (const PairParameters& pair : setup.materials.pairs)
        s.particular.push_back({pair.grain, pair.partner, pair.at_wall, laws(pair.laws)});
    if (setup.conditions.base == Base::glued_grains) glue_base(s, setup);
    return run;
}

void advance(PileRun& run, const PileSetup& setup, std::int64_t steps) {
    Simulation& s = run.simulation;
    const std::int64_t last = s.steps + steps;
    while (s.steps < last && !run.finished) {
        feed(run, setup);
        dem_min::advance(s, std::min(last, next_event(run, setup)) - s.steps);
        if (run.fed < setup.feed_time.size()) run.while_fed = run.work();
        watch_rest(run, setup);
    }
}

std::int64_t expected_steps(const PileSetup& setup) {
    const double fall = 2.0 * std::sqrt(2.0 * setup.conditions.drop_height / setup.gravity);
    return static_cast<std::int64_t>((setup.feed_time.back() + fall + 1.5 * setup.rest_duration) /
                                     setup.time_step);
}

PileRecord record(const PileRun& run, const PileSetup& setup) {
    const Simulation& s = run.simulation;
    PileRecord result{};
    result.heap.base_radius = 0.5 * setup.conditions.base_diameter;
    const std::vector<bool> held = held_by_funnel(s, setup.conditions);
    const auto add = [&](std::size_t k) {
        if (s.grains.fixed(k) || held[k]) return;
        result.heap.centre.push_back(s.grains.position(k));
        result.heap.radius.push_back(s.grains.radius[k]);
    };
    const dem_min::Clump one = grain_of(setup, setup.d, setup.density);
    if (setup.feed_axis.empty()) {
        for (std::size_t k = 0; k < s.grains.count(); ++k) add(k);
    } else {
        result.heap.spheres = static_cast<int>(one.balls.size());
        result.heap.sphere_size = one.balls.front().radius / (0.5 * setup.d);
        for (const dem_min::Member& member : s.members) add(static_cast<std::size_t>(member.grain));
    }
    const HeightMap map = scan(result.heap);
    result.at_rest = run.at_rest;
    result.formed =
        formed(map, {static_cast<std::size_t>(s.past.grains_lost), restlessness(s, setup)});
    for (const Estimator estimator : computed_estimators)
        result.angles.emplace_back(estimator, angle_of_repose(map, estimator));
    result.profile = radial_profile(map);
    if (const auto packing = packing_fraction(result.heap, map))
        result.packing_fraction = packing->value;
    result.coordination = dem_min::mean_coordination(s);
    result.grains_fed = static_cast<std::int64_t>(run.fed);
    result.grains_lost = s.past.grains_lost;
    result.steps = s.steps;
    result.work = run.work();
    result.work_while_fed = run.while_fed;
    result.time_step = setup.time_step;
    result.base_radius = result.heap.base_radius;
    result.grain_diameter = setup.d;
    result.hash = dem_min::state_hash(s);
    result.grains_in_funnel = std::count(held.begin(), held.end(), true) / result.heap.spheres;
    result.aspect_ratio = setup.aspect_ratio;
    result.notes = setup.notes;
    if (run.finished && !run.at_rest && setup.stand.shaking.acts())
        result.notes.push_back(fmt::format(
            "recorded while the base still moved the heap, {:.3g} s after the last grain: "
            "A omega^2/g is {:.3g}",
            s.time() - setup.feed_time.back(), shaking_strength(setup)));
    return result;
}

}  // namespace rigs
