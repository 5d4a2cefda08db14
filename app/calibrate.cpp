// SPDX-License-Identifier: MIT
#include "app/calibrate.hpp"

#include "app/calibrate_campaign.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace app {

namespace {

constexpr const char* examples = R"(Examples:
  similitude calibrate my-powder --out out/calibration --report out/calibration.html
      heaps are poured until the case's free parameters give its recorded angle of repose
  similitude calibrate my-powder --out out/calibration --resume
      go on after an interrupt: no heap that had come to rest is lost
  similitude calibrate my-powder --road paper --out out/paper
      as the paper does it: screening, steepest ascent, 3 x 3, a line)";

}  // namespace

Verb calibrate_verb(CLI::App& app, const std::string& command) {
    const auto options = std::make_shared<CampaignOptions>();
    CLI::App* verb = app.add_subcommand(
        "calibrate", "free parameters from recorded heaps, with what they cannot tell");
    verb->add_option("CASE", options->path, "case.json or its folder")->required();
    add_campaign_options(*verb, *options);
    add_common(*verb, options->common);
    verb->footer(examples);
    return {verb, [options, command] { return calibrate_campaign(*options, command); }};
}

}  // namespace app
