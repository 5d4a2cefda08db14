// SPDX-License-Identifier: MIT
// A case: the powder, what the user simulates, what was recorded. The format is docs/case.md.
// What is here has been checked: dimensions, ranges, names, recordings. Raw doubles are SI.
#pragma once

#include "cases/csv.hpp"
#include "cases/materials.hpp"
#include "cases/stl.hpp"
#include "cases/value.hpp"
#include "scaling/quantities.hpp"
#include "scaling/stated.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cases {

template <class Q>
struct Measured {
    Q value;
    Q uncertainty{};  // standard deviation of a Gaussian prior; 0 where the value is taken as known
};

struct Grain {
    Measured<scaling::Length> diameter;
    Measured<scaling::Density> density;
    Measured<scaling::Pressure> youngs_modulus;  // from a stated shear modulus G: E = 2 G (1 + nu)
    Measured<scaling::Dimensionless> poisson_ratio;
    // Empty: all grains have `diameter`. At most one of the two is filled.
    std::vector<std::pair<scaling::Length, double>> sizes;  // diameter, number fraction; sum 1
    std::vector<int> size_material;                         // [sizes], see materials.hpp
    // Cumulative volume fraction, diameter; both rising.
    std::vector<std::pair<double, scaling::Length>> size_distribution;
};

// Also the walls. Of the grains' material where the case leaves it out, which it may where nothing touches one.
struct Plate {
    scaling::Pressure youngs_modulus;
    scaling::Dimensionless poisson_ratio;
};

struct Surroundings {  // 0 where left out
    scaling::Acceleration gravity;
    scaling::Density fluid_density;
    scaling::Viscosity fluid_viscosity;
};

struct Parameter {
    double value;                                    // SI
    std::string unit;                                // SI: "1", "J/m^2", "(s/m)^(1/5)"
    std::optional<std::pair<double, double>> range;  // SI, low < high: free; without one: fixed
};

struct Numerics {  // how the user's run was made
    std::optional<scaling::Time> time_step;
    std::string integrator;              // "verlet", "euler"; empty where not said
    double youngs_modulus_factor = 1.0;  // softened / real
};

// The forces that friction may multiply, as contact/friction_cap.hpp names them.
const std::vector<std::string>& friction_caps();

struct Model {
    std::vector<std::string> physics;             // as written
    std::map<std::string, Parameter> parameters;  // as written, no defaults filled in
    std::vector<MaterialPair> pairs;              // for bulk rigs, where these say otherwise
    Numerics numerics;
    std::string friction_cap;  // of the rig `pile`, a name of friction_caps(); empty: the rig's own

    bool includes(const std::string& effect) const;
    const Parameter* find(const std::string& name) const;  // nullptr where not given
    double value_or(const std::string& name, double otherwise) const;
    // `name` at plates and walls of bulk rigs: `wall_NAME`, else the grains' `NAME`, else `otherwise`.
    // But work_of_adhesion, where not given for walls, is 0 there, whatever the grains have.
    double wall_value_or(const std::string& name, double otherwise) const;
};

// A file that the case names.
struct StatedFile {
    Value name;        // as written, with its place in the input
    std::string path;  // it stands relative to case.json
};

// Of the walls of the rig `pile`, see materials.hpp.
struct WallMaterials {
    int base = material_of_plate, funnel = material_of_plate;  // base: its rim as well
    std::vector<int> meshes;                                   // [meshes]
};

struct Experiment {
    std::string id;
    std::string rig;
    Value conditions;  // an object, checked against the rig's table; defaults are the rig's
    // Those of the case with what this experiment overrides.
    Grain grain;
    Plate plate;
    Surroundings surroundings;
    std::vector<Mesh> meshes;  // walls of the rig `pile`, in its own coordinates
    WallMaterials wall_material;
    std::optional<Recording> recording;
    std::optional<Recording> simulated;   // the user's own run, same channels
    std::map<std::string, double> noise;  // channel -> standard deviation, SI
    bool held_out = false;                // role
    // Where the two stand, also while they are sealed (cases/read_case.hpp); empty where none is named.
    std::optional<StatedFile> recording_file, simulated_file;
};

struct Scaling {
    double h;
    std::string scheme;     // empty where only `kept` is given
    std::string invariant;  // empty where left out: then it has to be asked for
    std::vector<std::string> kept;
    double softening = 1.0;  // E'/E
    bool distorted = false;
    // Of the scaled grain, not of the real one; w = 2 gamma for like solids.
    std::optional<scaling::EnergyPerArea> scaled_work_of_adhesion;
};

// What a publication says of its own scaled run, to be held against what follows from the case.
struct Stated {
    // With a heap where base_diameter, angle_of_repose and bulk_density are all stated.
    scaling::StatedCounts counts;
    std::optional<double> rayleigh_fraction;       // time step over Rayleigh time
    std::optional<scaling::Density> bulk_density;  // of the powder, air included
};

struct Case {
    std::string path;  // of case.json, as given
    std::string title;
    std::string source;  // where the numbers come from; empty where left out
    Grain grain;
    Plate plate;
    Surroundings surroundings;
    std::vector<Material> materials;  // by number from first_named_material on
    Model model;
    std::vector<Experiment> experiments;
    std::optional<Scaling> scaling;
    Stated stated;  // empty where left out

    const Experiment* find(const std::string& id) const;  // nullptr where there is none
};

}  // namespace cases
