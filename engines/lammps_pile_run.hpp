// SPDX-License-Identifier: MIT
// A deck of lammps_pile.hpp, run: progress, the heap read back, and LAMMPS as an engine that others may use.
#pragma once

#include "rigs/pile_engine.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace engines {

// A thermo line of the deck.
struct LammpsProgress {
    std::int64_t step = 0, grains = 0;  // glued ones included
    double kinetic = 0.0;               // J, of translation
};

struct LammpsPileRun {
    std::string release;  // "29 Sep 2021 - Update 2"
    bool interrupted;
    double seconds;                    // wall time
    std::vector<std::string> command;  // as it was run
    std::optional<rigs::PileEnd> end;  // none where interrupted
};

// Runs deck.in in `folder`, with mpirun where there is more than one rank. `show` is called as output comes. The record's `coordination` counts
// what touches: LAMMPS tells nothing of necks that are stretched. Throws std::runtime_error with LAMMPS' error and the log's path where
// it fails.
LammpsPileRun run_lammps_pile(const std::filesystem::path& lmp, const rigs::PileSetup&,
                              const std::filesystem::path& folder, int ranks,
                              const std::function<void(const LammpsProgress&)>& show = {});

// The command of such a run.
std::vector<std::string> lammps_pile_command(const std::string& lmp, int ranks);

// The heap of final.dump, as a run of our own that has ended there. `output` is what LAMMPS printed.
rigs::PileEnd read_lammps_pile(const rigs::PileSetup&, const std::filesystem::path& folder,
                               const std::string& output);

// Throws scaling::InvalidInput that names the package where there are several ranks and no mpirun.
void refuse_ranks_without_mpirun(int ranks);

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
