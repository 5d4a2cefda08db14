// SPDX-License-Identifier: MIT
// The work of `prove`: cases are made and judged, each in a process of its own, and all that is done is a file, so that a
// campaign can be stopped at any time and taken up again.
#pragma once

#include "app/judging.hpp"
#include "prove/campaign.hpp"
#include "prove/score.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

namespace app {

struct Campaign {
    prove::Extent extent;
    std::filesystem::path out;  // docs/prove.md says what is in it
    std::string judge;          // a program that takes the arguments of `similitude diagnose`
    std::uint64_t judge_seed = 1;
    double limit = 20.0;  // s of processor time for a case
    int stability = 0;    // the first so many single effects with D >= 5 are judged with more seeds
    int threads = 1;      // cases at a time
    bool write_only = false;
    bool resume = false;  // what is there is left as it is
};

constexpr int further_seeds = 19;

// Makes and judges what is missing. `show` hears how many cases are done, of how many, and the last one's name; it may be
// called by several threads, one at a time. Returns false where `stop` came first.
bool work(const Campaign&,
          const std::function<void(double done, double of, const std::string& name)>& show,
          const std::atomic<bool>& stop);

struct Result {
    prove::ScoreTable table;
    Times times;
};

// From the files alone. Cases of the extent that have not been judged yet count as wrong.
Result score(const Campaign&);

}  // namespace app
