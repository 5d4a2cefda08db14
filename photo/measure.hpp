// SPDX-License-Identifier: MIT
// Angle of repose, profile and their uncertainty from one photograph of a heap, seen from the side. The angle is that of the estimator
// `silhouette` (rigs/angle_of_repose.hpp), so that a picture and a simulation can be compared. How, and what it is worth: docs/photo.md.
#pragma once

#include "photo/picture.hpp"
#include "photo/separate.hpp"
#include "scaling/finding.hpp"
#include "statistics/intervals.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace photo {

enum class Heap { either, dark, light };  // against its background

// All places in pixels of the file, turned upright.
struct Settings {
    std::optional<std::pair<Pixel, Pixel>>
        base{};  // two points of the base line; found where it is left out
    std::optional<std::pair<Pixel, Pixel>> crop{};  // two opposite corners of what is looked at
    Heap heap = Heap::either;
    double looking_down =
        0.0;  // rad, of the camera at the apex; up or down: the sign does not matter
    bool looking_down_stated = false;
    std::uint64_t seed = 1;  // of the bootstrap
};

struct Flank {
    double angle;                   // rad
    double standard_error;          // rad, of the edge's roughness alone
    statistics::Interval interval;  // 95 %, rad, with the base line's error
    double roughness;               // pixels, standard deviation of the edge about the line
    double pieces;                  // how many independent ones the edge in the window is worth
    Pixel foot, top;                // the line at 20 and 80 % of the height
};

// Standard uncertainties of the angle, rad.
struct Parts {
    double roughness;  // of both edges: block bootstrap
    double light;  // where the edge is taken, at 35 or at 65 % of the step from background to heap
    double
        difference;  // left against right, what roughness and base line do not explain: other views of the heap differ as much
    double total;
};

struct Profile {
    std::vector<double> along,
        above;  // pixels: from the middle of the foot, right positive; above the base line
};

struct Heaped {
    double angle;                   // rad, mean of the flanks
    statistics::Interval interval;  // 95 %
    Parts parts;
    Flank left, right;
    std::optional<double>
        two_h_over_d;  // rad; none where the foot is not seen or the camera looks down
    double tilt,
        tilt_error;  // rad, of the base line, > 0 where it rises to the right; standard error
    Pixel base_left, base_right;       // its ends
    double height;                     // pixels, of the highest point above the base line
    std::optional<double> foot_width;  // pixels
    double width_error;                // pixels, standard error of foot_width
    Profile profile;
};

struct Measurement {
    std::optional<Heaped> heap;  // none where a finding is `unusable`
    std::vector<scaling::Finding>
        findings;  // what was judged, in the order of judging; an unusable one is the last
    std::vector<Pixel> edge;  // of the heap, as far as it was found; for drawing
    Tone tone = Tone::brightness;
    bool lighter = false;  // the heap than its background
};

// Throws scaling::InvalidParameter for points outside the picture, a base line of no length or steeper than 45 deg, a crop below 32 pixels, a
// camera that looks down by 45 deg or more.
Measurement measure(const Picture&, const Settings&);

// The angle of a cone whose outline shows `apparent` (both rad) to a camera that looks down at its apex by `looking_down`:
//   tan^2(angle) = (tan^2(apparent) + sin^2(looking_down)) / cos^2(looking_down).
// Plane through camera and apex that touches the cone; holds at any distance, so for perspective too, where the lens points at the apex.
double seen_level(double apparent, double looking_down);

}  // namespace photo
