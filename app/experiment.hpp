// SPDX-License-Identifier: MIT
// One experiment of a case, run: its files written, its result in the shapes that reports want.
#pragma once

#include "app/common.hpp"
#include "app/dump.hpp"
#include "cases/case.hpp"
#include "engines/peer.hpp"
#include "reports/run_sheets.hpp"
#include "reports/runs.hpp"
#include "rigs/flow.hpp"
#include "rigs/pile.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace app {

struct ExperimentRun {
    std::string id, rig;
    double seconds;
    std::optional<reports::RunSection> section;  // none where interrupted
    reports::Json result;
    std::vector<std::filesystem::path> dumps{};   // to open, one a format
    std::size_t frames = 0;                       // in each of them
    std::vector<reports::ChannelTable> tables{};  // as the CSV files have them
    std::function<void()> forget = [] {};         // once all results are on disk: the checkpoint
};

// Who runs an experiment, and by which contact rules.
struct EngineChoice {
    const engines::Peer* peer = nullptr;  // or our own core
    int ranks = 1;                        // of MPI
    bool lammps_rules = false;            // rigs::take_lammps_rules
    bool nearest = false;                 // the peer's nearest law where it has not the case's
};

// What a verb's --engine and --contact take, and what to say of a name that only other verbs take.
struct EngineNames {
    std::vector<std::string> engines{"dem_min", "lammps", "liggghts", "yade"};
    std::vector<std::string> contacts{"own", "lammps", "nearest"};
    std::string otherwise{};
};

// From --engine, --ranks (0 where not given) and --contact. Throws scaling::InvalidInput.
EngineChoice engine_choice(const std::string& engine, int ranks, const std::string& contact,
                           const EngineNames& = {});

// The setup of a pile of the case as it is run: counted_setup, under the rules chosen. Throws scaling::InvalidInput.
rigs::PileSetup chosen_setup(const cases::Case&, const cases::Experiment&, std::uint64_t seed,
                             bool yes, const EngineChoice&);

// Likewise of a discharge, a column or a drum.
rigs::FlowSetup chosen_flow(const cases::Case&, const cases::Experiment&, std::uint64_t seed,
                            const EngineChoice&);

struct RunPlace {
    std::filesystem::path folder;
    bool yes;  // run whatever it costs
    DumpPlan dump{};
    double checkpoint_every = 300.0;  // s of wall time
    bool sleep = false;               // quiet regions of a heap are left out
    EngineChoice engine{};
};

// Checks everything that can be wrong with the experiment now and returns what runs it later:
// ID.csv with the rig's channels, ID-grains.csv of a pile or a vessel. Throws scaling::InvalidInput for a rig
// that cannot be simulated, for a pile that is fed without a count, for a cost beyond a night unless
// `yes`, and for frames that lie closer than time steps. A drop has no frames.
std::function<ExperimentRun()> prepared(const cases::Case&, const cases::Experiment&,
                                        const CommonOptions&, const RunPlace&);

bool can_simulate(const cases::Experiment&);

bool has_frames(const cases::Experiment&);  // a rig whose grains --dump can write

std::string bytes_of(const std::string& path);

}  // namespace app
