// SPDX-License-Identifier: MIT
#include "app/experiment.hpp"

#include "app/machine_speed.hpp"
#include "app/pile_task.hpp"
#include "app/version.hpp"
#include "cases/csv.hpp"
#include "cases/messages.hpp"
#include "cases/rig_table.hpp"
#include "reports/numbers.hpp"
#include "rigs/drop.hpp"
#include "rigs/forward.hpp"
#include "rigs/height_map.hpp"
#include "rigs/single_grain.hpp"
#include "scaling/cost.hpp"
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

constexpr double longest_unasked = 12.0 * 3600.0;  // s: a night
constexpr double most_grains_unasked = 5e6;        // some 5 GB of grains and contacts

// Feeding until grains fall off needs a count here; says how many the base is likely to carry.
void refuse_endless(const Experiment& e) {
    const cases::Value& grains = e.conditions.at("grains");
    if (grains.kind != cases::Value::Kind::text) return;
    constexpr double angle = 0.7853981633974483,
                     packing = 0.5;  // 45 degrees: an order of magnitude is meant
    const double likely = scaling::grains_in(
        {e.conditions.at("base_diameter").quantity<scaling::Length>(), angle, packing},
        e.grain.diameter.value);
    cases::refuse(
        grains, "must be a count to be simulated",
        fmt::format("a heap on this base holds about {} grains of {}; scale the powder first",
                    reports::number(likely),
                    reports::quantity(e.grain.diameter.value.value(), "m")));
}

[[noreturn]] void refuse_cost(const Experiment& e, const std::string& got,
                              const std::string& rule) {
    throw InvalidInput(
        mistake("experiment " + cases::in_quotes(e.id), got, rule,
                "take fewer or larger grains (similitude scale), a softer modulus, or say --yes"));
}

void refuse_unaffordable(const Experiment& e, const rigs::PileSetup& setup, int threads) {
    const double grains = static_cast<double>(setup.feed_time.size());
    const double steps = static_cast<double>(rigs::expected_steps(setup));
    const double seconds = grains * steps / measured_speed(threads);
    if (seconds > longest_unasked)
        refuse_cost(
            e,
            fmt::format("{} grains x {} steps, about {} on this machine", reports::count(grains),
                        reports::count(steps), reports::quantity(seconds, "s")),
            "must not need more than 12 h unasked");
}

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
    refuse_endless(e);
    const double grains = static_cast<double>(e.conditions.at("grains").count());
    if (!place.yes && grains > most_grains_unasked)
        refuse_cost(e, reports::count(grains) + " grains", "must not be more than 5e6 unasked");
    const int threads = threads_of(o);
    PileTask task{.id = e.id,
                  .setup = rigs::pile_setup(c, e, o.seed),
                  .folder = place.folder,
                  .fingerprint = fingerprint_of(fmt::format("\n{} {} {}", e.id, o.seed, version),
                                                files_of(c, e)),
                  .threads = threads,
                  .resume = o.resume,
                  .progress = !o.quiet,
                  .dump = place.dump,
                  .checkpoint_every = place.checkpoint_every};
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
    const rigs::Ordinates at = rigs::ordinates_of(e);
    const rigs::Curves curves = rigs::forward_model(e)->predict(world, at);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const cases::RigRule& rig = cases::rig_rule(e.rig);
    const auto unit = [&](const std::string& channel) {
        return cases::find_channel(rig, channel)->units.front();
    };
    const std::string ordinate = rigs::ordinate_name(e);
    std::vector<cases::Column> columns{{ordinate, unit(ordinate), at.at, {}}};
    for (const auto& [name, values] : curves) columns.push_back({name, unit(name), values, {}});
    if (!at.retract.empty()) {
        columns.push_back({"branch", "", {}, {}});
        for (const bool back : at.retract)
            columns.back().words.emplace_back(back ? "retract" : "approach");
    }
    cases::write_csv((folder / (e.id + ".csv")).string(), columns);
    const cases::Recording* recording = e.recording ? &*e.recording : nullptr;
    return {e.id,
            e.rig,
            seconds.count(),
            reports::curves_section(e.id, columns, recording),
            {{"rows", at.at.size()}}};
}

bool has_curves(const Experiment& e) {
    return e.rig == "incline" || e.rig == "impact" || e.rig == "pull_off";
}

}  // namespace

bool can_simulate(const Experiment& e) {
    return e.rig == "pile" || e.rig == "drop" || has_curves(e);
}

std::function<ExperimentRun()> prepared(const Case& c, const Experiment& e, const CommonOptions& o,
                                        const RunPlace& place) {
    if (e.rig == "pile") return [task = pile_task(c, e, o, place)] { return pile_run(task); };
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
