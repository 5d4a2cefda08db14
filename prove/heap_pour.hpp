// SPDX-License-Identifier: MIT
// One heap of the truth, poured by LAMMPS on glued grains (rig `pile` of docs/case.md): what a deck needs, and what it leaves.
// Nothing here is shared with the engines, rigs and core that a judge uses. All in SI.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace prove {

struct Powder {
    double diameter, density, youngs_modulus, poisson_ratio, restitution;
};

struct HeapRig {
    double base_diameter, drop_height, feed_diameter, feed_rate;
    int grains;
};

// What acts beside weight and Hertz-Mindlin contacts; 0: not there.
struct HeapPhysics {
    double sliding_friction;
    double rolling_friction = 0.0;
    double work_of_adhesion = 0.0;  // J/m^2, JKR
    double size_spread = 0.0;       // standard deviation over mean diameter, by number
    double tilt_angle = 0.0, tilt_azimuth = 0.0;  // rad; the base leans down towards the azimuth
};

struct Pour {
    Powder grain;
    HeapRig rig;
    HeapPhysics acts;
    std::uint64_t seed;
};

// What `damping tsuji` of the release of 29 Sep 2021 must be told for impacts of restitution e.
double restitution_told(double e);

// deck.in and grains.data, for the release of 29 Sep 2021. The heap at rest goes to heap.dump.
std::map<std::string, std::string> lammps_files(const Pour&);

struct Ball {
    double x, y, z, radius;
};

// The loose grains of heap.dump. Throws std::runtime_error where the text is no whole dump.
std::vector<Ball> read_heap(const std::string& text);

struct Spot {
    double r, azimuth;
};

// What a line scanner sees there: the highest point of any grain above the spot, not below 0. z = 0 is the top of the glued grains.
double height_above(const std::vector<Ball>&, const Spot&);

}  // namespace prove
