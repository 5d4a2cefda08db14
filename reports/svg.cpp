// SPDX-License-Identifier: MIT
#include "reports/svg.hpp"

#include "reports/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

namespace reports {

namespace {

constexpr double page_width = 720.0, left = 80.0, right = 18.0, bottom = 52.0;  // user units
constexpr double tallest = 430.0, character = 7.2, legend_line = 22.0;

struct Style {
    const char *colour, *dash;
};
// Okabe & Ito (2008): blue, vermilion, green, purple. The class lets a page choose lighter ones on
// a dark ground.
constexpr std::array<Style, 4> styles{
    {{"#0072B2", ""}, {"#D55E00", "7 4"}, {"#009E73", "2 3"}, {"#CC79A7", "9 3 2 3"}}};

const Style& style(int k) { return styles[static_cast<std::size_t>(k) % styles.size()]; }

struct Range {
    double low = std::numeric_limits<double>::infinity(),
           high = -std::numeric_limits<double>::infinity();

    void add(const std::vector<double>& values) {
        for (const double v : values) {
            if (!std::isfinite(v)) continue;
            low = std::min(low, v);
            high = std::max(high, v);
        }
    }
    bool empty() const { return !(low <= high); }
    double size() const { return high - low; }
};

// 4 % of room at both ends, so that no point lies on the frame.
Range with_room(Range r) {
    const double room = r.size() > 0.0 ? 0.04 * r.size() : std::max(0.5 * std::abs(r.high), 1.0);
    return {r.low - room, r.high + room};
}

// Where data lie on the page.
struct Frame {
    Range x, y;
    double top, width, height;

    double px(double v) const { return left + (v - x.low) / x.size() * width; }
    double py(double v) const { return top + height - (v - y.low) / y.size() * height; }
};

std::string point(char command, double x, double y) {
    return fmt::format("{}{:.1f} {:.1f}", command, x, y);
}

std::string marker(double x, double y, int k) {
    const double s = 4.0;
    const std::string paint = fmt::format(
        "class=\"s{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"", k % 4, style(k).colour);
    switch (k % 4) {
        case 0:
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>", x, y, s, paint);
        case 1:
            return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" {}/>",
                               x - s, y - s, 2 * s, 2 * s, paint);
        case 2:
            return fmt::format("<path d=\"M{:.1f} {:.1f}l{} {}h{}z\" {}/>", x, y - s, s, 2 * s,
                               -2 * s, paint);
        default:
            return fmt::format("<path d=\"M{:.1f} {:.1f}l{} {}l{} {}l{} {}z\" {}/>", x, y - s, s, s,
                               -s, s, -s, -s, paint);
    }
}

// A marker of a few units as a piece of a path: dot, cross, plus, square.
std::string fine_marker(double x, double y, int k) {
    switch (k % 4) {
        case 0:
            return point('M', x, y) + "h0";
        case 1:
            return point('M', x - 2.0, y - 2.0) + "l4 4m0 -4l-4 4";
        case 2:
            return point('M', x - 2.4, y) + "h4.8m-2.4 -2.4v4.8";
        default:
            return point('M', x - 1.8, y - 1.8) + "h3.6v3.6h-3.6z";
    }
}

std::string fine_path(const std::string& pieces, int k) {
    return fmt::format(
        "<path class=\"s{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
        "stroke-linecap=\"round\" d=\"{}\"/>\n",
        k % 4, style(k).colour, k % 4 == 0 ? 3.6 : 1.1, pieces);
}

std::string curve_path(const Curve& curve, const Frame& f) {
    std::string d;
    bool down = false;
    for (std::size_t k = 0; k < std::min(curve.x.size(), curve.y.size()); ++k) {
        const bool there = std::isfinite(curve.x[k]) && std::isfinite(curve.y[k]);
        if (there) d += point(down ? 'L' : 'M', f.px(curve.x[k]), f.py(curve.y[k]));
        down = there;
    }
    return fmt::format(
        "<path class=\"s{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" "
        "stroke-dasharray=\"{}\" d=\"{}\"/>\n",
        curve.style % 4, style(curve.style).colour, style(curve.style).dash, d);
}

std::string markers(const Curve& curve, const Frame& f) {
    std::string out;
    if (curve.fine) {
        for (std::size_t k = 0; k < std::min(curve.x.size(), curve.y.size()); ++k)
            if (std::isfinite(curve.x[k]) && std::isfinite(curve.y[k]))
                out += fine_marker(f.px(curve.x[k]), f.py(curve.y[k]), curve.style);
        return fine_path(out, curve.style);
    }
    for (std::size_t k = 0; k < std::min(curve.x.size(), curve.y.size()); ++k)
        if (std::isfinite(curve.x[k]) && std::isfinite(curve.y[k]))
            out += marker(f.px(curve.x[k]), f.py(curve.y[k]), curve.style) + "\n";
    return out;
}

std::string band_path(const Band& band, const Frame& f) {
    std::string forth, back;
    for (std::size_t k = 0; k < band.x.size(); ++k) {
        if (!std::isfinite(band.low[k]) || !std::isfinite(band.high[k])) continue;
        forth += point(forth.empty() ? 'M' : 'L', f.px(band.x[k]), f.py(band.high[k]));
        back.insert(0, point('L', f.px(band.x[k]), f.py(band.low[k])));
    }
    if (forth.empty()) return "";
    return fmt::format(
        "<path class=\"b{}\" fill=\"{}\" fill-opacity=\"0.18\" stroke=\"none\" d=\"{}{}Z\"/>\n",
        band.style % 4, style(band.style).colour, forth, back);
}

std::string span_rectangle(const Span& span, const Frame& f) {
    const double from = std::clamp(f.px(std::min(span.from, span.to)), left, left + f.width);
    const double to = std::clamp(f.px(std::max(span.from, span.to)), left, left + f.width);
    if (!(to > from)) return "";
    return fmt::format(
        "<rect class=\"b{0}\" x=\"{1:.1f}\" y=\"{2:.1f}\" width=\"{3:.1f}\" height=\"{4:.1f}\" "
        "fill=\"{5}\" fill-opacity=\"0.16\"/><path class=\"s{0}\" stroke=\"{5}\" "
        "stroke-dasharray=\"2 2\" d=\"M{1:.1f} {2:.1f}v{4:.1f}m{3:.1f} 0v-{4:.1f}\"/>\n",
        span.style % 4, from, f.top, to - from, f.height, style(span.style).colour);
}

std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const std::string& more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                       anchor, more, escaped(with_micro(text)));
}

std::string x_axis(const Frame& f, const std::string& label) {
    const double base = f.top + f.height;
    std::string out;
    for (const double v : ticks(f.x.low, f.x.high, 9)) {
        out += fmt::format(
            "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke-opacity=\"0.15\"/>\n",
            f.px(v), f.top, base);
        out += text_at(f.px(v), base + 18.0, "middle", number(v));
    }
    return out + text_at(left + 0.5 * f.width, base + 42.0, "middle", label);
}

std::string y_axis(const Frame& f, const std::string& label) {
    std::string out;
    for (const double v :
         ticks(f.y.low, f.y.high,
               std::max(f.height > 150.0 ? 5 : 3, static_cast<int>(f.height / 45.0)))) {
        out += fmt::format(
            "<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\" stroke-opacity=\"0.15\"/>\n", left,
            f.py(v), left + f.width);
        out += text_at(left - 8.0, f.py(v) + 4.0, "end", number(v));
    }
    const double y = f.top + 0.5 * f.height;
    return out + text_at(16.0, y, "middle", label,
                         fmt::format(" transform=\"rotate(-90 16 {:.1f})\"", y));
}

std::string box(const Frame& f) {
    return fmt::format(
        "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
        left, f.top, f.width, f.height);
}

struct Entry {
    std::string label;
    int style;
    bool line, band, marked, fine = false;
};

std::vector<Entry> entries(const Plot& plot) {
    std::vector<Entry> all;
    for (const Curve& c : plot.curves)
        if (!c.label.empty()) all.push_back({c.label, c.style, !c.marked, false, c.marked, c.fine});
    for (const Band& b : plot.bands)
        if (!b.label.empty()) all.push_back({b.label, b.style, false, true, false});
    for (const Span& s : plot.spans)
        if (!s.label.empty()) all.push_back({s.label, s.style, false, true, false});
    return all;
}

std::string swatch(const Entry& e, double x, double y) {
    const Style& s = style(e.style);
    if (e.fine) {
        std::string three;
        for (const double dx : {6.0, 14.0, 22.0}) three += fine_marker(x + dx, y, e.style);
        return fine_path(three, e.style);
    }
    if (e.marked) return marker(x + 14.0, y, e.style);
    if (e.band)
        return fmt::format(
            "<rect class=\"b{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"28\" height=\"10\" fill=\"{}\" "
            "fill-opacity=\"0.3\"/>",
            e.style % 4, x, y - 5.0, s.colour);
    return fmt::format(
        "<path class=\"s{}\" d=\"M{:.1f} {:.1f}h28\" stroke=\"{}\" stroke-width=\"2\" "
        "stroke-dasharray=\"{}\"/>",
        e.style % 4, x, y, s.colour, s.dash);
}

// The legend above the frame, and how far it reaches down.
std::pair<std::string, double> legend(const Plot& plot) {
    std::string out;
    double x = left, y = 14.0;
    for (const Entry& e : entries(plot)) {
        const double needed = 36.0 + character * static_cast<double>(e.label.size()) + 18.0;
        if (x > left && x + needed > page_width) {
            x = left;
            y += legend_line;
        }
        out += swatch(e, x, y) + text_at(x + 36.0, y + 4.5, "start", e.label);
        x += needed;
    }
    return {out, out.empty() ? 10.0 : y + 14.0};
}

// A list of names is separated by spaces, so that a name may have none.
std::string without_spaces(std::string id) {
    for (char& c : id)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
    return id;
}

std::string opened(const std::string& title, const std::string& description, const std::string& id,
                   double height) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" role=\"img\" viewBox=\"0 0 {0:g} "
        "{1:.0f}\" "
        "aria-labelledby=\"{2}-title {2}-desc\" font-family=\"system-ui, sans-serif\" "
        "font-size=\"13\" "
        "fill=\"currentColor\">\n<title id=\"{2}-title\">{3}</title>\n<desc "
        "id=\"{2}-desc\">{4}</desc>\n"
        "<style>.grid,.frame{{stroke:currentColor;fill:none}}</style>\n",
        page_width, height, without_spaces(id), escaped(title), escaped(description));
}

Frame frame_of(const Plot& plot, double top) {
    Range x, y;
    for (const Curve& c : plot.curves) x.add(c.x), y.add(c.y);
    for (const Band& b : plot.bands) x.add(b.x), y.add(b.low), y.add(b.high);
    Frame f{with_room(x), with_room(y), top, page_width - left - right, plot.height};
    if (plot.x.range) f.x = {plot.x.range->first, plot.x.range->second};
    if (plot.y.range) f.y = {plot.y.range->first, plot.y.range->second};
    if (!plot.equal_scale) return f;
    f.height = f.width * f.y.size() / f.x.size();
    if (f.height > tallest) {
        f.width *= tallest / f.height;
        f.height = tallest;
    }
    return f;
}

}  // namespace

std::vector<double> ticks(double low, double high, int most) {
    const double least = (high - low) / most;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    double step = power;
    for (const double times : {1.0, 2.0, 5.0, 10.0}) {
        step = times * power;
        if (step >= least * (1.0 - 1e-12)) break;
    }
    std::vector<double> places;
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0)
        places.push_back(k == 0.0 ? 0.0 : k * step);
    return places;
}

std::string svg(const Plot& plot, const std::string& id) {
    Range any;
    for (const Curve& c : plot.curves) any.add(c.y);
    for (const Band& b : plot.bands) any.add(b.low);
    if (any.empty()) return "";
    const auto [legend_text, top] = legend(plot);
    const Frame f = frame_of(plot, top);
    std::string out = opened(plot.title, plot.description, id, f.top + f.height + bottom) +
                      legend_text + x_axis(f, plot.x.label) + y_axis(f, plot.y.label);
    for (const Span& span : plot.spans) out += span_rectangle(span, f);
    for (const Band& band : plot.bands) out += band_path(band, f);
    for (const Curve& curve : plot.curves)
        out += curve.marked ? markers(curve, f) : curve_path(curve, f);
    return out + box(f) + "</svg>\n";
}

std::string interval_svg(const std::string& title, const std::string& description,
                         const std::string& axis, const std::vector<IntervalRow>& rows,
                         const std::string& id) {
    if (rows.empty()) return "";
    Range x;
    std::size_t longest = 0;
    for (const IntervalRow& row : rows) {
        x.add({row.low, row.high, row.mean});
        x.add(row.values);
        longest = std::max(longest, row.label.size());
    }
    if (x.empty()) return "";
    const double labels = character * static_cast<double>(longest) + 18.0, line = 34.0;
    Frame f{with_room(x),
            {0.0, 1.0},
            8.0,
            page_width - left - right,
            line * static_cast<double>(rows.size())};
    const double width =
        f.width + left - labels;  // the labels stand where another plot has its y axis
    const auto px = [&](double v) { return labels + (v - f.x.low) / f.x.size() * width; };
    std::string out = opened(title, description, id, f.top + f.height + bottom);
    for (const double v : ticks(f.x.low, f.x.high, 9)) {
        out += fmt::format(
            "<path class=\"grid\" d=\"M{:.1f} {:.1f}v{:.1f}\" stroke-opacity=\"0.15\"/>\n", px(v),
            f.top, f.height);
        out += text_at(px(v), f.top + f.height + 18.0, "middle", number(v));
    }
    out += text_at(labels + 0.5 * width, f.top + f.height + 42.0, "middle", axis);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const IntervalRow& row = rows[k];
        const double y = f.top + line * (static_cast<double>(k) + 0.5);
        out += text_at(labels - 10.0, y + 4.5, "end", row.label);
        for (const double v : row.values)
            out += fmt::format(
                "<path class=\"s{}\" stroke=\"{}\" stroke-opacity=\"0.6\" d=\"M{:.1f} {:.1f}v8\"/>",
                row.style % 4, style(row.style).colour, px(v), y + 5.0);
        out += fmt::format(
            "<path class=\"s{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" d=\"M{:.1f} "
            "{:.1f}H{:.1f}m0 -5v10M{:.1f} {:.1f}v10\"/>",
            row.style % 4, style(row.style).colour, px(row.low), y, px(row.high), px(row.low),
            y - 5.0);
        out += marker(px(row.mean), y, row.style) + "\n";
    }
    return out + "</svg>\n";
}

}  // namespace reports
