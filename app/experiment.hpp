// SPDX-License-Identifier: MIT
// One experiment of a case, run: its files written, its result in the shapes that reports want.
#pragma once

#include "app/common.hpp"
#include "app/dump.hpp"
#include "cases/case.hpp"
#include "reports/runs.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace app {

struct ExperimentRun {
    std::string id, rig;
    double seconds;
    std::optional<reports::RunSection> section;  // none where interrupted
    reports::Json result;
    std::vector<std::filesystem::path> dumps{};  // to open, one a format
    std::size_t frames = 0;                      // in each of them
    std::function<void()> forget = [] {};        // once all results are on disk: the checkpoint
};

struct RunPlace {
    std::filesystem::path folder;
    bool yes;  // run whatever it costs
    DumpPlan dump{};
    double checkpoint_every = 300.0;  // s of wall time
    bool sleep = false;               // quiet regions of a heap are left out
};

// Checks everything that can be wrong with the experiment now and returns what runs it later:
// ID.csv with the rig's channels, ID-grains.csv of a pile. Throws scaling::InvalidInput for a rig
// that cannot be simulated, for a pile that is fed without a count, for a cost beyond a night unless
// `yes`, and for frames that lie closer than time steps. A drop has no frames.
std::function<ExperimentRun()> prepared(const cases::Case&, const cases::Experiment&,
                                        const CommonOptions&, const RunPlace&);

bool can_simulate(const cases::Experiment&);

std::string bytes_of(const std::string& path);

}  // namespace app
