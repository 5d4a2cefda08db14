// SPDX-License-Identifier: MIT
// How a vessel is filled: grains begin at places drawn one after another where they touch nobody, random sequential addition under
// a ceiling that rises where no place is found, and fall.
#include "dem_min/random.hpp"
#include "dem_min/timestep.hpp"
#include "rigs/flow.hpp"
#include "rigs/grain_sizes.hpp"
#include "rigs/vessels.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace rigs {
namespace {

using contact::Vec3;

constexpr std::uint64_t sizes_stream = 41, places_stream = 42;
constexpr int tries_under_a_ceiling = 60;  // some 0.25 of the room is full then
constexpr std::uint64_t most_tries_a_grain = 20'000;

// Grains by the cubes, one largest diameter wide, that hold their centres.
class Neighbourhood {
  public:
    explicit Neighbourhood(double width) : width_(width) {}
    void add(Vec3 at, double radius) { cubes_[cube(at)].push_back({at, radius}); }
    bool free(Vec3 at, double radius) const {
        const std::array<int, 3> middle = cube(at);
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dz = -1; dz <= 1; ++dz) {
                    const auto found =
                        cubes_.find({middle[0] + dx, middle[1] + dy, middle[2] + dz});
                    if (found == cubes_.end()) continue;
                    for (const Ball& ball : found->second) {
                        const Vec3 way = at - ball.at;
                        const double reach = radius + ball.radius;
                        if (contact::dot(way, way) <= reach * reach) return false;
                    }
                }
        return true;
    }

  private:
    struct Ball {
        Vec3 at;
        double radius;
    };
    std::array<int, 3> cube(Vec3 p) const {
        const auto index = [&](double x) { return static_cast<int>(std::floor(x / width_)); };
        return {index(p.x), index(p.y), index(p.z)};
    }
    double width_;
    std::map<std::array<int, 3>, std::vector<Ball>> cubes_;
};

void draw_sizes(FlowSetup& s, const cases::Grain& sizes, std::uint64_t seed) {
    const dem_min::RandomStream stream{seed, sizes_stream};
    double solid = 0.0;
    s.radius.clear();
    for (std::uint64_t k = 0;; ++k) {
        const bool enough = s.filling.grains > 0 ? k >= static_cast<std::uint64_t>(s.filling.grains)
                                                 : solid >= s.filling.solid;
        if (enough) return;
        const double radius = 0.5 * draw_grain(sizes, stream.uniform(k)).diameter;
        s.radius.push_back(radius);
        solid += 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    }
}

double& along(Vec3& p, Vec3 direction) {
    return direction.x != 0.0 ? p.x : direction.y != 0.0 ? p.y : p.z;
}

template <class V>
void draw_places(const V& vessel, FlowSetup& s, std::uint64_t seed) {
    const dem_min::RandomStream stream{seed, places_stream};
    const double largest = *std::max_element(s.radius.begin(), s.radius.end());
    const Vec3 upwards = up(vessel);
    dem_min::Box box = room(vessel);
    double& ceiling = along(box.high, upwards);
    const double roof = ceiling;
    ceiling = std::min(roof, along(box.low, upwards) + 6.0 * largest);
    Neighbourhood placed(2.0 * largest);
    s.place.clear();
    std::uint64_t drawn = 0;
    int in_vain = 0;
    while (s.place.size() < s.radius.size()) {
        if (drawn > most_tries_a_grain * s.radius.size())
            throw scaling::InvalidParameter(scaling::mistake(
                "grains", std::to_string(s.radius.size()), "must fit loosely into the vessel",
                "take fewer or smaller grains, or a wider vessel"));
        const double radius = s.radius[s.place.size()];
        const auto between = [&](double low, double high, std::uint64_t k) {
            return low + (high - low) * stream.uniform(3 * drawn + k);
        };
        const Vec3 at{between(box.low.x + radius, box.high.x - radius, 0),
                      between(box.low.y + radius, box.high.y - radius, 1),
                      between(box.low.z + radius, box.high.z - radius, 2)};
        ++drawn;
        if (!clear_of_walls(vessel, at, radius)) continue;
        if (placed.free(at, radius)) {
            placed.add(at, radius);
            s.place.push_back(at);
            in_vain = 0;
        } else if (++in_vain >= tries_under_a_ceiling && ceiling < roof) {
            ceiling = std::min(roof, ceiling + 0.5 * largest);
            in_vain = 0;
        }
    }
}

void choose_steps(FlowSetup& s) {
    const double nu = 0.3;  // as in rigs/pile_setup.cpp: E* alone is known
    double fall = 2.0 * s.d;
    for (const Vec3 at : s.place)
        fall = std::max(
            fall, contact::dot(at, std::visit([](const auto& v) { return up(v); }, s.vessel)));
    s.time_step =
        dem_min::step_limits(
            {.radius = *std::min_element(s.radius.begin(), s.radius.end()),
             .density = s.density,
             .youngs_modulus =
                 2.0 * (1.0 - nu * nu) * std::max(s.grains.e_star, s.walls.e_star / 2.0),
             .poisson_ratio = nu,
             .work_of_adhesion = std::max(s.grains.work_of_adhesion, s.walls.work_of_adhesion),
             .fastest_impact = std::sqrt(2.0 * s.gravity * fall)})
            .shortest();
    s.skin = 0.2 * s.d;
    s.rest_duration = std::sqrt(1000.0 * s.d / s.gravity);
    s.longest = 2.0 * std::sqrt(2.0 * fall / s.gravity) + 30.0 * s.rest_duration;
}

// Instants of the recording, each once; and of a column the spots that were looked at then.
void take_recording(FlowSetup& s, const cases::Recording& recording) {
    if (recording.has("depth")) s.depths = recording.values("depth");
    if (!recording.has("t")) return;
    std::map<double, std::vector<double>> spots;
    const std::vector<double>& t = recording.values("t");
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (!(t[k] >= 0.0)) continue;  // before t = 0 nothing moves
        std::vector<double>& here = spots[t[k]];
        if (recording.has("r")) here.push_back(recording.values("r")[k]);
    }
    for (auto& [time, here] : spots) {
        s.times.push_back(time);
        if (recording.has("r")) s.spots.push_back(std::move(here));
    }
}

Vessel vessel_of(const cases::Experiment& e) {
    if (e.rig == "discharge") return silo_of(e);
    if (e.rig == "column") return column_of(e);
    return drum_of(e);
}

void refuse_other_materials(const cases::Case& c, const cases::Experiment& e) {
    const bool mixed =
        std::any_of(e.grain.size_material.begin(), e.grain.size_material.end(),
                    [](int material) { return material != cases::material_of_grain; });
    if (mixed || !c.model.pairs.empty())
        throw scaling::InvalidInput(scaling::mistake(
            mixed ? "grain.sizes" : "model.pairs", "another material", "must be of the rig pile",
            "the rig " + e.rig + " has grains of one material"));
}

}  // namespace

bool is_flow(const cases::Experiment& e) {
    return e.rig == "discharge" || e.rig == "column" || e.rig == "drum";
}

void take_lammps_rules(FlowSetup& s) {
    take_lammps_rules(s.grains, s.walls, {s.d, s.density, s.gravity},
                      std::max(s.grains.work_of_adhesion, s.walls.work_of_adhesion));
}

void pour(FlowSetup& s, const cases::Grain& sizes, std::uint64_t seed) {
    draw_sizes(s, sizes, seed);
    std::visit([&](const auto& v) { draw_places(v, s, seed); }, s.vessel);
    choose_steps(s);
    s.every = std::visit([&](const auto& v) { return usual_interval(v, s); }, s.vessel);
}

FlowSetup flow_setup(const cases::Case& c, const cases::Experiment& e, std::uint64_t seed) {
    refuse_other_physics(c, e.rig, bulk_physics());
    refuse_other_materials(c, e);
    FlowSetup s{};
    s.vessel = vessel_of(e);
    s.filling = std::visit([&](const auto& v) { return filling_of(v, e); }, s.vessel);
    s.d = e.grain.diameter.value.value();
    s.density = e.grain.density.value.value();
    s.gravity = e.surroundings.gravity.value();
    if (!(s.gravity > 0.0))
        throw scaling::InvalidInput(scaling::mistake("surroundings.gravity", "0 m/s^2",
                                                     "must be > 0 for the rig " + e.rig,
                                                     "without it nothing flows"));
    const BulkContacts contacts = bulk_contacts(c, e);
    s.grains = contacts.grains, s.walls = contacts.walls;
    if (e.recording) take_recording(s, *e.recording);
    pour(s, e.grain, seed);
    return s;
}

FlowSetup scaled(const FlowSetup& original, const scaling::ScaleMap& map) {
    FlowSetup s = original;
    const double length = map.factor("length"), time = map.factor("time"),
                 apparatus = map.factor("apparatus_length");
    const auto times = [](double factor, auto&... values) { ((values *= factor), ...); };
    if (auto* silo = std::get_if<Silo>(&s.vessel))
        times(apparatus, silo->width, silo->depth, silo->outlet_width, silo->outlet_depth);
    if (auto* column = std::get_if<Column>(&s.vessel)) {
        times(apparatus, column->radius, column->height);
        times(apparatus / time, column->lift_speed);
    }
    if (auto* drum = std::get_if<Drum>(&s.vessel)) {
        times(apparatus, drum->diameter, drum->length);
        times(1.0 / time, drum->speed);
    }
    times(apparatus, s.filling.level);
    times(apparatus * apparatus * apparatus, s.filling.solid);
    times(length, s.d, s.skin);
    times(map.factor("density"), s.density);
    times(map.factor("gravity"), s.gravity);
    times(map.factor("youngs_modulus"), s.grains.e_star, s.grains.g_star, s.walls.e_star,
          s.walls.g_star);
    scale_attraction(s.grains, map), scale_attraction(s.walls, map);
    times(map.factor("contact_time"), s.time_step);
    times(time, s.rest_duration, s.longest, s.every);
    for (double& t : s.times) t *= time;
    for (double& depth : s.depths) depth *= apparatus;
    for (std::vector<double>& here : s.spots)
        for (double& r : here) r *= apparatus;
    for (std::size_t k = 0; k < s.radius.size(); ++k)
        times(length, s.radius[k], s.place[k].x, s.place[k].y, s.place[k].z);
    return s;
}

}  // namespace rigs
