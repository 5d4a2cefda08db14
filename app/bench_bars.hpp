// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace app {

struct Bar {
    std::string label;
    double value, low, high;  // >= 0
    int style;                // 0 to 3, as in reports/svg.hpp
};

// Lying bars that start at zero, each with a whisker from low to high: a whole <svg> element. Empty
// without a bar.
std::string bars_svg(const std::string& title, const std::string& axis, const std::vector<Bar>&,
                     const std::string& id);

}  // namespace app
