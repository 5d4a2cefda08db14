// SPDX-License-Identifier: MIT
#include "contact/effective.hpp"
#include "dem_min/random.hpp"
#include "dem_min/timestep.hpp"
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

enum Stream : std::uint64_t { feeding_places, grain_sizes };

double length_or(const cases::Value& conditions, const char* key, double otherwise) {
    return conditions.quantity_or<Length>(key, Length::from_value(otherwise)).value();
}

// The diameter at which a share `u` of all grains is smaller, of a distribution given by volume. Between two stated points the
// volume is spread evenly over the diameter, hence the number as d^-3; what lies below the first and above the last is not
// stated and left out.
double diameter_by_number(const std::vector<std::pair<double, Length>>& cumulative, double u) {
    std::vector<double> number(cumulative.size(), 0.0);
    const auto inverse_square = [&](std::size_t k) {
        return 1.0 / (cumulative[k].second.value() * cumulative[k].second.value());
    };
    for (std::size_t k = 1; k < cumulative.size(); ++k) {
        const double width = cumulative[k].second.value() - cumulative[k - 1].second.value();
        number[k] = number[k - 1] + (cumulative[k].first - cumulative[k - 1].first) / width *
                                        (inverse_square(k - 1) - inverse_square(k));
    }
    const double wanted = u * number.back();
    std::size_t k = 1;
    while (k + 1 < number.size() && number[k] < wanted) ++k;
    const double share = (wanted - number[k - 1]) / (number[k] - number[k - 1]);
    return 1.0 /
           std::sqrt(inverse_square(k - 1) - share * (inverse_square(k - 1) - inverse_square(k)));
}

struct Drawn {
    double diameter;
    int material;
};

// Log-normal by number, cut off at `cut` of its deviations: mean d before the cut, deviation `spread` times the mean.
double log_normal_diameter(double d, double spread, double u) {
    constexpr double cut = 2.5;
    const double deviation = std::sqrt(std::log1p(spread * spread));
    const double below = 0.5 * std::erfc(cut / std::numbers::sqrt2);
    const double wanted = below + u * (1.0 - 2.0 * below);
    double low = -cut, high = cut;  // of the normal deviate, halved down to its last bits
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(-middle / std::numbers::sqrt2) < wanted ? low : high) = middle;
    }
    return d * std::exp(deviation * 0.5 * (low + high) - 0.5 * deviation * deviation);
}

Drawn draw(const cases::Grain& grain, double spread, double u) {
    if (spread > 0.0)
        return {log_normal_diameter(grain.diameter.value.value(), spread, u),
                cases::material_of_grain};
    if (!grain.size_distribution.empty())
        return {diameter_by_number(grain.size_distribution, u), cases::material_of_grain};
    if (grain.sizes.empty()) return {grain.diameter.value.value(), cases::material_of_grain};
    double below = grain.sizes.front().second;
    std::size_t k = 0;
    while (k + 1 < grain.sizes.size() && u >= below) below += grain.sizes[++k].second;
    return {grain.sizes[k].first.value(), grain.size_material[k]};
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
    refuse_other_physics(c, "pile",
                         {"gravity", "hertz_mindlin", "hertz_coulomb", "adhesion", "wall_adhesion",
                          "wall_friction", "rolling_resistance", "polydispersity"});
    const cases::Model& model = c.model;
    const contact::Material grain = grain_material(experiment), plate = plate_material(experiment);
    PileSetup s{};
    s.conditions = pile_conditions(experiment);
    take_meshes(s, experiment.meshes);
    s.d = experiment.grain.diameter.value.value();
    s.density = grain.density.value();
    s.gravity = experiment.surroundings.gravity.value();
    const bool rolling = model.includes("rolling_resistance");
    const bool rigid = model.includes("hertz_coulomb");
    s.grains = elastic_parameters(grain, grain);
    s.grains.work_of_adhesion =
        model.includes("adhesion") ? model.value_or("work_of_adhesion", 0.0) : 0.0;
    s.grains.sliding_friction = model.value_or("sliding_friction", 0.0);
    s.grains.rolling_friction = rolling ? model.value_or("rolling_friction", 0.0) : 0.0;
    s.grains.restitution = model.value_or("restitution", 1.0);
    s.walls = elastic_parameters(grain, plate);
    s.walls.work_of_adhesion =
        model.includes("wall_adhesion") ? model.wall_value_or("work_of_adhesion", 0.0) : 0.0;
    s.walls.sliding_friction = model.wall_value_or("sliding_friction", 0.0);
    s.walls.rolling_friction = rolling ? model.wall_value_or("rolling_friction", 0.0) : 0.0;
    s.walls.restitution = model.wall_value_or("restitution", 1.0);
    s.grains.rigid_tangential = s.walls.rigid_tangential = rigid;
    s.grains.friction_cap = s.walls.friction_cap = friction_cap(model.friction_cap);
    const double spread =
        model.includes("polydispersity") ? model.value_or("size_spread", 0.0) : 0.0;
    if (spread > 0.0 &&
        (!experiment.grain.sizes.empty() || !experiment.grain.size_distribution.empty()))
        throw scaling::InvalidInput(
            scaling::mistake(c.path + ": model.physics", "polydispersity beside stated sizes",
                             "must be one of the two", "remove \"sizes\" or \"polydispersity\""));
    choose_feed(s, experiment.grain, seed, spread);
    choose_materials(s, c, experiment);
    choose_steps(s);
    return s;
}

double speed_of_rest(const PileSetup& s) { return 1e-3 * std::sqrt(s.gravity * s.d); }

void choose_feed(PileSetup& s, const cases::Grain& sizes, std::uint64_t seed, double size_spread) {
    const dem_min::RandomStream places{seed, feeding_places}, diameters{seed, grain_sizes};
    const auto count = static_cast<std::size_t>(s.conditions.grains);
    s.feed_time.resize(count), s.feed_x.resize(count), s.feed_y.resize(count),
        s.radius.resize(count), s.materials.of_grain.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const Drawn drawn = draw(sizes, size_spread, diameters.uniform(k));
        s.radius[k] = 0.5 * drawn.diameter;
        s.materials.of_grain[k] = drawn.material;
        const double room = std::max(0.0, 0.5 * s.conditions.feed_diameter - s.radius[k]);
        const double r = room * std::sqrt(places.uniform(2 * k));
        const double angle = 2.0 * std::numbers::pi * places.uniform(2 * k + 1);
        s.feed_x[k] = r * std::cos(angle);
        s.feed_y[k] = r * std::sin(angle);
        s.feed_time[k] = static_cast<double>(k) / s.conditions.feed_rate;
    }
}

void choose_steps(PileSetup& s) {
    const double smallest = *std::min_element(s.radius.begin(), s.radius.end());
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
    const dem_min::StepLimits limits =
        dem_min::step_limits({.radius = smallest,
                              .density = density,
                              .youngs_modulus = 2.0 * (1.0 - nu * nu) * e_star,
                              .poisson_ratio = nu,
                              .work_of_adhesion = work_of_adhesion,
                              .fastest_impact = std::sqrt(2.0 * s.gravity * fall)});
    s.time_step = limits.shortest();
    s.skin = 0.2 * s.d;
    s.lost_below = -3.0 * s.d;
    s.rest_duration = std::sqrt(1000.0 * s.d / s.gravity);
    s.longest = s.feed_time.back() + 30.0 * s.rest_duration;
}

void take_lammps_rules(PileSetup& s) {
    if (s.grains.friction_cap != contact::FrictionCap::elastic_plus_two_pull_off)
        throw scaling::InvalidInput(scaling::mistake(
            "model.friction_cap", "another than elastic_plus_two_pull_off",
            "must be that, or left out, under LAMMPS' rules", "or take --contact own"));
    const double mass = s.density * (std::numbers::pi / 6.0) * (s.d * s.d * s.d);
    double w = std::max(s.grains.work_of_adhesion, s.walls.work_of_adhesion);
    for (const PairParameters& pair : s.materials.pairs)
        w = std::max(w, pair.laws.work_of_adhesion);
    const double pull_off = 1.5 * std::numbers::pi * w * 0.25 * s.d;
    const double k = 100.0 * (mass * s.gravity + 2.0 * pull_off) / s.d;
    s.grains.as_lammps = s.walls.as_lammps = LammpsRules{k, std::sqrt(k * mass)};
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
    times(map.factor("youngs_modulus"), s.grains.e_star, s.grains.g_star, s.walls.e_star,
          s.walls.g_star);
    times(map.factor("work_of_adhesion"), s.grains.work_of_adhesion, s.walls.work_of_adhesion);
    for (PairParameters& pair : s.materials.pairs) {
        times(map.factor("youngs_modulus"), pair.laws.e_star, pair.laws.g_star);
        times(map.factor("work_of_adhesion"), pair.laws.work_of_adhesion);
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
