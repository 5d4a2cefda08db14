// SPDX-License-Identifier: MIT
// Our cost as the bed grows, next to the memory bandwidth of the machine, and on grains of two
// sizes.
#pragma once

#include "bench/compare.hpp"

#include <functional>
#include <string>
#include <vector>

namespace bench {

using Told = std::function<void(double share, const std::string& what)>;

struct ScalingPoint {
    int grains = 0, threads = 1;
    Spread grain_step;      // s of wall time per grain and step
    double contacts = 0.0;  // per grain, each counted once
    dem_min::MemoryUse memory{};
    double moved_in_a_step = 0.0;  // B, see dem_min::bytes_moved
    double triad = 0.0;            // B/s, arrays as large in all as this simulation
    double bytes_per_grain() const { return static_cast<double>(memory.bytes_grains) / grains; }
    double bytes_per_contact() const {  // 0 where there are none
        return contacts > 0.0 ? static_cast<double>(memory.bytes_contacts) / (contacts * grains)
                              : 0.0;
    }
    double moved() const { return moved_in_a_step / grains; }  // B per grain-step
};

struct Triad {
    double bytes = 0.0;  // of the three arrays in all
    int threads = 1;
    double bandwidth = 0.0;  // B/s
};

struct ScalingStudy {
    std::vector<ScalingPoint> points;  // by size, then by threads
};

// A lattice in contact, at the overlap at which JKR spheres carry no load: from the first step on
// the work is that of a bed at rest.
engines::Bed settled_bed(int nx, int ny, int nz);

// No size above `largest`; so many grain-steps are timed at each point and repeat.
ScalingStudy scaling_study(int largest, double grain_steps, int repeats,
                           const std::vector<int>& threads, const Told&);

// Grains of radius R in the gaps of a cubic lattice of grains ten times as large, settled under
// gravity, against as many grains of one size.
struct PolydisperseSide {
    int grains = 0;
    double contacts = 0.0;  // per grain, each counted once
    Spread contact_step;    // s of wall time per contact and step
    Spread grain_step;      // s of wall time per grain and step
};
struct PolydisperseStudy {
    int threads = 1;
    double size_ratio = 10.0;
    PolydisperseSide equal, mixed;
    double ratio() const { return mixed.contact_step.median / equal.contact_step.median; }
};
PolydisperseStudy polydisperse_study(int cells, int warm_up, int steps, int repeats, int threads,
                                     const Told&);

}  // namespace bench
