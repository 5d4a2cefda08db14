// SPDX-License-Identifier: MIT
#include "reports/svg.hpp"

#include "samples.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace reports;

namespace {

Plot line(std::vector<double> x, std::vector<double> y) {
    Plot plot;
    plot.title = "rise <of> a line";
    plot.description = "It rises.";
    plot.x.label = "r / d";
    plot.y.label = "z / d";
    plot.curves = {{.x = std::move(x), .y = std::move(y), .style = 1, .label = "a line"}};
    return plot;
}

}  // namespace

TEST_CASE("svg: ticks step by one, two or five and stay inside the axis", "[reports][svg]") {
    CHECK(ticks(0.0, 10.0, 10) == std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    CHECK(ticks(0.0, 10.0, 5) == std::vector<double>{0, 2, 4, 6, 8, 10});
    CHECK(ticks(-0.3, 0.3, 3) == std::vector<double>{-0.2, 0.0, 0.2});
    const std::vector<double> fine = ticks(1.0e-9, 1.9e-9, 9);
    REQUIRE(fine.size() == 10);
    CHECK(fine.front() == Approx(1.0e-9).epsilon(1e-12));  // k times a step: round-off alone
}

TEST_CASE("svg: a plot is well-formed and speaks to those who cannot see it", "[reports][svg]") {
    const std::string text = svg(line({0, 1, 2}, {0, 1, 4}), "one");
    CHECK(fault_in_markup(text) == "");
    CHECK(times_in(text, "<title id=\"one-title\">rise &lt;of&gt; a line</title>") == 1);
    CHECK(times_in(text, "<desc id=\"one-desc\">It rises.</desc>") == 1);
    CHECK(times_in(text, "a line</text>") == 1);
    CHECK(times_in(text, "stroke-dasharray=\"7 4\"") ==
          2);  // the curve and its place in the legend
}

TEST_CASE("svg: a number that is none interrupts the line and never reaches the page",
          "[reports][svg]") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::string text = svg(line({0, 1, 2, 3, 4}, {0, 1, none, 1, 0}), "gap");
    CHECK(times_in(text, "nan") == 0);
    CHECK(fault_in_markup(text) == "");
    const std::size_t d = text.find(" d=\"", text.find("fill=\"none\" stroke=\"#D55E00\""));
    CHECK(times_in(text.substr(d, text.find('"', d + 4) - d), "M") == 2);
}

TEST_CASE("svg: a plot without any point is no plot", "[reports][svg]") {
    CHECK(svg(line({}, {}), "empty").empty());
    CHECK(interval_svg("t", "d", "a", {}, "empty").empty());
}

TEST_CASE("svg: under one scale a slope of one is drawn at 45 degrees", "[reports][svg]") {
    Plot plot = line({0, 10}, {0, 10});
    plot.equal_scale = true;
    plot.x.range = {0.0, 20.0};
    plot.y.range = {0.0, 10.0};
    const std::string text = svg(plot, "equal");
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    const std::size_t d = text.find(
        " d=\"M", text.find("stroke=\"#D55E00\" stroke-width=\"2\" stroke-dasharray=\"7 4\" d="));
    REQUIRE(std::sscanf(text.c_str() + d, " d=\"M%lf %lfL%lf %lf", &x0, &y0, &x1, &y1) == 4);
    CHECK(x1 - x0 == Approx(y0 - y1).margin(0.2));  // coordinates have one decimal
    CHECK(x1 > x0);
}

TEST_CASE("svg: an interval shows every repeat behind it", "[reports][svg]") {
    const std::string text = interval_svg(
        "angle", "two sides", "deg",
        {{"reference", 30, 29, 31, {29.5, 30, 30.5}, 0}, {"scaled", 30.2, 29, 31.4, {30, 30.4}, 1}},
        "i");
    CHECK(fault_in_markup(text) == "");
    CHECK(times_in(text, "stroke-opacity=\"0.6\"") == 5);
}

TEST_CASE("svg: a marked interval ends at the frame, and one outside of it is not drawn",
          "[reports][svg]") {
    Plot plot = line({0, 1, 2}, {0, 1, 4});
    plot.x.range = {0.0, 2.0};
    plot.spans = {{1.0, 9.0, 3, "where"}};
    const std::string text = svg(plot, "span");
    CHECK(fault_in_markup(text) == "");
    CHECK(times_in(text, "where</text>") == 1);
    // The frame is 720 - 80 - 18 = 622 wide and begins at 80: from its middle, 391, to its end.
    CHECK(times_in(text, "<rect class=\"b3\" x=\"391.0\"") == 1);
    CHECK(times_in(text, "width=\"311.0\"") == 1);
    plot.spans = {{3.0, 9.0, 3, ""}};
    CHECK(times_in(svg(plot, "span"), "class=\"b3\"") == 0);
}

TEST_CASE("svg: hundreds of points are one path, in shapes that differ without colour",
          "[reports][svg]") {
    Plot plot = line({0, 1, 2}, {0, 1, 4});
    plot.curves[0].marked = plot.curves[0].fine = true;
    plot.curves.push_back(plot.curves[0]);
    plot.curves[1].style = 2;
    const std::string text = svg(plot, "fine");
    CHECK(fault_in_markup(text) == "");
    CHECK(times_in(text, "stroke-linecap=\"round\"") == 4);  // each curve, and each in the legend
    CHECK(times_in(text, "l4 4m0 -4l-4 4") == 6);            // 3 points and 3 in the legend
    CHECK(times_in(text, "h4.8m-2.4 -2.4v4.8") == 6);
}
