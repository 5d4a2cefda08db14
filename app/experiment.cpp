// SPDX-License-Identifier: MIT
#include "app/experiment.hpp"

#include "app/forward_curves.hpp"
#include "app/interrupt.hpp"
#include "app/pile_cost.hpp"
#include "app/pile_task.hpp"
#include "app/progress.hpp"
#include "app/version.hpp"
#include "cases/csv.hpp"
#include "cases/messages.hpp"
#include "engines/lammps_one_grain.hpp"
#include "engines/lammps_pile.hpp"
#include "engines/lammps_pile_run.hpp"
#include "engines/lammps_run.hpp"
#include "engines/process.hpp"
#include "reports/numbers.hpp"
#include "rigs/drop.hpp"
#include "rigs/forward.hpp"
#include "rigs/height_map.hpp"
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

void refuse_frames(const DumpPlan& plan, const rigs::PileSetup& setup, bool yes) {
    if (plan.formats.empty()) return;
    const std::string got = reports::quantity(plan.every, "s");
    const double step = setup.time_step;
    if (plan.every < step)
        throw InvalidInput(
            mistake("--dump-every", got,
                    "must not be shorter than a time step, " + reports::quantity(step, "s"),
                    "write a longer simulated time"));
    const double run = static_cast<double>(rigs::expected_steps(setup)) * step;  // s
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

PileTask pile_task(const Case& c, const Experiment& e, const CommonOptions& o,
                   const RunPlace& place) {
    const int threads = threads_of(o);
    PileTask task{.id = e.id,
                  .setup = chosen_setup(c, e, o.seed, place.yes, place.engine),
                  .folder = place.folder,
                  .fingerprint = fingerprint_of(fmt::format("\n{} {} {}", e.id, o.seed, version),
                                                files_of(c, e)),
                  .threads = threads,
                  .resume = o.resume,
                  .progress = !o.quiet,
                  .dump = place.dump,
                  .checkpoint_every = place.checkpoint_every};
    if (place.engine.lammps_rules)
        task.fingerprint = fingerprint_of("lammps rules", task.fingerprint);
    if (place.sleep) {
        task.setup.sleep_speed = rigs::speed_of_rest(task.setup);
        task.fingerprint = fingerprint_of("sleep", task.fingerprint);
    }
    refuse_frames(place.dump, task.setup, place.yes);
    if (!place.yes) refuse_unaffordable(e, task.setup, threads);
    return task;
}

void write_pile(const std::filesystem::path& folder, const std::string& id,
                const rigs::PileRecord& record) {
    const rigs::HeightMap map = rigs::scan(record.heap);
    cases::Column azimuth{"azimuth", "rad"}, r{"r", "m"}, z{"z", "m"};
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) {
            azimuth.values.push_back(map.azimuth(k));
            r.values.push_back(map.radius(i));
            z.values.push_back(map.z[k * map.rings + i]);
        }
    }
    cases::write_csv((folder / (id + ".csv")).string(), {azimuth, r, z});

    cases::Column x{"x", "m"}, y{"y", "m"}, height{"z", "m"}, radius{"radius", "m"};
    for (const contact::Vec3& p : record.heap.centre) {
        x.values.push_back(p.x);
        y.values.push_back(p.y);
        height.values.push_back(p.z);
    }
    radius.values = record.heap.radius;
    cases::write_csv((folder / (id + "-grains.csv")).string(), {x, y, height, radius});
}

ExperimentRun pile_run(const PileTask& task) {
    const PileOutcome outcome = run_pile(task);
    ExperimentRun run{
        task.id, "pile", outcome.seconds, std::nullopt, {{"interrupted_at_step", outcome.steps}}};
    run.dumps = outcome.dumps;
    run.frames = outcome.frames;
    if (!outcome.record) return run;
    write_pile(task.folder, task.id, *outcome.record);
    run.section = reports::pile_section(task.id, *outcome.record);
    run.result = reports::to_json(*outcome.record);
    run.forget = [task] { forget(task); };
    return run;
}

reports::Json engine_json(const std::string& release, int ranks,
                          const std::vector<std::string>& command,
                          const std::filesystem::path& deck) {
    return {{"name", "LAMMPS"},
            {"version", release},
            {"ranks", ranks},
            {"command", engines::command_line(command)},
            {"deck", (deck.filename() / "deck.in").string()},
            {"log", (deck.filename() / "log.lammps").string()}};
}

// The deck stays in ID-lammps/, whatever comes of its run.
ExperimentRun lammps_run(const PileTask& task, int ranks) {
    const std::filesystem::path lmp = engines::lammps_program("--engine");
    const std::filesystem::path deck = task.folder / (task.id + "-lammps");
    engines::write_lammps_deck(engines::lammps_pile(task.setup), deck);
    const double expected = static_cast<double>(rigs::expected_steps(task.setup));
    Progress progress(task.progress);
    progress.start(0.0);
    std::int64_t reached = 0;
    const engines::LammpsPileRun lammps = engines::run_lammps_pile(
        lmp, task.setup, deck, ranks, [&](const engines::LammpsProgress& p) {
            reached = p.step;
            const double step = static_cast<double>(p.step);
            if (progress.due())
                progress.show(step, expected,
                              fmt::format("{} in LAMMPS: step {}, {}, {} grains, kinetic {}",
                                          task.id, reports::count(step),
                                          reports::quantity(step * task.setup.time_step, "s"),
                                          p.grains, reports::quantity(p.kinetic, "J")));
        });
    ExperimentRun run{
        task.id, "pile", lammps.seconds, std::nullopt, {{"interrupted_at_step", reached}}};
    if (lammps.end) {
        const rigs::PileRecord& record = lammps.end->record;
        write_pile(task.folder, task.id, record);
        run.section = reports::pile_section(task.id, record);
        run.result = reports::to_json(record);
    }
    run.result["engine"] = engine_json(lammps.release, ranks, lammps.command, deck);
    return run;
}

// What only our own core can do with a pile.
void refuse_for_lammps(const CommonOptions& o, const RunPlace& place) {
    const auto refuse = [](const std::string& option, const std::string& remedy) {
        throw InvalidInput(mistake(option, "with --engine lammps",
                                   "must be left out: the run is LAMMPS' own", remedy));
    };
    if (!place.dump.formats.empty())
        refuse("--dump", "add a dump to the deck in ID-lammps/ and run it by hand");
    if (o.resume) refuse("--resume", "start anew");
    if (place.sleep) refuse("--sleep", "dem_min has it");
}

std::function<ExperimentRun()> prepared_pile(const Case& c, const Experiment& e,
                                             const CommonOptions& o, const RunPlace& place) {
    PileTask task = pile_task(c, e, o, place);
    if (!place.engine.lammps) return [task] { return pile_run(task); };
    refuse_for_lammps(o, place);
    engines::lammps_program("--engine");
    engines::refuse_ranks_without_mpirun(place.engine.ranks);
    engines::lammps_pile(task.setup);  // says what it cannot take before anything runs
    return [task, ranks = place.engine.ranks] { return lammps_run(task, ranks); };
}

// The deck stays in ID-lammps/.
ExperimentRun lammps_curves_run(const Case& c, const Experiment& e,
                                const std::filesystem::path& folder) {
    const std::filesystem::path deck = folder / (e.id + "-lammps");
    const rigs::Ordinates at = rigs::ordinates_of(e);
    const engines::LammpsCurvesRun lammps =
        engines::run_lammps_one_grain(engines::lammps_program("--engine"), c, e, at, deck);
    ExperimentRun run{e.id, e.rig, lammps.seconds, std::nullopt, {{"rows", at.at.size()}}};
    if (!lammps.interrupted) {
        const std::vector<cases::Column> columns = curve_columns(e, lammps.curves, at);
        cases::write_csv((folder / (e.id + ".csv")).string(), columns);
        run.section = reports::curves_section(e.id, columns, e.recording ? &*e.recording : nullptr);
    }
    run.result["engine"] = engine_json(lammps.release, 1, lammps.command, deck);
    return run;
}

std::function<ExperimentRun()> prepared_in_lammps(const Case& c, const Experiment& e,
                                                  const CommonOptions& o, const RunPlace& place) {
    refuse_for_lammps(o, place);
    if (place.engine.ranks > 1)
        throw InvalidInput(mistake("--ranks", std::to_string(place.engine.ranks),
                                   "must be 1 for a single grain", "leave --ranks out"));
    engines::lammps_program("--engine");
    // Says what it cannot take before anything runs.
    engines::lammps_one_grain(c, e, rigs::ordinates_of(e));
    return [&c, &e, folder = place.folder] { return lammps_curves_run(c, e, folder); };
}

ExperimentRun drop_run(const Experiment& e, const rigs::DropSetup& setup,
                       const std::filesystem::path& folder) {
    const auto start = std::chrono::steady_clock::now();
    const cases::Recording* recording = e.recording ? &*e.recording : nullptr;
    const rigs::DropRecord record = recording != nullptr
                                        ? rigs::run_drop(setup, recording->values("t"))
                                        : rigs::run_drop(setup);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    cases::write_csv((folder / (e.id + ".csv")).string(),
                     {{"t", "s", record.t}, {"z", "m", record.z}, {"x", "m", record.x}});
    return {e.id, "drop", seconds.count(), reports::drop_section(e.id, record, recording),
            reports::to_json(record)};
}

// Of the rigs with a forward model and no runner of their own.
ExperimentRun curves_run(const Experiment& e, const rigs::World& world,
                         const std::filesystem::path& folder) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<cases::Column> columns = forward_curves(e, world, rigs::ordinates_of(e));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    cases::write_csv((folder / (e.id + ".csv")).string(), columns);
    const cases::Recording* recording = e.recording ? &*e.recording : nullptr;
    return {e.id,
            e.rig,
            seconds.count(),
            reports::curves_section(e.id, columns, recording),
            {{"rows", columns.front().values.size()}}};
}

bool has_curves(const Experiment& e) {
    return e.rig == "incline" || e.rig == "impact" || e.rig == "pull_off";
}

}  // namespace

EngineChoice engine_choice(const std::string& engine, int ranks, const std::string& contact) {
    const auto one_of = [](const char* option, const std::string& got, const char* a,
                           const char* b) {
        if (got != a && got != b)
            throw InvalidInput(mistake(option, cases::in_quotes(got),
                                       fmt::format("must be {} or {}", a, b),
                                       fmt::format("{} is the default", a)));
        return got == b;
    };
    EngineChoice choice;
    choice.lammps = one_of("--engine", engine, "dem_min", "lammps");
    choice.lammps_rules = one_of("--contact", contact, "own", "lammps");
    if (ranks != 0 && !choice.lammps)
        throw InvalidInput(mistake("--ranks", std::to_string(ranks), "must go with --engine lammps",
                                   "the core takes --threads"));
    if (ranks < 0)
        throw InvalidInput(
            mistake("--ranks", std::to_string(ranks), "must be > 0", "1 is the default"));
    choice.ranks = ranks == 0 ? 1 : ranks;
    return choice;
}

rigs::PileSetup chosen_setup(const Case& c, const Experiment& e, std::uint64_t seed, bool yes,
                             const EngineChoice& choice) {
    rigs::PileSetup setup = counted_setup(c, e, seed, yes);
    if (choice.lammps_rules) rigs::take_lammps_rules(setup);
    return setup;
}

bool can_simulate(const Experiment& e) {
    return e.rig == "pile" || e.rig == "drop" || has_curves(e);
}

std::function<ExperimentRun()> prepared(const Case& c, const Experiment& e, const CommonOptions& o,
                                        const RunPlace& place) {
    if (e.rig == "pile") return prepared_pile(c, e, o, place);
    if (place.engine.lammps) return prepared_in_lammps(c, e, o, place);
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
                               "rig " + cases::in_quotes(e.rig),
                               "must be of the rig pile, drop, incline, impact or pull_off",
                               "no other rig can be simulated yet"));
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace app
