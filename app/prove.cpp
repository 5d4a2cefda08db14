// SPDX-License-Identifier: MIT
#include "app/prove.hpp"

#include "app/campaign.hpp"
#include "app/exit_code.hpp"
#include "app/heap_campaign.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/version.hpp"
#include "reports/proof.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace app {
namespace {

struct ProveOptions {
    CommonOptions common;
    Campaign campaign;
    std::string out = "out/prove", kind;
    bool score_only = false;
    CLI::Option* limit = nullptr;
    std::string lammps = "lmp";
    double size = 1.0;

    bool heaps() const { return campaign.extent.rig == "pile"; }
    HeapCampaign heap_campaign() const { return {campaign, lammps, size}; }
};

constexpr const char* examples = R"(Examples:
  similitude prove --cases 120 --seed 7
      makes 120 blind cases, has `similitude diagnose` judge each, opens the keys, tells the score
  similitude prove --cases 1200 --seed 7 --shard 1/4 --resume
      goes on with the first quarter of 1200
  similitude prove --cases 1200 --seed 7 --score-only --report out/score.html
      the score of all that has been judged so far, as a page
  similitude prove --cases 20 --seed 7 --kind single --rig drop --write-only --out out/drops
      the first 20 of that seed that conceal one effect from a falling grain, judged by nobody
  similitude prove --rig pile --cases 100 --seed 7 --resume
      heaps whose truth LAMMPS pours, in families of 20 (docs/prove-heaps.md))";

reports::Json json_of(const prove::Line& line) {
    reports::Json json = {{"figure", line.figure}, {"bar", line.bar}, {"count", line.count}};
    json["value"] = line.count > 0 ? reports::Json(line.value) : reports::Json(nullptr);
    json["wilson95"] = line.bounds
                           ? reports::Json(std::vector<double>{line.bounds->low, line.bounds->high})
                           : reports::Json(nullptr);
    json["met"] = line.met ? reports::Json(*line.met) : reports::Json(nullptr);
    json["note"] = line.note;
    return json;
}

reports::Json json_of(const Result& result, const ProveOptions& o, const std::string& command) {
    const prove::ScoreTable& t = result.table;
    reports::Json lines = reports::Json::array(), bins = reports::Json::array();
    for (const prove::Line& line : t.lines) lines.push_back(json_of(line));
    for (const prove::Calibration::Bin& b : t.calibration.bins)
        bins.push_back({{"told", b.probability}, {"came_true", b.frequency}, {"count", b.count}});
    return {{"format", "similitude-prove/1"},
            {"tool", {{"version", version}, {"git", git}, {"command", command}}},
            {"seed", o.campaign.extent.seed},
            {"cases", t.cases},
            {"without_verdict", t.missing},
            {"lines", lines},
            {"confusion", t.confusion},
            {"calibration",
             {{"expected_error", t.calibration.expected_error},
              {"expected_error_top", t.calibration.expected_error_top},
              {"brier", t.calibration.brier},
              {"bins", bins}}},
            {"cpu_seconds_per_case",
             {{"mean", result.times.mean},
              {"longest", result.times.longest},
              {"limit", o.campaign.limit},
              {"judged", result.times.count},
              {"failures", result.times.failures}}}};
}

std::string cost_of(const Result& result, const ProveOptions& o) {
    return fmt::format(
        "Processor time of a verdict: {:.2f} s on average, {:.1f} s the longest, {} judged, {} of "
        "them in vain (limit {:g} s)",
        result.times.mean, result.times.longest, result.times.count, result.times.failures,
        o.campaign.limit);
}

std::vector<std::string> limits_of(const ProveOptions& o) {
    std::vector<std::string> list{
        "Generator and judge share no code, but one reading of what each effect is "
        "(docs/effects.md): an effect that is misread on both sides goes unseen."};
    if (o.heaps())
        list.emplace_back(
            "The truth is another engine's, under the same contact laws: what real grains do "
            "beyond these is not tried. What the oracle could tell rests on its own heaps.");
    else
        list.emplace_back(
            "Physics that nobody thought of is stood in for by eight kinds from outside the "
            "catalogue. Real recordings are judged in docs/recordings.md.");
    return list;
}

int tell(const ProveOptions& o, const std::string& command) {
    const Result result = o.heaps() ? score(o.heap_campaign()) : score(o.campaign);
    print(o.common, prove::text(result.table) + '\n' + cost_of(result, o) + '\n');
    write_results(o.common, json_of(result, o, command), [&] {
        reports::Provenance who = provenance(command, "");
        who.seeds = {o.campaign.extent.seed};
        return reports::page_of(result.table, cost_of(result, o), limits_of(o), who);
    });
    const bool missed = std::any_of(result.table.lines.begin(), result.table.lines.end(),
                                    [](const prove::Line& line) { return line.met == false; });
    return missed ? answer_is_no : fine;
}

int run(ProveOptions o, const std::string& command) {
    Campaign& c = o.campaign;
    c.extent.seed = o.common.seed;
    if (!o.kind.empty()) c.extent.kind = prove::kind_of(o.kind);
    c.out = o.out;
    c.threads = threads_of(o.common);
    c.resume = o.common.resume;
    if (o.heaps()) {
        constexpr double longest = 2400.0;  // 20 minutes on two cores
        if (o.limit->count() == 0) c.limit = longest;
        if (c.extent.kind)
            throw scaling::InvalidInput(scaling::mistake("--kind", '"' + o.kind + '"',
                                                         "is of single grains' cases",
                                                         "leave it out with --rig pile"));
    }
    if (o.score_only) return tell(o, command);
    watch_interrupts();
    bool whole = false;
    {
        Progress progress(!o.common.quiet);
        progress.start(0.0);
        const auto show = [&progress](double done, double of, const std::string& name) {
            progress.show(done, of, name);
        };
        whole = o.heaps() ? work(o.heap_campaign(), show, interrupt_flag())
                          : work(c, show, interrupt_flag());
    }
    if (!whole) {
        fmt::print(stderr, "similitude: interrupted; the same command with --resume goes on\n");
        return interrupted;
    }
    return c.write_only ? fine : tell(o, command);
}

}  // namespace

Verb prove_verb(CLI::App& app, const std::string& command) {
    const auto options = std::make_shared<ProveOptions>();
    Campaign& c = options->campaign;
    c.judge = "/proc/self/exe";
    CLI::App* verb =
        app.add_subcommand("prove", "blind cases with concealed effects, judged and scored");
    verb->add_option("--cases", c.extent.cases, "how many")->capture_default_str();
    verb->add_option("--kind", options->kind,
                     "only null, single, look_alike, pair, outside or numerical");
    verb->add_option("--rig", c.extent.rig,
                     "only this rig of single grains; or pile: heaps, poured by LAMMPS");
    verb->add_option("--lammps", options->lammps, "LAMMPS, for --rig pile")
        ->type_name("PROGRAM")
        ->capture_default_str();
    verb->add_option("--size", options->size, "of --rig pile: 1000 times this many grains a heap")
        ->check(CLI::Range(0.05, 100.0))
        ->capture_default_str();
    verb->add_option("--shard", c.extent.shard, "i/n: every n-th case, beginning with the i-th")
        ->capture_default_str();
    verb->add_option("--out", options->out, "folder")->type_name("DIR")->capture_default_str();
    options->limit = verb->add_option("--limit", c.limit,
                                      "seconds of processor time for a case; then it is wrong; "
                                      "with --rig pile 2400 unless given")
                         ->check(CLI::Range(1.0, 1e5))
                         ->capture_default_str();
    verb->add_option("--judge-seed", c.judge_seed, "the seed that the judge is given")
        ->capture_default_str();
    verb->add_option("--stability", c.stability,
                     "judge the first N single effects with D >= 5 with 19 more seeds")
        ->capture_default_str();
    verb->add_option("--judge", c.judge,
                     "another program that takes the arguments of `similitude diagnose`")
        ->type_name("PROGRAM");
    CLI::Option* write_only = verb->add_flag("--write-only", c.write_only, "judge none");
    verb->add_flag("--score-only", options->score_only, "judge none, score what has been judged")
        ->excludes(write_only);
    add_common(*verb, options->common);
    verb->footer(examples);
    return {verb, [options, command] { return run(*options, command); }};
}

}  // namespace app
