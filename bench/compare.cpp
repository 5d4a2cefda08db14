// SPDX-License-Identifier: MIT
#include "bench/compare.hpp"

#include "engines/process.hpp"
#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace bench {

using engines::Bed;
using engines::BedEngine;
using engines::BedFigures;

namespace {

// Ten times slower than the slowest engine that we know of (Yade, 1.5e6 on two cores).
constexpr double slowest = 1e5;  // grain-steps/s

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out)
        throw scaling::InvalidInput(
            scaling::mistake(file.string(), "a place that cannot be written", "must be writable",
                             "choose another folder with --out"));
}

Timed timed(const BedEngine& e, int threads, const std::filesystem::path& folder) {
    return {.name = e.name,
            .title = e.title,
            .version = "",
            .package = e.package,
            .laws = e.laws,
            .differs = e.differs,
            .command = engines::command_line(e.command(threads)),
            .folder = folder.string(),
            .runs = {}};
}

BedFigures run_peer(const BedEngine& e, const Bed& bed, int threads,
                    const std::filesystem::path& folder, int repeat) {
    const double steps = static_cast<double>(bed.warm_up) + bed.steps;
    const engines::Finished f =
        engines::run(e.command(threads), folder, 60.0 + bed.grains() * steps / slowest);
    write(folder / fmt::format("output-{}.txt", repeat + 1), f.out);
    const std::string what = fmt::format("{} in {}", e.program, folder.string());
    if (f.timed_out)
        throw std::runtime_error(fmt::format("{} did not end within {:.0f} s", what, f.seconds));
    try {
        if (f.exit_code != 0)
            throw std::runtime_error(
                f.out.substr(f.out.size() - std::min<std::size_t>(400, f.out.size())));
        return e.read(bed, f.out);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(
            fmt::format("{} (exit code {}): {}", what, f.exit_code, error.what()));
    }
}

std::vector<std::string> names_of(const std::vector<BedEngine>& all) {
    std::vector<std::string> names;
    for (const BedEngine& e : all) names.push_back(e.name);
    return names;
}

const BedEngine& engine_named(const std::string& name) {
    const std::vector<BedEngine>& all = engines::bed_engines();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const BedEngine& e) { return e.name == name; });
    if (found != all.end()) return *found;
    const std::vector<std::string> names = names_of(all);
    throw scaling::InvalidInput(
        scaling::mistake("--against", '"' + name + '"', "must be one of " + scaling::joined(names),
                         "did you mean " + scaling::nearest_name(name, names) + "?"));
}

}  // namespace

Spread spread_of(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    const std::size_t n = v.size();
    return {0.5 * (v[(n - 1) / 2] + v[n / 2]), v.front(), v.back()};
}

std::vector<double> speeds(const Bed& bed, const Timed& engine) {
    std::vector<double> all;
    for (const BedFigures& f : engine.runs) all.push_back(f.grain_steps_per_second(bed));
    return all;
}

std::vector<double> ratios(const Timed& ours, const Timed& peer) {
    std::vector<double> all;
    for (std::size_t k = 0; k < std::min(ours.runs.size(), peer.runs.size()); ++k)
        all.push_back(peer.runs[k].seconds / ours.runs[k].seconds);
    return all;
}

std::vector<BedEngine> engines_for(const std::vector<std::string>& names) {
    std::vector<BedEngine> chosen;
    if (names.empty()) {
        for (const BedEngine& e : engines::bed_engines())
            if (engines::find_program(e.program)) chosen.push_back(e);
        return chosen;
    }
    for (const std::string& name : names) {
        const BedEngine& e = engine_named(name);
        if (!engines::find_program(e.program))
            throw scaling::InvalidInput(scaling::mistake(
                "--against", '"' + name + '"',
                fmt::format("must be on this machine, and there is no program {}", e.program),
                fmt::format("apt-get install {}, or leave --against out to take what is there",
                            e.package)));
        chosen.push_back(e);
    }
    return chosen;
}

Comparison compare(const Bed& bed, const std::vector<BedEngine>& peers, int repeats, int threads,
                   const std::filesystem::path& folder,
                   const std::function<void(double, const std::string&)>& progress) {
    Comparison c{bed, threads, {}, {}};
    c.ours.name = "similitude";
    c.ours.title = "similitude";
    c.ours.laws = "JKR, Mindlin with history, SDS rolling, Tsuji's dashpots";
    for (const BedEngine& e : peers) {
        const std::filesystem::path place = folder / e.name;
        std::error_code ignored;  // write says what is wrong
        std::filesystem::create_directories(place, ignored);
        for (const engines::DeckFile& file : e.deck(bed)) write(place / file.name, file.text);
        c.peers.push_back(timed(e, threads, place));
    }
    const double all = repeats * (1.0 + static_cast<double>(peers.size()));
    double done = 0.0;
    for (int k = 0; k < repeats; ++k) {
        const std::string which = fmt::format("run {} of {}", k + 1, repeats);
        c.ours.runs.push_back(run_ours(bed, threads, [&](double share) {
            progress((done + share) / all, "similitude, " + which);
        }));
        done += 1.0;
        for (std::size_t p = 0; p < peers.size(); ++p) {
            progress(done / all, peers[p].title + ", " + which);
            c.peers[p].runs.push_back(run_peer(peers[p], bed, threads, c.peers[p].folder, k));
            c.peers[p].version = c.peers[p].runs.back().version;
            done += 1.0;
        }
    }
    progress(1.0, "done");
    return c;
}

}  // namespace bench
