// SPDX-License-Identifier: MIT
// A pile in another engine: its deck run, and the heap of final.dump read back as that of a run of our own. A deck says at the end
// "similitude: at rest at step N" or "similitude: given up at step N".
#pragma once

#include "engines/deck_run.hpp"
#include "rigs/pile_engine.hpp"

#include <filesystem>
#include <functional>
#include <optional>

namespace engines {

struct PeerPileRun {
    DeckRun deck;
    std::optional<rigs::PileEnd> end;  // none where interrupted
};

// As run_deck. The record's `coordination` counts what touches: a stretched neck is not told.
PeerPileRun run_pile(const Peer&, const std::filesystem::path& program, const rigs::PileSetup&,
                     const std::filesystem::path& folder, int ranks,
                     const std::function<void(const DeckProgress&)>& show = {});

}  // namespace engines
