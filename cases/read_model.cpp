// SPDX-License-Identifier: MIT
#include "cases/read_model.hpp"

#include "cases/domain.hpp"
#include "cases/effects.hpp"
#include "cases/messages.hpp"
#include "scaling/adhesion.hpp"
#include "scaling/errors.hpp"
#include "scaling/schemes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cases {
namespace {

void read_physics(const Value& list, Model& model) {
    if (list.kind != Value::Kind::list)
        refuse(list, "must be a list of names", "write [\"gravity\", \"hertz_mindlin\"]");
    for (const Value& item : list.items) {
        const std::string& name = checked_word(item, effect_names());
        if (model.includes(name)) refuse(item, "must stand once", "remove the second");
        model.physics.push_back(name);
    }
    const int laws =
        (model.includes("hertz_mindlin") ? 1 : 0) + (model.includes("hertz_coulomb") ? 1 : 0);
    if (laws != 1) {
        refuse(list, fmt::format("must name one contact law, not {}", laws),
               "add or leave one of hertz_mindlin, hertz_coulomb");
    }
}

Parameter read_parameter(const ParameterRule& rule, const Value& given) {
    if (given.kind != Value::Kind::object) {
        refuse(given, "must be an object", "write {\"value\": " + given.as_written() + "}");
    }
    check_keys(given, {"value", "range"});
    const Value& value = given.at("value");
    std::string unit = rule.unit;
    if (unit.empty()) {
        // The offset of a channel is in the unit of that channel: whatever is written, in SI.
        const std::string text = value.text();
        for (const char* candidate : {"m", "s", "N", "rad", "rad/s", "m/s", "kg", "1"}) {
            try {
                to_si(text, parse_unit(candidate, value.where), value.where);
                unit = candidate;
                break;
            } catch (const scaling::InvalidInput&) {
                continue;
            }
        }
        if (unit.empty())
            refuse(value, "must be in the unit of a recorded channel", "write it as \"0.1 mm\"");
    }
    Parameter parameter{checked(value, unit, rule.domain), unit, std::nullopt};
    if (!given.has("range")) return parameter;
    const Value& range = given.at("range");
    if (range.kind != Value::Kind::list || range.items.size() != 2)
        refuse(range, "must be a pair", "write [low, high]");
    const double low = checked(range.items[0], unit, rule.domain);
    const double high = checked(range.items[1], unit, rule.domain);
    if (low >= high)
        refuse(range.items[1], "must be above the lower end, " + range.items[0].as_written(),
               "write [low, high]");
    if (parameter.value < low || parameter.value > high) {
        refuse(value,
               fmt::format("must lie in its range, {} to {}", range.items[0].as_written(),
                           range.items[1].as_written()),
               "widen the range or correct the value");
    }
    parameter.range = {low, high};
    return parameter;
}

void read_parameters(const Value& object, Model& model) {
    check_keys(object, parameter_names());
    for (const ParameterRule& rule : parameter_rules()) {
        if (object.has(rule.name))
            model.parameters.emplace(rule.name, read_parameter(rule, object.at(rule.name)));
    }
}

Numerics read_numerics(const Value& object) {
    check_keys(object, {"time_step", "integrator", "youngs_modulus_factor"});
    Numerics numerics;
    if (object.has("time_step")) {
        numerics.time_step =
            scaling::Time::from_value(checked(object.at("time_step"), "s", Domain::positive));
    }
    if (object.has("integrator"))
        numerics.integrator = checked_word(object.at("integrator"), {"verlet", "euler"});
    if (object.has("youngs_modulus_factor")) {
        numerics.youngs_modulus_factor =
            checked(object.at("youngs_modulus_factor"), "1", Domain::positive);
    }
    return numerics;
}

// "gravity", "velocity=1/2": what scaling/schemes.hpp understands.
std::vector<std::string> read_kept(const Value& list) {
    if (list.kind != Value::Kind::list)
        refuse(list, "must be a list", "write [\"gravity\", \"density\"]");
    std::vector<std::string> kept;
    for (const Value& item : list.items) {
        try {
            scaling::demand_from(item.text());
        } catch (const scaling::InvalidParameter& mistake) {
            throw scaling::InvalidInput(item.where + ": " + mistake.what());
        }
        kept.push_back(item.text());
    }
    return kept;
}

}  // namespace

Model read_model(const Value& object, const std::string& known_elsewhere,
                 const MaterialNames& names) {
    check_keys(object, {"physics", "parameters", "numerics", "pairs", "friction_cap"});
    Model model;
    read_physics(object.at("physics"), model);
    if (object.has("parameters")) read_parameters(object.at("parameters"), model);
    if (object.has("numerics")) model.numerics = read_numerics(object.at("numerics"));
    if (object.has("friction_cap"))
        model.friction_cap = checked_word(object.at("friction_cap"), friction_caps());
    if (object.has("pairs")) model.pairs = read_pairs(object.at("pairs"), names, model.physics);
    for (const Effect& effect : effects()) {
        if (!model.includes(effect.name)) continue;
        for (const std::string& need : effect.needs) {
            if (model.find(need) != nullptr || need == known_elsewhere) continue;
            throw scaling::InvalidInput(
                scaling::mistake(object.where + ".parameters." + need, "nothing",
                                 "must be given with \"" + effect.name + "\" in physics",
                                 "add it, or remove the effect"));
        }
    }
    return model;
}

Scaling read_scaling(const Value& object) {
    check_keys(object, {"h", "scheme", "invariant", "kept", "softening", "distorted",
                        "scaled_surface_energy", "scaled_work_of_adhesion"});
    Scaling result;
    result.h = checked(object.at("h"), "1", Domain::positive);
    if (object.has("scheme"))
        result.scheme = checked_word(object.at("scheme"), scaling::scheme_names());
    if (object.has("invariant")) {
        std::vector<std::string> names;
        for (const scaling::Invariant invariant : scaling::all_invariants())
            names.emplace_back(to_string(invariant));
        result.invariant = checked_word(object.at("invariant"), names);
    }
    if (object.has("kept")) {
        if (object.has("scheme"))
            refuse(object.at("kept"), "must not stand beside a scheme", "give one of the two");
        result.kept = read_kept(object.at("kept"));
    }
    if (object.has("softening"))
        result.softening = checked(object.at("softening"), "1", Domain::positive);
    if (object.has("distorted")) result.distorted = object.at("distorted").boolean();
    const bool surface_energy = object.has("scaled_surface_energy");
    if (surface_energy && object.has("scaled_work_of_adhesion")) {
        refuse(object.at("scaled_work_of_adhesion"), "must not stand beside scaled_surface_energy",
               "give one of the two");
    }
    if (surface_energy || object.has("scaled_work_of_adhesion")) {
        const Value& given =
            object.at(surface_energy ? "scaled_surface_energy" : "scaled_work_of_adhesion");
        const double w = (surface_energy ? 2.0 : 1.0) * checked(given, "J/m^2", Domain::positive);
        result.scaled_work_of_adhesion = scaling::EnergyPerArea::from_value(w);
    }
    return result;
}

Stated read_stated(const Value& object, scaling::Density grain_density) {
    check_keys(object, {"grains", "original_grains", "time_step", "rayleigh_fraction", "feed_rate",
                        "settling_time", "simulated_time", "wall_time", "base_diameter",
                        "angle_of_repose", "bulk_density"});
    const auto read = [&]<class Q>(const char* key, const char* unit, std::optional<Q>& into) {
        if (object.has(key)) into = Q::from_value(checked(object.at(key), unit, Domain::positive));
    };
    Stated result;
    scaling::StatedCounts& counts = result.counts;
    if (object.has("grains")) {
        const Value& grains = object.at("grains");
        const bool list = grains.kind == Value::Kind::list;
        for (const Value& n : list ? grains.items : std::vector<Value>{grains}) {
            counts.grains.push_back(static_cast<double>(n.count()));
        }
    }
    if (object.has("original_grains")) {
        counts.original_grains = static_cast<double>(object.at("original_grains").count());
    }
    read("time_step", "s", counts.time_step);
    read("feed_rate", "1/s", counts.feed_rate);
    read("settling_time", "s", counts.settling_time);
    read("simulated_time", "s", counts.simulated_time);
    read("wall_time", "s", counts.wall_time);
    read("bulk_density", "kg/m^3", result.bulk_density);
    if (object.has("rayleigh_fraction")) {
        result.rayleigh_fraction = checked(object.at("rayleigh_fraction"), "1", Domain::positive);
    }
    std::optional<scaling::Length> base;
    std::optional<scaling::Dimensionless> angle;
    read("base_diameter", "m", base);
    read("angle_of_repose", "rad", angle);
    if (result.bulk_density && *result.bulk_density >= grain_density) {
        refuse(object.at("bulk_density"), "must be below the density of the grain",
               "check which of the two is which");
    }
    if (base && angle && result.bulk_density) {
        counts.heap =
            scaling::Heap{*base, angle->value(), (*result.bulk_density / grain_density).value()};
    }
    return result;
}

const std::vector<std::string>& friction_caps() {
    static const std::vector<std::string> names = {
        "elastic_plus_two_pull_off", "total_plus_two_pull_off", "repulsive_part", "elastic"};
    return names;
}

bool Model::includes(const std::string& effect) const {
    return std::find(physics.begin(), physics.end(), effect) != physics.end();
}

const Parameter* Model::find(const std::string& name) const {
    const auto found = parameters.find(name);
    return found == parameters.end() ? nullptr : &found->second;
}

double Model::value_or(const std::string& name, double otherwise) const {
    const Parameter* parameter = find(name);
    return parameter == nullptr ? otherwise : parameter->value;
}

double Model::wall_value_or(const std::string& name, double otherwise) const {
    if (const Parameter* wall = find("wall_" + name)) return wall->value;
    return name == "work_of_adhesion" ? 0.0 : value_or(name, otherwise);
}

}  // namespace cases
