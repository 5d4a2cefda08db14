// SPDX-License-Identifier: MIT
#include "app/scaled_case.hpp"

#include "app/common.hpp"
#include "cases/units.hpp"
#include "scaling/cost.hpp"
#include "scaling/errors.hpp"
#include "verify/scaling_map_plan.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using scaling::InvalidInput;
using scaling::mistake;

std::string exactly(double si, const char* unit) { return fmt::format("{:.9g} {}", si, unit); }

Json raw(const cases::Case& c) {
    std::filesystem::path path = c.path;
    if (std::filesystem::is_directory(path)) path /= "case.json";
    std::ifstream file(path);
    return Json::parse(file);
}

void scale_grain(Json& grain, const cases::Grain& g, const GrainChange& to) {
    grain["diameter"] = exactly(to.h * g.diameter.value.value(), "m");
    const double e = to.softening * g.youngs_modulus.value.value();
    grain.erase("shear_modulus");
    grain["youngs_modulus"] = exactly(e, "Pa");
    const auto larger = [&](const Json& text) {
        return exactly(
            to.h * cases::quantity<scaling::Length>(text.get<std::string>(), "grain").value(), "m");
    };
    if (grain.contains("size_distribution"))
        for (Json& row : grain["size_distribution"]) row[1] = larger(row[1]);
    if (grain.contains("sizes"))
        for (Json& row : grain["sizes"]) row[0] = larger(row[0]);
}

// Equal grains would form a crystal on glued ones, the more the fewer there are, and the map was poured with these sizes. Their
// mean volume is that of the stated grain.
void spread_sizes(Json& grain, double d, std::vector<std::string>& notes) {
    for (const double size : verify::map_sizes)
        grain["sizes"].push_back({exactly(size * d / std::cbrt(verify::map_mean_cube), "m"),
                                  1.0 / std::size(verify::map_sizes)});
    notes.emplace_back(
        "grains of one size would pile up as a crystal: they are of five sizes now, from 0.8 to "
        "1.2 times the mean, as the map's are");
}

double grains_of(const cases::Experiment& e, double h) {
    const cases::Value& stated = e.conditions.at("grains");
    if (stated.kind == cases::Value::Kind::number)
        return static_cast<double>(stated.count()) / (h * h * h);
    constexpr double angle = 0.7853981633974483, packing = 0.5, spilled = 1.5;  // rad (45 deg)
    return spilled *
           scaling::grains_in(
               {e.conditions.at("base_diameter").quantity<scaling::Length>(), angle, packing},
               h * e.grain.diameter.value);
}

// A number without its unit is a rate of grains: there are h^3 fewer.
void scale_feed(Json& conditions, const cases::Experiment& e, const GrainChange& to,
                std::vector<std::string>& notes) {
    constexpr double narrowest = 10.0;  // outlet over grain; tests of funnels: docs/heap-50mm.md
    if (conditions.contains("feed_rate")) {
        const double rate = e.conditions.at("feed_rate").si(cases::parse_unit("1/s", "feed_rate"));
        conditions["feed_rate"] = exactly(rate / std::pow(to.h, 3.0), "1/s");
    }
    const double d = to.h * e.grain.diameter.value.value();
    if (!conditions.contains("funnel")) {
        if (!conditions.contains("drop_height"))
            notes.push_back("no drop_height stated: it is 5 grains, so it grows with the grain");
        return;
    }
    const cases::Value& funnel = e.conditions.at("funnel");
    const double outlet = funnel.at("outlet_diameter").quantity<scaling::Length>().value();
    if (outlet >= narrowest * d) return;
    notes.push_back(fmt::format(
        "the funnel's outlet is {:.2g} grains wide and would jam: grains fall from a disc as "
        "wide (4 grains at least), at the outlet's height",
        outlet / d));
    conditions["drop_height"] =
        exactly(funnel.at("outlet_height").quantity<scaling::Length>().value(), "m");
    conditions["feed_diameter"] = exactly(std::max(outlet, 4.0 * d), "m");
    conditions.erase("funnel");
}

}  // namespace

ScaledCase scaled_case(const cases::Case& c, const cases::Experiment& e, const GrainChange& to) {
    ScaledCase result;
    Json json = raw(c);
    if (json.contains("materials"))
        throw InvalidInput(mistake(c.path + ": materials", "several",
                                   "must be one to be scaled by advise",
                                   "scale each by hand: similitude scale"));
    Json experiment;
    for (const Json& other : json["experiments"])
        if (other.at("id") == e.id) experiment = other;
    if (experiment.contains("grain"))
        throw InvalidInput(mistake(c.path + ": " + e.id + ".grain", "one of its own",
                                   "must be the case's to be scaled by advise",
                                   "write it as the case's grain"));
    scale_grain(json["grain"], c.grain, to);
    if (to.h > 1.0 && c.grain.sizes.empty() && c.grain.size_distribution.empty())
        spread_sizes(json["grain"], to.h * c.grain.diameter.value.value(), result.notes);
    Json& model = json["model"];
    Json& parameters = model["parameters"];
    parameters.erase("work_of_adhesion");
    Json& physics = model["physics"];
    const auto listed = std::find(physics.begin(), physics.end(), "adhesion");
    if (to.work_of_adhesion > 0.0) {
        parameters["work_of_adhesion"] = {{"value", exactly(to.work_of_adhesion, "J/m^2")}};
        if (listed == physics.end()) physics.push_back("adhesion");
    } else if (listed != physics.end()) {
        physics.erase(listed);
    }
    for (auto& [name, parameter] : parameters.items())
        if (parameter.is_object()) parameter.erase("range");
    Json& conditions = experiment["conditions"];
    conditions["grains"] = static_cast<long>(std::max(1.0, std::round(grains_of(e, to.h))));
    scale_feed(conditions, e, to, result.notes);
    for (const char* key : {"recording", "simulated", "noise", "role"}) experiment.erase(key);
    json["experiments"] = Json::array({experiment});
    for (const char* key : {"scaling", "stated"}) json.erase(key);
    json["title"] = fmt::format("{} (grains {:g} times as large)", c.title, to.h);
    result.json = json.dump(2) + "\n";
    return result;
}

std::string write_case(const ScaledCase& scaled, const std::filesystem::path& folder) {
    const std::string path = (folder / "case.json").string();
    write_file(path, scaled.json);
    return path;
}

}  // namespace app
