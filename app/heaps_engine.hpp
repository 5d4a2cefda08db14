// SPDX-License-Identifier: MIT
// Who pours the many heaps of `verify` and `calibrate`.
#pragma once

#include "app/experiment.hpp"
#include "rigs/pile_engine.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace app {

struct HeapsEngine {
    std::string engine = "dem_min", contact = "own";
    int ranks = 0;
};

// --engine, --ranks, --contact.
void add_heaps_engine(CLI::App& verb, HeapsEngine&);

// Throws scaling::InvalidInput, also for an engine or contact rules of single heaps only.
EngineChoice choice_of(const HeapsEngine&);

// None for our own core. Its decks run in `remembered`/ENGINE.
std::unique_ptr<rigs::PileEngine> engine_of(const EngineChoice&,
                                            const std::filesystem::path& remembered);

}  // namespace app
