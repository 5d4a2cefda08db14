// SPDX-License-Identifier: MIT
#include "app/bench.hpp"

#include "app/bench_results.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace app {

namespace {

struct BenchOptions {
    CommonOptions common;
    std::vector<std::string> against;
    std::string bed = "30x30x50", out = "out";
    int repeats = 3, warm_up = engines::Bed{}.warm_up, steps = engines::Bed{}.steps;
    int largest = 1'000'000;
    bool scaling = false, polydisperse = false;
};

constexpr const char* examples = R"(Examples:
  similitude bench --against lammps --report out/bench.html
      the same 45 000 grains in turn, ours and theirs, three times
  similitude bench --scaling --polydisperse --json out/bench.json
      our own cost from 1e3 to 1e6 grains, and on grains of two sizes)";

constexpr double triad_bytes = 256e6;  // B, no cache holds that
constexpr double grain_steps = 1e7;    // a few seconds for each point of --scaling
constexpr int mixed_cells = 4;         // 4 x 4 x 2 large grains, some 10^4 in all
constexpr int mixed_warm_up = 6000;    // steps, for grains to fall as far as they are wide
constexpr int mixed_steps = 500;

engines::Bed bed_of(const BenchOptions& o) {
    engines::Bed bed;
    int end = 0;
    const bool read =
        std::sscanf(o.bed.c_str(), "%4dx%4dx%4d%n", &bed.nx, &bed.ny, &bed.nz, &end) == 3 &&
        static_cast<std::size_t>(end) == o.bed.size();
    // Below three, a grain would touch its own image in the next period.
    if (!read || bed.nx < 3 || bed.ny < 3 || bed.nz < 1)
        throw scaling::InvalidInput(
            scaling::mistake("--bed", '"' + o.bed + '"',
                             "must be grains along x, y and z, at least 3x3x1", "write 30x30x50"));
    bed.seed = o.common.seed;
    bed.warm_up = o.warm_up;
    bed.steps = o.steps;
    return bed;
}

void refuse_resume(const BenchOptions& o) {
    if (o.common.resume)
        throw scaling::InvalidInput(
            scaling::mistake("--resume", "set", "must be left out of bench",
                             "a measurement that was interrupted is made anew"));
}

// Stops the bench from inside where a signal has come.
bench::Told told(Progress& progress) {
    return [&progress](double share, const std::string& what) {
        if (interrupt_flag()) throw bench::Interrupted{};
        progress.show(share, 1.0, what);
    };
}

std::vector<int> teams(int threads) {
    return threads > 1 ? std::vector<int>{1, threads} : std::vector<int>{1};
}

BenchResults measured(const BenchOptions& o, const engines::Bed& bed,
                      const std::vector<engines::BedEngine>& peers) {
    Progress progress(!o.common.quiet);
    const int threads = threads_of(o.common);
    BenchResults r{bench::this_machine(), {}, {}, {}, {}};
    if (o.scaling)
        r.scaling =
            bench::scaling_study(o.largest, grain_steps, o.repeats, teams(threads), told(progress));
    if (o.polydisperse)
        r.polydisperse = bench::polydisperse_study(mixed_cells, mixed_warm_up, mixed_steps,
                                                   o.repeats, threads, told(progress));
    if (!o.scaling && !o.polydisperse)
        r.comparison = bench::compare(bed, peers, o.repeats, threads,
                                      std::filesystem::path(o.out) / "bench", told(progress));
    for (const int team : teams(threads))
        r.triads.push_back({triad_bytes, team, bench::triad_bandwidth(triad_bytes, team)});
    return r;
}

int run(const BenchOptions& o, const std::string& command) {
    refuse_resume(o);
    const engines::Bed bed = bed_of(o);
    std::vector<engines::BedEngine> peers;
    if (!o.scaling && !o.polydisperse) peers = bench::engines_for(o.against);
    watch_interrupts();
    BenchResults r;
    try {
        r = measured(o, bed, peers);
    } catch (const bench::Interrupted&) {
        return interrupted;
    } catch (const std::exception&) {
        if (interrupt_flag()) return interrupted;  // the engine that ran then got the signal too
        throw;
    }
    reports::Provenance who = provenance(command, "");
    who.threads = threads_of(o.common);
    reports::Json json = {{"format", "similitude-bench/1"}, {"tool", reports::to_json(who)}};
    json.update(to_json(r));
    print(o.common, text_of(r));
    write_results(o.common, json, [&] {
        return reports::Page{.title = "Speed of the DEM core",
                             .source = r.machine.processor,
                             .verdict = verdict_of(r),
                             .runs = sections_of(r),
                             .limits = limits_of(r),
                             .provenance = who};
    });
    return fine;
}

}  // namespace

Verb bench_verb(CLI::App& app, const std::string& command) {
    const auto o = std::make_shared<BenchOptions>();
    CLI::App* verb = app.add_subcommand("bench", "speed against other engines on the same bed");
    auto* against =
        verb->add_option("--against", o->against,
                         "lammps, liggghts, yade; those that are on this machine otherwise")
            ->type_name("NAMES")
            ->delimiter(',');
    verb->add_option("--repeats", o->repeats, "runs of each, in turn")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    verb->add_option("--bed", o->bed, "grains along x, y and z")
        ->type_name("NXxNYxNZ")
        ->capture_default_str();
    verb->add_option("--warm-up", o->warm_up, "steps before the clock starts")
        ->check(CLI::Range(0, 100'000'000))
        ->capture_default_str();
    verb->add_option("--steps", o->steps, "steps that are timed")
        ->check(CLI::Range(1, 100'000'000))
        ->capture_default_str();
    verb->add_option("--out", o->out, "folder for decks and what the engines print")
        ->type_name("DIR")
        ->capture_default_str();
    verb->add_flag("--scaling", o->scaling, "instead: our cost from 1e3 to 1e6 grains")
        ->excludes(against);
    verb->add_option("--largest", o->largest, "of --scaling: no more grains than this")
        ->check(CLI::Range(1000, 1'000'000))
        ->capture_default_str();
    verb->add_flag("--polydisperse", o->polydisperse,
                   "instead: our cost on sizes 1 to 10 against one size")
        ->excludes(against);
    add_common(*verb, o->common);
    verb->footer(examples);
    return {verb, [o, command] { return run(*o, command); }};
}

}  // namespace app
