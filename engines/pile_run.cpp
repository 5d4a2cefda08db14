// SPDX-License-Identifier: MIT
#include "engines/pile_run.hpp"

#include "dem_min/walls.hpp"
#include "engines/lammps_files.hpp"
#include "engines/pile_feed.hpp"

#include <fmt/format.h>

#include <utility>

namespace engines {
namespace {

using rigs::PileSetup;

const std::string at_rest = "similitude: at rest at step";
const std::string given_up = "similitude: given up at step";

rigs::PileEnd read_heap(const Peer& peer, const PileSetup& setup,
                        const std::filesystem::path& folder, const DeckRun& done) {
    const FinalGrains last = read_final_grains(folder, loose_density(setup), "c_touching");
    rigs::PileRun run = rigs::begin_pile(setup, 1);
    dem_min::Simulation& s = run.simulation;
    double contacts = 0.0;
    std::int64_t loose = 0;
    for (std::size_t k = 0; k < last.grains.size(); ++k) {
        if (last.grains[k].fixed) continue;
        dem_min::insert(s, last.grains[k]);
        contacts += last.extra[k];
        for (const dem_min::Wall& wall : s.walls)
            contacts +=
                dem_min::distance(wall, last.grains[k].position).distance < last.grains[k].radius;
        ++loose;
    }
    run.fed = setup.feed_time.size();
    run.finished = true;
    run.at_rest = says(done.output, at_rest);
    s.steps = last.step;
    s.past.grains_lost = static_cast<std::int64_t>(run.fed) - loose;
    s.past.grain_steps = done.grain_steps;
    rigs::PileRecord record = rigs::record(run, setup);
    record.coordination = loose > 0 ? contacts / static_cast<double>(loose) : 0.0;
    if (setup.grains.work_of_adhesion > 0.0)
        record.notes.push_back(
            fmt::format("coordination counts grains that touch: {} does not tell of necks that are "
                        "stretched",
                        peer.title));
    return {std::move(run), std::move(record)};
}

}  // namespace

PeerPileRun run_pile(const Peer& peer, const std::filesystem::path& program, const PileSetup& setup,
                     const std::filesystem::path& folder, int ranks,
                     const std::function<void(const DeckProgress&)>& show) {
    PeerPileRun result{run_deck(peer, program, folder, ranks, {at_rest, given_up}, show), {}};
    if (!result.deck.interrupted) result.end = read_heap(peer, setup, folder, result.deck);
    return result;
}

}  // namespace engines
