// SPDX-License-Identifier: MIT
// Processor time of one call of each forward model: what a refit pays some thousand times. Prints one line per world.
#include "cases/units.hpp"
#include "rigs/forward.hpp"

#include <fmt/format.h>

#include <ctime>
#include <string>
#include <utility>
#include <vector>

namespace {

cases::Value stated(std::vector<std::pair<std::string, std::string>> members) {
    cases::Value all{.where = "bench"};
    for (auto& [key, text] : members) {
        cases::Value one{
            .where = "bench." + key, .kind = cases::Value::Kind::text, .written_text = text};
        all.members.emplace_back(key, one);
    }
    return all;
}

cases::Experiment glass(const std::string& rig,
                        std::vector<std::pair<std::string, std::string>> conditions) {
    cases::Experiment e;
    e.id = rig, e.rig = rig;
    e.conditions = stated(std::move(conditions));
    e.grain.diameter.value = scaling::in_si<scaling::Length>(4e-3);
    e.grain.density.value = scaling::in_si<scaling::Density>(2500.0);
    e.grain.youngs_modulus.value = scaling::in_si<scaling::Pressure>(6e10);
    e.grain.poisson_ratio.value = 0.22;
    e.plate = {e.grain.youngs_modulus.value, e.grain.poisson_ratio.value};
    e.surroundings = {scaling::in_si<scaling::Acceleration>(9.81),
                      scaling::in_si<scaling::Density>(1.2),
                      scaling::in_si<scaling::Viscosity>(1.8e-5)};
    return e;
}

std::vector<double> even(double first, double last, int count) {
    std::vector<double> at;
    for (int k = 0; k < count; ++k) at.push_back(first + (last - first) * k / (count - 1));
    return at;
}

void time_of(const std::string& name, const cases::Experiment& e, const rigs::World& world,
             const rigs::Ordinates& o) {
    const auto model = rigs::forward_model(e);
    constexpr int calls = 2000;
    double sum = 0.0;
    for (int k = 0; k < calls / 10; ++k) sum += model->predict(world, o).begin()->second.back();
    const std::clock_t start = std::clock();
    for (int k = 0; k < calls; ++k) sum += model->predict(world, o).begin()->second.back();
    const double spent = 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    fmt::print("{:<44} {:8.1f} us{}\n", name, spent / calls, sum == 0.123 ? " " : "");
}

void drops() {
    const cases::Experiment e = glass("drop", {{"height", "500 mm"}});
    const cases::Experiment oblique =
        glass("drop", {{"height", "500 mm"}, {"horizontal_speed", "1 m/s"}});
    const rigs::Ordinates o{even(0.0, 2.6, 200), {}};  // ten bounces
    rigs::World w{.physics = {"gravity", "hertz_mindlin"},
                  .parameters = {{"restitution", 0.85}, {"sliding_friction", 0.3}},
                  .stated = {},
                  .numerics = {},
                  .missing = {}};
    const auto with = [&](const std::string& effect,
                          const std::map<std::string, double>& parameters) {
        rigs::World more = w;
        more.physics.insert(effect);
        more.parameters.insert(parameters.begin(), parameters.end());
        return more;
    };
    time_of("drop", e, w, o);
    time_of("drop, along x", oblique, w, o);
    time_of("drop, along x, velocity_dependent_friction", oblique,
            with("velocity_dependent_friction",
                 {{"dynamic_friction", 0.1}, {"friction_velocity", 0.3}}),
            o);
    time_of("drop, along x, viscoelastic_restitution", oblique,
            with("viscoelastic_restitution", {{"loss_coefficient", 0.1}}), o);
    time_of("drop, air_drag", e, with("air_drag", {}), o);
    time_of("drop, adhesion", e, with("adhesion", {{"work_of_adhesion", 0.1}}), o);
    time_of("drop, capillary_bridge", e,
            with("capillary_bridge", {{"surface_tension", 0.07}, {"liquid_volume", 1e-12}}), o);
    time_of("drop, van_der_waals", e, with("van_der_waals", {{"hamaker_constant", 1e-19}}), o);
    time_of("drop, electrostatic", e, with("electrostatic", {{"charge", 1e-10}}), o);
    time_of("drop, vibration", e, with("vibration", {{"amplitude", 1e-4}, {"frequency", 50.0}}), o);
    rigs::World missing = w;
    missing.missing = {"z", {0.0, 0.05, 0.2, 0.5}, {-1e-4, -5e-5, 0.0, 0.0}};
    time_of("drop, a missing force", e, missing, o);
    rigs::World stepped = w;
    stepped.numerics = cases::Numerics{scaling::in_si<scaling::Time>(1e-6), "verlet", 1.0};
    time_of("drop, at a time step of 1 us", e, stepped, o);
}

void others() {
    rigs::World w{.physics = {"gravity", "hertz_mindlin", "rolling_resistance"},
                  .parameters = {{"restitution", 0.85},
                                 {"sliding_friction", 0.3},
                                 {"rolling_friction", 0.01}},
                  .stated = {},
                  .numerics = {},
                  .missing = {}};
    const rigs::Ordinates t{even(0.0, 1.0, 200), {}}, angles{even(0.05, 1.5, 30), {}};
    const cases::Experiment plane = glass("incline", {{"angle", "10 deg"}, {"speed", "0.5 m/s"}});
    time_of("incline", plane, w, t);
    rigs::World slow = w;
    slow.physics.insert("velocity_dependent_friction");
    slow.parameters["dynamic_friction"] = 0.1, slow.parameters["friction_velocity"] = 0.2;
    time_of("incline, velocity_dependent_friction", plane, slow, t);
    rigs::World dragged = w;
    dragged.physics.insert("air_drag");
    time_of("incline, air_drag", plane, dragged, t);
    const cases::Experiment thrown = glass("impact", {{"speed", "2 m/s"}});
    time_of("impact, micro-slip", thrown, w, angles);
    rigs::World viscous = w;
    viscous.physics.insert("viscoelastic_restitution"),
        viscous.parameters["loss_coefficient"] = 0.1;
    time_of("impact, micro-slip, viscoelastic_restitution", thrown, viscous, angles);
    rigs::World rigid = w;
    rigid.physics.erase("hertz_mindlin"), rigid.physics.insert("hertz_coulomb");
    time_of("impact, rigid", thrown, rigid, angles);
}

void force_curves() {
    cases::Experiment e =
        glass("pull_off", {{"preload", "1 mN"}, {"cantilever_stiffness", "20 N/m"}});
    e.conditions.members.emplace_back(
        "counterpart",
        cases::Value{.where = "bench", .kind = cases::Value::Kind::text, .written_text = "plate"});
    rigs::World w{.physics = {"hertz_mindlin", "adhesion", "van_der_waals", "capillary_bridge"},
                  .parameters = {{"work_of_adhesion", 0.1},
                                 {"hamaker_constant", 1e-19},
                                 {"surface_tension", 0.07},
                                 {"liquid_volume", 1e-15}},
                  .stated = {},
                  .numerics = {},
                  .missing = {}};
    rigs::Ordinates o{even(-1e-7, 1e-6, 200), {}};
    for (int k = 0; k < 200; ++k) o.retract.push_back(k % 2 == 0);
    time_of("pull_off, against separation", e, w, o);
    e.recording = cases::Recording{{{"displacement", "m", {0.0}}, {"force", "N", {0.0}}}};
    for (double& x : o.at) x *= 100.0;
    time_of("pull_off, against the drive", e, w, o);
}

}  // namespace

int main() {
    drops();
    others();
    force_curves();
}
