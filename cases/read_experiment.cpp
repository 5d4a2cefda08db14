// SPDX-License-Identifier: MIT
#include "cases/read_experiment.hpp"

#include "cases/messages.hpp"
#include "cases/read_powder.hpp"
#include "cases/rig_table.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>

namespace cases {
namespace {

Value with_overrides(const Value& experiment, const std::string& key, const Value& shared) {
    if (!experiment.has(key)) return shared;
    const Value& own = experiment.at(key);
    if (own.kind == Value::Kind::object && own.has("surface_energy")) {
        refuse(own.at("surface_energy"), "must stand in the grain of the case",
               "model.parameters are one for all experiments");
    }
    return shared.kind == Value::Kind::null ? own : overridden(shared, own);
}

Plate plate_of(const Value& experiment, const Shared& shared, const RigRule& rig,
               const Experiment& read) {
    const Value plate = with_overrides(experiment, "plate", shared.plate);
    if (plate.kind != Value::Kind::null) return read_plate(plate);
    if (needs_plate(rig, read.conditions)) {
        throw scaling::InvalidInput(scaling::mistake(
            experiment.where + ".plate", "nothing", "must be given for the rig " + rig.name,
            "add \"plate\" to the case or to this experiment"));
    }
    return {read.grain.youngs_modulus.value, read.grain.poisson_ratio.value};
}

// Of the cantilever behind a force curve in volts; 0 where one of the two factors is not stated.
double newtons_per_volt(const Value& conditions) {
    if (!conditions.has("deflection_sensitivity") || !conditions.has("cantilever_stiffness"))
        return 0.0;
    return checked_pair(conditions.at("deflection_sensitivity"), "m/V", Domain::positive).value *
           checked_pair(conditions.at("cantilever_stiffness"), "N/m", Domain::positive).value;
}

std::optional<StatedFile> file_of(const Value& experiment, const std::string& key,
                                  const std::string& folder) {
    if (!experiment.has(key)) return std::nullopt;
    const Value& name = experiment.at(key);
    return StatedFile{name, (std::filesystem::path(folder) / name.text()).string()};
}

void read_once(std::optional<Recording>& recording, const std::optional<StatedFile>& file,
               const std::string& rig, double volts) {
    if (recording || !file) return;
    if (!std::filesystem::is_regular_file(file->path)) {
        refuse(file->name, "must be a file beside case.json",
               "no file " + file->path + "; check its name");
    }
    recording = read_recording(file->path, rig, volts);
}

// The condition `mesh`: one, or a list.
std::vector<Mesh> meshes_of(const Value& conditions, const std::string& folder) {
    if (!conditions.has("mesh")) return {};
    const Value& given = conditions.at("mesh");
    std::vector<Mesh> read;
    for (const Value& mesh : given.kind == Value::Kind::list ? given.items : std::vector{given}) {
        if (!mesh.has("unit")) {
            throw scaling::InvalidInput(
                scaling::mistake(mesh.where + ".unit", "nothing", "must be given",
                                 "STL has no unit of its own; write \"unit\": \"mm\""));
        }
        const Value& unit = mesh.at("unit");
        const double metres =
            to_si("1 " + unit.text(), scaling::dimension_of<scaling::Length>(), unit.where);
        const Value& name = mesh.at("file");
        const std::filesystem::path path = std::filesystem::path(folder) / name.text();
        if (!std::filesystem::is_regular_file(path)) {
            refuse(name, "must be a file beside case.json",
                   "no file " + path.string() + "; check its name");
        }
        read.push_back(read_stl(path.string(), metres));
        if (!mesh.has("shift")) continue;
        for (std::array<double, 3>& vertex : read.back().vertices) {
            for (std::size_t k = 0; k < 3; ++k)
                vertex[k] += mesh.at("shift").items[k].quantity<scaling::Length>().value();
        }
    }
    return read;
}

WallMaterials wall_materials(const Value& conditions, const MaterialNames& names) {
    const auto of = [&](const Value& owner, const char* key) {
        return owner.has(key) ? names.number_of(owner.at(key)) : material_of_plate;
    };
    WallMaterials walls;
    walls.base = of(conditions, "base_material");
    if (conditions.has("funnel")) walls.funnel = of(conditions.at("funnel"), "material");
    if (!conditions.has("mesh")) return walls;
    const Value& mesh = conditions.at("mesh");
    for (const Value& one : mesh.kind == Value::Kind::list ? mesh.items : std::vector{mesh})
        walls.meshes.push_back(of(one, "material"));
    return walls;
}

// Grains fall and are fed by weight, so that their material must have a density.
void check_densities(const Grain& grain, const Shared& shared) {
    for (const int number : grain.size_material) {
        if (number < first_named_material) continue;
        const Material& m =
            shared.materials[static_cast<std::size_t>(number - first_named_material)];
        if (m.density) continue;
        const std::string file = shared.grain.where.substr(0, shared.grain.where.rfind("grain"));
        throw scaling::InvalidInput(
            scaling::mistake(file + "materials." + m.name + ".density", "nothing",
                             "must be given for a material of grains", "add the key \"density\""));
    }
}

std::map<std::string, double> read_noise(const Value& noise, const RigRule& rig) {
    std::vector<std::string> numbers;
    for (const ChannelRule& channel : rig.channels) {
        if (channel.words.empty()) numbers.push_back(channel.name);
    }
    check_keys(noise, numbers);
    std::map<std::string, double> read;
    for (const auto& [name, value] : noise.members) {
        const std::vector<std::string>& units = find_channel(rig, name)->units;
        const bool pure = value.kind == Value::Kind::number || value.written_text.ends_with('%');
        const bool as_fraction = pure && std::find(units.begin(), units.end(), "1") != units.end();
        read[name] = checked(value, as_fraction ? "1" : units.front(), Domain::not_negative);
    }
    return read;
}

// A force that is simulated must have what it acts through.
void check_surroundings(const Value& experiment, const Surroundings& s, const Model& model) {
    const auto require = [&](const char* effect, bool holds, const char* key) {
        if (!model.includes(effect) || holds) return;
        throw scaling::InvalidInput(
            scaling::mistake(experiment.where + ".surroundings." + key, "nothing above 0",
                             std::string("must be given with \"") + effect + "\" in physics",
                             "add it to the surroundings of the case"));
    };
    require("gravity", s.gravity.value() > 0.0, "gravity");
    require("air_drag", s.fluid_density.value() > 0.0, "fluid_density");
    require("air_drag", s.fluid_viscosity.value() > 0.0, "fluid_viscosity");
    require("buoyancy", s.fluid_density.value() > 0.0, "fluid_density");
}

}  // namespace

Experiment read_experiment(const Value& experiment, const Shared& shared, const Model& model) {
    check_keys(experiment, {"id", "rig", "conditions", "recording", "simulated", "noise", "role",
                            "grain", "plate", "surroundings"});
    Experiment read;
    read.id = experiment.at("id").text();
    if (read.id.empty() || read.id.find_first_of("/\\") != std::string::npos) {
        refuse(experiment.at("id"), "must be a name without slashes", "files are named after it");
    }
    read.rig = checked_word(experiment.at("rig"), rig_names());
    const RigRule& rig = rig_rule(read.rig);
    read.conditions = experiment.at("conditions");
    check_conditions(rig, read.conditions);
    read.grain = read_grain(with_overrides(experiment, "grain", shared.grain), shared.names);
    check_densities(read.grain, shared);
    if (read.rig == "pile") read.wall_material = wall_materials(read.conditions, shared.names);
    read.plate = plate_of(experiment, shared, rig, read);
    read.surroundings =
        read_surroundings(with_overrides(experiment, "surroundings", shared.surroundings));
    check_surroundings(experiment, read.surroundings, model);
    read.meshes = meshes_of(read.conditions, shared.folder);
    read.recording_file = file_of(experiment, "recording", shared.folder);
    read.simulated_file = file_of(experiment, "simulated", shared.folder);
    if (experiment.has("noise")) read.noise = read_noise(experiment.at("noise"), rig);
    if (experiment.has("role"))
        read.held_out = checked_word(experiment.at("role"), {"fit", "held_out"}) == "held_out";
    return read;
}

void read_recordings(Experiment& e) {
    const double volts = newtons_per_volt(e.conditions);
    read_once(e.recording, e.recording_file, e.rig, volts);
    read_once(e.simulated, e.simulated_file, e.rig, volts);
    if (e.recording && e.recording->has("angle_of_repose") && !e.recording->has("estimator") &&
        !e.conditions.has("estimator")) {
        refuse(e.recording_file->name, "must say how the angle of repose was taken",
               "add a column estimator, or the condition \"estimator\"");
    }
}

}  // namespace cases
