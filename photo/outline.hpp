// SPDX-License-Identifier: MIT
// The edge of the heap in a field that separates it from the background.
#pragma once

#include "photo/picture.hpp"
#include "photo/separate.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace photo {

// y = level + slope x, in pixels of the field.
struct Line {
    double level, slope;

    double y(double x) const { return level + slope * x; }
};

// The largest connected region of the heap's class (neighbours share a side). Shape of `on`: [height][width].
struct Region {
    std::size_t width, height, pixels;
    std::vector<char> on;
    bool touches_left, touches_right, touches_top, touches_bottom;
};

// `above`: only pixels above this line count, and only regions that come within three pixels of it. No pixels where there is none.
Region largest_region(const Field&, const std::optional<Line>& above);

// Where the field goes from background to heap, one place per column of the region, to a part of a pixel: coming from above for the upper
// edge, from below for the lower. `share` of the step between the levels that the field itself has on both sides of the edge,
// four to ten pixels away from it: a surface that is wrong there cancels. At the foot, where the heap is thinner than that, of the step from 0 to 1. Columns
// whose edge cannot be found are left out.
std::vector<Pixel> upper_edge(const Field&, const Region&, double share = 0.5);
std::vector<Pixel> lower_edge(const Field&, const Region&);

}  // namespace photo
