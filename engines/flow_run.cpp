// SPDX-License-Identifier: MIT
#include "engines/flow_run.hpp"

#include "engines/lammps_files.hpp"
#include "engines/lammps_vessels.hpp"

#include <cstdio>
#include <stdexcept>
#include <utility>

namespace engines {
namespace {

using rigs::FlowSetup;

const std::string released = "similitude: released at step";
const std::string over = "similitude: over at step";
const std::string given_up = "similitude: given up at step";

void read_over(const std::string& output, rigs::SeenFlow& seen) {
    long long step = 0, still_since = 0, last_out = 0;
    const std::size_t at = output.find(over);
    if (at == std::string::npos ||
        std::sscanf(output.c_str() + at + over.size(), " %lld, still since %lld, last out %lld",
                    &step, &still_since, &last_out) != 3)
        throw std::runtime_error("the deck does not say when the flow was over");
    seen.still_since = still_since, seen.last_out = last_out;
}

rigs::FlowRun read_flow(const FlowSetup& setup, const std::filesystem::path& folder,
                        const std::string& output) {
    rigs::SeenFlow seen{says(output, released), -1, -1, {}};
    if (seen.released) read_over(output, seen);
    const double gone = gone_below(setup);
    for (FinalGrains& frame : read_grains(folder / "looks.dump", setup.density)) {
        std::erase_if(frame.grains, [&](const dem_min::Grain& g) { return g.position.z < gone; });
        seen.sights.push_back({frame.step, std::move(frame.grains)});
    }
    return rigs::run_as_seen(setup, seen);
}

}  // namespace

PeerFlowRun run_flow(const Peer& peer, const std::filesystem::path& program, const FlowSetup& setup,
                     const std::filesystem::path& folder, int ranks,
                     const std::function<void(const DeckProgress&)>& show) {
    PeerFlowRun result{run_deck(peer, program, folder, ranks, {over, given_up}, show), {}};
    if (!result.deck.interrupted) result.end = read_flow(setup, folder, result.deck.output);
    return result;
}

}  // namespace engines
