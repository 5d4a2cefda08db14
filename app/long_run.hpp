// SPDX-License-Identifier: MIT
// A simulation of any rig from its setup to its end, interruptible: on a signal, and every now and then, the run
// is put on disk.
#pragma once

#include "app/dump.hpp"
#include "rigs/pile.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace app {

struct RunPlan {
    std::string id;                // of the experiment; names the files
    std::filesystem::path folder;  // of checkpoints
    std::uint64_t
        fingerprint;  // of everything that decides the run: a checkpoint of another one is refused
    int threads = 1;
    bool resume = false, progress = true;
    DumpPlan dump{};
    double checkpoint_every = 300.0;  // s of wall time
};

// A run of a rig, as far as it has to be known to be carried out.
struct RigRun {
    dem_min::Simulation& simulation;
    Box box;  // of a frame, unless its grains need more
    std::int64_t expected_steps;
    std::function<void(std::int64_t steps)> advance;
    std::function<bool()> finished;
    std::function<double(double steps)> work;  // expected, in grain-steps, until then
    std::function<std::string(double grain_steps_per_second, double awake)> status;
    // What a checkpoint says beside the grains; taken back before they are read.
    std::function<nlohmann::json()> state;
    std::function<void(const nlohmann::json&)> take_state;
};

struct RunOutcome {
    bool finished;  // else it was interrupted, and the checkpoint is on disk
    std::int64_t steps;
    double seconds;      // wall time, with that of earlier parts
    std::size_t frames;  // dumped so far
    std::vector<std::filesystem::path> dumps;
};

// With `resume` it goes on from its checkpoint if there is one. Throws scaling::InvalidInput for a
// checkpoint of another run. A finished run has its checkpoint too, until it is forgotten: so an
// interrupt during a later experiment does not cost this one.
RunOutcome carry_out(const RunPlan&, const RigRun&);

// Takes the checkpoint away.
void forget(const RunPlan&);

// FNV-1a of bytes, 64 bits; chained through `start`.
std::uint64_t fingerprint_of(const std::string& bytes, std::uint64_t start = 14695981039346656037u);

}  // namespace app
