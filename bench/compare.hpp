// SPDX-License-Identifier: MIT
// Ours and other engines on the same bed, in turn: a machine that slows down for a while then slows
// all of them, and the ratio of neighbouring runs holds where the speeds do not.
#pragma once

#include "bench/ours.hpp"
#include "engines/bed_engine.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Spread {
    double median = 0.0, low = 0.0, high = 0.0;  // low and high: lowest and highest
};
Spread spread_of(std::vector<double> values);  // at least one

// All runs of one engine. Shape of runs: [repeats].
struct Timed {
    std::string name, title, version, package, laws, differs;
    std::string command;  // as typed, after `cd folder`; of ours: empty, it runs in this process
    std::string folder;
    std::vector<engines::BedFigures> runs;
};

struct Comparison {
    engines::Bed bed;
    int threads = 1;
    Timed ours;
    std::vector<Timed> peers;
};

// Speed of ours over that of the peer, run by run.
std::vector<double> ratios(const Timed& ours, const Timed& peer);

std::vector<double> speeds(const engines::Bed&, const Timed&);  // grain-steps/s, run by run

// The engines named; of none the ones on this machine. Throws scaling::InvalidInput, with the
// package to install, where one is unknown or not there.
std::vector<engines::BedEngine> engines_for(const std::vector<std::string>& names);

// `progress(share, what)`. Decks and what the engines printed stay in folder/NAME. Throws
// std::runtime_error where an engine fails.
Comparison compare(const engines::Bed&, const std::vector<engines::BedEngine>&, int repeats,
                   int threads, const std::filesystem::path& folder,
                   const std::function<void(double, const std::string&)>& progress);

}  // namespace bench
