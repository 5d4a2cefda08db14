// SPDX-License-Identifier: MIT
#include "verify/scaling_map_runs.hpp"

#include "verify/scaling_map_heaps.hpp"
#include "verify/scaling_map_judge.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace verify {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

class Pourer {
  public:
    Pourer(const MapPlan& plan, std::uint64_t first_seed, const MapRun& run)
        : plan_(plan), run_(run), known_(read_heaps(run.heaps)) {
        const std::vector<MapTurn> all = map_turns(plan, first_seed);
        for (const MapPile& p : plan.piles) cost_.push_back(expected_cost(p));
        for (std::size_t k = 0; k < all.size(); ++k)
            if (static_cast<int>(k % static_cast<std::size_t>(run.shards)) == run.shard - 1)
                turns_.push_back(all[k]);
        for (const MapTurn& t : turns_) total_ += cost_[t.pile];
        part_.resize(turns_.size(), 0.0);
    }

    MapEnd pour() {
        std::vector<std::thread> workers;
        for (int k = 0; k < run_.threads; ++k) workers.emplace_back([this] { work(); });
        for (std::thread& worker : workers) worker.join();
        if (fault_) std::rethrow_exception(fault_);
        if (stopped()) return MapEnd::stopped;
        return left_out_ ? MapEnd::out_of_budget : MapEnd::complete;
    }

  private:
    bool stopped() const { return run_.stop != nullptr && run_.stop->load(); }

    void tell(std::size_t turn, double share, const std::string& ended) {
        const std::lock_guard lock(mutex_);
        part_[turn] = share * cost_[turns_[turn].pile];
        double done = 0.0;
        for (const double part : part_) done += part;
        if (run_.progress) run_.progress(done, total_, ended);
    }

    // Whether a heap of this cost would end within the budget, at the speed of this run so far; the first ones may always begin.
    bool fits(double cost) const {
        if (run_.budget <= 0.0) return true;
        const double passed = seconds_since(start_);
        if (passed >= run_.budget) return false;
        return poured_ == 0.0 || passed + cost * pouring_seconds_ / poured_ <= run_.budget;
    }

    void work() {
        for (;;) {
            std::size_t turn = 0;
            {
                const std::lock_guard lock(mutex_);
                if (next_ >= turns_.size() || stopped() || fault_) return;
                turn = next_++;
            }
            try {
                pour_one(turn);
            } catch (const Interrupted&) {
                return;
            } catch (...) {
                const std::lock_guard lock(mutex_);
                fault_ = std::current_exception();
            }
        }
    }

    void pour_one(std::size_t turn) {
        const MapTurn& t = turns_[turn];
        const PileJob job = map_job(plan_.piles[t.pile], t.seed);
        if (!known_.contains({job.name, fingerprint(job)})) {
            {
                const std::lock_guard lock(mutex_);
                if (!fits(cost_[t.pile])) {
                    left_out_ = true;
                    return;
                }
            }
            const auto begun = Clock::now();
            Campaign one;
            one.stop = run_.stop;
            one.progress = [&](double done, double of, const std::string&) {
                tell(turn, done / of, "");
            };
            MapHeap heap = map_heap(poured_or_failed(job, one), plan_.piles[t.pile]);
            heap.setup = fingerprint(job), heap.git = run_.git;
            append_heap(run_.heaps, heap);
            const std::lock_guard lock(mutex_);
            poured_ += cost_[t.pile];
            pouring_seconds_ += seconds_since(begun);
        }
        tell(turn, 1.0, job.name);
    }

    // A heap whose numbers are no longer finite is an answer about its step or its grain, not the end of the map.
    static PileSample poured_or_failed(const PileJob& job, const Campaign& one) {
        try {
            return run_piles({job}, one).front();
        } catch (const std::runtime_error&) {
            PileSample failed;
            failed.name = job.name;
            failed.seed = job.seed;
            failed.missed = {"finite_numbers"};
            return failed;
        }
    }

    const MapPlan& plan_;
    const MapRun& run_;
    const MapHeaps known_;
    std::vector<MapTurn> turns_;
    std::vector<double> cost_, part_;  // grain-steps: [piles], expected of one heap; [turns], done
    double total_ = 0.0;
    double poured_ = 0.0, pouring_seconds_ = 0.0;  // by this run: grain-steps, s of one thread
    std::size_t next_ = 0;
    bool left_out_ = false;
    std::mutex mutex_{};
    std::exception_ptr fault_{};
    Clock::time_point start_ = Clock::now();
};

}  // namespace

MapEnd pour_map(const MapPlan& plan, std::uint64_t first_seed, const MapRun& run) {
    return Pourer(plan, first_seed, run).pour();
}

ScalingMap gather_map(const MapPlan& plan, std::uint64_t first_seed,
                      const std::filesystem::path& file) {
    const MapHeaps known = read_heaps(file);
    std::set<std::string> names;
    for (const auto& entry : known) names.insert(entry.first.first);
    ScalingMap map{.extent = plan.extent,
                   .reference_grains = plan.reference_grains,
                   .first_seed = first_seed,
                   .cells = {},
                   .heaps = {},
                   .heaps_planned = 0,
                   .heaps_stale = 0,
                   .grain_steps_planned = 0.0};
    std::vector<std::vector<MapHeap>> of_pile(plan.piles.size());
    for (const MapTurn& t : map_turns(plan, first_seed)) {
        const MapPile& p = plan.piles[t.pile];
        ++map.heaps_planned;
        const PileJob job = map_job(p, t.seed);
        map.grain_steps_planned += expected_grain_steps(job.setup);
        if (const auto heap = known.find({job.name, fingerprint(job)}); heap != known.end())
            of_pile[t.pile].push_back(heap->second);
        else
            map.heaps_stale += names.count(job.name);
    }
    for (const MapPair& pair : plan.pairs)
        map.cells.push_back(map_cell(pair, plan.piles[pair.reference], plan.piles[pair.scaled],
                                     of_pile[pair.reference], of_pile[pair.scaled]));
    if (!plan.impact_factors.empty())
        for (MapCell& c :
             single_impacts(plan.impact_bond, plan.impact_elasticity, plan.impact_factors))
            map.cells.push_back(std::move(c));
    for (const auto& heaps : of_pile) map.heaps.insert(map.heaps.end(), heaps.begin(), heaps.end());
    return map;
}

}  // namespace verify
