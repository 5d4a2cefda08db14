// SPDX-License-Identifier: MIT
#include "app/calibrate_campaign.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "cases/read_case.hpp"
#include "reports/road.hpp"
#include "verify/pile_runs.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <optional>

namespace app {

namespace {

// Nothing where a signal came.
std::optional<calibrate::Calibration> calibrated(const cases::Case& c, const RoadOptions& o,
                                                 bool quiet) {
    Progress progress(!quiet);
    const CalibrationWatch watch{
        .progress =
            [&progress](double done, double of, const std::string& ended) {
                progress.show(done, of, ended.empty() ? "heaps" : "heaps, last finished: " + ended);
            },
        .stop = &interrupt_flag()};
    try {
        return calibration(c, o, watch);
    } catch (const verify::Interrupted&) {
        return std::nullopt;
    }
}

}  // namespace

void add_campaign_options(CLI::App& verb, CampaignOptions& campaign) {
    RoadOptions& o = campaign.road;
    verb.add_option("--experiment", o.experiment, "the pile; the first with a recording otherwise")
        ->type_name("ID");
    verb.add_option("--road", o.road, "surrogate, or paper (Niu et al. 2026)")
        ->type_name("ROAD")
        ->capture_default_str();
    verb.add_option("--budget", o.budget,
                    "heaps that the surrogate's road may pour on its way to the answer")
        ->check(CLI::Range(4, 100'000))
        ->capture_default_str();
    verb.add_option("--batch", o.batch, "of these so many are decided on together")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    verb.add_option("--confirm", o.confirm, "heaps of fresh seeds at the answer, on top")
        ->check(CLI::Range(0, 100'000))
        ->capture_default_str();
    verb.add_option("--estimator", o.estimator,
                    "of the recorded angles only these; all are of one otherwise")
        ->type_name("NAME");
    verb.add_flag("--bulk-density", o.bulk_density,
                  "the case's stated bulk density is to be met as well");
    verb.add_option("--at", o.at,
                    "take no road: pour --confirm heaps at the case's own values, with these in "
                    "their place")
        ->type_name("NAME=VALUE ...")
        ->expected(1, 100);
    verb.add_option("--friction-cap", o.friction_cap,
                    "what friction multiplies, in place of the case's (docs/laws/friction_cap.md)")
        ->type_name("NAME");
    add_heaps_engine(verb, o.heaps);
    verb.add_flag("--yes", o.yes, "run even where the estimate says more than 12 hours");
    verb.add_option("--out", o.out, "folder for runs.csv and finished heaps")
        ->type_name("DIR")
        ->capture_default_str();
}

int calibrate_campaign(const CampaignOptions& o, const std::string& command) {
    const cases::Case c = cases::read_case(o.path);
    RoadOptions road = o.road;
    road.seed = o.common.seed, road.threads = threads_of(o.common), road.resume = o.common.resume;
    watch_interrupts();
    const auto done = calibrated(c, road, o.common.quiet);
    if (!done) {
        fmt::print(stderr, "similitude: interrupted; the same command with --resume goes on\n");
        return interrupted;
    }
    reports::Provenance who = provenance(command, o.path);
    who.threads = road.threads;
    who.seeds = {road.seed};
    const reports::Json json = reports::to_json(*done, who);
    print(o.common, reports::text_of(*done));
    write_results(o.common, json, [&] { return reports::page_of(c, *done, who); });
    if (!done->answer()) return cannot_tell;
    return calibrate::holds(*done) ? fine : answer_is_no;
}

}  // namespace app
