// SPDX-License-Identifier: MIT
#include "app/pile_task.hpp"

#include "app/common.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "dem_min/checkpoint.hpp"
#include "reports/numbers.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <fstream>

namespace app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t steps_at_once = 200;
constexpr std::chrono::minutes between_checkpoints{5};

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
    bool at_rest;
    double seconds;
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
                j.at("at_rest"),
                j.at("seconds")};
    } catch (const std::exception& error) {
        throw scaling::InvalidInput(scaling::mistake(path, error.what(),
                                                     "must be the state of an interrupted run",
                                                     "remove it, or start anew without --resume"));
    }
}

void remove_old(const PileTask& task, std::int64_t steps) {
    std::error_code ignored;  // a leftover costs room, nothing else
    std::filesystem::remove(checkpoint_file(task, steps), ignored);
}

// New grains first, then the state that points at them, then the old grains go: whenever this is
// cut off, one whole pair stays. Returns the steps of the checkpoint written.
std::int64_t write_state(const PileTask& task, const rigs::PileRun& run, double seconds,
                         std::int64_t old_steps) {
    const std::int64_t steps = run.simulation.steps;
    std::filesystem::create_directories(task.folder);
    dem_min::write_checkpoint(run.simulation, checkpoint_file(task, steps));
    const nlohmann::json j = {{"fingerprint", hexadecimal(task.fingerprint)},
                              {"steps", steps},
                              {"still_since", run.still_since},
                              {"fed", run.fed},
                              {"at_rest", run.at_rest},
                              {"seconds", seconds}};
    const std::filesystem::path file = state_file(task), half = file.string() + ".tmp";
    write_file(half.string(), j.dump(2) + "\n");
    std::filesystem::rename(half, file);
    if (old_steps != steps) remove_old(task, old_steps);
    return steps;
}

State resumed(rigs::PileRun& run, const PileTask& task) {
    const State state = read_state(task);
    if (state.fingerprint != task.fingerprint)
        throw scaling::InvalidInput(scaling::mistake(
            state_file(task).string(), hexadecimal(state.fingerprint),
            "must belong to this case, seed and version: " + hexadecimal(task.fingerprint),
            "start anew without --resume, or choose another --out"));
    dem_min::read_checkpoint(run.simulation, checkpoint_file(task, state.steps));
    run.fed = state.fed;
    run.still_since = state.still_since;
    run.at_rest = state.at_rest;
    return state;
}

std::string what_happens(const PileTask& task, const rigs::PileRun& run) {
    return fmt::format("{}: step {}, {} of {} grains fed", task.id,
                       reports::count(static_cast<double>(run.simulation.steps)), run.fed,
                       task.setup.feed_time.size());
}

}  // namespace

PileOutcome run_pile(const PileTask& task) {
    rigs::PileRun run = rigs::begin_pile(task.setup, task.threads);
    State state{task.fingerprint, -1, -1, 0, false, 0.0};
    if (task.resume && std::filesystem::exists(state_file(task))) state = resumed(run, task);
    const auto start = Clock::now();
    const auto seconds = [&] {
        return state.seconds + std::chrono::duration<double>(Clock::now() - start).count();
    };
    const auto expected = static_cast<double>(rigs::expected_steps(task.setup));
    auto last_checkpoint = start;
    Progress progress(task.progress);
    while (!run.finished) {
        rigs::advance(run, task.setup, steps_at_once);
        progress.show(static_cast<double>(run.simulation.steps), expected, what_happens(task, run));
        if (interrupt_flag() && !run.finished) {
            write_state(task, run, seconds(), state.steps);
            return {std::nullopt, run.simulation.steps, seconds()};
        }
        if (Clock::now() - last_checkpoint < between_checkpoints) continue;
        state.steps = write_state(task, run, seconds(), state.steps);
        last_checkpoint = Clock::now();
    }
    std::error_code ignored;
    std::filesystem::remove(state_file(task), ignored);
    remove_old(task, state.steps);
    return {rigs::record(run, task.setup), run.simulation.steps, seconds()};
}

std::uint64_t fingerprint_of(const std::string& bytes, std::uint64_t start) {
    std::uint64_t hash = start;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return hash;
}

}  // namespace app
