// SPDX-License-Identifier: MIT
// One pile from its setup to its record, interruptible: on a signal, and every now and then, the run
// is put on disk.
#pragma once

#include "app/dump.hpp"
#include "rigs/pile.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace app {

struct PileTask {
    std::string id;  // of the experiment; names the files
    rigs::PileSetup setup;
    std::filesystem::path folder;  // of checkpoints
    std::uint64_t
        fingerprint;  // of everything that decides the run: a checkpoint of another one is refused
    int threads = 1;
    bool resume = false, progress = true;
    DumpPlan dump{};
    double checkpoint_every = 300.0;  // s of wall time
};

struct PileOutcome {
    std::optional<rigs::PileRecord>
        record;  // none where interrupted; the checkpoint is on disk then
    std::int64_t steps;
    double seconds;      // wall time, with that of earlier parts
    std::size_t frames;  // dumped so far
    std::vector<std::filesystem::path> dumps;
};

// With `resume` it goes on from its checkpoint if there is one. Throws scaling::InvalidInput for a
// checkpoint of another run. A finished run has its checkpoint too, until it is forgotten: so an
// interrupt during a later experiment does not cost this one.
PileOutcome run_pile(const PileTask&);

// Takes the checkpoint away.
void forget(const PileTask&);

// FNV-1a of bytes, 64 bits; chained through `start`.
std::uint64_t fingerprint_of(const std::string& bytes, std::uint64_t start = 14695981039346656037u);

}  // namespace app
