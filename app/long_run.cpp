// SPDX-License-Identifier: MIT
#include "app/long_run.hpp"

#include "app/common.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "dem_min/checkpoint.hpp"
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

std::filesystem::path state_file(const RunPlan& plan) {
    return plan.folder / (plan.id + ".state.json");
}
// The steps are in the name, so that a state never meets a checkpoint of another instant.
std::filesystem::path checkpoint_file(const RunPlan& plan, std::int64_t steps) {
    return plan.folder / fmt::format("{}.{}.checkpoint", plan.id, steps);
}

std::string hexadecimal(std::uint64_t value) { return fmt::format("{:016x}", value); }

// What a checkpoint says beside the grains themselves.
struct State {
    std::uint64_t fingerprint;
    std::int64_t steps;
    double seconds;
    nlohmann::json rig, dump;
};

[[noreturn]] void refuse_state(const std::string& path, const std::string& what) {
    throw scaling::InvalidInput(scaling::mistake(path, what,
                                                 "must be the state of an interrupted run",
                                                 "remove it, or start anew without --resume"));
}

State read_state(const RunPlan& plan) {
    const std::string path = state_file(plan).string();
    try {
        std::ifstream file(path);
        const nlohmann::json j = nlohmann::json::parse(file);
        return {std::stoull(j.at("fingerprint").get<std::string>(), nullptr, 16), j.at("steps"),
                j.at("seconds"), j.at("rig"), j.at("dump")};
    } catch (const std::exception& error) {
        refuse_state(path, error.what());
    }
}

// Checkpoints of this experiment but that of step `kept`; one cut off while it was written goes too.
void remove_checkpoints(const RunPlan& plan, std::int64_t kept) {
    std::error_code ignored;  // a leftover costs room, nothing else
    const std::string start = plan.id + ".", kept_name = checkpoint_file(plan, kept).filename();
    for (const auto& entry : std::filesystem::directory_iterator(plan.folder, ignored)) {
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
void write_state(const RunPlan& plan, const RigRun& run, const Dump& dump, double seconds) {
    const std::int64_t steps = run.simulation.steps;
    std::filesystem::create_directories(plan.folder);
    dem_min::write_checkpoint(run.simulation, checkpoint_file(plan, steps));
    const nlohmann::json j = {{"fingerprint", hexadecimal(plan.fingerprint)},
                              {"steps", steps},
                              {"rig", run.state()},
                              {"seconds", seconds},
                              {"dump", described(dump)}};
    const std::filesystem::path file = state_file(plan), half = file.string() + ".tmp";
    write_file(half.string(), j.dump(2) + "\n");
    std::filesystem::rename(half, file);
    remove_checkpoints(plan, steps);
}

// Returns the wall time that the run has taken so far, s.
double resume(const RigRun& run, Dump& dump, const RunPlan& plan) {
    const State state = read_state(plan);
    if (state.fingerprint != plan.fingerprint)
        throw scaling::InvalidInput(scaling::mistake(
            state_file(plan).string(), hexadecimal(state.fingerprint),
            "must belong to this case, seed and version: " + hexadecimal(plan.fingerprint),
            "start anew without --resume, or choose another --out"));
    try {
        run.take_state(state.rig);
    } catch (const nlohmann::json::exception& error) {
        refuse_state(state_file(plan).string(), error.what());
    }
    dem_min::read_checkpoint(run.simulation, checkpoint_file(plan, state.steps));
    resume(dump, state.dump);
    return state.seconds;
}

rigs::GrainSteps grain_steps(const dem_min::Simulation& s) {
    return {s.past.grain_steps, s.past.grain_steps_slept};
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
std::int64_t advance_part(const RigRun& run, std::int64_t frame, std::int64_t part) {
    const auto start = Clock::now();
    const std::int64_t steps = std::min(part, frame - run.simulation.steps);
    run.advance(steps);
    const double seconds = seconds_since(start);
    if (seconds > longest_part) return std::max<std::int64_t>(1, part / 2);
    return seconds < shortest_part && steps == part ? std::min(most_steps, 2 * part) : part;
}

}  // namespace

RunOutcome carry_out(const RunPlan& plan, const RigRun& run) {
    const dem_min::Simulation& s = run.simulation;
    Dump dump{.plan = plan.dump,
              .folder = plan.folder,
              .id = plan.id,
              .time_step = s.settings.time_step,
              .box = run.box};
    double earlier = 0.0;  // s
    if (plan.resume && std::filesystem::exists(state_file(plan))) {
        earlier = resume(run, dump, plan);
    } else {
        forget(plan);
        begin(dump);
    }
    const auto start = Clock::now();
    auto last_checkpoint = start;
    const auto outcome = [&](bool finished) -> RunOutcome {
        return {finished, s.steps, earlier + seconds_since(start), dump.steps.size(), files(dump)};
    };
    const auto work_so_far = [&] { return run.work(static_cast<double>(s.steps)); };
    const double whole = run.work(static_cast<double>(run.expected_steps));
    Progress progress(plan.progress);
    progress.start(work_so_far());
    Speed speed(grain_steps(s));
    std::int64_t part = 100;
    while (!run.finished()) {
        if (s.steps == next_frame(dump)) add_frame(dump, s);
        part = advance_part(run, next_frame(dump), part);
        if (progress.due()) {
            const Speed::Since since = speed.since_last(grain_steps(s));
            progress.show(work_so_far(), whole,
                          run.status(since.grain_steps_per_second, since.awake));
        }
        const bool stop = interrupt_flag() && !run.finished();
        if (stop || seconds_since(last_checkpoint) >= plan.checkpoint_every) {
            write_state(plan, run, dump, earlier + seconds_since(start));
            last_checkpoint = Clock::now();
        }
        if (stop) return outcome(false);
    }
    add_frame(dump, s);
    write_state(plan, run, dump, earlier + seconds_since(start));
    return outcome(true);
}

void forget(const RunPlan& plan) {
    std::error_code ignored;
    std::filesystem::remove(state_file(plan), ignored);
    remove_checkpoints(plan, -1);
}

std::uint64_t fingerprint_of(const std::string& bytes, std::uint64_t start) {
    std::uint64_t hash = start;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return hash;
}

}  // namespace app
