// SPDX-License-Identifier: MIT
// Many samples of the rig `compression`, one per seed and condition: run side by side, each remembered on disk as soon as it is
// finished, so that an interrupted campaign goes on where it stopped.
#pragma once

#include "rigs/compression.hpp"
#include "verify/pile_runs.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace verify {

struct CompressionJob {
    std::string name;  // unique, fit for a file name
    std::uint64_t seed;
    rigs::CompressionSetup setup;
    double unit_of_length = 1.0, unit_of_time = 1.0;  // in which the final state is hashed
};

// Piston stress over strain. Shape of both: [points].
struct StressStrain {
    std::vector<double> strain, stress;  // 1, Pa
};

struct CompressionSample {
    std::string name;
    std::uint64_t seed = 0;
    double grains = 0.0;
    // When the consolidation stress was reached.
    double strain = 0.0, packing_fraction = 0.0, coordination = 0.0, floor_over_piston = 0.0;
    double strength = 0.0, strain_at_strength = 0.0;  // Pa, 1
    double inertial_number = 0.0, inertial_number_of_crush = 0.0;
    double steps = 0.0, seconds = 0.0;
    StressStrain confined, crushed;
    std::uint64_t hash = 0;  // of the final state, in the job's units
};

// In the order of `jobs`; `campaign.engine` takes no part. Throws Interrupted if `stop` was set before all had finished.
std::vector<CompressionSample> run_compressions(const std::vector<CompressionJob>&,
                                                const Campaign&);

// The file of a remembered sample: its name and a fingerprint of its whole setup, so that another one is run anew.
std::filesystem::path file_of(const CompressionJob&, const std::filesystem::path& folder);

}  // namespace verify
