// SPDX-License-Identifier: MIT
#include "app/export.hpp"

#include "app/exit_code.hpp"
#include "app/experiment.hpp"
#include "app/lammps_cost.hpp"
#include "cases/messages.hpp"
#include "cases/read_case.hpp"
#include "engines/lammps_one_grain.hpp"
#include "engines/lammps_pile.hpp"
#include "reports/numbers.hpp"
#include "rigs/forward.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace app {

namespace {

using scaling::InvalidInput;
using scaling::mistake;

struct ExportOptions {
    std::string path, experiment, engine, out = "out", contact = "lammps", submit;
    std::uint64_t seed = 1;
    int ranks = 1;
};

constexpr const char* examples = R"(Examples:
  similitude export my-powder --engine lammps --out runs/deck --seed 3
      deck.in and its data files for every pile, drop, incline and impact, each in runs/deck/ID-lammps
  similitude export my-powder --engine lammps --out runs/deck --submit slurm --ranks 32
      and job.sh beside each deck: sbatch job.sh)";

// Of the words of the deck's own folder; srun starts the ranks.
std::string slurm_script(const std::string& id, int ranks, int hours) {
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
    return script + "exec srun lmp -in deck.in -log log.lammps\n";
}

struct Exported {
    std::string id;
    engines::LammpsDeck deck;
    std::optional<LammpsCost> cost{};  // of a pile
};

constexpr int hours_for_a_grain = 24;

Exported exported(const cases::Case& c, const cases::Experiment& e, const ExportOptions& o,
                  const EngineChoice& choice) {
    if (e.rig != "pile") return {e.id, engines::lammps_one_grain(c, e, rigs::ordinates_of(e))};
    const rigs::PileSetup setup = chosen_setup(c, e, o.seed, true, choice);
    return {e.id, engines::lammps_pile(setup), lammps_cost(setup, choice.ranks)};
}

std::string estimate_text(const LammpsCost& cost, int ranks) {
    return fmt::format(
        "estimate: {} grains, {} steps, {} grain-steps, {} h on {} rank{} (docs/export.md says of "
        "which machine)",
        reports::count(cost.grains), reports::count(cost.steps), reports::count(cost.grain_steps),
        reports::number(cost.seconds / 3600.0), ranks, ranks == 1 ? "" : "s");
}

bool has_deck(const cases::Experiment& e) {
    return e.rig == "pile" || engines::has_one_grain_deck(e);
}

int run(const ExportOptions& o) {
    const cases::Case c = cases::read_case(o.path);
    if (o.engine != "lammps")
        throw InvalidInput(mistake("--engine", cases::in_quotes(o.engine), "must be lammps",
                                   "no other engine has a deck yet"));
    if (!o.submit.empty() && o.submit != "slurm")
        throw InvalidInput(mistake("--submit", cases::in_quotes(o.submit), "must be slurm",
                                   "leave it out and start the deck yourself"));
    const EngineChoice choice = engine_choice(o.engine, o.ranks, o.contact);
    std::vector<std::string> ids;
    std::vector<Exported> decks;
    for (const cases::Experiment& e : c.experiments) {
        if (!has_deck(e)) continue;
        ids.push_back(e.id);
        if (!o.experiment.empty() && e.id != o.experiment) continue;
        decks.push_back(exported(c, e, o, choice));
    }
    if (decks.empty())
        throw InvalidInput(
            mistake("--experiment", o.experiment.empty() ? "none" : cases::in_quotes(o.experiment),
                    "must be a pile, drop, incline or impact of the case",
                    ids.empty() ? "this case has none" : cases::suggestion(o.experiment, ids)));
    for (const auto& [id, deck, cost] : decks) {
        const std::filesystem::path folder = std::filesystem::path(o.out) / (id + "-lammps");
        engines::write_lammps_deck(deck, folder);
        if (!o.submit.empty())
            write_file(
                (folder / "job.sh").string(),
                slurm_script(id, choice.ranks, cost ? hours_to_ask_for(*cost) : hours_for_a_grain));
        fmt::print("{}\n", (folder / "deck.in").string());
        if (cost) fmt::print(stderr, "{}\n", estimate_text(*cost, choice.ranks));
    }
    return fine;
}

}  // namespace

Verb export_verb(CLI::App& app, const std::string&) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* verb =
        app.add_subcommand("export", "an experiment as a deck that another engine runs");
    verb->add_option("CASE", options->path, "case.json or its folder")->required();
    verb->add_option("--engine", options->engine, "lammps")->type_name("ENGINE")->required();
    verb->add_option("--experiment", options->experiment,
                     "only this one; all that have a deck otherwise")
        ->type_name("ID");
    verb->add_option("--out", options->out, "folder for the decks")
        ->type_name("DIR")
        ->capture_default_str();
    verb->add_option("--seed", options->seed, "of feeding places and sizes")->capture_default_str();
    verb->add_option("--contact", options->contact,
                     "contact rules: lammps (those that LAMMPS has), or own where the case needs "
                     "nothing that differs")
        ->type_name("RULES")
        ->capture_default_str();
    verb->add_option("--ranks", options->ranks, "MPI ranks that the script asks for")
        ->type_name("N")
        ->capture_default_str();
    verb->add_option("--submit", options->submit, "slurm: write job.sh beside the deck")
        ->type_name("SYSTEM");
    verb->footer(examples);
    return {verb, [options] { return run(*options); }};
}

}  // namespace app
