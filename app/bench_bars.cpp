// SPDX-License-Identifier: MIT
#include "app/bench_bars.hpp"

#include "reports/numbers.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace app {

namespace {

constexpr double width = 720.0, left = 110.0, right = 30.0, line = 40.0, thick = 22.0, below = 48.0;
// Those of reports/svg.cpp; the class lets the page choose others on a dark ground.
constexpr std::array<const char*, 4> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7"};

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                       anchor, reports::escaped(text));
}

std::string bar(const Bar& b, double y, double scale) {
    const auto px = [&](double v) { return left + scale * v; };
    return text_at(left - 10.0, y + 4.5, "end", b.label) +
           fmt::format(
               "<rect class=\"b{0}\" x=\"{1:.1f}\" y=\"{2:.1f}\" width=\"{3:.1f}\" "
               "height=\"{4}\" fill=\"{5}\" fill-opacity=\"0.45\"/>\n",
               b.style % 4, left, y - 0.5 * thick, scale * b.value, thick,
               colours[static_cast<std::size_t>(b.style) % colours.size()]) +
           fmt::format(
               "<path fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.6\" "
               "d=\"M{0:.1f} {2:.1f}H{1:.1f}M{0:.1f} {3:.1f}v10M{1:.1f} {3:.1f}v10\"/>\n",
               px(b.low), px(b.high), y, y - 5.0);
}

}  // namespace

std::string bars_svg(const std::string& title, const std::string& axis,
                     const std::vector<Bar>& bars, const std::string& id) {
    double longest = 0.0;
    for (const Bar& b : bars) longest = std::max({longest, b.value, b.high});
    if (longest <= 0.0) return "";
    const double scale = (width - left - right) / longest;
    const double foot = line * static_cast<double>(bars.size());
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" role=\"img\" viewBox=\"0 0 {0} "
        "{1:.0f}\" aria-labelledby=\"{2}-title\" font-family=\"system-ui, sans-serif\" "
        "font-size=\"13\" fill=\"currentColor\">\n<title id=\"{2}-title\">{3}</title>\n",
        width, foot + below, id, reports::escaped(title));
    for (const double v : reports::ticks(0.0, longest, 8))
        out += fmt::format(
                   "<path stroke=\"currentColor\" stroke-opacity=\"0.15\" "
                   "d=\"M{:.1f} 0V{:.1f}\"/>\n",
                   left + scale * v, foot) +
               text_at(left + scale * v, foot + 18.0, "middle", reports::number(v));
    out += text_at(left + 0.5 * (width - left - right), foot + 40.0, "middle", axis);
    for (std::size_t k = 0; k < bars.size(); ++k)
        out += bar(bars[k], line * (static_cast<double>(k) + 0.5), scale);
    return out + "</svg>\n";
}

}  // namespace app
