// SPDX-License-Identifier: MIT
#include "reports/photo.hpp"

#include "reports/numbers.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace reports {
namespace {

constexpr double deg = std::numbers::pi / 180.0;

// Two decimals: a picture of a smooth heap is good for a twentieth of a degree.
std::string fine_degrees(double radians) { return fmt::format("{:.2f}", radians / deg); }

std::string interval_text(const statistics::Interval& i) {
    return fmt::format("{} to {}", fine_degrees(i.low), fine_degrees(i.high));
}

Json place(photo::Pixel p) { return Json::array({p.x, p.y}); }

Json flank_json(const photo::Flank& f) {
    return {{"angle", f.angle},
            {"interval", {f.interval.low, f.interval.high}},
            {"standard_error", f.standard_error},
            {"roughness_pixels", f.roughness},
            {"independent_pieces", f.pieces},
            {"at_20_percent", place(f.foot)},
            {"at_80_percent", place(f.top)}};
}

Json length_json(double pixels, double error, const std::optional<PhotoScale>& scale) {
    Json j{{"pixels", pixels}, {"pixels_standard_error", error}};
    if (scale) {
        const double m = pixels * scale->metres_per_pixel;
        j["m"] = m;
        j["m_standard_error"] =
            std::hypot(error * scale->metres_per_pixel, m * scale->relative_error);
    }
    return j;
}

std::string length_text(double pixels, const std::optional<PhotoScale>& scale) {
    return scale ? quantity(pixels * scale->metres_per_pixel, "m")
                 : fmt::format("{:.0f} pixels", pixels);
}

const char* tone_name(photo::Tone tone) {
    switch (tone) {
        case photo::Tone::brightness:
            return "brightness";
        case photo::Tone::red_less_blue:
            return "red less blue";
        case photo::Tone::green_less_rest:
            return "green less red and blue";
    }
    return "";
}

std::string sizes(const photo::Heaped& h, const std::optional<PhotoScale>& scale) {
    const std::string height = length_text(h.height, scale);
    return h.foot_width
               ? fmt::format("Height {}, foot {} wide", height, length_text(*h.foot_width, scale))
               : fmt::format("Height {}", height);
}

std::vector<std::string> notes_of(const photo::Measurement& m) {
    std::vector<std::string> notes;
    if (m.heap) {
        const photo::Heaped& h = *m.heap;
        notes.push_back(
            fmt::format("Standard uncertainty {} deg: roughness of the edges {}, where in the "
                        "blurred edge the line is drawn {}, left against right {}",
                        fine_degrees(h.parts.total), fine_degrees(h.parts.roughness),
                        fine_degrees(h.parts.light), fine_degrees(h.parts.difference)));
        notes.push_back(
            fmt::format("Base line tilted by {} +- {} deg, {}, taken out; it makes one flank "
                        "steeper and the other flatter, and leaves "
                        "their mean",
                        fine_degrees(std::abs(h.tilt)), fine_degrees(2.0 * h.tilt_error),
                        h.tilt > 0.0 ? "rising to the right" : "rising to the left"));
    }
    for (const scaling::Finding& f : m.findings)
        if (f.judgement == scaling::Judgement::caution) notes.push_back(f.text);
    return notes;
}

TextTable table_of(const photo::Heaped& h) {
    const auto row = [](const char* name, double angle, const std::string& interval,
                        const char* what) {
        return std::vector<std::string>{name, fine_degrees(angle), interval, what};
    };
    TextTable t{{"angle", "degrees", "95 % interval", "what it is"}};
    t.push_back(
        row("silhouette", h.angle, interval_text(h.interval), "mean of left and right flank"));
    t.push_back(row("left", h.left.angle, interval_text(h.left.interval),
                    "line through the edge, 20 to 80 % of the height"));
    t.push_back(row("right", h.right.angle, interval_text(h.right.interval), "the same"));
    if (h.two_h_over_d)
        t.push_back(row("two_h_over_d", *h.two_h_over_d, "", "height over half the foot's width"));
    return t;
}

std::string base64(const std::string& bytes) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        unsigned n = 0;
        for (std::size_t j = 0; j < 3; ++j)
            n = n << 8 | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j)
            out += k + j <= bytes.size() ? digits[n >> (18 - 6 * j) & 63] : '=';
    }
    return out;
}

// A wider line of the halo's tone under the coloured one, so that it is seen on any ground.
std::string stroke(const std::string& shape, const char* colour, double width,
                   const char* dash = "", const char* halo = "#fff") {
    return fmt::format(
        "<{0} fill=\"none\" stroke=\"{4}\" stroke-opacity=\"0.6\" stroke-width=\"{1:.1f}\" "
        "stroke-linecap=\"round\"/>\n"
        "<{0} fill=\"none\" stroke=\"{2}\" stroke-width=\"{3:.1f}\"{5}/>\n",
        shape, 1.8 * width, colour, width, halo,
        *dash ? fmt::format(" stroke-dasharray=\"{}\"", dash) : "");
}

std::string segment(photo::Pixel a, photo::Pixel b) {
    return fmt::format("line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"", a.x, a.y,
                       b.x, b.y);
}

photo::Pixel between(photo::Pixel a, photo::Pixel b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

std::string drawn(const photo::Picture& picture, const photo::Measurement& m,
                  const std::string& description) {
    const double n = static_cast<double>(picture.reduced_by);
    const double width = static_cast<double>(picture.width) * n,
                 height = static_cast<double>(picture.height) * n;
    const double line = width / 320.0;  // as thick in a large picture as in a small one
    std::string s = fmt::format(
        "<svg class=\"plot\" role=\"img\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "aria-labelledby=\"photo-d\"><desc id=\"photo-d\">{2}</desc>\n"
        "<image width=\"{0:.0f}\" height=\"{1:.0f}\" href=\"data:image/jpeg;base64,{3}\"/>\n<g "
        "transform=\"translate(0.5 0.5)\">\n",
        width, height, escaped(description), base64(photo::jpeg_of(picture)));
    if (m.heap)
        s += stroke(segment(m.heap->base_left, m.heap->base_right), "#cc3311", 0.8 * line,
                    fmt::format("{:.0f} {:.0f}", 4 * line, 3 * line).c_str());
    std::string labels;
    if (m.heap) {
        for (const bool left : {true, false}) {
            const photo::Flank& f = left ? m.heap->left : m.heap->right;
            const std::string dash = fmt::format("{:.0f} {:.0f}", 2 * line, 2 * line);
            s += stroke(segment(between(f.foot, f.top, -1.0 / 3.0), f.foot), "#0077bb", 0.7 * line,
                        dash.c_str());
            s += stroke(segment(f.top, between(f.foot, f.top, 4.0 / 3.0)), "#0077bb", 0.7 * line,
                        dash.c_str());
            s += stroke(segment(f.foot, f.top), "#0077bb", 1.3 * line);
            const photo::Pixel at = between(f.foot, f.top, 0.6);
            s += fmt::format(
                "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" font-weight=\"600\" "
                "text-anchor=\"{}\" fill=\"#004a75\" stroke=\"#fff\" "
                "stroke-width=\"{:.1f}\" paint-order=\"stroke\">{:.1f}\u00b0</text>\n",
                at.x + (left ? -5.0 : 5.0) * line, at.y - 2.0 * line, 11.0 * line,
                left ? "end" : "start", 1.6 * line, f.angle / deg);
        }
    }
    // Where columns are missing the edge is interrupted.
    std::string points;
    const auto flush = [&] {
        if (!points.empty())
            s += stroke(fmt::format("polyline points=\"{}\"", points), "#ffcc33", 0.5 * line, "",
                        "#000");
        points.clear();
    };
    double last = -10.0;
    for (const photo::Pixel& p : m.edge) {
        if (p.x - last > 3.0 * n) flush();
        points += fmt::format("{:.1f},{:.1f} ", p.x, p.y), last = p.x;
    }
    flush();
    return s + labels + "</g></svg>";
}

}  // namespace

Verdict verdict_of(const photo::Measurement& m) {
    if (!m.heap) {
        const scaling::Finding& f = m.findings.back();
        const bool numeric = f.rule.starts_with('>') || f.rule.starts_with('<');
        return {Answer::cannot_tell, "No angle can be read from this picture",
                numeric ? fmt::format("{}: {} is {}, must be {}.", f.text, words(f.name),
                                      number(f.value), f.rule)
                        : fmt::format("{}. Needed: {}.", f.text, f.rule)};
    }
    const photo::Heaped& h = *m.heap;
    return {
        Answer::yes,
        fmt::format("Angle of repose {} deg, 95 % between {} and {} deg", fine_degrees(h.angle),
                    fine_degrees(h.interval.low), fine_degrees(h.interval.high)),
        fmt::format("The left flank shows {} deg, the right {} deg, against a base line that is "
                    "tilted by {} deg in the picture; estimator silhouette.",
                    fine_degrees(h.left.angle), fine_degrees(h.right.angle),
                    fine_degrees(std::abs(h.tilt)))};
}

Json to_json(const photo::Measurement& m, const std::optional<PhotoScale>& scale) {
    Json j{{"answer", to_string(verdict_of(m).answer)}};
    j["angle_of_repose"] = nullptr;
    if (m.heap) {
        const photo::Heaped& h = *m.heap;
        j["angle_of_repose"] = {{"estimator", "silhouette"},
                                {"angle", h.angle},
                                {"interval", {h.interval.low, h.interval.high}},
                                {"standard_uncertainty", h.parts.total},
                                {"from_roughness", h.parts.roughness},
                                {"from_light", h.parts.light},
                                {"from_left_against_right", h.parts.difference},
                                {"left", flank_json(h.left)},
                                {"right", flank_json(h.right)}};
        j["two_h_over_d"] = h.two_h_over_d ? Json(*h.two_h_over_d) : Json(nullptr);
        j["tilt"] = {{"angle", h.tilt},
                     {"standard_error", h.tilt_error},
                     {"base_line", {place(h.base_left), place(h.base_right)}}};
        j["height"] = length_json(h.height, h.left.roughness, scale);
        j["foot_width"] =
            h.foot_width ? length_json(*h.foot_width, h.width_error, scale) : Json(nullptr);
    }
    j["metres_per_pixel"] = scale ? Json{{"value", scale->metres_per_pixel},
                                         {"relative_standard_error", scale->relative_error}}
                                  : Json(nullptr);
    j["tone"] = tone_name(m.tone);
    j["heap_is"] = m.lighter ? "lighter" : "darker";
    j["findings"] = to_json(m.findings);
    j["limits"] = limits_of(m);
    return j;
}

std::string text_of(const photo::Measurement& m, const std::optional<PhotoScale>& scale) {
    const Verdict v = verdict_of(m);
    std::string text = fmt::format("{}\n", v.headline);
    if (m.heap)
        text += fmt::format("\n{}", columns(table_of(*m.heap), {false, true, true, false}));
    else
        text += fmt::format("{}\n", wrapped(v.why, 100, 0));
    if (m.heap) text += fmt::format("\n{}.\n", sizes(*m.heap, scale));
    for (const std::string& note : notes_of(m))
        text += fmt::format("{}\n", wrapped(note + ".", 100, 4));
    return text;
}

RunSection photo_section(const std::string& name, const photo::Picture& picture,
                         const photo::Measurement& m, const std::optional<PhotoScale>& scale) {
    const Verdict verdict = verdict_of(m);
    return {name,
            {verdict.answer, m.heap ? sizes(*m.heap, scale) : verdict.headline,
             m.heap ? "" : verdict.why},
            notes_of(m),
            {drawn(picture, m, verdict.headline + ". " + verdict.why),
             m.heap ? "Yellow: the edge as found. Blue: the line through each flank, full between "
                      "20 and 80 % of the height. Red: the base line."
                    : "Yellow: what was taken for the edge of a heap."},
            m.heap ? table_of(*m.heap) : TextTable{},
            {}};
}

std::vector<std::string> limits_of(const photo::Measurement& m) {
    std::vector<std::string> limits{
        "One picture shows two flanks. A heap that is not round has others; turn it, and take more "
        "pictures.",
        "How far the camera looked down or up cannot be seen in the picture. The angle holds for a "
        "lens level with the apex, or as stated.",
        "Pixels are taken as square and lines as straight: a picture stretched by hand, or the "
        "edge of a wide-angle lens, is not corrected.",
        "The angle is against the red line, which should be what the heap stands on: where it is "
        "not, state the base line. A table that is not level is not "
        "noticed."};
    if (m.heap)
        limits.emplace_back(
            "The interval covers roughness, blur and light, and left against right; it does not "
            "cover another way to pour.");
    return limits;
}

}  // namespace reports
