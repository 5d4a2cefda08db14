// SPDX-License-Identifier: MIT
// road_trials KIND TRIALS BUDGET [density]: both roads on that many synthetic powders; the surrogate with
// BUDGET runs in all. Prints one line for each trial and a summary.
#include "road_trials.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

double quantile(std::vector<double> v, double q) {
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(q * static_cast<double>(v.size() - 1) + 0.5)];
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr, "road_trials three|five|seven TRIALS BUDGET [density]\n");
        return 2;
    }
    const std::string kind = argv[1];
    const int trials = std::atoi(argv[2]);
    calibrate::SurrogateOptions options;
    options.budget = std::atoi(argv[3]);
    options.settled = 0.0;
    std::vector<double> paper, ours;
    double paper_runs = 0, our_runs = 0, held = 0, foretold = 0, region = 0, passed = 0,
           lost[2] = {}, width = 0;
    for (int k = 0; k < trials; ++k) {
        const auto p = synthetic::powder(kind, static_cast<std::uint64_t>(k), argc > 4);
        const auto a = synthetic::paper_trial(p);
        const auto b = synthetic::surrogate_trial(p, options);
        std::printf(
            "%3d target %5.1f  paper %2d runs, miss %6.2f %s  ours %2d runs, miss %6.2f, held %d "
            "(%.2f) foretold %d region %d\n",
            k, *p.problem.targets[0].value, a.runs, a.miss_deg, a.passed ? "      " : "beside",
            b.runs, b.miss_deg, b.held, b.held_share, b.foretold, b.region);
        std::fflush(stdout);
        paper.push_back(std::abs(a.miss_deg)), ours.push_back(std::abs(b.miss_deg));
        paper_runs += a.runs, our_runs += b.runs, held += b.held, foretold += b.foretold,
            region += b.region, width += b.held_share;
        passed += a.passed, lost[0] += !a.answered, lost[1] += !b.answered;
    }
    const double n = trials;
    std::printf("%s, %d trials        runs   median miss  90 %% of misses below  without a heap\n",
                kind.c_str(), trials);
    std::printf("paper (passed %3.0f %%)   %5.1f  %8.2f deg  %8.2f deg          %3.0f\n",
                100 * passed / n, paper_runs / n, quantile(paper, 0.5), quantile(paper, 0.9),
                lost[0]);
    std::printf("ours                   %5.1f  %8.2f deg  %8.2f deg          %3.0f\n", our_runs / n,
                quantile(ours, 0.5), quantile(ours, 0.9), lost[1]);
    std::printf(
        "optimum in the interval: held %.0f %% (mean width %.2f of the range), foretold %.0f %%, "
        "region %.0f %%\n",
        100 * held / n, width / n, 100 * foretold / n, 100 * region / n);
}
