// SPDX-License-Identifier: MIT
// Line plots as SVG text: no script, no font file, no network; readable in black and white, since
// every style has its own dash and marker beside its colour (Okabe & Ito's set). Axis lines take
// the colour of the text around them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reports {

struct Axis {
    std::string label;  // with its unit; "r / d" where there is none
    std::optional<std::pair<double, double>> range =
        std::nullopt;  // low < high; left out: that of the data
};

// One line, or markers where `marked`; points that are not finite interrupt it. Shape of x, y:
// [points].
struct Curve {
    std::vector<double> x, y;
    int style = 0;           // 0 to 3: colour, dash and marker
    std::string label = {};  // empty: not in the legend
    bool marked = false;
    bool fine = false;  // with `marked`: small markers, for hundreds of points
};

// The area between low and high. Shape of all: [points].
struct Band {
    std::vector<double> x, low, high;
    int style = 0;
    std::string label = {};
};

// An interval of x, marked over the whole height; what lies outside the frame is not drawn.
struct Span {
    double from, to;
    int style = 0;
    std::string label = {};
};

struct Plot {
    std::string title,
        description;  // for screen readers: what a reader of the figure would say that it shows
    Axis x, y;
    std::vector<Band> bands;
    std::vector<Curve> curves;
    bool equal_scale = false;  // one unit is as long on y as on x
    std::vector<Span> spans = {};
    double height = 320.0;  // of the frame, where the scales are not equal
};

// A whole <svg> element, 720 units wide. An empty plot is an empty string. `id` must be unique on
// its page.
std::string svg(const Plot&, const std::string& id);

// Steps of 1, 2 or 5 times a power of ten inside [low, high], `most` at most; low < high.
std::vector<double> ticks(double low, double high, int most);

// One mean and its interval on each of several lines; `values` are the repeats behind it.
struct IntervalRow {
    std::string label;
    double mean, low, high;
    std::vector<double> values;
    int style = 0;
};

// The rows above a common axis, as wide as `svg` draws.
std::string interval_svg(const std::string& title, const std::string& description,
                         const std::string& axis, const std::vector<IntervalRow>&,
                         const std::string& id);

}  // namespace reports
