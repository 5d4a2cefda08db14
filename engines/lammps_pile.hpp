// SPDX-License-Identifier: MIT
// The rig `pile` in LAMMPS: a setup as a deck with its data files, a run of it, and the heap read back (docs/export.md).
// The deck feeds the very grains of the setup. It reads them in small batches, each grain where it would by then have fallen to,
// with the speed it would have; it looks for rest by the rig's own criterion, and leaves the heap in final.dump.
// Written for the release of 29 September 2021.
#pragma once

#include "rigs/pile.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace engines {

struct LammpsDeck {
    std::string deck;                                        // deck.in
    std::vector<std::pair<std::string, std::string>> files;  // name and text, beside deck.in
};

// Grains that are read together: `first` to `last`, `last` included, at the step at which `last` is due.
struct FeedBatch {
    std::size_t first, last;
    std::int64_t step;
};

// A batch is closed before its first grain has fallen d/2.
std::vector<FeedBatch> feed_batches(const rigs::PileSetup&);

// What follows `pair_coeff * *`, and `granular` in `fix wall/gran/region`. The moduli are told as E = 2 E* with nu = 0, which
// gives E* between grains and, by LAMMPS' own rule E/2, at a wall; k_t/a = 8 G* as a number.
// `tsuji` is told the restitution that gives the case's (restitution_to_tell). A pair has it; a wall of this release does not: its
// number goes through the polynomial anew in every run of a deck.
std::string granular_arguments(const rigs::ContactParameters&);

// Throws scaling::InvalidInput, which names `option`, below 0.12: there the polynomial of `tsuji` ends.
void refuse_restitution(double restitution, const std::string& option);

// Throws scaling::InvalidInput, which names `option`, for what LAMMPS has not or we have not told it yet: contact rules of our own,
// rigid friction, any base but glued grains, several materials, a funnel or mesh, sleep, a restitution below 0.12.
LammpsDeck lammps_pile(const rigs::PileSetup&, const std::string& option = "--engine");

void write_lammps_deck(const LammpsDeck&, const std::filesystem::path& folder);

// A thermo line of the deck.
struct LammpsProgress {
    std::int64_t step = 0, grains = 0;  // glued ones included
    double kinetic = 0.0;               // J, of translation
};

struct LammpsPileRun {
    std::string release;  // "29 Sep 2021 - Update 2"
    bool interrupted;
    double seconds;                          // wall time
    std::vector<std::string> command;        // as it was run
    std::optional<rigs::PileRecord> record;  // none where interrupted
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
rigs::PileRecord read_lammps_pile(const rigs::PileSetup&, const std::filesystem::path& folder,
                                  const std::string& output);

}  // namespace engines
