// SPDX-License-Identifier: MIT
// The rig `drop` as the command line runs it: one grain released above a flat horizontal plate (docs/drop.md).
#pragma once

#include "cases/case.hpp"
#include "rigs/drop_path.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace rigs {

// From an experiment of the rig `drop`; all but the height 0 where left out. Throws scaling::InvalidInput.
DropConditions drop_conditions(const Stated&, const World&);

struct DropSetup {
    DropConditions conditions;
    OneGrain grain;
    std::optional<cases::Numerics> numerics;  // of the user's run; without: as exact as need be
};

// Throws scaling::InvalidInput where the model holds physics that a single grain on a plate does not show.
DropSetup drop_setup(const cases::Case&, const cases::Experiment&);

struct DropRecord {
    std::vector<double> t, z, x;  // s, m, m; z of the lowest point, x from the place of release
    bool settled = false;         // lies still, slides or rolls: does not leave the plate again
    double settled_at = 0.0;      // s
    int impacts = 0;
    std::int64_t steps = 0;  // of fixed length, where the numerics ask for them
};

// At the given times, which must not fall. Throws scaling::InvalidParameter otherwise.
DropRecord run_drop(const DropSetup&, const std::vector<double>& times);

// At `count` even times from 0 until the grain has settled, or 20 times the first fall where it does not within them. Throws
// scaling::InvalidParameter where it never comes down.
DropRecord run_drop(const DropSetup&, int count = 200);

}  // namespace rigs
