// SPDX-License-Identifier: MIT
// road_trials KIND TRIALS BUDGET [density]: both roads on that many synthetic powders; ours with
// BUDGET runs in all, or with "same" as many as the paper's road took on that powder, and with the bulk density as a second target. Prints a line a trial and a summary.
#include "road_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

struct Score {
    std::string name;
    double runs = 0.0, lost = 0.0;
    std::vector<double> misses{};

    void add(int of_runs, double miss, bool answered) {
        runs += of_runs, lost += !answered;
        misses.push_back(std::abs(miss));
    }
    void print() {
        std::sort(misses.begin(), misses.end());
        const double n = static_cast<double>(misses.size());
        const auto quantile = [&](double q) {
            return misses[static_cast<std::size_t>(q * (n - 1.0) + 0.5)];
        };
        fmt::print("{:<18} {:5.1f} {:8.2f} {:8.2f} {:8.2f} {:6.0f} %\n", name, runs / n,
                   quantile(0.5), quantile(0.75), quantile(0.9), 100.0 * lost / n);
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        fmt::print(stderr, "road_trials three|five|seven TRIALS BUDGET|same [density]\n");
        return 2;
    }
    const std::string kind = argv[1];
    const int trials = std::atoi(argv[2]);
    calibrate::SurrogateOptions options;
    const bool same = std::string(argv[3]) == "same";
    if (!same) options.budget = std::atoi(argv[3]);
    options.settled = 0.0;
    Score paper{"paper"}, quarters{"paper, quarters"}, ours{"ours"};
    double held = 0, foretold = 0, region = 0, width = 0, known = 0;
    for (int k = 0; k < trials; ++k) {
        const auto p = synthetic::powder(kind, static_cast<std::uint64_t>(k), argc > 4);
        const auto a = synthetic::paper_trial(p), c = synthetic::paper_trial(p, true);
        if (same) options.budget = a.runs;
        const auto b = synthetic::surrogate_trial(p, options);
        fmt::print(
            "{:3} target {:5.1f}  paper {} runs {:6.2f}, quarters {} runs {:6.2f}  ours {} runs "
            "{:6.2f}, "
            "held {:d} ({:.2f}, known {:.2f}) foretold {:d} region {:d}\n",
            k, *p.problem.targets[0].value, a.runs, a.miss_deg, c.runs, c.miss_deg, b.runs,
            b.miss_deg, b.held, b.held_share, b.known_share, b.foretold, b.region);
        std::fflush(stdout);
        paper.add(a.runs, a.miss_deg, a.answered), quarters.add(c.runs, c.miss_deg, c.answered);
        ours.add(b.runs, b.miss_deg, b.answered);
        held += b.held, foretold += b.foretold, region += b.region;
        width += b.held_share, known += b.known_share;
    }
    const double n = trials;
    fmt::print(
        "{}, {} trials: runs, miss in deg below which 50, 75, 90 % lie (90: no heap), without a "
        "heap\n",
        kind, trials);
    for (Score* s : {&paper, &quarters, &ours}) s->print();
    fmt::print(
        "optimum within its interval: held {:.0f} %, width {:.2f} of the range ({:.2f} if all were "
        "known); "
        "foretold {:.0f} %; region {:.0f} %\n",
        100 * held / n, width / n, known / n, 100 * foretold / n, 100 * region / n);
}
