// SPDX-License-Identifier: MIT
// The rig `discharge` (docs/discharge.md).
#include "dem_min/mesh.hpp"
#include "rigs/vessels.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigs {
namespace {

using contact::Vec3;
using dem_min::Plane;
using dem_min::Simulation;
using scaling::Length;

constexpr std::size_t the_bottom = 0;      // wall
constexpr double packing_to_spare = 0.66;  // denser than a bed that is poured

double area(const Silo& silo) {
    return silo.round ? std::numbers::pi / 4.0 * silo.width * silo.width : silo.width * silo.depth;
}

double largest_across(const Silo& silo) { return std::hypot(silo.width, silo.depth); }

// A plate wider than the silo with a hole in its middle. A slot as long as the silo runs on under its walls.
dem_min::Wall plate_with_slot(const Silo& silo) {
    const double out = 2.0 * largest_across(silo);
    const double x = 0.5 * silo.outlet_width;
    const double y = silo.outlet_depth < silo.depth ? 0.5 * silo.outlet_depth : silo.depth;
    const dem_min::Surface plate{
        {{-out, -out, 0.0},
         {out, -out, 0.0},
         {out, out, 0.0},
         {-out, out, 0.0},
         {-x, -y, 0.0},
         {x, -y, 0.0},
         {x, y, 0.0},
         {-x, y, 0.0}},
        {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}}};
    return dem_min::mesh_walls(plate).at(0);  // flat: one patch
}

// Over the middle half of the outlet: a grain on its edge is no arch.
bool over_outlet(const Silo& silo, Vec3 p) {
    if (silo.round_outlet) return std::hypot(p.x, p.y) < 0.25 * silo.outlet_width;
    return std::abs(p.x) < 0.25 * silo.outlet_width && std::abs(p.y) < 0.5 * silo.outlet_depth;
}

// kg/s: the least-squares line through the rows between a fifth and four fifths of all that came out; nothing for fewer than 5.
struct Rate {
    double mean = 0.0;
    std::size_t rows = 0;
};
Rate rate_of(const std::vector<double>& t, const std::vector<double>& m) {
    Rate rate;
    double st = 0.0, sm = 0.0, stt = 0.0, stm = 0.0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (m[k] < 0.2 * m.back() || m[k] > 0.8 * m.back()) continue;
        ++rate.rows;
        st += t[k], sm += m[k], stt += t[k] * t[k], stm += t[k] * m[k];
    }
    const auto n = static_cast<double>(rate.rows);
    if (rate.rows >= 5) rate.mean = (n * stm - st * sm) / (n * stt - st * st);
    return rate;
}

}  // namespace

Silo silo_of(const cases::Experiment& e) {
    const cases::Value& given = e.conditions;
    const auto length = [&](const char* key) { return given.at(key).quantity<Length>().value(); };
    Silo s{};
    s.round = given.at("silo_shape").text() == "cylinder";
    s.width = length(s.round ? "silo_diameter" : "width");
    s.depth = s.round ? s.width : length("depth");
    s.round_outlet = given.has("outlet_diameter");
    const char* outlet = s.round_outlet ? "outlet_diameter" : "outlet_width";
    s.outlet_width = length(outlet);
    s.outlet_depth = s.round_outlet              ? s.outlet_width
                     : given.has("outlet_depth") ? length("outlet_depth")
                                                 : s.depth;
    const bool fits = s.round && !s.round_outlet
                          ? std::hypot(s.outlet_width, s.outlet_depth) <= s.width
                          : s.outlet_width <= s.width && s.outlet_depth <= s.depth;
    if (!fits)
        cases::refuse(given.at(outlet), "must fit into the silo's bottom",
                      s.round && !s.round_outlet && !given.has("outlet_depth")
                          ? "state outlet_depth too: left out, it is the silo's own depth"
                          : "take a smaller outlet or a wider silo");
    return s;
}

Filling filling_of(const Silo& silo, const cases::Experiment& e) {
    if (e.conditions.has("grains"))
        return {static_cast<int>(e.conditions.at("grains").count()), 0.0, 0.0};
    const double height = e.conditions.at("fill_height").quantity<Length>().value();
    return {0, packing_to_spare * area(silo) * height, height};
}

Vec3 up(const Silo&) { return {0.0, 0.0, 1.0}; }

dem_min::Box room(const Silo& s) {
    const double x = 0.5 * s.width, y = 0.5 * s.depth;
    return {{-x, -y, 0.0}, {x, y, std::numeric_limits<double>::infinity()}};
}

bool clear_of_walls(const Silo& s, Vec3 p, double radius) {
    return !s.round || std::hypot(p.x, p.y) < 0.5 * s.width - radius;
}

std::vector<dem_min::Wall> walls_of(const Silo& s, double top) {
    const double x = 0.5 * s.width, y = 0.5 * s.depth;
    std::vector<dem_min::Wall> walls{dem_min::disc(largest_across(s), 0.0)};
    if (s.round) {
        walls.push_back(dem_min::tube(x, 0.0, top));
    } else {
        walls.push_back(Plane{{-x, 0.0, 0.0}, {1.0, 0.0, 0.0}});
        walls.push_back(Plane{{x, 0.0, 0.0}, {-1.0, 0.0, 0.0}});
        walls.push_back(Plane{{0.0, -y, 0.0}, {0.0, 1.0, 0.0}});
        walls.push_back(Plane{{0.0, y, 0.0}, {0.0, -1.0, 0.0}});
    }
    return walls;
}

double usual_interval(const Silo&, const FlowSetup& s) { return std::sqrt(s.d / s.gravity); }

// Beverloo's rate without its correction, and the wait for what no longer comes.
double expected_duration(const Silo& silo, const FlowSetup& s) {
    const double a = silo.outlet_width, b = silo.outlet_depth;
    const double rate = 0.5 * std::sqrt(s.gravity * std::min(a, b)) * a * b;  // m^3/s
    double solid = 0.0;
    for (const double r : s.radius) solid += 4.0 / 3.0 * std::numbers::pi * r * r * r;
    return solid / 0.6 / rate + s.rest_duration;
}

void let_go(const Silo& silo, Simulation& s) {
    s.walls[the_bottom] =
        silo.round_outlet ? dem_min::Shell{0.5 * silo.outlet_width, 0.0, largest_across(silo), 0.0}
                          : plate_with_slot(silo);
}

void look(const Silo&, FlowRun& run, const FlowSetup&, double t, std::size_t) {
    run.state.rows.push_back({t, run.state.noted.at("filled_mass") - mass_of(run.simulation)});
}

// Over when nothing has left for the rest duration: drained down to what stands beside the outlet, or jammed with grains above its middle.
std::string watch(const Silo& silo, FlowRun& run, const FlowSetup& setup) {
    const Simulation& s = run.simulation;
    double& last =
        run.state.noted.try_emplace("last_count", run.state.noted.at("grains")).first->second;
    const auto count = static_cast<double>(s.grains.count());
    if (count < last) run.state.last_out = s.steps;
    last = count;
    const double waited = static_cast<double>(s.steps - run.state.last_out) * setup.time_step;
    if (count > 0.0 && waited < setup.rest_duration) return {};
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        if (over_outlet(silo, s.grains.position(k))) return "jammed";
    return "drained";
}

void complete(const Silo& silo, FlowRecord& r, const FlowRun& run, const FlowSetup& setup) {
    std::vector<double> t, m;
    for (const std::vector<double>& row : run.state.rows) t.push_back(row[0]), m.push_back(row[1]);
    r.channels = {{"t", "s", t, {}}, {"m", "kg", m, {}}};
    const double filled = run.state.noted.at("filled_mass");
    const double height =
        setup.filling.level > 0.0 ? setup.filling.level : 2.0 * run.state.noted.at("mean_height");
    const double bulk_density = filled / area(silo) / height;
    const double out = filled - mass_of(run.simulation);
    const double until =
        static_cast<double>(run.state.last_out - run.state.released) * setup.time_step;
    r.quantities.insert(r.quantities.end(),
                        {{"grains_left", static_cast<double>(run.simulation.grains.count()), "1"},
                         {"discharged_mass", out, "kg"},
                         {"last_out", until, "s"},
                         {"fill_height", height, "m"},
                         {"bulk_density", bulk_density, "kg/m^3"},
                         {"outlet_over_grain", silo.outlet_width / setup.d, "1"}});
    const Rate rate = m.empty() ? Rate{} : rate_of(t, m);
    if (rate.mean == 0.0) return;
    r.quantities.push_back({"rate", rate.mean, "kg/s"});
    r.quantities.push_back(
        {"reduced_rate",
         rate.mean / (bulk_density * std::sqrt(setup.gravity * std::pow(setup.d, 5.0))), "1"});
}

}  // namespace rigs
