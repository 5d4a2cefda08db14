// SPDX-License-Identifier: MIT
// The angle of repose, read from a height map in five ways. No two mean quite the same: only angles of one
// estimator may be compared. H: height of the heap (its highest point), R: base radius.
//   flank_20_80   per sector of 30 deg about the apex, the least-squares line through the spots between 20 and 80 % of H;
//                 the mean of the 12 angles
//   cone          z = h - tan(angle) |x - x0| through all spots at 10 to 90 % of h; h, x0 and the angle are free (the level of the
//                 foot follows from them and is not tied to the base); Tukey's biweight, c = 4.685
//   two_h_over_d  tan(angle) = H / foot radius, ISO 4324's 2h/D
//   silhouette    the outline seen from the side, like a protractor on a photograph: the line through the outline at 20 to 80 %
//                 of H, mean of left and right flank, mean of 12 views 15 deg apart
//   volume        the cone of the heap's volume V on its foot: tan(angle) = 3 V / (pi foot radius^3)
//   protractor    read by a person from a photograph: a name for recordings, computed by nothing here
// The three that fit lines leave out the spots within one diameter of the rim, where grains show their sides. Apex: centre of the area above 80 % of H. Foot radius: that of the disc with the area under grains; the base's own where
// it comes within a diameter of that.
// Biases on cones of known angle: docs/angle-of-repose.md.
#pragma once

#include "rigs/height_map.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace rigs {

enum class Estimator { flank_20_80, cone, two_h_over_d, silhouette, volume, protractor };

// Those that angle_of_repose computes.
inline constexpr std::array computed_estimators = {Estimator::flank_20_80, Estimator::cone,
                                                   Estimator::two_h_over_d, Estimator::silhouette,
                                                   Estimator::volume};

const char* to_string(Estimator);                                 // the name above
std::optional<Estimator> estimator_named(std::string_view name);  // nothing for an unknown name

struct Angle {
    double angle;         // rad
    double spread;        // rad, sample standard deviation over sectors or views
    std::size_t samples;  // number of sectors or views that could be read, 12 at most
};

// Nothing without grains, and where fewer than 6 sectors or views have a line through them (a flat layer has no flank).
// two_h_over_d and volume answer for any grains at all: ask formed() first. Throws scaling::InvalidParameter for protractor.
std::optional<Angle> angle_of_repose(const HeightMap&, Estimator);

struct Point {
    double x, y;  // m
};

Point apex(const HeightMap&);  // the origin without grains

double foot_radius(const HeightMap&);  // m; 0 without grains

}  // namespace rigs
