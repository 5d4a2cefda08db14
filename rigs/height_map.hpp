// SPDX-License-Identifier: MIT
// What a line scanner sees of a heap: the highest point of any loose grain above each spot of the base, 0 where there is
// none; and what can be read from it: the mean profile and the packing fraction.
// The scanner sees the tops of spheres, about half a diameter above the surface that a continuum would have. That shifts
// every height alike and leaves the slope as it is (docs/angle-of-repose.md).
#pragma once

#include "rigs/heap.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace rigs {

// Heights on a polar grid about the base's axis. Spot (k, i) lies at azimuth 2 pi (k + 1/2) / azimuths and radius
// (i + 1/2) base_radius / rings.
struct HeightMap {
    std::size_t azimuths, rings;
    double base_radius;     // m
    double grain_diameter;  // m, the mean over the loose grains; 0 without grains
    std::vector<double>
        z;  // m, [azimuths * rings], z[k * rings + i]; > 0 under a loose grain, else 0

    double azimuth(std::size_t k) const;  // rad
    double radius(std::size_t i) const;   // m
    double area(std::size_t i) const;     // m^2 of the base for which one spot of ring i stands
};

// The map of a heap, its spots d/8 apart or, on bases wider than 100 d, base_radius/400. `azimuths` is a multiple of 12.
// Throws scaling::InvalidParameter unless base_radius > 0, every radius > 0, all numbers are finite and centre and radius have
// one length.
HeightMap scan(const Heap&);

// The highest of all spots, m; 0 without grains.
double height(const HeightMap&);

// The volume between the base's top and the map, m^3.
double volume(const HeightMap&);

// Mean height over all azimuths, and its sample standard deviation over 12 sectors of 30 deg.
struct RadialProfile {
    std::vector<double> r, z, spread;  // m, [rings]
};

RadialProfile radial_profile(const HeightMap&);

// The share of space that grains fill inside a heap, away from its edges:
//   inside: deeper than one diameter, along the normal, under the surface of revolution of the mean profile; farther than one
//           diameter from the base's top and from its rim.
// Vertical lines through the spots of the map are cut by the grains exactly, spheres at the edge of the region counted with
// the part that lies inside: no grain is chosen by its centre, so the edge brings no bias. Material in the overlap of two
// grains counts twice (overlap/d of 1e-3: 1e-5 of the value).
struct PackingFraction {
    double value;
    double volume;  // m^3 of the region, by which its scatter can be judged
};

// `map` must be the scan of `heap`. Nothing where the region is smaller than ten cubes of one diameter.
std::optional<PackingFraction> packing_fraction(const Heap& heap, const HeightMap& map);

}  // namespace rigs
