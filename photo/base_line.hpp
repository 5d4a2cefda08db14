// SPDX-License-Identifier: MIT
// The line that the heap stands on, where nobody drew it.
#pragma once

#include "photo/outline.hpp"

#include <optional>
#include <vector>

namespace photo {

struct BaseLine {
    Line line;
    double
        slope_error;  // standard error by leaving out an eighth of the points at a time; more where the pieces left and right have another slope
    double level_error;  // pixels, in the middle of the points it was found from
};

// A straight line, at most 20 deg steep, that many of the points lie on, left and right of their middle, and under which at most a quarter of them
// lie: the table beside a heap, or the lower edge of one. Found among the lines through pairs of points, then by least squares through
// what lies within the tolerance. Nothing where fewer than 2 % of the width (at least 8 points) lie on it on either side.
std::optional<BaseLine> find_base_line(const std::vector<Pixel>& edge, std::size_t width);

}  // namespace photo
