// SPDX-License-Identifier: MIT
#include "app/convert.hpp"

#include "app/convert_edem.hpp"
#include "app/convert_grains.hpp"
#include "app/exit_code.hpp"
#include "cases/read_case.hpp"
#include "cases/units.hpp"
#include "contact/effective.hpp"
#include "engines/conventions.hpp"
#include "reports/text.hpp"
#include "reports/workbook.hpp"
#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

namespace app {
namespace {

using reports::Json;
using scaling::InvalidInput;
using scaling::mistake;

struct GrainOptions {
    std::string path, diameter, density, youngs_modulus;
    double poisson_ratio = 0.3;
    bool wall = false;
};

struct ConvertOptions {
    CommonOptions common;
    GrainOptions grain;
    std::string from, value, to, keep = "pull_off_force";
};

// Of the grain that forces are told for.
struct StatedGrain {
    double diameter = 100e-6, density = 2500.0, youngs_modulus = 10e6, poisson_ratio = 0.3;  // SI
    bool stated = false, stiffness_stated = false;
    engines::Pair pair{};
};

StatedGrain grain_of(const GrainOptions& o) {
    StatedGrain g;
    if (!o.path.empty()) {
        const cases::Case c = cases::read_case(o.path, cases::HeldOut::sealed);
        g.diameter = c.grain.diameter.value.value(), g.density = c.grain.density.value.value();
        g.youngs_modulus = c.grain.youngs_modulus.value.value();
        g.poisson_ratio = c.grain.poisson_ratio.value.value();
        g.stated = g.stiffness_stated = true;
    }
    const auto positive = [](const std::string& text, const char* unit, const char* where) {
        const double v = cases::to_si(text, cases::parse_unit(unit, where), where);
        if (!(v > 0.0) || !std::isfinite(v))
            throw InvalidInput(mistake(where, '"' + text + '"', "must be > 0", "with its unit"));
        return v;
    };
    if (!o.diameter.empty()) g.diameter = positive(o.diameter, "m", "--diameter"), g.stated = true;
    if (!o.density.empty()) g.density = positive(o.density, "kg/m^3", "--density");
    if (!o.youngs_modulus.empty()) {
        g.youngs_modulus = positive(o.youngs_modulus, "Pa", "--youngs-modulus");
        g.poisson_ratio = o.poisson_ratio, g.stiffness_stated = true;
    }
    const contact::Material m{g.youngs_modulus * scaling::si::pascals, g.poisson_ratio,
                              scaling::Density::from_value(g.density)};
    const double radius = 0.5 * g.diameter;
    g.pair = {
        .r_star = o.wall ? radius : 0.5 * radius,
        .e_star = contact::e_star(m, m).value(),
        .radius = radius,
        .weight = contact::sphere_mass(m, scaling::Length::from_value(radius)).value() * 9.80665,
        .wall = o.wall};
    return g;
}

// Those whose name is `wanted` or starts with it: edem_v1 is all readings of it. All where nothing is wanted.
template <class Convention>
std::vector<const Convention*> chosen(const std::vector<Convention>& table,
                                      const std::string& wanted, const char* where) {
    std::vector<const Convention*> list;
    std::vector<std::string> names;
    for (const Convention& c : table) {
        names.push_back(c.name);
        if (wanted == c.name) return {&c};
        if (wanted.empty() || c.name.starts_with(wanted + "_")) list.push_back(&c);
    }
    if (list.empty())
        throw InvalidInput(mistake(where, '"' + wanted + '"',
                                   "must be one of " + scaling::joined(names),
                                   "did you mean " + scaling::nearest_name(wanted, names) + "?"));
    return list;
}

template <class Convention>
const Convention& one(const std::vector<Convention>& table, const std::string& wanted) {
    const auto list = chosen(table, wanted, "--from");
    if (list.size() == 1) return *list.front();
    std::vector<std::string> names;
    for (const Convention* c : list) names.push_back(c->name);
    throw InvalidInput(mistake("--from", wanted.empty() ? "none" : '"' + wanted + '"',
                               "must be one of " + scaling::joined(names),
                               "they mean different things by one number"));
}

Json start(const char* what, const std::string& command) {
    return {{"format", "similitude-convert/1"},
            {"what", what},
            {"tool", reports::to_json(provenance(command, ""))}};
}

Json grain_json(const StatedGrain& g) {
    return {{"diameter", g.diameter},
            {"density", g.density},
            {"youngs_modulus", g.youngs_modulus},
            {"poisson_ratio", g.poisson_ratio},
            {"counterpart", g.pair.wall ? "wall" : "grain"},
            {"assumed", !g.stated}};
}

std::string grain_words(const StatedGrain& g) {
    return fmt::format("{} of {}, {}{}", g.pair.wall ? "A grain at a wall," : "Two grains",
                       cases::format_si(g.diameter, "m"), cases::format_si(g.density, "kg/m^3"),
                       g.stated ? "" : " (assumed: state --diameter, --density or --case)");
}

const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };

// `more` stands between the value and where it comes from.
template <class Convention>
Json told(const Convention& c, double value, const Json& more = Json::object()) {
    Json j{{"name", c.name},
           {"engine", c.engine},
           {"parameter", c.parameter},
           {"value", number(value)}};
    j.update(more);
    j["differs"] = c.differs, j["source"] = c.source;
    return j;
}

void give(const CommonOptions& o, const Json& json, const std::string& text) {
    print(o, text);
    write_results(o, json, [] { return reports::Page{}; });
    if (!o.xlsx.empty()) reports::write_workbook(o.xlsx, reports::sheets_of_convert(json));
}

int adhesion(const ConvertOptions& o, const std::string& command) {
    const StatedGrain g = grain_of(o.grain);
    const engines::AdhesionConvention& from = one(engines::adhesion_conventions(), o.from);
    const double value = cases::to_si(o.value, cases::parse_unit(from.unit, "--value"), "--value");
    if (!(value > 0.0) || !std::isfinite(value))
        throw InvalidInput(mistake("--value", '"' + o.value + '"', "must be > 0",
                                   "without adhesion there is nothing to convert"));
    const auto needs_stiffness = [&](const engines::AdhesionConvention& c) {
        return c.pull == engines::Pull::per_area && !(g.stated && g.stiffness_stated);
    };
    if (needs_stiffness(from))
        throw InvalidInput(mistake("--from", '"' + o.from + '"',
                                   "pulls by the area of overlap, which depends on the grain",
                                   "state --diameter and --youngs-modulus, or --case"));
    const double force = from.pull_off(value, g.pair);
    const double w = from.work_of_adhesion(force, g.pair);
    const bool keep_work = o.keep == "work_of_adhesion";
    if (keep_work && !std::isfinite(w))
        throw InvalidInput(
            mistake("--keep", o.keep, from.name + " has none", "keep pull_off_force"));

    Json json = start("adhesion", command);
    json["grain"] = grain_json(g);
    json["keep"] = o.keep;
    const auto pulling = [&](const engines::AdhesionConvention& c, double v, double f) {
        return told(c, v,
                    {{"unit", c.unit},
                     {"pull_off_force", number(f)},
                     {"pull_off_in_grain_weights", number(f / g.pair.weight)},
                     {"work_of_adhesion", number(c.work_of_adhesion(f, g.pair))}});
    };
    json["from"] = pulling(from, value, force);
    json["to"] = Json::array();
    std::vector<std::vector<std::string>> rows{
        {"convention", "parameter", "value", "pull-off", "grain weights", "differs from JKR"}};
    const auto row = [&](const engines::AdhesionConvention& c, double v, double f) {
        rows.push_back({c.name, c.parameter,
                        std::isfinite(v) ? cases::format_si(v, c.unit) : "state the grain",
                        std::isfinite(f) ? cases::format_si(f, "N") : "",
                        std::isfinite(f) ? fmt::format("{:.4g}", f / g.pair.weight) : "",
                        c.differs.substr(0, c.differs.find(':'))});
    };
    row(from, value, force);
    std::string notes;
    bool outside = false;
    std::vector<const engines::AdhesionConvention*> targets;
    bool is_unpublished = false;
    for (const engines::Unpublished& u : engines::unpublished_adhesion()) {
        if (!o.to.empty() && o.to != u.name) continue;
        is_unpublished = is_unpublished || o.to == u.name;
        json["unpublished"].push_back(
            {{"name", u.name}, {"engine", u.engine}, {"instead", u.instead}});
        notes +=
            "\n" + reports::wrapped(u.name + " (" + u.engine + "): " + u.instead + ".", 100, 4);
    }
    if (!is_unpublished) targets = chosen(engines::adhesion_conventions(), o.to, "--to");
    for (const engines::AdhesionConvention* c : targets) {
        if (c == &from && o.to.empty()) continue;
        const double wanted = keep_work ? c->pull_off_of_work(w, g.pair) : force;
        double v = std::nan("");
        if (!needs_stiffness(*c) && std::isfinite(wanted)) v = c->value(wanted, g.pair);
        outside = outside || (!o.to.empty() && !std::isfinite(v));
        json["to"].push_back(pulling(*c, v, wanted));
        row(*c, v, wanted);
        if (!o.to.empty())
            notes += "\n" + reports::wrapped(
                                c->name + ": " + c->source +
                                    (c->differs.empty() ? "" : "; differs: " + c->differs) + ".",
                                100, 4);
    }
    give(o.common, json,
         fmt::format("{}: pull-off {}, {:.4g} grain weights{}\n\n{}{}\n", grain_words(g),
                     cases::format_si(force, "N"), force / g.pair.weight,
                     std::isfinite(w) ? ", work of adhesion " + cases::format_si(w, "J/m^2") : "",
                     reports::columns(rows, {false, false, true, true, true, false}), notes));
    return outside || is_unpublished ? outside_validity : fine;
}

double plain_number(const std::string& text, double most) {
    const double v = cases::to_si(text, cases::parse_unit("1", "--value"), "--value");
    if (!(v > 0.0) || !(v < most))
        throw InvalidInput(mistake(
            "--value", '"' + text + '"',
            std::isfinite(most) ? fmt::format("must lie between 0 and {}", most) : "must be > 0",
            "a number without a unit"));
    return v;
}

int rolling(const ConvertOptions& o, const std::string& command) {
    const StatedGrain g = grain_of(o.grain);
    const engines::RollingConvention& from = one(engines::rolling_conventions(), o.from);
    const double value = plain_number(o.value, HUGE_VAL), lever = value * from.lever(g.pair);
    Json json = start("rolling", command);
    json["grain"] = grain_json(g);
    json["lever"] = lever;
    std::vector<std::vector<std::string>> rows{{"convention", "parameter", "value", "note"}};
    const auto row = [&](const engines::RollingConvention& c, double v) {
        rows.push_back({c.name, c.parameter, fmt::format("{:.6g}", v), c.differs});
    };
    json["from"] = told(from, value);
    json["to"] = Json::array();
    row(from, value);
    for (const auto* c : chosen(engines::rolling_conventions(), o.to, "--to")) {
        if (c == &from && o.to.empty()) continue;
        const double v = lever / c->lever(g.pair);
        json["to"].push_back(told(*c, v));
        row(*c, v);
    }
    give(o.common, json,
         fmt::format("{}: the normal force has a lever of {} against rolling\n\n{}",
                     g.pair.wall ? "A grain at a wall" : "Two equal grains",
                     cases::format_si(lever, "m"),
                     reports::columns(rows, {false, false, true, false})));
    return fine;
}

int damping(const ConvertOptions& o, const std::string& command) {
    const double e = plain_number(o.value, 1.0);
    Json json = start("damping", command);
    json["restitution"] = e;
    json["to"] = Json::array();
    std::vector<std::vector<std::string>> rows{{"convention", "parameter", "value", "note"}};
    for (const auto* c : chosen(engines::damping_conventions(), o.to, "--to")) {
        json["to"].push_back(told(*c, c->value(e)));
        rows.push_back({c->name, c->parameter, fmt::format("{:.6g}", c->value(e)), c->differs});
    }
    give(o.common, json,
         fmt::format("Restitution {:.6g} of a Hertz contact without adhesion\n\n{}", e,
                     reports::columns(rows, {false, false, true, false})));
    return fine;
}

constexpr const char* examples = R"(Examples:
  similitude convert adhesion --from lammps_jkr --value "0.19 J/m^2" --to edem_v1
      both readings of EDEM's first JKR model
  similitude convert adhesion --from surface_energy --value "20 mJ/m^2" --case data/zirconia
      what every engine needs for these grains
  similitude convert grains heap.dump heap.data --to lammps_data --units si
      the last frame of a dump of LIGGGHTS as LAMMPS' data)";

void add_output(CLI::App& verb, CommonOptions& o) {
    verb.add_option("--json", o.json,
                    "write the result as JSON to FILE, or to standard output with -")
        ->type_name("FILE");
    verb.add_flag("--quiet", o.quiet, "no table");
    add_workbook(verb, o);
}

void add_grain(CLI::App& verb, GrainOptions& o) {
    verb.add_option("--case", o.path, "take the grain from a case");
    verb.add_option("--diameter", o.diameter, "of the grain, with its unit; 100 um otherwise");
    verb.add_option("--density", o.density, "of the grain; 2500 kg/m^3 otherwise");
    verb.add_option("--youngs-modulus", o.youngs_modulus, "of the simulated grain");
    verb.add_option("--poisson-ratio", o.poisson_ratio, "beside --youngs-modulus")
        ->check(CLI::Range(-0.999, 0.5))
        ->capture_default_str();
    verb.add_flag("--wall", o.wall, "a grain at a wall, not two grains");
}

}  // namespace

Verb convert_verb(CLI::App& app, const std::string& command) {
    const auto o = std::make_shared<ConvertOptions>();
    CLI::App* verb = app.add_subcommand(
        "convert",
        "another engine's number for adhesion, rolling or damping, or its file of grains");
    verb->require_subcommand(1);
    verb->footer(examples);
    CLI::App* sticky = verb->add_subcommand("adhesion", "keeps the pull-off force");
    CLI::App* rolls = verb->add_subcommand("rolling", "keeps the largest torque");
    CLI::App* damps = verb->add_subcommand("damping", "from a restitution");
    for (CLI::App* sub : {sticky, rolls, damps}) {
        sub->add_option("--value", o->value, "the number to convert, with its unit")->required();
        sub->add_option("--to", o->to, "convention, or the start of several names; all otherwise");
        add_output(*sub, o->common);
    }
    for (CLI::App* sub : {sticky, rolls}) {
        sub->add_option("--from", o->from, "whose number it is")->required();
        add_grain(*sub, o->grain);
    }
    sticky->add_option("--keep", o->keep, "pull_off_force or work_of_adhesion")
        ->check(CLI::IsMember({"pull_off_force", "work_of_adhesion"}))
        ->capture_default_str();
    const Verb grains = convert_grains_verb(*verb), edem = convert_edem_verb(*verb);
    return {verb, [=] {
                return grains.app->parsed() ? grains.run()
                       : edem.app->parsed() ? edem.run()
                       : sticky->parsed()   ? adhesion(*o, command)
                       : rolls->parsed()    ? rolling(*o, command)
                                            : damping(*o, command);
            }};
}

}  // namespace app
