// SPDX-License-Identifier: MIT
#include "cases/read_case.hpp"

#include "cases/domain.hpp"
#include "cases/json_tree.hpp"
#include "cases/read_experiment.hpp"
#include "cases/read_model.hpp"
#include "cases/read_powder.hpp"

#include <filesystem>

namespace cases {
namespace {

// gamma of like grains as the pair's work of adhesion, w = 2 gamma, so that one name is left.
void adopt_surface_energy(const Value& grain, Case& read) {
    if (!grain.has("surface_energy")) return;
    const Value& gamma = grain.at("surface_energy");
    if (read.model.find("work_of_adhesion") != nullptr) {
        refuse(gamma, "must not stand beside model.parameters.work_of_adhesion",
               "give one of the two; w = 2 gamma");
    }
    read.model.parameters["work_of_adhesion"] = {
        2.0 * checked(gamma, "J/m^2", Domain::not_negative), "J/m^2", std::nullopt};
}

Value empty_object(const std::string& where) {
    return {.where = where, .kind = Value::Kind::object};
}

}  // namespace

Case read_case(const std::string& path, HeldOut held_out) {
    Case read;
    read.path = std::filesystem::is_directory(path)
                    ? (std::filesystem::path(path) / "case.json").string()
                    : path;
    const Value root = read_json(read.path);
    check_keys(root, {"format", "title", "source", "grain", "plate", "surroundings", "materials",
                      "model", "experiments", "scaling", "stated"});
    checked_word(root.at("format"), {"similitude-case/1"});
    if (root.has("title")) read.title = root.at("title").text();
    if (root.has("source")) read.source = root.at("source").text();

    Shared shared;
    shared.folder = std::filesystem::path(read.path).parent_path().string();
    shared.grain = root.at("grain");
    shared.surroundings = root.has("surroundings") ? root.at("surroundings")
                                                   : empty_object(root.where + "surroundings");
    shared.plate.kind = Value::Kind::null;
    if (root.has("plate")) shared.plate = root.at("plate");

    if (root.has("materials")) read.materials = read_materials(root.at("materials"));
    shared.names = MaterialNames(read.materials);
    shared.materials = read.materials;
    read.grain = read_grain(shared.grain, shared.names);
    read.surroundings = read_surroundings(shared.surroundings);
    read.plate = {read.grain.youngs_modulus.value, read.grain.poisson_ratio.value};
    if (root.has("plate")) read.plate = read_plate(shared.plate);
    if (root.has("scaling")) read.scaling = read_scaling(root.at("scaling"));
    const bool adhesion_elsewhere = shared.grain.has("surface_energy") ||
                                    (read.scaling && read.scaling->scaled_work_of_adhesion);
    read.model =
        read_model(root.at("model"), adhesion_elsewhere ? "work_of_adhesion" : "", shared.names);
    adopt_surface_energy(shared.grain, read);
    if (read.scaling && read.scaling->scaled_work_of_adhesion &&
        read.model.find("work_of_adhesion") != nullptr) {
        refuse(root.at("scaling"),
               "must not state the adhesion of the scaled grain beside that of the real one",
               "give one of the two; the other follows from the invariant");
    }
    if (root.has("stated")) read.stated = read_stated(root.at("stated"), read.grain.density.value);

    if (!root.has("experiments")) return read;
    const Value& experiments = root.at("experiments");
    if (experiments.kind != Value::Kind::list)
        refuse(experiments, "must be a list", "write [ ] around the experiments");
    for (const Value& entry : experiments.items) {
        Experiment experiment = read_experiment(entry, shared, read.model);
        if (read.find(experiment.id) != nullptr)
            refuse(entry.at("id"), "must not be used twice", "rename one");
        if (!experiment.held_out || held_out == HeldOut::opened) read_recordings(experiment);
        if (!read.model.friction_cap.empty() && experiment.rig != "pile")
            refuse(root.at("model").at("friction_cap"),
                   "must not stand in a case with the rig " + experiment.rig,
                   "only piles know it: give them a case of their own");
        read.experiments.push_back(std::move(experiment));
    }
    return read;
}

void open_held_out(Case& sealed) {
    for (Experiment& experiment : sealed.experiments)
        if (experiment.held_out) read_recordings(experiment);
}

const Experiment* Case::find(const std::string& id) const {
    for (const Experiment& experiment : experiments) {
        if (experiment.id == id) return &experiment;
    }
    return nullptr;
}

}  // namespace cases
