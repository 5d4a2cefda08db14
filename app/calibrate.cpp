// SPDX-License-Identifier: MIT
#include "app/calibrate.hpp"

#include "app/exit_code.hpp"
#include "app/scale_input.hpp"
#include "calibrate/observations.hpp"
#include "cases/read_case.hpp"
#include "reports/calibration.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace app {

namespace {

struct CalibrateOptions {
    CommonOptions common;
    std::string path;
    bool replay = false;
};

constexpr const char* examples = R"(Examples:
  similitude calibrate data/zirconia/case.json --replay --report out/replay.html
      the paper's calibration computed again from its own runs, and what they can carry
  similitude calibrate data/zirconia/case.json --replay --json - --quiet
      every printed number beside the recomputed one; exit code 3 where one differs or the ranking
      cannot be concluded)";

int run(const CalibrateOptions& o, const std::string& command) {
    if (!o.replay)
        throw scaling::InvalidInput(
            scaling::mistake("calibrate", "no --replay", "must say what to do",
                             "--replay audits the calibration in published.json beside the case"));
    const cases::Case c = cases::read_case(o.path);
    const calibrate::Replayed r = calibrate::replayed(c, scale_input(c, {}));
    const reports::Provenance who = provenance(command, o.path);
    reports::Json json = {{"format", "similitude-replay/1"}, {"tool", reports::to_json(who)}};
    json.update(reports::to_json(r));
    print(o.common, reports::text_of(r));
    write_results(o.common, json, [&] { return reports::page_of(r, who); });
    return r.holds() ? fine : answer_is_no;
}

}  // namespace

Verb calibrate_verb(CLI::App& app, const std::string& command) {
    const auto options = std::make_shared<CalibrateOptions>();
    CLI::App* verb =
        app.add_subcommand("calibrate", "a published calibration, replayed and audited");
    verb->add_option("CASE", options->path, "case.json or its folder")->required();
    verb->add_flag("--replay", options->replay,
                   "compute published.json beside the case again and audit it");
    add_common(*verb, options->common);
    verb->footer(examples);
    return {verb, [options, command] { return run(*options, command); }};
}

}  // namespace app
