// SPDX-License-Identifier: MIT
// One run of the rig `discharge`, `column` or `drum` from its setup to its record.
#pragma once

#include "app/long_run.hpp"
#include "rigs/flow.hpp"

#include <optional>

namespace app {

struct FlowTask {
    RunPlan plan;
    rigs::FlowSetup setup;
};

struct FlowOutcome {
    std::optional<rigs::FlowRecord> record;  // none where interrupted
    RunOutcome run;
};

FlowOutcome run_flow(const FlowTask&);

}  // namespace app
