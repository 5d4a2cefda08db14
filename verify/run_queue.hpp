// SPDX-License-Identifier: MIT
// Jobs of a campaign, run side by side: what is remembered is taken from there, a fault or a stop ends all.
#pragma once

#include "verify/pile_runs.hpp"

#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace verify {

// Shared by the workers of one campaign. Shape of samples, done: [jobs].
template <class Job, class Sample>
struct RunQueue {
    const std::vector<Job>& jobs;
    const Campaign& campaign;
    std::vector<std::optional<Sample>> samples;
    std::vector<double> done;  // grain-steps
    double total = 0.0;
    std::size_t next = 0;
    std::mutex mutex{};
    std::exception_ptr fault{};

    RunQueue(const std::vector<Job>& all, const Campaign& c)
        : jobs(all), campaign(c), samples(all.size()), done(all.size(), 0.0) {}

    bool stopped() const { return campaign.stop != nullptr && campaign.stop->load(); }

    void tell(const std::string& ended) {
        double sum = 0.0;
        for (const double part : done) sum += part;
        if (campaign.progress) campaign.progress(sum, total, ended);
    }

    // What job k is expected to cost, and its sample where it has been remembered.
    void expect(std::size_t k, double grain_steps, std::optional<Sample> remembered) {
        total += grain_steps;
        samples[k] = std::move(remembered);
        if (samples[k]) done[k] = grain_steps;
    }

    // The samples of all jobs; `run_one(queue, index)` sets one, or leaves it where it was stopped. Throws Interrupted, or what a run threw.
    template <class RunOne>
    std::vector<Sample> run(int threads, const RunOne& run_one) {
        std::vector<std::thread> workers;
        for (int k = 0; k < threads; ++k) workers.emplace_back([&] { work(run_one); });
        for (std::thread& worker : workers) worker.join();
        if (fault) std::rethrow_exception(fault);
        std::vector<Sample> all;
        for (std::optional<Sample>& sample : samples) {
            if (!sample) throw Interrupted{};
            all.push_back(std::move(*sample));
        }
        return all;
    }

  private:
    template <class RunOne>
    void work(const RunOne& run_one) {
        for (;;) {
            std::size_t index = 0;
            {
                const std::lock_guard lock(mutex);
                while (next < jobs.size() && samples[next]) ++next;
                if (next >= jobs.size() || stopped() || fault) return;
                index = next++;
            }
            try {
                run_one(*this, index);
            } catch (...) {
                const std::lock_guard lock(mutex);
                fault = std::current_exception();
            }
        }
    }
};

}  // namespace verify
