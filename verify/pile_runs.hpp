// SPDX-License-Identifier: MIT
// Many piles, one per seed and condition: run side by side, each remembered on disk as soon as it is finished, so that an
// interrupted campaign goes on where it stopped.
#pragma once

#include "rigs/pile_engine.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace verify {

struct PileJob {
    std::string name;  // unique, fit for a file name: "reference-7"
    std::uint64_t seed;
    rigs::PileSetup setup;
    double unit_of_length = 1.0,
           unit_of_time = 1.0;  // the scaled run's in the reference's: its state is hashed in them
};

// What similarity is judged by, plain numbers; lengths in grain diameters.
struct PileSample {
    std::string name;
    std::uint64_t seed = 0;
    bool formed = false, at_rest = false;
    std::vector<std::string> missed;  // names of the criteria of a heap that it does not meet
    // In the order of rigs::computed_estimators.
    std::array<std::optional<double>, rigs::computed_estimators.size()> angles_deg;
    std::optional<double> packing_fraction;
    double coordination = 0.0;
    double grains_on_base = 0.0, grains_lost = 0.0, steps = 0.0, seconds = 0.0;
    double mean_compression = 0.0;              // N, dem_min::mean_compression
    double grain_steps = 0.0;                   // that were made
    double slept = 0.0, slept_while_fed = 0.0;  // 1, shares of the grain-steps
    std::vector<double> profile_r, profile_z;   // mean profile, in d
    std::uint64_t hash = 0;                     // of the final state, in the job's units

    // By one of rigs::computed_estimators.
    std::optional<double> angle_deg(rigs::Estimator) const;
};

struct Campaign {
    int threads = 1;                      // piles at a time, each on one thread
    rigs::PileEngine* engine = nullptr;   // who runs them, one after the other; none: our own core
    std::filesystem::path remembered_in;  // folder; empty: nothing is remembered
    // Called from one thread at a time: grains-steps done, of how many, and the pile that has just ended (or empty).
    std::function<void(double done, double of, const std::string& ended)> progress;
    const std::atomic<bool>* stop = nullptr;  // set by an interrupt: finished piles stay remembered
};

// In the order of `jobs`. Throws Interrupted if `stop` was set before all had finished, and scaling::InvalidInput, before any runs, for
// what the engine cannot take.
struct Interrupted {};
std::vector<PileSample> run_piles(const std::vector<PileJob>& jobs, const Campaign&);

// 16 hexadecimal digits of all that a pile depends on: its setup to the last bit, the physics of this core, who runs it.
std::string fingerprint(const PileJob&, const rigs::PileEngine* engine = nullptr);

// The file of a remembered pile: its name and its fingerprint, so that another one is run anew.
std::filesystem::path file_of(const PileJob&, const std::filesystem::path& folder,
                              const rigs::PileEngine* engine = nullptr);

// Grain-steps that a pile is likely to need: half of the grains are there while they are fed.
double expected_grain_steps(const rigs::PileSetup&);

}  // namespace verify
