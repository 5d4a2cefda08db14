// SPDX-License-Identifier: MIT
// LAMMPS as an engine that other rooms may use: decks of lammps_pile.hpp, run by pile_run.hpp.
#pragma once

#include "rigs/pile_engine.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace engines {

class LammpsPiles : public rigs::PileEngine {
  public:
    // Decks run in `folder`, one after the other; it goes when a heap has come back, and stays where LAMMPS failed. Throws
    // scaling::InvalidInput where lmp or mpirun is missing.
    LammpsPiles(std::filesystem::path folder, int ranks);

    std::string name() const override;
    std::string key(
        const rigs::PileSetup&) const override;  // release, ranks, every byte of the deck
    std::optional<rigs::PileEnd> run(const rigs::PileSetup&,
                                     const std::function<void(std::int64_t step)>& show) override;

  private:
    std::filesystem::path lmp_, folder_;
    int ranks_;
    std::string release_;
};

}  // namespace engines
