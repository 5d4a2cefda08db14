// SPDX-License-Identifier: MIT
// One pile from its setup to its record, interruptible: on a signal, and every five minutes, the
// run is put on disk.
#pragma once

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
};

struct PileOutcome {
    std::optional<rigs::PileRecord>
        record;  // none where interrupted; the checkpoint is on disk then
    std::int64_t steps;
    double seconds;  // wall time, with that of earlier parts
};

// With `resume` it goes on from its checkpoint if there is one. A finished run leaves no checkpoint
// behind. Throws scaling::InvalidInput for a checkpoint of another run.
PileOutcome run_pile(const PileTask&);

// FNV-1a of bytes, 64 bits; chained through `start`.
std::uint64_t fingerprint_of(const std::string& bytes, std::uint64_t start = 14695981039346656037u);

}  // namespace app
