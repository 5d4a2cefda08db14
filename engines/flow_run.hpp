// SPDX-License-Identifier: MIT
// A rig `discharge`, `column` or `drum` in another engine: its deck run, and what it saw read back as a run of our own.
// A deck prints "similitude: released at step N", and at the end "similitude: over at step N, still since N, last out N" or
// "similitude: given up at step N"; looks.dump has the grains of t = 0, of each look, of the end.
#pragma once

#include "engines/deck_run.hpp"
#include "rigs/flow.hpp"

#include <filesystem>
#include <functional>
#include <optional>

namespace engines {

struct PeerFlowRun {
    DeckRun deck;
    std::optional<rigs::FlowRun> end;  // none where interrupted
};

// As run_deck.
PeerFlowRun run_flow(const Peer&, const std::filesystem::path& program, const rigs::FlowSetup&,
                     const std::filesystem::path& folder, int ranks,
                     const std::function<void(const DeckProgress&)>& show = {});

}  // namespace engines
