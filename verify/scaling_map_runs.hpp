// SPDX-License-Identifier: MIT
// Pours the heaps of a map and judges them. Each finished heap is a line of a file at once (scaling_map_heaps.hpp), so that a
// map goes on heap by heap, in shards, with any number of threads, on another machine, and comes out the same.
#pragma once

#include "verify/scaling_map_plan.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

namespace verify {

struct MapRun {
    int threads = 1;
    std::filesystem::path heaps{};  // the file of finished heaps; must be named
    std::string git{};              // of this program, for the lines that it adds; no comma
    int shard = 1, shards = 1;      // this one of so many: every so-manieth heap of the order
    double budget = 0.0;            // s: no heap begins that would not end by then; 0: none
    // Grain-steps done, of how many (of this shard), and the heap that has just ended (or empty); called from one thread at a time.
    std::function<void(double done, double of, const std::string& ended)> progress{};
    const std::atomic<bool>* stop = nullptr;
};

enum class MapEnd { complete, out_of_budget, stopped };

// Pours what is missing.
MapEnd pour_map(const MapPlan&, std::uint64_t first_seed, const MapRun&);

// The map of all heaps that are in the file, of whatever shard.
ScalingMap gather_map(const MapPlan&, std::uint64_t first_seed, const std::filesystem::path& heaps);

}  // namespace verify
