// SPDX-License-Identifier: MIT
#include "app/diagnose.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/lammps_base.hpp"
#include "app/poured_heaps.hpp"
#include "app/predictions.hpp"
#include "app/progress.hpp"
#include "cases/read_case.hpp"
#include "diagnose/piles.hpp"
#include "reports/diagnosis.hpp"
#include "reports/diagnosis_json.hpp"
#include "rigs/pile.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace app {

namespace {

struct DiagnoseOptions {
    CommonOptions common;
    std::string path, predict, engine = "dem_min", out = "out", heaps = "out/similitude-heaps";
    std::string contact = "own";
    double alpha = diagnose::Settings{}.alpha;
};

constexpr const char* examples = R"(Examples:
  similitude diagnose my-drops --report out/my-drops.html
      what the simulation of my-drops/case.json lacks, with figures
  similitude diagnose my-drops --json - --predict out/my-drops --seed 2
      the verdict for programs, and the predicted curves of every experiment as CSV
  similitude diagnose my-drops --engine lammps --out out/my-drops
      the simulation that is judged is one of LAMMPS, with the model of the case)";

int exit_code_of(diagnose::Answer answer) {
    switch (reports::answer_of(answer)) {
        case reports::Answer::yes:
            return fine;
        case reports::Answer::no:
            return answer_is_no;
        case reports::Answer::cannot_tell:
        case reports::Answer::outside_validity:
            return cannot_tell;
    }
    return internal_fault;
}

// Empty where a signal came first.
std::optional<diagnose::Verdict> judged(const cases::Case& c, const DiagnoseOptions& o,
                                        const Judge& judge) {
    Progress progress(!o.common.quiet);
    diagnose::Settings settings{
        .seed = o.common.seed, .threads = threads_of(o.common), .alpha = o.alpha};
    // Heaps take most of the time where there are any: their part of the bar.
    double from = 0.0;
    settings.progress = [&](double share, const std::string& what) {
        progress.show(from + (1.0 - from) * share, 1.0, what);
        return !interrupt_flag();
    };
    PouredHeaps heaps(o.heaps, settings.threads, [&](std::size_t done, std::size_t of) {
        constexpr double first = 0.75;  // of the bar, for the first heaps asked for
        const double share = static_cast<double>(done) / static_cast<double>(of);
        progress.show(from == 0.0 ? first * share : from, 1.0,
                      fmt::format("heaps, {} of {}", done, of));
        if (done == of) from = first;
        return !interrupt_flag();
    });
    settings.pour = [&](std::vector<rigs::PileSetup> setups) {
        if (o.contact == "lammps")
            for (rigs::PileSetup& setup : setups) rigs::take_lammps_rules(setup);
        return heaps(setups);
    };
    try {
        diagnose::Verdict v = judge(c, settings, cases::open_held_out);
        if (heaps.poured() + heaps.recalled() > 0)
            v.warnings.push_back(
                fmt::format("Heaps: {} poured now, {:.0f} s of one core, {} found in {}.",
                            heaps.poured(), heaps.seconds(), heaps.recalled(), o.heaps));
        if (o.contact == "lammps")
            v.warnings.push_back(
                "Heaps under LAMMPS' contact rules: SDS rolling, its friction limit under "
                "adhesion, JKR torn off at the deepest tension.");
        return v;
    } catch (const diagnose::Interrupted&) {
        return std::nullopt;
    }
}

// Who made the base simulation; nothing where a signal came.
std::optional<std::vector<std::string>> with_base(cases::Case& c, const DiagnoseOptions& o) {
    if (o.engine != "lammps") return std::vector<std::string>{};
    Progress progress(!o.common.quiet);
    LammpsBase base = simulate_base_in_lammps(
        c, std::filesystem::absolute(o.out),
        [&](std::size_t k, std::size_t of, const std::string& id) {
            progress.show(static_cast<double>(k), static_cast<double>(of), "LAMMPS runs " + id);
        });
    if (base.interrupted) return std::nullopt;
    return base.statements;
}

int run(const DiagnoseOptions& o, const std::string& command, const Judge& judge) {
    cases::Case c = cases::read_case(o.path, cases::HeldOut::sealed);
    if (o.contact == "lammps" && !diagnose::has_piles(c))
        throw scaling::InvalidInput(
            scaling::mistake("--contact", "lammps", "must go with a pile whose profile is recorded",
                             "LAMMPS' rules are for heaps; leave the option out"));
    if (!o.predict.empty()) make_folder(o.predict);  // a minute of work must not end at a bad name
    watch_interrupts();
    const auto base = with_base(c, o);
    std::optional<diagnose::Verdict> v;
    if (base) v = judged(c, o, judge);
    if (v) v->warnings.insert(v->warnings.begin(), base->begin(), base->end());
    if (!v) {
        fmt::print(stderr,
                   "similitude: interrupted; a diagnosis starts anew when it is asked for again\n");
        return interrupted;
    }
    reports::Provenance who = provenance(command, c.path);
    who.seeds = {o.common.seed};
    who.threads = threads_of(o.common);
    print(o.common, (c.title.empty() ? "" : c.title + "\n") + reports::text_of(*v));
    if (!o.predict.empty()) write_predictions(o.predict, v->curves);
    write_results(o.common, reports::to_json(*v, who),
                  [&] { return reports::page_of(c, *v, who); });
    return exit_code_of(v->answer);
}

}  // namespace

Verb diagnose_verb(CLI::App& app, const std::string& command, const Judge& judge) {
    const auto options = std::make_shared<DiagnoseOptions>();
    CLI::App* verb = app.add_subcommand(
        "diagnose", "where a simulation and its recordings differ, and which physics was left out");
    verb->add_option("CASE", options->path, "case.json or its folder")->required();
    verb->add_option("--predict", options->predict,
                     "write the predicted curves of every experiment as CSV into this folder")
        ->type_name("DIR");
    verb->add_option("--alpha", options->alpha, "chance of calling a mismatch where there is none")
        ->check(CLI::Range(1e-4, 0.5))
        ->capture_default_str();
    verb->add_option("--engine", options->engine,
                     "whose simulation is judged: lammps runs drops, inclines and impacts of the "
                     "case first, as if `simulated` held them")
        ->check(CLI::IsMember({"dem_min", "lammps"}))
        ->capture_default_str();
    verb->add_option("--contact", options->contact,
                     "rules of the heaps' contacts: lammps where the simulation that is judged was "
                     "one of LAMMPS with SDS rolling")
        ->check(CLI::IsMember({"own", "lammps"}))
        ->capture_default_str();
    verb->add_option("--heaps", options->heaps,
                     "folder in which heaps poured for piles are remembered; cases of one powder "
                     "and apparatus share them")
        ->type_name("DIR")
        ->capture_default_str();
    verb->add_option("--out", options->out, "folder for LAMMPS' decks")
        ->type_name("DIR")
        ->capture_default_str();
    add_common(*verb, options->common);
    verb->footer(examples);
    return {verb, [options, command, judge] { return run(*options, command, judge); }};
}

}  // namespace app
