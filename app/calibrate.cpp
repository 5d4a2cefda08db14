// SPDX-License-Identifier: MIT
#include "app/calibrate.hpp"

#include "app/calibrate_campaign.hpp"
#include "app/exit_code.hpp"
#include "app/scale_input.hpp"
#include "calibrate/observations.hpp"
#include "cases/read_case.hpp"
#include "reports/calibration.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <utility>

namespace app {

namespace {

struct CalibrateOptions {
    CampaignOptions campaign;
    bool replay = false;
};

constexpr const char* examples = R"(Examples:
  similitude calibrate my-powder --out out/calibration --report out/calibration.html
      heaps are poured until the case's free parameters give its recorded angle of repose; with
      --resume it goes on after an interrupt, and no heap that had come to rest is lost
  similitude calibrate my-powder --road paper --out out/paper
      as the paper does it: screening, steepest ascent, 3 x 3, a line
  similitude calibrate my-powder --at "work_of_adhesion=0.4 J/m^2" sliding_friction=0.8 --seed 101
      six heaps at a given point: do they form, and what is their angle
  similitude calibrate data/zirconia/case.json --replay --report out/replay.html
      the paper's calibration computed again from its own runs, and what they can carry; exit
      code 3 where a printed number differs or the ranking cannot be concluded)";

int replay(const CampaignOptions& o, const std::string& command) {
    const cases::Case c = cases::read_case(o.path);
    calibrate::Published published = calibrate::read_published(c.path);
    const calibrate::Replayed r = calibrate::replayed(std::move(published), c, scale_input(c, {}));
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
    CLI::App* verb = app.add_subcommand(
        "calibrate", "free parameters from recorded heaps; a published calibration audited");
    verb->add_option("CASE", options->campaign.path, "case.json or its folder")->required();
    verb->add_flag("--replay", options->replay,
                   "pour nothing: compute published.json beside the case again and audit it");
    add_campaign_options(*verb, options->campaign);
    verb->get_option("--replay")->excludes(verb->get_option("--at"));
    add_common(*verb, options->campaign.common);
    verb->footer(examples);
    return {verb, [options, command] {
                return options->replay ? replay(options->campaign, command)
                                       : calibrate_campaign(options->campaign, command);
            }};
}

}  // namespace app
