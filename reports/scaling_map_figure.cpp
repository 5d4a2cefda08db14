// SPDX-License-Identifier: MIT
#include "reports/numbers.hpp"
#include "reports/scaling_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace reports {

namespace {

using verify::MapCell;
using verify::MapQuantity;
using verify::MapVerdict;

constexpr double width = 720.0, left = 150.0, top = 42.0, row_height = 46.0;

// Tints of Okabe & Ito's green, vermilion and yellow that carry dark letters; the sign tells them apart without colour.
struct Look {
    const char *colour, *sign;
};
Look look(MapVerdict verdict) {
    switch (verdict) {
        case MapVerdict::holds:
            return {"#a6dcc8", "\u2713"};
        case MapVerdict::breaks:
            return {"#f3b48a", "\u2717"};
        case MapVerdict::not_decided:
            return {"#f2e6a8", "?"};
        case MapVerdict::not_poured:
            return {"#e3e6ea", "\u2013"};
    }
    return {"", ""};
}

const MapQuantity* find(const MapCell& c, const std::string& quantity) {
    for (const MapQuantity& q : c.quantities)
        if (q.name == quantity) return &q;
    return nullptr;
}

std::string text_at(double x, double y, const std::string& text, const char* more) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, more, escaped(text));
}

// As many digits as the margin has, and one more.
std::string fixed(double value, double margin) {
    const int digits = margin >= 1.0 ? 1 : margin >= 0.1 ? 2 : margin >= 0.01 ? 3 : 4;
    return fmt::format("{:.{}f}", value, digits);
}

std::string shortened(const std::string& text, double box) {
    const auto most = static_cast<std::size_t>(box / 5.6);
    return text.size() <= most ? text : text.substr(0, most - 3) + "...";
}

// What is written into a box: two lines.
std::pair<std::string, std::string> lines(const MapCell& c, const MapQuantity* q) {
    if (q == nullptr)
        return {std::string(look(c.verdict).sign) + " " + words(to_string(c.verdict)),
                map_words(c.why)};
    if (c.verdict == MapVerdict::not_poured) return {"", map_words(c.why)};
    if (q->reference.count < 2 || q->scaled.count < 2) return {"? too few heaps", ""};
    return {fmt::format("{} {}", look(q->verdict).sign, fixed(q->difference, q->margin)),
            fmt::format("[{}, {}]", fixed(q->interval.low, q->margin),
                        fixed(q->interval.high, q->margin))};
}

using Row = std::pair<std::string, double>;  // rule, Bond number

const char* factor_axis(const std::string& study) {
    if (study == "coarse_graining") return "h, grain over reference grain";
    if (study == "softening" || study == "single_impact")
        return "E of the reference over E (times softer)";
    if (study == "base_over_grain") return "base over grain, over the reference's";
    if (study == "outlet_over_grain") return "outlet over grain, over the reference's";
    if (study == "drop_height") return "drop height over the reference's";
    if (study == "feed_rate") return "feed rate over the reference's";
    return "time step over the reference's";
}

// One box for each cell of a study, where rows and columns meet.
struct Grid {
    std::vector<Row> rows;
    std::vector<double> factors;
    std::vector<const MapCell*> cells;
    double box() const { return (width - left - 8.0) / static_cast<double>(factors.size()); }
};

Grid grid_of(const verify::ScalingMap& map, const std::string& study, const std::string& quantity) {
    Grid g;
    for (const MapCell& c : map.cells) {
        if (c.study != study || (!quantity.empty() && find(c, quantity) == nullptr)) continue;
        g.cells.push_back(&c);
        const Row row{c.rule, c.bond};
        if (std::find(g.rows.begin(), g.rows.end(), row) == g.rows.end()) g.rows.push_back(row);
        if (std::find(g.factors.begin(), g.factors.end(), c.factor) == g.factors.end())
            g.factors.push_back(c.factor);
    }
    std::sort(g.factors.begin(), g.factors.end());
    std::stable_sort(g.rows.begin(), g.rows.end(),
                     [](const Row& a, const Row& b) { return a.second < b.second; });
    return g;
}

std::string cell_svg(const Grid& g, const MapCell& c, const std::string& quantity) {
    const auto at = [](const auto& list, const auto& value) {
        return static_cast<double>(std::find(list.begin(), list.end(), value) - list.begin());
    };
    const double x = left + at(g.factors, c.factor) * g.box(),
                 y = top + at(g.rows, Row{c.rule, c.bond}) * row_height;
    const MapQuantity* q = quantity.empty() ? nullptr : find(c, quantity);
    const auto [first, second] = lines(c, q);
    const Look colours =
        look(q != nullptr && c.verdict != MapVerdict::not_poured ? q->verdict : c.verdict);
    std::string out = fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" "
        "stroke=\"none\"/>\n",
        x + 1.5, y + 1.5, g.box() - 3.0, row_height - 3.0, colours.colour);
    const double middle = x + 0.5 * g.box();
    out += text_at(middle, y + 19.0, first,
                   "text-anchor=\"middle\" fill=\"#1b1f24\" stroke=\"none\" font-weight=\"600\"");
    return out + text_at(middle, y + 35.0, shortened(second, g.box()),
                         "text-anchor=\"middle\" fill=\"#1b1f24\" stroke=\"none\" "
                         "font-size=\"10\"");
}

}  // namespace

std::string map_svg(const verify::ScalingMap& map, const std::string& study,
                    const std::string& quantity, const std::string& id) {
    const Grid g = grid_of(map, study, quantity);
    if (g.cells.empty()) return "";
    const double height = top + row_height * static_cast<double>(g.rows.size()) + 8.0;
    const std::string title =
        words(study) + ": " + (quantity.empty() ? "verdicts" : map_words(quantity));
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" role=\"img\" viewBox=\"0 0 {0:g} "
        "{1:g}\" aria-labelledby=\"{2}-t {2}-d\" fill=\"currentColor\" font-family=\"inherit\" "
        "font-size=\"12\">\n<title id=\"{2}-t\">{3}</title><desc id=\"{2}-d\">{4} rows by {5} "
        "columns of verdicts; the table beside it has the same in words.</desc>\n",
        width, height, id, escaped(title), g.rows.size(), g.factors.size());
    out += text_at(left + 0.5 * (width - left), 14.0, factor_axis(study), "text-anchor=\"middle\"");
    out += text_at(left - 10.0, 32.0, "rule, F_po/(m g)", "text-anchor=\"end\"");
    for (std::size_t k = 0; k < g.factors.size(); ++k)
        out += text_at(left + (static_cast<double>(k) + 0.5) * g.box(), 32.0, number(g.factors[k]),
                       "text-anchor=\"middle\" font-weight=\"600\"");
    for (std::size_t k = 0; k < g.rows.size(); ++k)
        out += text_at(left - 10.0, top + (static_cast<double>(k) + 0.5) * row_height + 4.0,
                       fmt::format("{}, {}", map_words(g.rows[k].first), number(g.rows[k].second)),
                       "text-anchor=\"end\"");
    for (const MapCell* c : g.cells) out += cell_svg(g, *c, quantity);
    return out + "</svg>\n";
}

}  // namespace reports
