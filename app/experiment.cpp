// SPDX-License-Identifier: MIT
#include "app/experiment.hpp"

#include "app/flow_task.hpp"
#include "app/forward_curves.hpp"
#include "app/peer_run.hpp"
#include "app/pile_cost.hpp"
#include "app/pile_task.hpp"
#include "app/version.hpp"
#include "cases/csv.hpp"
#include "cases/messages.hpp"
#include "reports/numbers.hpp"
#include "rigs/drop.hpp"
#include "rigs/forward.hpp"
#include "rigs/single_grain.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>

namespace app {

namespace {

using cases::Case;
using cases::Experiment;
using scaling::InvalidInput;
using scaling::mistake;

// A frame of 300 grains has some 60 kB; a slip of the unit would fill the disk with them.
constexpr double most_frames_unasked = 1e4;

void refuse_frames(const DumpPlan& plan, double step, std::int64_t steps, bool yes) {
    if (plan.formats.empty()) return;
    const std::string got = reports::quantity(plan.every, "s");
    if (plan.every < step)
        throw InvalidInput(
            mistake("--dump-every", got,
                    "must not be shorter than a time step, " + reports::quantity(step, "s"),
                    "write a longer simulated time"));
    const double run = static_cast<double>(steps) * step;  // s
    if (!yes && run / plan.every > most_frames_unasked)
        throw InvalidInput(
            mistake("--dump-every", got, "must not make more than 1e4 frames unasked",
                    fmt::format("the run lasts some {}; write a longer time, or say --yes",
                                reports::quantity(run, "s"))));
}

// Of the bytes of all files that decide the run.
std::uint64_t files_of(const Case& c, const Experiment& e) {
    std::uint64_t state = fingerprint_of(bytes_of(c.path));
    for (const cases::Mesh& mesh : e.meshes) state = fingerprint_of(bytes_of(mesh.path), state);
    return state;
}

RunPlan plan_of(const Case& c, const Experiment& e, const CommonOptions& o, const RunPlace& place) {
    return {.id = e.id,
            .folder = place.folder,
            .fingerprint =
                fingerprint_of(fmt::format("\n{} {} {}", e.id, o.seed, version), files_of(c, e)),
            .threads = threads_of(o),
            .resume = o.resume,
            .progress = !o.quiet,
            .dump = place.dump,
            .checkpoint_every = place.checkpoint_every};
}

PileTask pile_task(const Case& c, const Experiment& e, const CommonOptions& o,
                   const RunPlace& place) {
    PileTask task{plan_of(c, e, o, place), chosen_setup(c, e, o.seed, place.yes, place.engine)};
    if (place.engine.lammps_rules)
        task.plan.fingerprint = fingerprint_of("lammps rules", task.plan.fingerprint);
    if (place.sleep) {
        task.setup.sleep_speed = rigs::speed_of_rest(task.setup);
        task.plan.fingerprint = fingerprint_of("sleep", task.plan.fingerprint);
    }
    const std::int64_t steps = rigs::expected_steps(task.setup);
    refuse_frames(place.dump, task.setup.time_step, steps, place.yes);
    if (!place.yes) refuse_unaffordable(e, task.setup, task.plan.threads);
    return task;
}

// What there is to say of a run wherever it ended.
ExperimentRun run_so_far(const RunPlan& plan, const std::string& rig, const RunOutcome& outcome) {
    ExperimentRun run{
        plan.id, rig, outcome.seconds, std::nullopt, {{"interrupted_at_step", outcome.steps}}};
    run.dumps = outcome.dumps;
    run.frames = outcome.frames;
    if (outcome.finished) run.forget = [plan] { forget(plan); };
    return run;
}

ExperimentRun pile_run(const PileTask& task) {
    const PileOutcome outcome = run_pile(task);
    ExperimentRun run = run_so_far(task.plan, "pile", outcome.run);
    if (!outcome.record) return run;
    run.tables = write_pile(task.plan.folder, task.plan.id, *outcome.record);
    run.section = reports::pile_section(task.plan.id, *outcome.record);
    run.result = reports::to_json(*outcome.record);
    return run;
}

std::function<ExperimentRun()> prepared_pile(const Case& c, const Experiment& e,
                                             const CommonOptions& o, const RunPlace& place) {
    PileTask task = pile_task(c, e, o, place);
    if (place.engine.peer != nullptr) return prepared_pile_in_peer(task, o, place);
    return [task] { return pile_run(task); };
}

ExperimentRun flow_run(const FlowTask& task, const Experiment& e) {
    const FlowOutcome outcome = run_flow(task);
    ExperimentRun run = run_so_far(task.plan, e.rig, outcome.run);
    if (!outcome.record) return run;
    const rigs::FlowRecord& record = *outcome.record;
    run.tables = write_flow(task.plan.folder, task.plan.id, record);
    run.section =
        reports::flow_section(task.plan.id, record, e.recording ? &*e.recording : nullptr);
    run.result = reports::to_json(record);
    return run;
}

std::function<ExperimentRun()> prepared_flow(const Case& c, const Experiment& e,
                                             const CommonOptions& o, const RunPlace& place) {
    FlowTask task{plan_of(c, e, o, place), chosen_flow(c, e, o.seed, place.engine)};
    if (place.engine.lammps_rules)
        task.plan.fingerprint = fingerprint_of("lammps rules", task.plan.fingerprint);
    refuse_frames(place.dump, task.setup.time_step, rigs::expected_steps(task.setup), place.yes);
    if (!place.yes)
        refuse_unaffordable(e, task.setup.place.size(), rigs::expected_steps(task.setup),
                            task.plan.threads);
    if (place.engine.peer != nullptr) return prepared_flow_in_peer(task, e, o, place);
    return [task, &e] { return flow_run(task, e); };
}

ExperimentRun drop_run(const Experiment& e, const rigs::DropSetup& setup,
                       const std::filesystem::path& folder) {
    const auto start = std::chrono::steady_clock::now();
    const cases::Recording* recording = e.recording ? &*e.recording : nullptr;
    const rigs::DropRecord record = recording != nullptr
                                        ? rigs::run_drop(setup, recording->values("t"))
                                        : rigs::run_drop(setup);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    ExperimentRun run{e.id, "drop", seconds.count(), reports::drop_section(e.id, record, recording),
                      reports::to_json(record)};
    run.tables = {{e.id, {{"t", "s", record.t}, {"z", "m", record.z}, {"x", "m", record.x}}}};
    cases::write_csv((folder / (e.id + ".csv")).string(), run.tables.front().columns);
    return run;
}

// Of the rigs with a forward model and no runner of their own.
ExperimentRun curves_run(const Experiment& e, const rigs::World& world,
                         const std::filesystem::path& folder) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<cases::Column> columns = forward_curves(e, world, rigs::ordinates_of(e));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    cases::write_csv((folder / (e.id + ".csv")).string(), columns);
    const cases::Recording* recording = e.recording ? &*e.recording : nullptr;
    ExperimentRun run{e.id,
                      e.rig,
                      seconds.count(),
                      reports::curves_section(e.id, columns, recording),
                      {{"rows", columns.front().values.size()}}};
    run.tables = {{e.id, columns}};
    return run;
}

bool has_curves(const Experiment& e) {
    return e.rig == "incline" || e.rig == "impact" || e.rig == "pull_off";
}

}  // namespace

EngineChoice engine_choice(const std::string& engine, int ranks, const std::string& contact,
                           const EngineNames& names) {
    const auto one_of = [&](const char* option, const std::string& got,
                            const std::vector<std::string>& known,
                            const std::vector<std::string>& elsewhere) {
        const auto in = [&](const std::vector<std::string>& list) {
            return std::find(list.begin(), list.end(), got) != list.end();
        };
        if (in(known)) return;
        std::string list;
        for (const std::string& name : known)
            list += (list.empty() ? "" : name == known.back() ? " or " : ", ") + name;
        throw InvalidInput(
            mistake(option, cases::in_quotes(got), "must be " + list,
                    in(elsewhere) ? names.otherwise : cases::suggestion(got, known)));
    };
    const EngineNames all;
    one_of("--engine", engine, names.engines, all.engines);
    one_of("--contact", contact, names.contacts, all.contacts);
    EngineChoice choice;
    choice.peer = engines::find_peer(engine);
    choice.lammps_rules = contact == "lammps";
    choice.nearest = contact == "nearest";
    if (choice.nearest && choice.peer == nullptr)
        throw InvalidInput(mistake("--contact", "nearest", "must go with another engine",
                                   "dem_min has the case's own laws"));
    if (ranks < 0)
        throw InvalidInput(
            mistake("--ranks", std::to_string(ranks), "must be > 0", "1 is the default"));
    if (ranks != 0 && (choice.peer == nullptr || !choice.peer->ranks)) {
        std::string parallel;
        for (const std::string& name : names.engines)
            if (const engines::Peer* peer = engines::find_peer(name); peer && peer->ranks)
                parallel += (parallel.empty() ? "" : " or ") + name;
        throw InvalidInput(mistake("--ranks", std::to_string(ranks),
                                   "must go with --engine " + parallel + ", under MPI",
                                   "leave it out; the core takes --threads"));
    }
    choice.ranks = ranks == 0 ? 1 : ranks;
    return choice;
}

rigs::PileSetup chosen_setup(const Case& c, const Experiment& e, std::uint64_t seed, bool yes,
                             const EngineChoice& choice) {
    rigs::PileSetup setup = counted_setup(c, e, seed, yes);
    if (choice.lammps_rules) rigs::take_lammps_rules(setup);
    return setup;
}

rigs::FlowSetup chosen_flow(const Case& c, const Experiment& e, std::uint64_t seed,
                            const EngineChoice& choice) {
    rigs::FlowSetup setup = rigs::flow_setup(c, e, seed);
    if (choice.lammps_rules) rigs::take_lammps_rules(setup);
    return setup;
}

bool has_frames(const Experiment& e) { return e.rig == "pile" || rigs::is_flow(e); }

bool can_simulate(const Experiment& e) { return has_frames(e) || e.rig == "drop" || has_curves(e); }

std::function<ExperimentRun()> prepared(const Case& c, const Experiment& e, const CommonOptions& o,
                                        const RunPlace& place) {
    if (e.rig == "pile") return prepared_pile(c, e, o, place);
    if (rigs::is_flow(e)) return prepared_flow(c, e, o, place);
    if (place.engine.peer != nullptr) return prepared_in_peer(c, e, o, place);
    if (e.rig == "drop")
        return [&e, setup = rigs::drop_setup(c, e), folder = place.folder] {
            return drop_run(e, setup, folder);
        };
    if (has_curves(e)) {
        rigs::refuse_physics_of_many(c, e.rig);
        return [&e, world = rigs::world_of(c, e), folder = place.folder] {
            return curves_run(e, world, folder);
        };
    }
    throw InvalidInput(mistake("experiment " + cases::in_quotes(e.id),
                               "rig " + cases::in_quotes(e.rig), "must be of a rig that runs",
                               "similitude simulate --help names them"));
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace app
