// SPDX-License-Identifier: MIT
// One pile from its setup to its record.
#pragma once

#include "app/long_run.hpp"
#include "rigs/pile.hpp"

#include <optional>

namespace app {

struct PileTask {
    RunPlan plan;
    rigs::PileSetup setup;
};

struct PileOutcome {
    std::optional<rigs::PileRecord> record;  // none where interrupted
    RunOutcome run;
};

PileOutcome run_pile(const PileTask&);

}  // namespace app
