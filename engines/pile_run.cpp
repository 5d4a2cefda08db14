// SPDX-License-Identifier: MIT
#include "engines/pile_run.hpp"

#include "dem_min/walls.hpp"
#include "engines/lammps_files.hpp"
#include "engines/pile_feed.hpp"
#include "engines/process.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace engines {
namespace {

using rigs::PileSetup;

const std::string at_rest = "similitude: at rest at step";
const std::string given_up = "similitude: given up at step";

bool says(const std::string& output, const std::string& what) {
    return output.find(what) != std::string::npos;
}

bool read_progress(const std::string& line, PileProgress& p) {
    long long step = 0, grains = 0;
    double kinetic = 0.0, heap = 0.0, any = 0.0;
    if (std::sscanf(line.c_str(), " %lld %lld %lf %lf %lf", &step, &grains, &kinetic, &heap,
                    &any) != 5)
        return false;
    p = {step, grains, kinetic};
    return true;
}

std::int64_t grain_steps(const std::string& output) {
    PileProgress now, before;
    std::int64_t sum = 0;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
        if (read_progress(line, now)) {
            sum += before.grains * (now.step - before.step);
            before = now;
        }
    return sum;
}

rigs::PileEnd read_heap(const Peer& peer, const PileSetup& setup,
                        const std::filesystem::path& folder, const std::string& output) {
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
    run.at_rest = says(output, at_rest);
    s.steps = last.step;
    s.past.grains_lost = static_cast<std::int64_t>(run.fed) - loose;
    s.past.grain_steps = grain_steps(output);
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
                     const std::function<void(const PileProgress&)>& show) {
    PeerPileRun result{};
    result.command = peer.command(program.string(), ranks);
    std::size_t read = 0;
    const auto watch = [&](const std::string& out) {
        PileProgress last;
        bool any = false;
        for (std::size_t end; (end = out.find('\n', read)) != std::string::npos; read = end + 1)
            any = read_progress(out.substr(read, end - read), last) || any;
        if (any && show) show(last);
    };
    const Finished f = run(result.command, folder, std::numeric_limits<double>::infinity(), watch);
    result.seconds = f.seconds;
    result.release = peer.release(f.out);
    keep_output(peer, folder, f.out);
    if (f.exit_code == 0 && (says(f.out, at_rest) || says(f.out, given_up))) {
        result.end = read_heap(peer, setup, folder, f.out);
        return result;
    }
    result.interrupted = f.stopped;
    if (!f.stopped)
        throw std::runtime_error(fmt::format("{} ended with {}: {} (see {})", peer.title,
                                             f.exit_code, peer.complaint(f.out),
                                             (folder / peer.log).string()));
    return result;
}

void refuse_ranks_without_mpirun(int ranks) {
    if (ranks > 1 && !find_program("mpirun"))
        throw scaling::InvalidInput(scaling::mistake("--ranks", std::to_string(ranks),
                                                     "needs the program mpirun",
                                                     "apt-get install openmpi-bin"));
}

}  // namespace engines
