// SPDX-License-Identifier: MIT
#include "app/convert_edem.hpp"

#include "app/exit_code.hpp"
#include "app/scale_input.hpp"
#include "cases/messages.hpp"
#include "cases/read_case.hpp"
#include "contact/effective.hpp"
#include "engines/conventions.hpp"
#include "reports/edem_sheet.hpp"
#include "reports/text.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace app {

namespace {

using scaling::InvalidInput;
using scaling::mistake;

struct Options {
    CommonOptions common;
    std::string path, of, jkr, rolling = "edem_standard", out;
};

template <class Convention>
const Convention& named(const std::vector<Convention>& table, const std::string& name) {
    return *std::find_if(table.begin(), table.end(),
                         [&](const Convention& c) { return c.name == name; });
}

// What the case says of itself, or of the grain that is simulated in its place.
struct Grain {
    double length = 1.0, density = 1.0, modulus = 1.0, gravity = 1.0;  // scaled over original
    double work_of_adhesion = 0.0, wall_work_of_adhesion = 0.0;        // J/m^2
};

Grain grain_of(const cases::Case& c, const std::string& of) {
    Grain g;
    g.work_of_adhesion = c.model.value_or("work_of_adhesion", 0.0);
    g.wall_work_of_adhesion = c.model.wall_value_or("work_of_adhesion", 0.0);
    if (c.scaling && of.empty())
        throw InvalidInput(mistake("--of", "none", "must be original or scaled",
                                   "the case states a scaling: say which grain the sheet is for"));
    if (of != "scaled") {
        // Where the case states the scaled grain's adhesion, the original's follows from it.
        if (!c.scaling || g.work_of_adhesion > 0.0) return g;
        const scaling::ScaleStudy study = study_of(c, {}, 1e7);
        if (study.adhesion) g.work_of_adhesion = study.adhesion->original.work_of_adhesion.value();
        return g;
    }
    if (!c.scaling)
        throw InvalidInput(mistake("--of", "scaled", "must be original: the case states no scaling",
                                   "add \"scaling\" to the case"));
    const scaling::ScaleStudy study = study_of(c, {}, 1e7);  // the speed tells the wall time alone
    const auto factor = [&](const char* quantity) {
        for (const scaling::FactorRow& row : study.factors)
            if (row.quantity == quantity) return row.factor;
        return 1.0;
    };
    g.length = factor("length"), g.density = factor("density");
    g.modulus = factor("youngs_modulus"), g.gravity = factor("gravity");
    const double before = g.work_of_adhesion;
    if (study.adhesion) g.work_of_adhesion = study.adhesion->scaled.work_of_adhesion.value();
    if (g.wall_work_of_adhesion > 0.0 && before > 0.0)
        g.wall_work_of_adhesion *= g.work_of_adhesion / before;
    return g;
}

struct PairRequest {
    bool wall;
    double e_star, radius, restitution, sliding, rolling, work_of_adhesion;
};

reports::EdemPair pair_of(const Options& o, const PairRequest& r) {
    const engines::Pair pair{.r_star = r.wall ? r.radius : 0.5 * r.radius,
                             .e_star = r.e_star,
                             .radius = r.radius,
                             .weight = 1.0,  // forces in grain weights are not told here
                             .wall = r.wall};
    const auto& ours = named(engines::rolling_conventions(), "similitude");
    const auto& theirs = named(engines::rolling_conventions(), o.rolling);
    reports::EdemPair p{r.restitution, r.sliding, r.rolling * ours.lever(pair) / theirs.lever(pair),
                        0.0, std::nan("")};
    if (!(r.work_of_adhesion > 0.0)) return p;
    const auto& w = named(engines::adhesion_conventions(), "work_of_adhesion");
    p.pull_off_force = w.pull_off(r.work_of_adhesion, pair);
    if (o.jkr != "edem_v2")
        p.surface_energy =
            named(engines::adhesion_conventions(), o.jkr).value(p.pull_off_force, pair);
    return p;
}

void refuse_more_materials(const cases::Case& c) {
    if (!c.materials.empty() || !c.model.pairs.empty())
        throw InvalidInput(
            mistake(c.path + ": materials",
                    fmt::format("{} materials beside grain and plate", c.materials.size()),
                    "must be none for this sheet", "write one case for each pair of materials"));
}

reports::EdemInput input_of(const cases::Case& c, const Options& o) {
    const Grain g = grain_of(c, o.of);
    const bool adhesive = g.work_of_adhesion > 0.0 || g.wall_work_of_adhesion > 0.0;
    if (adhesive && o.jkr.empty())
        throw InvalidInput(
            mistake("--jkr", "none", "must be edem_v1_equations, edem_v1_text or edem_v2",
                    "EDEM's page on JKR contradicts itself by a factor 2: see docs/convert.md"));
    const double nu = c.grain.poisson_ratio.value.value();
    const double plate_nu = c.plate.poisson_ratio.value();
    const double e = g.modulus * c.grain.youngs_modulus.value.value();
    const double plate_e = g.modulus * c.plate.youngs_modulus.value();
    const double density = g.density * c.grain.density.value.value();
    const double d = g.length * c.grain.diameter.value.value();
    const contact::Material grain{e * scaling::si::pascals, nu,
                                  scaling::Density::from_value(density)};
    const contact::Material plate{plate_e * scaling::si::pascals, plate_nu, grain.density};
    const double none = std::nan("");
    const bool rolls = c.model.includes("rolling_resistance");
    const auto of = [&](const char* name) { return c.model.value_or(name, none); };
    const auto at_wall = [&](const char* name) { return c.model.wall_value_or(name, none); };

    reports::EdemInput in{};
    in.grains = {"grains", nu, e, density};
    in.plate = {"plate", plate_nu, plate_e, none};
    in.grain_grain = pair_of(
        o, {false, contact::e_star(grain, grain).value(), 0.5 * d, of("restitution"),
            of("sliding_friction"), rolls ? of("rolling_friction") : 0.0, g.work_of_adhesion});
    in.grain_plate =
        pair_of(o, {true, contact::e_star(grain, plate).value(), 0.5 * d, at_wall("restitution"),
                    at_wall("sliding_friction"), rolls ? at_wall("rolling_friction") : 0.0,
                    g.wall_work_of_adhesion});
    in.diameter = d;
    for (const auto& [share, size] : c.grain.size_distribution)
        in.sizes.emplace_back(100.0 * share, g.length * size.value());
    in.gravity = g.gravity * c.surroundings.gravity.value();
    in.contact_model = !adhesive            ? "Hertz-Mindlin (no slip)"
                       : o.jkr == "edem_v2" ? "Hertz-Mindlin with JKR Version 2"
                                            : "Hertz-Mindlin with JKR";
    in.rolling_model = o.rolling == "edem_rvd"
                           ? "Relative Velocity Dependent (RVD) Rolling Friction"
                           : "Standard Rolling Friction";
    if (o.jkr == "edem_v1_equations")
        in.convention = "if EDEM follows its equations: pull-off 3 pi gamma R*";
    if (o.jkr == "edem_v1_text")
        in.convention = "if EDEM follows the force its page states: pull-off 3/2 pi gamma R*";
    if (o.jkr == "edem_v2")
        in.convention = "not published how it follows: set it by a pull-off test";
    for (const std::string& name : c.model.physics)
        if (name != "gravity" && name != "hertz_mindlin" && name != "adhesion" &&
            name != "wall_adhesion" && name != "rolling_resistance" && name != "wall_friction")
            in.left_out.push_back(name);
    if (!c.model.friction_cap.empty() && c.model.friction_cap != "repulsive_part")
        in.left_out.push_back("friction_cap " + c.model.friction_cap);
    if (!c.grain.sizes.empty()) in.left_out.push_back("sizes by number (one diameter is written)");
    return in;
}

std::string text_of(const reports::Sheet& sheet) {
    std::vector<std::vector<std::string>> rows{{"dialog", "field", "value", "unit"}};
    for (const auto& row : sheet.rows) {
        const auto* text = std::get_if<std::string>(&row[2]);
        const double value = text != nullptr ? 0.0 : std::get<double>(row[2]);
        rows.push_back({std::get<std::string>(row[0]), std::get<std::string>(row[1]),
                        text != nullptr        ? *text
                        : std::isfinite(value) ? fmt::format("{:.6g}", value)
                                               : "",
                        std::get<std::string>(row[3])});
    }
    return reports::columns(rows, {false, false, true, false});
}

int run(const Options& o) {
    const bool xlsx = o.out.ends_with(".xlsx");
    if (!o.out.empty() && !xlsx && !o.out.ends_with(".csv"))
        throw InvalidInput(
            mistake("--out", cases::in_quotes(o.out), "must end with .xlsx or .csv", "choose one"));
    const cases::Case c = cases::read_case(o.path, cases::HeldOut::sealed);
    refuse_more_materials(c);
    const reports::EdemInput in = input_of(c, o);
    const reports::Sheet sheet = reports::edem_sheet(in);
    if (xlsx) reports::write_workbook(o.out, {sheet});
    if (!o.out.empty() && !xlsx) write_file(o.out, reports::csv_of(sheet));
    print(o.common, text_of(sheet));
    const bool untold = in.grain_grain.pull_off_force > 0.0 || in.grain_plate.pull_off_force > 0.0;
    return o.jkr == "edem_v2" && untold ? outside_validity : fine;
}

}  // namespace

Verb convert_edem_verb(CLI::App& convert) {
    const auto o = std::make_shared<Options>();
    CLI::App* verb = convert.add_subcommand(
        "edem", "what to type into EDEM for a case, in the order of its dialogs");
    verb->add_option("CASE", o->path, "case.json or its folder")->required();
    verb->add_option("--of", o->of, "original or scaled grain, where the case states a scaling")
        ->check(CLI::IsMember({"original", "scaled"}));
    verb->add_option("--jkr", o->jkr,
                     "what EDEM's surface energy means: edem_v1_equations, edem_v1_text, edem_v2")
        ->check(CLI::IsMember({"edem_v1_equations", "edem_v1_text", "edem_v2"}));
    verb->add_option("--rolling", o->rolling, "edem_standard or edem_rvd")
        ->check(CLI::IsMember({"edem_standard", "edem_rvd"}))
        ->capture_default_str();
    verb->add_option("--out", o->out, "write the sheet to FILE.xlsx or FILE.csv")
        ->type_name("FILE");
    verb->add_flag("--quiet", o->common.quiet, "no table");
    return {verb, [=] { return run(*o); }};
}

}  // namespace app
