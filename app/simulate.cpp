// SPDX-License-Identifier: MIT
#include "app/simulate.hpp"

#include "app/exit_code.hpp"
#include "app/experiment.hpp"
#include "app/interrupt.hpp"
#include "app/pile_task.hpp"
#include "cases/messages.hpp"
#include "cases/read_case.hpp"
#include "cases/units.hpp"
#include "reports/text.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace app {

namespace {

using cases::Case;
using cases::Experiment;
using scaling::InvalidInput;
using scaling::mistake;

struct SimulateOptions {
    CommonOptions common;
    std::string path, experiment, out = "out";
    std::string dump, dump_every, checkpoint_every = "5 min";
    std::string engine = "dem_min", contact = "own";
    int ranks = 0;
    bool yes = false, sleep = false;
};

constexpr const char* examples = R"(Examples:
  similitude simulate my-powder --out runs/seed-3 --seed 3 --report runs/seed-3/pile.html
      all experiments of the case in the folder my-powder
  similitude simulate my-powder --out runs/seed-3 --seed 3 --resume
      go on after an interrupt (Ctrl-C writes a checkpoint)
  similitude simulate my-powder --dump vtp,lammps --dump-every "5 ms"
      frames for ParaView (out/ID.pvd), OVITO and LAMMPS (out/ID.lammpstrj)
  similitude simulate my-powder --xlsx runs.xlsx
      a workbook as well: what was measured with its units, and every channel
  similitude simulate my-powder --experiment heap --engine lammps --ranks 2 --contact lammps
      the same feed in LAMMPS; its deck and log stay in out/heap-lammps; liggghts and yade likewise)";

std::vector<const Experiment*> chosen(const Case& c, const std::string& id) {
    std::vector<const Experiment*> all;
    std::vector<std::string> ids;
    for (const Experiment& e : c.experiments) {
        ids.push_back(e.id);
        if (id.empty() ? can_simulate(e) : e.id == id) all.push_back(&e);
    }
    if (all.empty() && !id.empty())
        throw InvalidInput(
            mistake("--experiment", cases::in_quotes(id), "must be one of the case's experiments",
                    ids.empty() ? "this case has none" : cases::suggestion(id, ids)));
    if (all.empty())
        throw InvalidInput(mistake(c.path + ": experiments", "none that can be simulated",
                                   "must hold one", "no other rig can be simulated yet"));
    return all;
}

// The case and its meshes, each once, with the hash of its bytes.
reports::Json inputs_json(const Case& c, const std::vector<ExperimentRun>& runs) {
    std::vector<std::string> paths = {c.path};
    const auto add = [&](const std::string& path) {
        if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
    };
    for (const ExperimentRun& run : runs) {
        const Experiment* e = c.find(run.id);
        if (e == nullptr) continue;
        for (const cases::Mesh& mesh : e->meshes) add(mesh.path);
    }
    reports::Json list = reports::Json::array();
    for (const std::string& path : paths)
        list.push_back(
            {{"path", path}, {"fnv1a64", fmt::format("{:016x}", fingerprint_of(bytes_of(path)))}});
    return list;
}

reports::Json json_of(const Case& c, const SimulateOptions& o,
                      const std::vector<ExperimentRun>& runs, const reports::Provenance& who) {
    reports::Json list = reports::Json::array();
    for (const ExperimentRun& run : runs) {
        list.push_back({{"experiment", run.id},
                        {"rig", run.rig},
                        {"wall_time", run.seconds},
                        {"finished", run.section.has_value()},
                        {"result", run.result}});
        if (run.dumps.empty()) continue;
        reports::Json files = reports::Json::array();
        for (const auto& file : run.dumps) files.push_back(file.filename().string());
        list.back()["dumps"] = {{"frames", run.frames}, {"files", std::move(files)}};
    }
    return {{"format", "similitude-run/1"},
            {"tool", reports::to_json(who)},
            {"case", c.path},
            {"title", c.title},
            {"inputs", inputs_json(c, runs)},
            {"seed", o.common.seed},
            {"units", "SI"},
            {"runs", std::move(list)}};
}

std::string text_of(const ExperimentRun& run) {
    if (!run.section)
        return fmt::format("{}: interrupted; the same command with --resume goes on\n", run.id);
    const reports::RunSection& section = *run.section;
    std::string text = fmt::format("{}: {}\n", run.id, section.verdict.headline);
    text += "  " + reports::wrapped(section.verdict.why, 98, 2) + "\n";
    for (const std::string& note : section.notes)
        text += "  " + reports::wrapped(note, 98, 2) + "\n";
    if (!run.dumps.empty()) text += fmt::format("  {} frames in", run.frames);
    for (const auto& file : run.dumps) text += " " + file.string();
    if (!run.dumps.empty()) text += "\n";
    if (section.quantities.empty()) return text;
    std::vector<bool> right(section.quantities.front().size(), true);
    right.front() = false;
    return text + reports::columns(section.quantities, right);
}

std::vector<reports::RunSection> sections_of(const std::vector<ExperimentRun>& runs) {
    std::vector<reports::RunSection> sections;
    for (const ExperimentRun& run : runs)
        if (run.section) sections.push_back(*run.section);
    return sections;
}

std::vector<reports::ChannelTable> tables_of(const std::vector<ExperimentRun>& runs) {
    std::vector<reports::ChannelTable> tables;
    for (const ExperimentRun& run : runs)
        tables.insert(tables.end(), run.tables.begin(), run.tables.end());
    return tables;
}

RunPlace place_of(const SimulateOptions& o) {
    const double wall =
        cases::quantity<scaling::Time>(o.checkpoint_every, "--checkpoint-every").value();
    if (!(wall > 0.0))
        throw InvalidInput(mistake("--checkpoint-every", cases::in_quotes(o.checkpoint_every),
                                   "must be > 0", "write a wall time, such as \"5 min\""));
    return {o.out, o.yes,   dump_plan(o.dump, o.dump_every),
            wall,  o.sleep, engine_choice(o.engine, o.ranks, o.contact)};
}

void refuse_idle_options(const std::vector<const Experiment*>& experiments, const RunPlace& p) {
    const auto any = [&](const auto& uses) {
        return std::any_of(experiments.begin(), experiments.end(),
                           [&](const Experiment* e) { return uses(*e); });
    };
    if (!p.dump.formats.empty() && !any(has_frames))
        throw InvalidInput(mistake("--dump", "no pile, silo, column or drum among the experiments",
                                   "must be of one", "the path of a drop stands in its ID.csv"));
    if (p.sleep && !any([](const Experiment& e) { return e.rig == "pile"; }))
        throw InvalidInput(mistake("--sleep", "no pile among the experiments", "must be of one",
                                   "leave it out: all grains of the other rigs stay awake"));
}

int run(const SimulateOptions& o, const std::string& command) {
    const Case c = cases::read_case(o.path);
    const RunPlace place = place_of(o);
    const std::vector<const Experiment*> experiments = chosen(c, o.experiment);
    refuse_idle_options(experiments, place);
    std::vector<std::function<ExperimentRun()>> todo;
    for (const Experiment* e : experiments) todo.push_back(prepared(c, *e, o.common, place));
    std::filesystem::create_directories(o.out);
    watch_interrupts();
    std::vector<ExperimentRun> runs;
    bool whole = true, decided = true;
    for (const auto& next : todo) {
        whole = whole && !interrupt_flag();
        if (!whole) break;
        runs.push_back(next());
        whole = runs.back().section.has_value();
        decided =
            decided && whole && runs.back().section->verdict.answer != reports::Answer::cannot_tell;
        print(o.common, text_of(runs.back()));
    }
    reports::Provenance who = provenance(command, c.path);
    who.seeds = {o.common.seed};
    who.threads = threads_of(o.common);
    const reports::Json json = json_of(c, o, runs, who);
    write_file((std::filesystem::path(o.out) / "run.json").string(), reports::text_of(json));
    if (!o.common.xlsx.empty())
        reports::write_workbook(o.common.xlsx, reports::sheets_of_runs(json, tables_of(runs)));
    write_results(o.common, json, [&] { return reports::page_of(c, sections_of(runs), who); });
    for (const ExperimentRun& r : runs)
        if (whole) r.forget();
    return !whole ? interrupted : decided ? fine : cannot_tell;
}

}  // namespace

Verb simulate_verb(CLI::App& app, const std::string& command) {
    const auto options = std::make_shared<SimulateOptions>();
    CLI::App* verb = app.add_subcommand(
        "simulate", "run the experiments of a case: channels, grains, a manifest");
    verb->add_option("CASE", options->path, "case.json or its folder")->required();
    verb->add_option("--experiment", options->experiment,
                     "only this one; all that can be simulated otherwise")
        ->type_name("ID");
    verb->add_option("--out", options->out, "folder for results and checkpoints")
        ->type_name("DIR")
        ->capture_default_str();
    verb->add_flag("--yes", options->yes, "run even where the estimate says more than 12 hours");
    verb->add_option("--dump", options->dump,
                     "frames of piles, silos, columns, drums: lammps (also OVITO), vtp (ParaView), "
                     "extxyz (OVITO, ASE)")
        ->type_name("FORMAT[,FORMAT]");
    verb->add_option("--dump-every", options->dump_every,
                     "simulated time between two frames, with its unit: \"1 ms\"")
        ->type_name("TIME");
    verb->add_option("--checkpoint-every", options->checkpoint_every,
                     "wall time between two checkpoints, with its unit")
        ->type_name("TIME")
        ->capture_default_str();
    verb->add_flag(
        "--sleep", options->sleep,
        "leave out regions of a heap that are at rest until something comes: faster, and "
        "not quite the same heap");
    verb->add_option(
            "--engine", options->engine,
            "who runs them: dem_min, or lammps, liggghts or yade (pull_off: dem_min or lammps)")
        ->type_name("ENGINE")
        ->capture_default_str();
    verb->add_option("--ranks", options->ranks, "MPI ranks of LAMMPS or LIGGGHTS; 1 by default")
        ->type_name("N");
    verb->add_option(
            "--contact", options->contact,
            "contact rules of the piles: own, lammps (those that LAMMPS has too, on either "
            "engine), or nearest (where LIGGGHTS or Yade has not the case's law)")
        ->type_name("RULES")
        ->capture_default_str();
    add_common(*verb, options->common);
    add_workbook(*verb, options->common);
    verb->footer(examples);
    return {verb, [options, command] { return run(*options, command); }};
}

}  // namespace app
