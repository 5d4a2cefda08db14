// SPDX-License-Identifier: MIT
// Who works on which tile. Each thread has a run of tiles, always about the same, whose data stay in its cache; whoever is through
// with its own takes from what another has left, so that nobody waits for longer than a tile takes. No bit depends on who works.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace dem_min {

class Shares {
  public:
    // Every other thread walks down its run, so that neighbours meet where their runs do. `begins`: see Simulation::shares.
    explicit Shares(const std::vector<int>& begins)
        : team_(static_cast<int>(begins.size()) - 1), runs_(new Run[begins.size()]) {
        for (int k = 0; k < team_; ++k)
            left_of(k) =
                pack(begins[static_cast<std::size_t>(k)], begins[static_cast<std::size_t>(k) + 1]);
    }

    // The next tile for thread `who`; -1: none is left. Each tile is given once.
    int take(int who) {
        for (int run = who; run >= 0; run = fullest()) {
            const bool front = (run % 2 == 0) == (run == who);
            std::uint64_t left = left_of(run).load(std::memory_order_relaxed);
            while (first(left) < last(left)) {
                const std::uint64_t rest =
                    front ? pack(first(left) + 1, last(left)) : pack(first(left), last(left) - 1);
                if (left_of(run).compare_exchange_weak(left, rest, std::memory_order_relaxed))
                    return front ? first(left) : last(left) - 1;
            }
        }
        return -1;
    }

  private:
    struct alignas(64) Run {
        std::atomic<std::uint64_t> left{0};  // first tile and the one after the last
    };
    std::atomic<std::uint64_t>& left_of(int run) const {
        return runs_[static_cast<std::size_t>(run)].left;
    }
    static std::uint64_t pack(int first, int last) {
        return static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint64_t>(last);
    }
    static int first(std::uint64_t run) { return static_cast<int>(run >> 32); }
    static int last(std::uint64_t run) { return static_cast<int>(run & 0xffffffffu); }

    int fullest() const {  // the run with most tiles left; -1: all are empty
        int best = -1, most = 0;
        for (int k = 0; k < team_; ++k) {
            const std::uint64_t run = left_of(k).load(std::memory_order_relaxed);
            if (last(run) - first(run) > most) best = k, most = last(run) - first(run);
        }
        return best;
    }

    int team_;
    std::unique_ptr<Run[]> runs_;
};

}  // namespace dem_min
