// SPDX-License-Identifier: MIT
// How a deck feeds the grains of a setup: in small batches, each grain where it would by then have fallen to.
#pragma once

#include "rigs/pile.hpp"

#include <cstdint>
#include <vector>

namespace engines {

// Grains that are fed together: `first` to `last`, `last` included, at the step at which `last` is due.
struct FeedBatch {
    std::size_t first, last;
    std::int64_t step;
};

// A batch is closed before its first grain has fallen d/2.
std::vector<FeedBatch> feed_batches(const rigs::PileSetup&);

// Heights at which grains appear over a heap that is below its feed, m, [grains]: the lowest at which a grain is clear of those still in
// flight, both when it appears and when its batch is fed.
std::vector<double> feed_heights(const rigs::PileSetup&, const std::vector<FeedBatch>&);

// How far a grain that appeared at `since` has fallen at `t`, m; times in s.
double fallen(const rigs::PileSetup&, double since, double t);

}  // namespace engines
