// SPDX-License-Identifier: MIT
// One experiment of a case, run: its files written, its result in the shapes that reports want.
#pragma once

#include "app/common.hpp"
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
};

struct RunPlace {
    std::filesystem::path folder;
    bool yes;  // run whatever it costs
};

// Checks everything that can be wrong with the experiment now and returns what runs it later:
// ID.csv with the rig's channels, ID-grains.csv of a pile. Throws scaling::InvalidInput for a rig
// that cannot be simulated, for a pile that is fed without a count, and for a cost beyond a night
// unless `yes`.
std::function<ExperimentRun()> prepared(const cases::Case&, const cases::Experiment&,
                                        const CommonOptions&, const RunPlace&);

bool can_simulate(const cases::Experiment&);

std::string bytes_of(const std::string& path);

}  // namespace app
