// SPDX-License-Identifier: MIT
#include "app/export.hpp"

#include "app/exit_code.hpp"
#include "app/experiment.hpp"
#include "cases/messages.hpp"
#include "cases/read_case.hpp"
#include "engines/nearest.hpp"
#include "engines/process.hpp"
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
    std::uint64_t seed = 1;
    int ranks = 0;
};

constexpr const char* examples = R"(Examples:
  similitude export my-powder --engine lammps --out runs/deck --seed 3
      deck.in and its data files for every pile, drop, incline and impact, each in runs/deck/ID-lammps
  similitude export my-powder --engine lammps --out runs/deck --submit slurm --ranks 32
      and job.sh beside each deck: sbatch job.sh
  similitude export my-powder --engine yade --contact nearest
      a script for Yade, with DMT in place of JKR; how far off that is goes to stderr)";

// Of the words of the deck's own folder; srun starts the ranks.
std::string slurm_script(const std::string& id, const engines::Peer& peer, int ranks) {
    std::string script = fmt::format(R"(#!/bin/sh
# Written by similitude, never run on a cluster: add partition, account and modules as yours wants them.
#SBATCH --job-name={}
#SBATCH --ntasks={}
#SBATCH --time=24:00:00
#SBATCH --output=job.log
set -eu
)",
                                     id, ranks);
    script += "cd \"${SLURM_SUBMIT_DIR:-.}\"\n";
    return script + "exec " + (peer.ranks ? "srun " : "") +
           engines::command_line(peer.command(peer.program, 1)) + "\n";
}

bool has_deck(const cases::Experiment& e) {
    return e.rig == "pile" || e.rig == "drop" || e.rig == "incline" || e.rig == "impact";
}

int run(const ExportOptions& o) {
    const cases::Case c = cases::read_case(o.path);
    if (!o.submit.empty() && o.submit != "slurm")
        throw InvalidInput(mistake("--submit", cases::in_quotes(o.submit), "must be slurm",
                                   "leave it out and start the deck yourself"));
    const EngineChoice choice = engine_choice(o.engine, o.ranks,
                                              !o.contact.empty()     ? o.contact
                                              : o.engine == "lammps" ? "lammps"
                                                                     : "own");
    if (choice.peer == nullptr)
        throw InvalidInput(mistake("--engine", cases::in_quotes(o.engine), "must be another engine",
                                   "simulate runs dem_min"));
    const engines::Peer& peer = *choice.peer;
    const engines::DeckOptions options{.nearest = choice.nearest};
    std::vector<std::string> ids, off;
    std::vector<std::pair<std::string, engines::Deck>> decks;
    for (const cases::Experiment& e : c.experiments) {
        if (!has_deck(e)) continue;
        ids.push_back(e.id);
        if (!o.experiment.empty() && e.id != o.experiment) continue;
        if (e.rig != "pile") {
            decks.emplace_back(e.id, peer.one_grain(c, e, rigs::ordinates_of(e), options));
            continue;
        }
        const rigs::PileSetup setup = chosen_setup(c, e, o.seed, true, choice);
        decks.emplace_back(e.id, peer.pile(setup, options));
        if (choice.nearest)
            off = engines::how_far_off(peer, engines::program_of(peer), setup,
                                       std::filesystem::path(o.out) / "nearest");
    }
    if (decks.empty())
        throw InvalidInput(
            mistake("--experiment", o.experiment.empty() ? "none" : cases::in_quotes(o.experiment),
                    "must be a pile, drop, incline or impact of the case",
                    ids.empty() ? "this case has none" : cases::suggestion(o.experiment, ids)));
    for (const std::string& said : off) fmt::print(stderr, "similitude: {}\n", said);
    for (const auto& [id, deck] : decks) {
        const std::filesystem::path folder = std::filesystem::path(o.out) / (id + "-" + peer.name);
        engines::write_deck(deck, folder);
        if (!o.submit.empty())
            write_file((folder / "job.sh").string(), slurm_script(id, peer, choice.ranks));
        fmt::print("{}\n", (folder / deck.name).string());
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
    verb->add_option("--ranks", options->ranks, "MPI ranks that the script asks for; 1 by default")
        ->type_name("N");
    verb->add_option("--submit", options->submit, "slurm: write job.sh beside the deck")
        ->type_name("SYSTEM");
    verb->footer(examples);
    return {verb, [options] { return run(*options); }};
}

}  // namespace app
