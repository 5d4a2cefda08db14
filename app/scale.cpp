// SPDX-License-Identifier: MIT
#include "app/scale.hpp"

#include "app/exit_code.hpp"
#include "app/machine_speed.hpp"
#include "app/scale_input.hpp"
#include "cases/read_case.hpp"
#include "reports/text.hpp"
#include "reports/workbook.hpp"
#include "scaling/scale_study.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace app {

namespace {

struct ScaleOptions {
    CommonOptions common;
    std::string path;
    ScaleOverrides overrides;
};

constexpr const char* examples = R"(Examples:
  similitude scale data/zirconia/case.json
      what the paper's own scaling keeps and breaks
  similitude scale data/zirconia/case.json --scheme kept_gravity --report scale.html
      the same powder under a scheme that keeps every group
  similitude scale data/zirconia/case.json --keep density,gravity,youngs_modulus --distorted
      --invariant weight_bond --surface-energy "30 mJ/m^2" --of original
      apparatus scaled too, from a measured surface energy)";

void add_overrides(CLI::App& verb, ScaleOverrides& o) {
    verb.add_option("--h", o.h, "scaled over original grain diameter");
    verb.add_option("--scheme", o.scheme,
                    "exact, kept_gravity, kept_gravity_kept_modulus, paper, coarse_grain");
    verb.add_option("--keep", o.keep,
                    "your own scheme: quantities that stay, or stay as a power of h: gravity=-1")
        ->delimiter(',')
        ->type_name("A,B,...");
    verb.add_flag("--distorted", o.distorted,
                  "let grain and surroundings scale differently where --keep asks for too much");
    verb.add_option("--softening", o.softening,
                    "modulus of the simulation over the real one, E'/E");
    verb.add_option(
        "--invariant", o.invariant,
        "what the adhesion keeps: weight_bond, stress_bond, cohesion_number, sticking_velocity");
    verb.add_option("--work-of-adhesion", o.work_of_adhesion,
                    "of a pair, w = 2 gamma, with its unit: \"0.38 J/m^2\"");
    verb.add_option("--surface-energy", o.surface_energy,
                    "of one surface, gamma, with its unit: \"0.19 J/m^2\"");
    verb.add_option("--of", o.of, "which grain that adhesion belongs to: original or scaled")
        ->check(CLI::IsMember({"original", "scaled"}));
    verb.add_option("--experiment", o.experiment,
                    "which experiment's apparatus; the first one otherwise");
    verb.add_option("--apparatus", o.apparatus,
                    "characteristic length instead of the experiment's: \"6 mm\"");
}

int run(const ScaleOptions& options, const std::string& command) {
    const cases::Case c = cases::read_case(options.path);
    const double speed = measured_speed(threads_of(options.common));
    const scaling::ScaleStudy study = study_of(c, options.overrides, speed);
    const reports::Provenance who = provenance(command, c.path);

    const reports::Json json = reports::to_json(c, study, speed, who);
    print(options.common, (c.title.empty() ? "" : c.title + "\n") + reports::text_of(study));
    write_results(options.common, json, [&] { return reports::page_of(c, study, who); });
    if (!options.common.xlsx.empty())
        reports::write_workbook(options.common.xlsx, reports::sheets_of_scale(json));
    return study.adhesion && !study.adhesion->physically_usable ? outside_validity : fine;
}

}  // namespace

Verb scale_verb(CLI::App& app, const std::string& command) {
    const auto options = std::make_shared<ScaleOptions>();
    CLI::App* verb = app.add_subcommand(
        "scale", "scale factors, what they keep and break, the adhesion they need, what they save");
    verb->add_option("CASE", options->path, "case.json or its folder")->required();
    add_overrides(*verb, options->overrides);
    add_common(*verb, options->common);
    add_workbook(*verb, options->common);
    verb->footer(examples);
    return {verb, [options, command] { return run(*options, command); }};
}

}  // namespace app
