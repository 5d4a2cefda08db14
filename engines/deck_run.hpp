// SPDX-License-Identifier: MIT
// A deck of many grains in another engine: run, its progress told. A deck prints lines of `step grains kinetic-energy number
// number`, and at the end one of the lines that it is asked for here.
#pragma once

#include "engines/peer.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace engines {

struct DeckProgress {
    std::int64_t step = 0, grains = 0;  // glued ones included
    double kinetic = 0.0;               // J, of translation
};

struct DeckRun {
    std::string release;  // "29 Sep 2021 - Update 2"
    bool interrupted = false;
    double seconds = 0.0;              // wall time
    std::vector<std::string> command;  // as it was run
    std::string output;
    std::int64_t grain_steps = 0;
};

// Runs the deck that lies in `folder`. `show` is called as output comes. Throws std::runtime_error with the engine's error and the
// log's path where it fails, or says none of `endings`.
DeckRun run_deck(const Peer&, const std::filesystem::path& program,
                 const std::filesystem::path& folder, int ranks,
                 const std::vector<std::string>& endings,
                 const std::function<void(const DeckProgress&)>& show);

bool says(const std::string& output, const std::string& what);

// Throws scaling::InvalidInput that names the package where there are several ranks and no mpirun.
void refuse_ranks_without_mpirun(int ranks);

}  // namespace engines
