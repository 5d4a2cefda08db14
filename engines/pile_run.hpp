// SPDX-License-Identifier: MIT
// A pile in another engine: its deck run, its progress told, and the heap of final.dump read back as that of a run of our own.
// A deck prints lines of `step grains kinetic-energy top top`, and at the end "similitude: at rest at step N" or "similitude: given
// up at step N".
#pragma once

#include "engines/peer.hpp"
#include "rigs/pile_engine.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace engines {

struct PileProgress {
    std::int64_t step = 0, grains = 0;  // glued ones included
    double kinetic = 0.0;               // J, of translation
};

struct PeerPileRun {
    std::string release;  // "29 Sep 2021 - Update 2"
    bool interrupted;
    double seconds;                    // wall time
    std::vector<std::string> command;  // as it was run
    std::optional<rigs::PileEnd> end;  // none where interrupted
};

// Runs the deck that lies in `folder`. `show` is called as output comes. The record's `coordination` counts what touches: a stretched
// neck is not told. Throws std::runtime_error with the engine's error and the log's path where it fails.
PeerPileRun run_pile(const Peer&, const std::filesystem::path& program, const rigs::PileSetup&,
                     const std::filesystem::path& folder, int ranks,
                     const std::function<void(const PileProgress&)>& show = {});

// Throws scaling::InvalidInput that names the package where there are several ranks and no mpirun.
void refuse_ranks_without_mpirun(int ranks);

}  // namespace engines
