// SPDX-License-Identifier: MIT
#include "app/verify.hpp"

#include "app/exit_code.hpp"
#include "app/heaps_engine.hpp"
#include "app/interrupt.hpp"
#include "app/machine_speed.hpp"
#include "app/progress.hpp"
#include "app/remembered_campaign.hpp"
#include "app/scale_input.hpp"
#include "app/scaling_map.hpp"
#include "app/verify_against.hpp"
#include "app/verify_compression.hpp"
#include "cases/read_case.hpp"
#include "reports/checks.hpp"
#include "scaling/errors.hpp"
#include "verify/exact_answers.hpp"
#include "verify/similarity.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace app {

namespace {

struct VerifyOptions {
    CommonOptions common;
    std::string path = "data/zirconia/case.json", out = "out";
    std::string against;  // another engine; empty: none
    bool small = false, full = false, exact_only = false, sleep = false;
    std::string experiment;  // with --sleep; empty: the first pile with a count of grains
    int seeds = 0;           // a side, with --sleep; 0: 3 with --small, else 12
    HeapsEngine heaps;
};

constexpr const char* examples = R"(Examples:
  similitude verify data/zirconia/case.json --report out/zirconia.html
      exact answers, the same bits after rescaling, scaled heaps against reference heaps
  similitude verify --exact --json -
      only the exact answers, in a few seconds
  similitude verify --against lammps --report out/lammps.html
      our core beside LAMMPS on the same rules; with --small without the heaps
  similitude verify data/slow-feed --sleep --seeds 12 --json out/sleep.json
      heaps that may sleep against heaps that stay awake, and what sleep saves
  similitude verify data/zirconia/case.json --small --engine lammps --ranks 2 --contact lammps
      the scaled heaps against the reference heaps, all of them run by LAMMPS
  similitude verify compression --small
      a powder of larger grains compressed and crushed, by the rule of its adhesion)";

verify::Campaign campaign_of(const VerifyOptions& o, Progress& progress) {
    return remembered_campaign(o.common, std::filesystem::path(o.out) / "similitude-heaps",
                               progress, "heaps");
}

verify::Extent extent_of(const VerifyOptions& o) {
    return o.small  ? verify::Extent::small
           : o.full ? verify::Extent::full
                    : verify::Extent::standard;
}

// The study that belongs to the heaps, with the case's own scheme beside it.
void add_scaling(reports::Page& page, const cases::Case& c, int threads) {
    const double speed = measured_speed(threads);
    ScaleOverrides heaps;
    heaps.scheme = "kept_gravity";
    page.study = study_of(c, heaps, speed);
    if (c.scaling && c.scaling->scheme != heaps.scheme) page.beside = study_of(c, {}, speed);
}

reports::Page page_of(const std::optional<cases::Case>& c, const reports::Verification& v,
                      const reports::Provenance& who, int threads) {
    reports::Page page{.title = c && !c->title.empty() ? c->title : "Exact answers",
                       .source = c ? c->source : "",
                       .verdict = reports::verdict_of(v),
                       .verification = v,
                       .limits = reports::limits_of(v),
                       .provenance = who};
    if (!c || v.sleep) return page;
    add_scaling(page, *c, threads);
    for (const std::string& limit : reports::limits_of(*page.study)) page.limits.push_back(limit);
    return page;
}

reports::Provenance provenance_of(const VerifyOptions& o, const std::string& command,
                                  const reports::Verification& v) {
    reports::Provenance who = provenance(command, o.exact_only ? "" : o.path);
    who.threads = threads_of(o.common);
    for (const verify::Comparison* c : reports::comparisons_of(v))
        for (const verify::Side* side : {&c->reference, &c->scaled})
            for (const verify::PileSample& s : side->samples)
                if (std::find(who.seeds.begin(), who.seeds.end(), s.seed) == who.seeds.end())
                    who.seeds.push_back(s.seed);
    return who;
}

// The pile whose heaps may sleep.
const cases::Experiment& pile_of(const cases::Case& c, const std::string& id) {
    const cases::Experiment* chosen = id.empty() ? nullptr : c.find(id);
    std::string known;
    for (const cases::Experiment& e : c.experiments) {
        if (e.rig != "pile") continue;
        known += (known.empty() ? "" : ", ") + e.id;
        const bool counted = e.conditions.at("grains").kind == cases::Value::Kind::number;
        if (id.empty() && chosen == nullptr && counted) chosen = &e;
    }
    if (chosen == nullptr || chosen->rig != "pile")
        throw scaling::InvalidInput(scaling::mistake(
            id.empty() ? c.path + ": experiments" : "--experiment",
            id.empty() ? "no pile with a count of grains" : id, "must be a pile of this case",
            known.empty() ? "this case has none" : "piles: " + known));
    return *chosen;
}

void run_heaps(const VerifyOptions& o, const cases::Case& c, reports::Verification& v) {
    Progress progress(!o.common.quiet);
    const EngineChoice choice = choice_of(o.heaps);
    verify::Campaign campaign = campaign_of(o, progress);
    const std::unique_ptr<rigs::PileEngine> engine = engine_of(choice, campaign.remembered_in);
    campaign.engine = engine.get();
    const int seeds = o.seeds > 0 ? o.seeds : o.small ? 3 : 12;
    if (o.sleep)
        v.sleep = verify::sleep_study(c, pile_of(c, o.experiment), seeds, o.common.seed, campaign);
    else
        v.similarity = verify::similarity(c, extent_of(o), o.common.seed, campaign,
                                          {.lammps_rules = choice.lammps_rules});
}

int run(const VerifyOptions& o, const std::string& command) {
    if (!o.against.empty()) return verify_against(o.common, o.out, !o.small, command);
    std::optional<cases::Case> c;
    if (!o.exact_only) c = cases::read_case(o.path);
    watch_interrupts();
    reports::Verification v{};
    if (!o.sleep) v.checks = verify::exact_answers();
    try {
        if (c) run_heaps(o, *c, v);
    } catch (const verify::Interrupted&) {
        fmt::print(stderr, "similitude: interrupted; the same command with --resume goes on\n");
        return interrupted;
    }
    const reports::Provenance who = provenance_of(o, command, v);
    reports::Json json = {{"format", "similitude-verification/1"}, {"tool", reports::to_json(who)}};
    json.update(reports::to_json(v));
    print(o.common, (c && !c->title.empty() ? c->title + "\n" : "") + reports::text_of(v));
    write_results(o.common, json, [&] { return page_of(c, v, who, threads_of(o.common)); });
    return exit_code_of(reports::verdict_of(v).answer);
}

}  // namespace

Verb verify_verb(CLI::App& app, const std::string& command) {
    const auto options = std::make_shared<VerifyOptions>();
    CLI::App* verb =
        app.add_subcommand("verify", "exact answers, and scaled heaps against reference heaps");
    verb->add_option("CASE", options->path, "case.json or its folder")->capture_default_str();
    auto* small = verb->add_flag("--small", options->small,
                                 "3 seeds a side: intervals are shown, equivalence is not claimed");
    auto* full =
        verb->add_flag("--full", options->full, "every scheme, invariant, control and seed: hours");
    auto* exact = verb->add_flag("--exact", options->exact_only, "no heaps");
    small->excludes(full)->excludes(exact);
    full->excludes(exact);
    auto* against =
        verb->add_option("--against", options->against, "our core beside another engine; no CASE")
            ->check(CLI::IsMember({"lammps"}))
            ->excludes(full)
            ->excludes(exact);
    auto* sleep = verb->add_flag("--sleep", options->sleep,
                                 "the case's pile with quiet regions left out, against the same "
                                 "without; and what that saves");
    sleep->excludes(full)->excludes(exact)->excludes(against);
    verb->add_option("--experiment", options->experiment, "the pile for --sleep; else the first")
        ->type_name("ID")
        ->needs(sleep);
    verb->add_option("--seeds", options->seeds, "heaps a side for --sleep, 12 by default")
        ->check(CLI::Range(2, 1000))
        ->needs(sleep);
    add_heaps_engine(*verb, options->heaps);
    for (const char* option : {"--engine", "--contact"})
        verb->get_option(option)->excludes(exact)->excludes(against)->excludes(sleep);
    verb->add_option("--out", options->out, "folder in which finished heaps are remembered")
        ->type_name("DIR")
        ->capture_default_str();
    add_common(*verb, options->common);
    verb->footer(examples);
    const auto of_compression = std::make_shared<CompressionOptions>();
    const CLI::App* compression = add_compression(*verb, *of_compression);
    const Verb map = scaling_map_verb(*verb, command);
    return {verb, [options, of_compression, compression, map, command] {
                return compression->parsed() ? verify_compression(*of_compression, command)
                       : map.app->parsed()   ? map.run()
                                             : run(*options, command);
            }};
}

}  // namespace app
