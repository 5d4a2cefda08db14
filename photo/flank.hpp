// SPDX-License-Identifier: MIT
// One flank of an outline: the line between 20 and 80 % of the height, and how well it is known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace photo {

// A point of the outline: `along` the base line from the apex outwards, `above` it; both in pixels.
struct EdgePoint {
    double along, above;
};

// above = level - slope along.
struct FlankFit {
    double level, slope;
    double roughness;           // pixels, robust standard deviation of the points about the line
    double pieces;              // how many independent ones the points are worth
    double slope_error;         // standard error
    double degrees_of_freedom;  // of slope_error
    std::vector<EdgePoint> points;  // in the window
};

// As `silhouette` in rigs/angle_of_repose.hpp: points are chosen by the height that the line itself has where they stand, between 20
// and 80 % of `height`, again and again until the choice stays. The least squares are weighted by Tukey's biweight (c = 4.685, scale 1.4826 times the
// median residual), so that a stray grain in the air does not count.
// The error is a circular block bootstrap of the residuals (Politis & Romano 1992, in: Exploring the Limits of Bootstrap, 263): neighbouring points of
// an edge of grains go together. Blocks are three correlation lengths long, at most a fifth of the flank; `pieces` is the number of points over the
// correlation length. Nothing for fewer than 12 points or a level flank.
std::optional<FlankFit> fit_flank(std::span<const EdgePoint>, double height, std::uint64_t seed);

// The slope alone, as above, of the line between two heights.
std::optional<double> flank_slope(std::span<const EdgePoint>, double low, double high);

}  // namespace photo
