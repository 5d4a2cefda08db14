// SPDX-License-Identifier: MIT
// Another engine that runs piles, as rooms to the right may know it: `engines` implements it, `app` hands it in.
#pragma once

#include "rigs/pile.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace rigs {

struct PileEnd {
    PileRun run;  // grains at their last places; contacts only as far as the engine tells of them
    PileRecord record;
};

class PileEngine {
  public:
    virtual ~PileEngine() = default;

    // For the reader: "LAMMPS 29 Sep 2021 - Update 2, 2 ranks".
    virtual std::string name() const = 0;

    // All that decides a run of the engine, as text: two runs of one key are one run. Throws scaling::InvalidInput, which names
    // what the engine cannot take.
    virtual std::string key(const PileSetup&) const = 0;

    // One pile from its first grain to rest; nothing where a signal came. `show` hears the step. One call at a time.
    virtual std::optional<PileEnd> run(const PileSetup&,
                                       const std::function<void(std::int64_t step)>& show) = 0;
};

}  // namespace rigs
