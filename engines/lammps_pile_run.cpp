// SPDX-License-Identifier: MIT
#include "engines/lammps_pile_run.hpp"

#include "dem_min/walls.hpp"
#include "engines/lammps_files.hpp"
#include "engines/lammps_pile.hpp"
#include "engines/lammps_run.hpp"
#include "engines/process.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace engines {
namespace {

using rigs::PileSetup;

bool read_progress(const std::string& line, LammpsProgress& p) {
    long long step = 0, grains = 0;
    double kinetic = 0.0, heap = 0.0, any = 0.0;
    if (std::sscanf(line.c_str(), " %lld %lld %lf %lf %lf", &step, &grains, &kinetic, &heap,
                    &any) != 5)
        return false;
    p = {step, grains, kinetic};
    return true;
}

}  // namespace

std::vector<std::string> lammps_pile_command(const std::string& lmp, int ranks) {
    std::vector<std::string> argv = ranks > 1 ? mpirun(ranks) : std::vector<std::string>{};
    for (const std::string& word : {lmp, std::string("-in"), std::string("deck.in"),
                                    std::string("-log"), std::string("log.lammps")})
        argv.push_back(word);
    return argv;
}

rigs::PileEnd read_lammps_pile(const PileSetup& setup, const std::filesystem::path& folder,
                               const std::string& output) {
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
    run.at_rest = output.find("similitude: at rest at step") != std::string::npos;
    s.steps = last.step;
    s.past.grains_lost = static_cast<std::int64_t>(run.fed) - loose;
    LammpsProgress now, before;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
        if (read_progress(line, now)) {
            s.past.grain_steps += before.grains * (now.step - before.step);
            before = now;
        }
    rigs::PileRecord record = rigs::record(run, setup);
    record.coordination = loose > 0 ? contacts / static_cast<double>(loose) : 0.0;
    if (setup.grains.work_of_adhesion > 0.0)
        record.notes.emplace_back(
            "coordination counts grains that touch: LAMMPS does not tell of necks that are "
            "stretched");
    return {std::move(run), std::move(record)};
}

LammpsPileRun run_lammps_pile(const std::filesystem::path& lmp, const PileSetup& setup,
                              const std::filesystem::path& folder, int ranks,
                              const std::function<void(const LammpsProgress&)>& show) {
    LammpsPileRun result{};
    result.command = lammps_pile_command(lmp.string(), ranks);
    std::size_t read = 0;
    const auto watch = [&](const std::string& out) {
        LammpsProgress last;
        bool any = false;
        for (std::size_t end; (end = out.find('\n', read)) != std::string::npos; read = end + 1)
            any = read_progress(out.substr(read, end - read), last) || any;
        if (any && show) show(last);
    };
    const Finished f = run(result.command, folder, std::numeric_limits<double>::infinity(), watch);
    result.seconds = f.seconds;
    result.release = lammps_release(f.out.substr(std::min(f.out.find("LAMMPS ("), f.out.size())));
    const bool whole = f.out.find("similitude: at rest at step") != std::string::npos ||
                       f.out.find("similitude: given up at step") != std::string::npos;
    if (f.exit_code == 0 && whole) {
        result.end = read_lammps_pile(setup, folder, f.out);
        return result;
    }
    result.interrupted = f.stopped;
    if (!f.stopped)
        throw std::runtime_error(fmt::format("LAMMPS ended with {}: {} (see {})", f.exit_code,
                                             lammps_complaint(f.out),
                                             (folder / "log.lammps").string()));
    return result;
}

void refuse_ranks_without_mpirun(int ranks) {
    if (ranks > 1 && !find_program("mpirun"))
        throw scaling::InvalidInput(scaling::mistake("--ranks", std::to_string(ranks),
                                                     "needs the program mpirun",
                                                     "apt-get install openmpi-bin"));
}

LammpsPiles::LammpsPiles(std::filesystem::path folder, int ranks)
    : lmp_(lammps_program("--engine")),
      folder_(std::move(folder)),
      ranks_(ranks),
      release_(installed_release(lmp_)) {
    refuse_ranks_without_mpirun(ranks);
}

std::string LammpsPiles::name() const {
    return fmt::format("LAMMPS {}, {} rank{}", release_, ranks_, ranks_ == 1 ? "" : "s");
}

std::string LammpsPiles::key(const PileSetup& s) const {
    const LammpsDeck deck = lammps_pile(s);
    std::string text = name() + '\n' + deck.deck;
    for (const auto& [file, content] : deck.files) text += file + '\n' + content;
    return text;
}

std::optional<rigs::PileEnd> LammpsPiles::run(const PileSetup& s,
                                              const std::function<void(std::int64_t)>& show) {
    write_lammps_deck(lammps_pile(s), folder_);
    LammpsPileRun done = run_lammps_pile(lmp_, s, folder_, ranks_, [&](const LammpsProgress& p) {
        if (show) show(p.step);
    });
    if (done.end) std::filesystem::remove_all(folder_);
    return std::move(done.end);
}

}  // namespace engines
