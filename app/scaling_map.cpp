// SPDX-License-Identifier: MIT
#include "app/scaling_map.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/version.hpp"
#include "cases/messages.hpp"
#include "cases/units.hpp"
#include "reports/scaling_map.hpp"
#include "reports/scaling_map_json.hpp"
#include "scaling/errors.hpp"
#include "verify/scaling_map_runs.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace app {

namespace {

namespace fs = std::filesystem;
using scaling::InvalidInput;
using scaling::mistake;

struct MapOptions {
    CommonOptions common;
    std::string heaps = "out/scaling-map.csv", shard = "1/1", budget = "12 h";
    bool small = false, tiny = false;
};

constexpr const char* examples = R"(Examples:
  similitude verify scaling-map --small --report out/map.html
      some heaps of 1 600 grains and fewer: minutes
  similitude verify scaling-map --heaps data/scaling-map/heaps.csv --resume --json out/map.json
      what is missing of the whole map is added to that file: hours, a few at a time if need be)";

struct Shard {
    int number, of;
};

Shard shard_from(const std::string& text) {
    Shard s{};
    char rest = 0;
    if (std::sscanf(text.c_str(), "%d/%d%c", &s.number, &s.of, &rest) != 2 || s.of < 1 ||
        s.of > 1000 || s.number < 1 || s.number > s.of)
        throw InvalidInput(mistake("--shard", cases::in_quotes(text),
                                   "must be i/n with 1 <= i <= n <= 1000", "1/2 and 2/2, say"));
    return s;
}

verify::MapExtent extent_of(const MapOptions& o) {
    return o.tiny    ? verify::MapExtent::tiny
           : o.small ? verify::MapExtent::small
                     : verify::MapExtent::full;
}

// Heaps of hours must not go because somebody forgot a flag.
void refuse_to_forget(const fs::path& heaps, bool resume) {
    if (resume || !fs::exists(heaps)) return;
    throw InvalidInput(mistake("--heaps", heaps.string() + ", which holds finished heaps",
                               "must be no file yet unless --resume is given",
                               "say --resume to go on from them, or another --heaps"));
}

int run(const MapOptions& o, const std::string& command) {
    const Shard shard = shard_from(o.shard);
    const double budget = cases::quantity<scaling::Time>(o.budget, "--budget").value();
    refuse_to_forget(o.heaps, o.common.resume);
    watch_interrupts();
    const verify::MapPlan plan = verify::map_plan(extent_of(o));
    Progress progress(!o.common.quiet);
    verify::MapRun pouring;
    pouring.threads = threads_of(o.common);
    pouring.heaps = o.heaps;
    pouring.git = git;
    pouring.shard = shard.number, pouring.shards = shard.of;
    pouring.budget = budget;
    pouring.stop = &interrupt_flag();
    pouring.progress = [&progress](double done, double of, const std::string& ended) {
        progress.show(done, of, ended.empty() ? "heaps" : "heaps, last finished: " + ended);
    };
    const verify::MapEnd end = verify::pour_map(plan, o.common.seed, pouring);
    if (end == verify::MapEnd::stopped) {
        fmt::print(stderr, "similitude: interrupted; the same command with --resume goes on\n");
        return interrupted;
    }
    const verify::ScalingMap map = verify::gather_map(plan, o.common.seed, o.heaps);
    reports::Provenance who = provenance(command, "");
    who.threads = pouring.threads;
    print(o.common, reports::text_of(map));
    write_results(o.common, reports::to_json(map, who), [&] { return reports::page_of(map, who); });
    return end == verify::MapEnd::complete ? fine : cannot_tell;
}

}  // namespace

Verb scaling_map_verb(CLI::App& verify, const std::string& command) {
    const auto options = std::make_shared<MapOptions>();
    CLI::App* verb =
        verify.add_subcommand("scaling-map", "which scaling rule keeps which pile, over seeds");
    auto* small = verb->add_flag("--small", options->small, "small heaps and few cells: minutes");
    verb->add_flag("--tiny", options->tiny, "one cell of two and two heaps of 143 grains: seconds")
        ->excludes(small);
    verb->add_option("--shard", options->shard, "this part of the heaps: 1/2, then 2/2 beside it")
        ->type_name("I/N")
        ->capture_default_str();
    verb->add_option("--budget", options->budget,
                     "no heap begins that would end later; what is missing is told")
        ->type_name("TIME")
        ->capture_default_str();
    verb->add_option("--heaps", options->heaps,
                     "CSV to which each finished heap is added; with --resume those in it count")
        ->type_name("FILE")
        ->capture_default_str();
    add_common(*verb, options->common);
    verb->footer(examples);
    return {verb, [options, command] { return run(*options, command); }};
}

}  // namespace app
