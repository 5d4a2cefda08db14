// SPDX-License-Identifier: MIT
#include "engines/deck_run.hpp"

#include "engines/process.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace engines {
namespace {

bool read_progress(const std::string& line, DeckProgress& p) {
    long long step = 0, grains = 0;
    double kinetic = 0.0, heap = 0.0, any = 0.0;
    if (std::sscanf(line.c_str(), " %lld %lld %lf %lf %lf", &step, &grains, &kinetic, &heap,
                    &any) != 5)
        return false;
    p = {step, grains, kinetic};
    return true;
}

std::int64_t grain_steps(const std::string& output) {
    DeckProgress now, before;
    std::int64_t sum = 0;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
        if (read_progress(line, now)) {
            sum += before.grains * (now.step - before.step);
            before = now;
        }
    return sum;
}

}  // namespace

bool says(const std::string& output, const std::string& what) {
    return output.find(what) != std::string::npos;
}

DeckRun run_deck(const Peer& peer, const std::filesystem::path& program,
                 const std::filesystem::path& folder, int ranks,
                 const std::vector<std::string>& endings,
                 const std::function<void(const DeckProgress&)>& show) {
    DeckRun result;
    result.command = peer.command(program.string(), ranks);
    std::size_t read = 0;
    const auto watch = [&](const std::string& out) {
        DeckProgress last;
        bool any = false;
        for (std::size_t end; (end = out.find('\n', read)) != std::string::npos; read = end + 1)
            any = read_progress(out.substr(read, end - read), last) || any;
        if (any && show) show(last);
    };
    Finished f = run(result.command, folder, std::numeric_limits<double>::infinity(), watch);
    result.seconds = f.seconds;
    result.release = peer.release(f.out);
    keep_output(peer, folder, f.out);
    const bool ended = std::any_of(endings.begin(), endings.end(),
                                   [&](const std::string& e) { return says(f.out, e); });
    if (f.exit_code != 0 || !ended) {
        result.interrupted = f.stopped;
        if (!f.stopped)
            throw std::runtime_error(fmt::format("{} ended with {}: {} (see {})", peer.title,
                                                 f.exit_code, peer.complaint(f.out),
                                                 (folder / peer.log).string()));
    }
    result.grain_steps = grain_steps(f.out);
    result.output = std::move(f.out);
    return result;
}

void refuse_ranks_without_mpirun(int ranks) {
    if (ranks > 1 && !find_program("mpirun"))
        throw scaling::InvalidInput(scaling::mistake("--ranks", std::to_string(ranks),
                                                     "needs the program mpirun",
                                                     "apt-get install openmpi-bin"));
}

}  // namespace engines
