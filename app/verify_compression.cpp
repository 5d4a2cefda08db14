// SPDX-License-Identifier: MIT
#include "app/verify_compression.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/remembered_campaign.hpp"
#include "reports/compression.hpp"
#include "verify/compression_study.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace app {

namespace {

constexpr const char* examples = R"(Examples:
  similitude verify compression --small --threads 1
      128 grains for 1020, 3 seeds: intervals are shown, little can be claimed
  similitude verify compression --seeds 12 --resume --report out/compression.html
      1020 to 8168 grains; half an hour on 2 cores, goes on where it was stopped)";

verify::CompressionPlan plan_of(const CompressionOptions& o) {
    verify::CompressionPlan plan = o.small ? verify::small_plan() : verify::CompressionPlan{};
    if (o.seeds > 0) plan.seeds = o.seeds;
    plan.among_larger = o.among_larger;
    return plan;
}

// Nothing where a signal came.
std::optional<verify::CompressionStudy> studied(const CompressionOptions& o) {
    Progress progress(!o.common.quiet);
    const verify::Campaign campaign = remembered_campaign(
        o.common, std::filesystem::path(o.out) / "similitude-compression", progress, "samples");
    try {
        return verify::compression_study(plan_of(o), o.common.seed, campaign);
    } catch (const verify::Interrupted&) {
        return {};
    }
}

std::vector<std::uint64_t> seeds_of(const verify::CompressionStudy& study) {
    std::vector<std::uint64_t> seeds;
    const auto take = [&](const verify::CompressionSide& side) {
        for (const verify::CompressionSample& s : side.samples)
            if (std::find(seeds.begin(), seeds.end(), s.seed) == seeds.end())
                seeds.push_back(s.seed);
    };
    for (const verify::RuleResult& r : study.rules) {
        take(r.reference);
        for (const verify::CompressionCellResult& cell : r.cells) take(cell.side);
    }
    take(study.half_speed.side);
    return seeds;
}

}  // namespace

CLI::App* add_compression(CLI::App& verify, CompressionOptions& o) {
    CLI::App* verb = verify.add_subcommand(
        "compression",
        "a powder of larger grains compressed and crushed, by the rule that its "
        "adhesion follows");
    auto* small =
        verb->add_flag("--small", o.small, "a cell half as wide, h = 2 alone, 3 seeds: a minute");
    verb->add_flag("--among-larger", o.among_larger,
                   "without h = 1, which takes most of the time: h = 1.5 and 2 against 1.25")
        ->excludes(small);
    verb->add_option("--seeds", o.seeds, "samples a side, 10 by default")
        ->check(CLI::Range(2, 1000));
    verb->add_option("--out", o.out, "folder in which finished samples are remembered")
        ->type_name("DIR")
        ->capture_default_str();
    add_common(*verb, o.common);
    verb->footer(examples);
    return verb;
}

int verify_compression(const CompressionOptions& o, const std::string& command) {
    watch_interrupts();
    const auto study = studied(o);
    if (!study) {
        fmt::print(stderr, "similitude: interrupted; the same command with --resume goes on\n");
        return interrupted;
    }
    reports::Provenance who = provenance(command, "");
    who.threads = threads_of(o.common);
    who.seeds = seeds_of(*study);
    reports::Json json = {{"format", "similitude-compression/1"}, {"tool", reports::to_json(who)}};
    json.update(reports::to_json(*study));
    print(o.common, reports::text_of(*study));
    write_results(o.common, json, [&] { return reports::page_of(*study, who); });
    return exit_code_of(reports::verdict_of(*study).answer);
}

}  // namespace app
