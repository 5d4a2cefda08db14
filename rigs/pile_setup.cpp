// SPDX-License-Identifier: MIT
#include "dem_min/random.hpp"
#include "dem_min/timestep.hpp"
#include "rigs/grain_sizes.hpp"
#include "rigs/pile.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace rigs {
namespace {

using scaling::Dimensionless;
using scaling::Frequency;
using scaling::Length;

enum Stream : std::uint64_t { feeding_places, grain_sizes, grain_axes };

double length_or(const cases::Value& conditions, const char* key, double otherwise) {
    return conditions.quantity_or<Length>(key, Length::from_value(otherwise)).value();
}

}  // namespace

PileConditions pile_conditions(const cases::Experiment& experiment) {
    const cases::Value& given = experiment.conditions;
    const double d = experiment.grain.diameter.value.value();
    const double g = experiment.surroundings.gravity.value();
    PileConditions c{};
    const std::string base = given.at("base").text();
    c.base = base == "flat"            ? Base::flat
             : base == "flat_with_rim" ? Base::flat_with_rim
                                       : Base::glued_grains;
    c.base_diameter = given.at("base_diameter").quantity<Length>().value();
    c.rim_height = length_or(given, "rim_height", d);
    if (given.at("grains").kind == cases::Value::Kind::text)
        cases::refuse(given.at("grains"), "must be a number of grains to be simulated",
                      "write how many to feed, e.g. 1500; what falls off the base is gone");
    c.grains = static_cast<int>(given.at("grains").count());
    c.drop_height = length_or(given, "drop_height", 5.0 * d);
    c.feed_diameter = length_or(given, "feed_diameter", 6.0 * d);
    if (given.has("funnel")) {
        const cases::Value& funnel = given.at("funnel");
        c.funnel = Funnel{funnel.at("outlet_diameter").quantity<Length>().value(),
                          funnel.at("top_diameter").quantity<Length>().value(),
                          funnel.at("height").quantity<Length>().value(),
                          funnel.at("outlet_height").quantity<Length>().value()};
        c.feed_diameter = c.funnel->top_diameter;
    }
    c.feed_rate =
        given.quantity_or<Frequency>("feed_rate", Frequency::from_value(default_feed_rate(c, d, g)))
            .value();
    return c;
}

// The meshes of the case, as they stand; and what was noted when they were read.
static void take_meshes(PileSetup& s, const std::vector<cases::Mesh>& meshes) {
    for (const cases::Mesh& mesh : meshes) {
        dem_min::Surface surface;
        for (const auto& [x, y, z] : mesh.vertices) surface.vertices.push_back({x, y, z});
        surface.triangles = mesh.triangles;
        s.conditions.meshes.push_back(std::move(surface));
        s.notes.insert(s.notes.end(), mesh.notes.begin(), mesh.notes.end());
    }
}

double default_feed_rate(const PileConditions& c, double d, double gravity) {
    const double fall_speed = std::sqrt(2.0 * gravity * c.drop_height);
    const double stream = std::numbers::pi / 4.0 * c.feed_diameter * c.feed_diameter * fall_speed;
    return 0.05 * stream / (std::numbers::pi / 6.0 * d * d * d);
}

PileSetup pile_setup(const cases::Case& c, const cases::Experiment& experiment,
                     std::uint64_t seed) {
    std::vector<std::string> physics = bulk_physics();
    physics.insert(physics.end(), {"air_drag", "buoyancy", "tilt", "vibration", "shape",
                                   "capillary_bridge", "ageing", "polydispersity"});
    refuse_other_physics(c, "pile", physics);
    if (c.model.includes("shape"))
        for (const char* other : {"air_drag", "buoyancy", "tilt", "vibration"})
            if (c.model.includes(other))
                throw scaling::InvalidInput(scaling::mistake(
                    c.path + ": model.physics", std::string("\"shape\" and \"") + other + '"',
                    "elongated grains are poured in still, thin air on a level base at rest",
                    "take one of the two out"));
    PileSetup s{};
    s.conditions = pile_conditions(experiment);
    take_meshes(s, experiment.meshes);
    s.d = experiment.grain.diameter.value.value();
    s.density = experiment.grain.density.value.value();
    s.gravity = experiment.surroundings.gravity.value();
    const BulkContacts contacts = bulk_contacts(c, experiment);
    s.grains = contacts.grains, s.walls = contacts.walls;
    if (c.model.includes("shape")) s.aspect_ratio = c.model.value_or("aspect_ratio", 1.0);
    add_pair_effects(c, s.grains, s.walls);
    const double spread =
        c.model.includes("polydispersity") ? c.model.value_or("size_spread", 0.0) : 0.0;
    if (spread > 0.0 &&
        (!experiment.grain.sizes.empty() || !experiment.grain.size_distribution.empty()))
        throw scaling::InvalidInput(
            scaling::mistake(c.path + ": model.physics", "polydispersity beside stated sizes",
                             "must be one of the two", "remove \"sizes\" or \"polydispersity\""));
    choose_feed(s, experiment.grain, seed, spread);
    choose_materials(s, c, experiment);
    choose_surroundings(s, c, experiment);
    choose_steps(s);
    return s;
}

dem_min::Clump grain_of(const PileSetup& s, double d, double density) {
    if (s.aspect_ratio > 1.0) return dem_min::elongated_grain(d, s.aspect_ratio, density);
    return dem_min::row_of_spheres(1, 0.5 * d, 0.0, density);
}

std::size_t spheres_per_grain(const PileSetup& s) {
    return grain_of(s, s.d, s.density).balls.size();
}

double speed_of_rest(const PileSetup& s) { return 1e-3 * std::sqrt(s.gravity * s.d); }

void choose_feed(PileSetup& s, const cases::Grain& sizes, std::uint64_t seed, double size_spread) {
    const dem_min::RandomStream places{seed, feeding_places}, diameters{seed, grain_sizes},
        axes{seed, grain_axes};
    const auto count = static_cast<std::size_t>(s.conditions.grains);
    s.feed_axis.clear();
    s.feed_time.resize(count), s.feed_x.resize(count), s.feed_y.resize(count),
        s.radius.resize(count), s.materials.of_grain.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const DrawnGrain drawn = draw_grain(sizes, diameters.uniform(k), size_spread);
        s.radius[k] = 0.5 * drawn.diameter;
        s.materials.of_grain[k] = drawn.material;
        const double reach = s.aspect_ratio > 1.0
                                 ? dem_min::half_length(grain_of(s, drawn.diameter, s.density))
                                 : s.radius[k];
        const double room = std::max(0.0, 0.5 * s.conditions.feed_diameter - reach);
        const double r = room * std::sqrt(places.uniform(2 * k));
        const double angle = 2.0 * std::numbers::pi * places.uniform(2 * k + 1);
        s.feed_x[k] = r * std::cos(angle);
        s.feed_y[k] = r * std::sin(angle);
        s.feed_time[k] = static_cast<double>(k) / s.conditions.feed_rate;
        if (s.aspect_ratio > 1.0) {  // uniform on the sphere: as in z, so in the angle about it
            const double z = 2.0 * axes.uniform(2 * k) - 1.0, across = std::sqrt(1.0 - z * z);
            const double about = 2.0 * std::numbers::pi * axes.uniform(2 * k + 1);
            s.feed_axis.push_back({across * std::cos(about), across * std::sin(about), z});
        }
    }
}

void choose_steps(PileSetup& s) {
    // Of a clump that of its spheres. The end of a long one is lighter than the whole, but heavier than its sphere alone (clump_test.cpp).
    const double smallest_grain = *std::min_element(s.radius.begin(), s.radius.end());
    const double smallest = grain_of(s, 2.0 * smallest_grain, s.density).balls.front().radius;
    // E and nu are no longer known one by one: nu = 0.3 stands in for the Rayleigh time, where 0 to 0.5 moves it by 8 %.
    const double nu = 0.3;
    const double fall =
        s.conditions.funnel ? s.conditions.funnel->outlet_height : s.conditions.drop_height;
    double e_star = std::max(s.grains.e_star, s.walls.e_star / 2.0), density = s.density;
    double work_of_adhesion = std::max(s.grains.work_of_adhesion, s.walls.work_of_adhesion);
    for (const PairParameters& pair : s.materials.pairs) {
        e_star = std::max(e_star, pair.at_wall ? pair.laws.e_star / 2.0 : pair.laws.e_star);
        work_of_adhesion = std::max(work_of_adhesion, pair.laws.work_of_adhesion);
    }
    for (const int number : s.materials.of_grain)
        if (!s.materials.density.empty())
            density = std::min(density, s.materials.density[static_cast<std::size_t>(number)]);
    s.skin = 0.2 * s.d;
    s.lost_below = -3.0 * s.d;
    s.rest_duration = std::sqrt(1000.0 * s.d / s.gravity);
    s.longest = s.feed_time.back() + (s.stand.shaking.acts() ? 10.0 : 30.0) * s.rest_duration;
    const dem_min::StepLimits limits = dem_min::step_limits(
        {.radius = smallest,
         .density = density,
         .youngs_modulus = 2.0 * (1.0 - nu * nu) * e_star,
         .poisson_ratio = nu,
         .work_of_adhesion = work_of_adhesion * s.grains.ageing.growth(s.longest),
         .fastest_impact =
             std::sqrt(2.0 * s.gravity * fall) + s.stand.shaking.amplitude * s.stand.shaking.omega,
         .bridge = s.grains.bridge});
    s.time_step = limits.shortest();
}

void take_lammps_rules(PileSetup& s) {
    double w = std::max(s.grains.work_of_adhesion, s.walls.work_of_adhesion);
    for (const PairParameters& pair : s.materials.pairs)
        w = std::max(w, pair.laws.work_of_adhesion);
    take_lammps_rules(s.grains, s.walls, {s.d, s.density, s.gravity}, w);
    for (PairParameters& pair : s.materials.pairs) pair.laws.as_lammps = s.grains.as_lammps;
}

PileSetup scaled(const PileSetup& original, const scaling::ScaleMap& map) {
    PileSetup s = original;
    const double length = map.factor("length"), time = map.factor("time");
    const auto times = [](double factor, auto&... values) { ((values *= factor), ...); };
    PileConditions& c = s.conditions;
    times(map.factor("apparatus_length"), c.base_diameter, c.rim_height, c.drop_height,
          c.feed_diameter);
    if (c.funnel)
        times(map.factor("apparatus_length"), c.funnel->outlet_diameter, c.funnel->top_diameter,
              c.funnel->height, c.funnel->outlet_height);
    for (dem_min::Surface& mesh : c.meshes)
        for (contact::Vec3& v : mesh.vertices) times(map.factor("apparatus_length"), v.x, v.y, v.z);
    times(1.0 / time, c.feed_rate);
    times(length, s.d, s.skin, s.lost_below);
    times(map.factor("density"), s.density);
    times(map.factor("gravity"), s.gravity);
    times(map.factor("density"), s.fluid.drag.density, s.fluid.lifting_density);
    times(map.factor("viscosity"), s.fluid.drag.viscosity);
    times(map.factor("apparatus_length"), s.stand.shaking.amplitude);
    times(1.0 / time, s.stand.shaking.omega);
    times(map.factor("youngs_modulus"), s.grains.e_star, s.grains.g_star, s.walls.e_star,
          s.walls.g_star);
    scale_attraction(s.grains, map), scale_attraction(s.walls, map);
    for (PairParameters& pair : s.materials.pairs) {
        times(map.factor("youngs_modulus"), pair.laws.e_star, pair.laws.g_star);
        scale_attraction(pair.laws, map);
    }
    for (double& density : s.materials.density) times(map.factor("density"), density);
    const double mass = map.factor("density") * length * length * length;
    const auto scale_rolling = [&](ContactParameters& laws) {
        if (!laws.as_lammps) return;
        times(mass / (time * time), laws.as_lammps->rolling_stiffness);
        times(mass / time, laws.as_lammps->rolling_damping);
    };
    scale_rolling(s.grains), scale_rolling(s.walls);
    for (PairParameters& pair : s.materials.pairs) scale_rolling(pair.laws);
    times(map.factor("contact_time"), s.time_step);
    times(length / time, s.sleep_speed);
    times(time, s.rest_duration, s.longest);
    for (double& t : s.feed_time) t *= time;
    for (std::size_t k = 0; k < s.radius.size(); ++k)
        times(length, s.radius[k], s.feed_x[k], s.feed_y[k]);
    return s;
}

}  // namespace rigs
