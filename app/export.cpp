// SPDX-License-Identifier: MIT
#include "app/export.hpp"

#include "app/exit_code.hpp"
#include "app/experiment.hpp"
#include "app/lammps_cost.hpp"
#include "cases/messages.hpp"
#include "cases/read_case.hpp"
#include "engines/lammps_pull_off.hpp"
#include "engines/lammps_rules.hpp"
#include "engines/lammps_vessels.hpp"
#include "engines/nearest.hpp"
#include "engines/process.hpp"
#include "reports/numbers.hpp"
#include "rigs/forward.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace app {

namespace {

using scaling::InvalidInput;
using scaling::mistake;

struct ExportOptions {
    std::string path, experiment, engine, out = "out", contact, submit;
    std::string lammps_release;  // 2021 where it is left out
    std::uint64_t seed = 1;
    int ranks = 0;
};

constexpr const char* examples = R"(Examples:
  similitude export my-powder --engine lammps --out runs/deck --seed 3
      deck.in and its data files for every experiment, each in runs/deck/ID-lammps
  similitude export my-powder --engine lammps --out runs/deck --submit slurm --ranks 32
      and job.sh beside each deck: sbatch job.sh
  similitude export my-powder --engine lammps --lammps-release later
      the syntax of the current LAMMPS manual, which nobody has run
  similitude export my-powder --engine yade --contact nearest
      a script for Yade, with DMT in place of JKR; how far off that is goes to stderr)";

// Of the words of the deck's own folder; srun starts the ranks.
std::string slurm_script(const std::string& id, const engines::Peer& peer, int ranks, int hours) {
    std::string script = fmt::format(R"(#!/bin/sh
# Written by similitude, never run on a cluster: add partition, account and modules as yours wants them.
#SBATCH --job-name={}
#SBATCH --ntasks={}
#SBATCH --time={}:00:00
#SBATCH --output=job.log
set -eu
)",
                                     id, ranks, hours);
    script += "cd \"${SLURM_SUBMIT_DIR:-.}\"\n";
    return script + "exec " + (peer.ranks ? "srun " : "") +
           engines::command_line(peer.command(peer.program, 1)) + "\n";
}

struct Exported {
    std::string id;
    engines::Deck deck;
    std::optional<LammpsCost> cost{};    // of a pile in LAMMPS
    std::vector<std::string> said = {};  // how far off it is, and what is untested
};

constexpr int hours_unknown = 24;  // to ask for where no cost was measured

Exported exported(const cases::Case& c, const cases::Experiment& e, const ExportOptions& o,
                  const EngineChoice& choice, engines::LammpsRelease release) {
    const engines::Peer& peer = *choice.peer;
    const engines::DeckOptions options{.nearest = choice.nearest, .lammps = release};
    const auto warn = [&](Exported& made, bool adhesive) {
        const std::string said = engines::untested(options, adhesive);
        if (!said.empty()) made.said.push_back(e.id + ": " + said);
    };
    if (rigs::is_flow(e)) {
        const rigs::FlowSetup setup = chosen_flow(c, e, o.seed, choice);
        Exported made{e.id, peer.flow(setup, options)};
        warn(made, setup.grains.work_of_adhesion > 0.0);
        if (const std::string note = engines::vessel_note(setup); !note.empty())
            made.said.push_back(e.id + ": " + note);
        return made;
    }
    if (e.rig != "pile") {
        Exported made{e.id, peer.one_grain(c, e, rigs::ordinates_of(e), options)};
        warn(made, false);
        const std::string tear_off = e.rig == "pull_off" ? engines::tear_off_note(c, e) : "";
        if (!tear_off.empty()) made.said.push_back(e.id + ": " + tear_off);
        return made;
    }
    const rigs::PileSetup setup = chosen_setup(c, e, o.seed, true, choice);
    Exported made{e.id, peer.pile(setup, options)};
    if (peer.name == "lammps") made.cost = lammps_cost(setup, choice.ranks);
    warn(made, setup.grains.work_of_adhesion > 0.0);
    if (choice.nearest)
        made.said = engines::how_far_off(peer, engines::program_of(peer), setup,
                                         std::filesystem::path(o.out) / "nearest");
    return made;
}

std::string estimate_text(const LammpsCost& cost, int ranks) {
    return fmt::format(
        "estimate: {} grains, {} steps, {} grain-steps, {} on {} rank{} (docs/export.md says of "
        "which machine)",
        reports::count(cost.grains), reports::count(cost.steps), reports::count(cost.grain_steps),
        reports::quantity(cost.seconds, "s"), ranks, ranks == 1 ? "" : "s");
}

engines::LammpsRelease release_of(const ExportOptions& o) {
    if (o.lammps_release.empty()) return engines::LammpsRelease::of_2021;
    if (o.engine != "lammps")
        throw InvalidInput(mistake("--lammps-release", "with --engine " + o.engine,
                                   "must go with --engine lammps", "leave it out"));
    if (o.lammps_release != "2021" && o.lammps_release != "later")
        throw InvalidInput(mistake("--lammps-release", cases::in_quotes(o.lammps_release),
                                   "must be 2021 or later",
                                   "2021 is the release of 29 Sep 2021, which Debian 12 has"));
    return o.lammps_release == "later" ? engines::LammpsRelease::later
                                       : engines::LammpsRelease::of_2021;
}

int run(const ExportOptions& o) {
    const cases::Case c = cases::read_case(o.path);
    if (!o.submit.empty() && o.submit != "slurm")
        throw InvalidInput(mistake("--submit", cases::in_quotes(o.submit), "must be slurm",
                                   "leave it out and start the deck yourself"));
    const std::string contact = !o.contact.empty()     ? o.contact
                                : o.engine == "lammps" ? "lammps"
                                                       : "own";
    const EngineChoice choice =
        engine_choice(o.engine, o.ranks, contact,
                      {.engines = {"lammps", "liggghts", "yade"},
                       .otherwise = "simulate runs our own core, under the rules own or lammps"});
    const engines::Peer& peer = *choice.peer;
    const engines::LammpsRelease release = release_of(o);
    std::vector<std::string> ids;
    std::vector<Exported> decks;
    for (const cases::Experiment& e : c.experiments) {
        if (!engines::has_deck(peer, e)) continue;
        ids.push_back(e.id);
        if (!o.experiment.empty() && e.id != o.experiment) continue;
        decks.push_back(exported(c, e, o, choice, release));
    }
    if (decks.empty())
        throw InvalidInput(
            mistake("--experiment", o.experiment.empty() ? "none" : cases::in_quotes(o.experiment),
                    "must be a pile, drop, incline or impact of the case, in LAMMPS also a "
                    "pull_off, discharge, column or drum",
                    ids.empty() ? "this case has none" : cases::suggestion(o.experiment, ids)));
    for (const auto& [id, deck, cost, said] : decks) {
        const std::filesystem::path folder = std::filesystem::path(o.out) / (id + "-" + peer.name);
        engines::write_deck(deck, folder);
        if (!o.submit.empty())
            write_file((folder / "job.sh").string(),
                       slurm_script(id, peer, choice.ranks,
                                    cost ? hours_to_ask_for(*cost) : hours_unknown));
        fmt::print("{}\n", (folder / deck.name).string());
        if (cost) fmt::print(stderr, "{}\n", estimate_text(*cost, choice.ranks));
        for (const std::string& sentence : said) fmt::print(stderr, "similitude: {}\n", sentence);
    }
    return fine;
}

}  // namespace

Verb export_verb(CLI::App& app, const std::string&) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* verb =
        app.add_subcommand("export", "an experiment as a deck that another engine runs");
    verb->add_option("CASE", options->path, "case.json or its folder")->required();
    verb->add_option("--engine", options->engine, "lammps, liggghts or yade")
        ->type_name("ENGINE")
        ->required();
    verb->add_option("--experiment", options->experiment,
                     "only this one; all that have a deck otherwise")
        ->type_name("ID");
    verb->add_option("--out", options->out, "folder for the decks")
        ->type_name("DIR")
        ->capture_default_str();
    verb->add_option("--seed", options->seed, "of feeding places and sizes")->capture_default_str();
    verb->add_option("--contact", options->contact,
                     "contact rules: own, lammps (those that LAMMPS has; for it the default), or "
                     "nearest (where the engine has not the case's law)")
        ->type_name("RULES");
    verb->add_option("--lammps-release", options->lammps_release,
                     "2021 (29 Sep 2021, which decks are run with; the default), or later: in the "
                     "current manual's syntax, untested")
        ->type_name("RELEASE");
    verb->add_option("--ranks", options->ranks, "MPI ranks that the script asks for; 1 by default")
        ->type_name("N");
    verb->add_option("--submit", options->submit, "slurm: write job.sh beside the deck")
        ->type_name("SYSTEM");
    verb->footer(examples);
    return {verb, [options] { return run(*options); }};
}

}  // namespace app
