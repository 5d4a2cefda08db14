// SPDX-License-Identifier: MIT
// An experiment run in another engine: its deck stays in ID-ENGINE/, whatever comes of its run.
#pragma once

#include "app/experiment.hpp"
#include "app/flow_task.hpp"
#include "app/pile_task.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace app {

// As `prepared` (app/experiment.hpp): all that can be wrong is said now. Throw scaling::InvalidInput.
std::function<ExperimentRun()> prepared_pile_in_peer(const PileTask&, const CommonOptions&,
                                                     const RunPlace&);
std::function<ExperimentRun()> prepared_flow_in_peer(const FlowTask&, const cases::Experiment&,
                                                     const CommonOptions&, const RunPlace&);
std::function<ExperimentRun()> prepared_in_peer(const cases::Case&, const cases::Experiment&,
                                                const CommonOptions&, const RunPlace&);

// ID.csv with the scanned heap and ID-grains.csv; returns what stands in them.
std::vector<reports::ChannelTable> write_pile(const std::filesystem::path& folder,
                                              const std::string& id, const rigs::PileRecord&);

// ID.csv with the rig's channels, ID-grains.csv, and of a drum ID-velocity.csv; likewise.
std::vector<reports::ChannelTable> write_flow(const std::filesystem::path& folder,
                                              const std::string& id, const rigs::FlowRecord&);

}  // namespace app
