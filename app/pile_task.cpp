// SPDX-License-Identifier: MIT
#include "app/pile_task.hpp"

#include "app/common.hpp"
#include "app/interrupt.hpp"
#include "app/pile_status.hpp"
#include "app/progress.hpp"
#include "dem_min/checkpoint.hpp"
#include "reports/numbers.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>

namespace app {

namespace {

using Clock = std::chrono::steady_clock;

// Signals, status and checkpoints are looked after between two parts of a run, which are so long
// that nobody waits for them and so short that nobody notices.
constexpr double shortest_part = 0.05, longest_part = 0.2;  // s
constexpr std::int64_t most_steps = 2000;

std::filesystem::path state_file(const PileTask& task) {
    return task.folder / (task.id + ".state.json");
}
// The steps are in the name, so that a state never meets a checkpoint of another instant.
std::filesystem::path checkpoint_file(const PileTask& task, std::int64_t steps) {
    return task.folder / fmt::format("{}.{}.checkpoint", task.id, steps);
}

std::string hexadecimal(std::uint64_t value) { return fmt::format("{:016x}", value); }

// What a checkpoint says beside the grains themselves.
struct State {
    std::uint64_t fingerprint;
    std::int64_t steps, still_since;
    std::size_t fed;
    rigs::GrainSteps while_fed;
    bool at_rest, finished;
    double seconds;
    nlohmann::json dump;
};

State read_state(const PileTask& task) {
    const std::string path = state_file(task).string();
    try {
        std::ifstream file(path);
        const nlohmann::json j = nlohmann::json::parse(file);
        return {std::stoull(j.at("fingerprint").get<std::string>(), nullptr, 16),
                j.at("steps"),
                j.at("still_since"),
                j.at("fed"),
                {j.at("while_fed").at(0), j.at("while_fed").at(1)},
                j.at("at_rest"),
                j.at("finished"),
                j.at("seconds"),
                j.at("dump")};
    } catch (const std::exception& error) {
        throw scaling::InvalidInput(scaling::mistake(path, error.what(),
                                                     "must be the state of an interrupted run",
                                                     "remove it, or start anew without --resume"));
    }
}

// Checkpoints of this experiment but that of step `kept`; one cut off while it was written goes too.
void remove_checkpoints(const PileTask& task, std::int64_t kept) {
    std::error_code ignored;  // a leftover costs room, nothing else
    const std::string start = task.id + ".", kept_name = checkpoint_file(task, kept).filename();
    for (const auto& entry : std::filesystem::directory_iterator(task.folder, ignored)) {
        const std::string name = entry.path().filename();
        if (!name.starts_with(start) || name == kept_name) continue;
        const std::size_t digits = name.find_first_not_of("0123456789", start.size());
        const std::string rest = digits == std::string::npos ? "" : name.substr(digits);
        if (rest == ".checkpoint" || rest == ".checkpoint.tmp")
            std::filesystem::remove(entry.path(), ignored);
    }
}

// New grains first, then the state that points at them, then the old grains go: whenever this is
// cut off, one whole pair stays.
void write_state(const PileTask& task, const rigs::PileRun& run, const Dump& dump, double seconds) {
    const std::int64_t steps = run.simulation.steps;
    std::filesystem::create_directories(task.folder);
    dem_min::write_checkpoint(run.simulation, checkpoint_file(task, steps));
    const nlohmann::json j = {{"fingerprint", hexadecimal(task.fingerprint)},
                              {"steps", steps},
                              {"still_since", run.still_since},
                              {"fed", run.fed},
                              {"while_fed", {run.while_fed.asked, run.while_fed.slept}},
                              {"at_rest", run.at_rest},
                              {"finished", run.finished},
                              {"seconds", seconds},
                              {"dump", described(dump)}};
    const std::filesystem::path file = state_file(task), half = file.string() + ".tmp";
    write_file(half.string(), j.dump(2) + "\n");
    std::filesystem::rename(half, file);
    remove_checkpoints(task, steps);
}

// Returns the wall time that the run has taken so far, s.
double resume(rigs::PileRun& run, Dump& dump, const PileTask& task) {
    const State state = read_state(task);
    if (state.fingerprint != task.fingerprint)
        throw scaling::InvalidInput(scaling::mistake(
            state_file(task).string(), hexadecimal(state.fingerprint),
            "must belong to this case, seed and version: " + hexadecimal(task.fingerprint),
            "start anew without --resume, or choose another --out"));
    dem_min::read_checkpoint(run.simulation, checkpoint_file(task, state.steps));
    resume(dump, state.dump);
    run.fed = state.fed;
    run.while_fed = state.while_fed;
    run.still_since = state.still_since;
    run.at_rest = state.at_rest;
    run.finished = state.finished;
    return state.seconds;
}

// What holds every grain of the rig that has not yet fallen off.
Box box_of(const rigs::PileSetup& setup) {
    const rigs::PileConditions& c = setup.conditions;
    double width = std::max(c.base_diameter, c.feed_diameter), top = c.drop_height;
    if (c.funnel) {
        width = std::max(width, c.funnel->top_diameter);
        top = c.funnel->outlet_height + c.funnel->height;
    }
    return {{-0.5 * width, -0.5 * width, setup.lost_below}, {0.5 * width, 0.5 * width, top}};
}

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// What was done since it was last asked.
class Speed {
  public:
    explicit Speed(rigs::GrainSteps so_far) : then_(so_far) {}

    struct Since {
        double grain_steps_per_second,
            awake;  // awake: 1, share of the grain-steps that were not slept
    };
    Since since_last(rigs::GrainSteps now) {
        const rigs::GrainSteps part{now.asked - then_.asked, now.slept - then_.slept};
        const double speed = static_cast<double>(part.asked) / seconds_since(last_);
        then_ = now;
        last_ = Clock::now();
        return {speed, 1.0 - part.share_slept()};
    }

  private:
    rigs::GrainSteps then_;
    Clock::time_point last_ = Clock::now();
};

// Goes on until the next frame is due or the part has been long enough; returns how many steps the
// next part should have.
std::int64_t advance_part(rigs::PileRun& run, const PileTask& task, std::int64_t frame,
                          std::int64_t part) {
    const auto start = Clock::now();
    const std::int64_t steps = std::min(part, frame - run.simulation.steps);
    rigs::advance(run, task.setup, steps);
    const double seconds = seconds_since(start);
    if (seconds > longest_part) return std::max<std::int64_t>(1, part / 2);
    return seconds < shortest_part && steps == part ? std::min(most_steps, 2 * part) : part;
}

}  // namespace

PileOutcome run_pile(const PileTask& task) {
    rigs::PileRun run = rigs::begin_pile(task.setup, task.threads);
    const dem_min::Simulation& s = run.simulation;
    const std::size_t glued = s.grains.count();
    Dump dump{.plan = task.dump,
              .folder = task.folder,
              .id = task.id,
              .time_step = task.setup.time_step,
              .box = box_of(task.setup)};
    double earlier = 0.0;  // s
    if (task.resume && std::filesystem::exists(state_file(task))) {
        earlier = resume(run, dump, task);
    } else {
        forget(task);
        begin(dump);
    }
    const auto start = Clock::now();
    auto last_checkpoint = start;
    const auto work = [&](std::int64_t steps) {
        return expected_work(task.setup, glued, static_cast<double>(steps));
    };
    const double whole = work(rigs::expected_steps(task.setup));
    Progress progress(task.progress);
    progress.start(work(s.steps));
    Speed speed(run.work());
    std::int64_t part = 100;
    while (!run.finished) {
        if (s.steps == next_frame(dump)) add_frame(dump, s);
        part = advance_part(run, task, next_frame(dump), part);
        if (progress.due()) {
            const Speed::Since since = speed.since_last(run.work());
            progress.show(
                work(s.steps), whole,
                pile_status(task.id, run, task.setup, since.grain_steps_per_second, since.awake));
        }
        const bool stop = interrupt_flag() && !run.finished;
        if (stop || seconds_since(last_checkpoint) >= task.checkpoint_every) {
            write_state(task, run, dump, earlier + seconds_since(start));
            last_checkpoint = Clock::now();
        }
        if (stop)
            return {std::nullopt, s.steps, earlier + seconds_since(start), dump.steps.size(),
                    files(dump)};
    }
    add_frame(dump, s);
    write_state(task, run, dump, earlier + seconds_since(start));
    return {rigs::record(run, task.setup), s.steps, earlier + seconds_since(start),
            dump.steps.size(), files(dump)};
}

void forget(const PileTask& task) {
    std::error_code ignored;
    std::filesystem::remove(state_file(task), ignored);
    remove_checkpoints(task, -1);
}

std::uint64_t fingerprint_of(const std::string& bytes, std::uint64_t start) {
    std::uint64_t hash = start;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return hash;
}

}  // namespace app
